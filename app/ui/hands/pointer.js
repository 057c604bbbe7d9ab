// @ts-check
/**
 * Taking hold of masses with a mouse, pens and fingers, each with a mass of its own. Where the pointers are in the scene is
 * told to the server at every animation frame while it matters.
 */
import { shown } from "../../stage/canvas.js";
import { pageState, send } from "../../wire/channel.js";
import { editing } from "../../features/edit/editing.js";
import { areFree, freeHand, freshHand, handAt } from "./hands.js";
import { nearest, onScreen, wireNumber, screen, worldAt } from "../../stage/screen.js";
import { viserCanvas } from "../viser/viser.js";

/** Pixels from a mass within which it is taken hold of. */
const REACH = { mouse: 12, pen: 16, touch: 26, disc: 0 };
/** Pixels within which a press counts as a click. */
const CLICK = 4;
/** Milliseconds after a finger on the background in which a second one is for the view, whatever is under it. */
const PINCH = 250;

/** @typedef {{x: number, y: number}} Place pixels of the window */

/** Where the pointer was last over the canvas, in pixels of the window. @type {{x: number, y: number} | null} */
let pointer = null;
/**
 * What each pointer holds: in which hand, where it was pressed, where it is and whether the server knows that.
 *
 * @type {Map<number, {mass: number, hand: number, start: Place, at: Place, moved: boolean, told: boolean}>}
 */
const holds = new Map();
/** When each finger came down on the background, ms of the events' clock. @type {Map<number, number>} */
const viewing = new Map();
let asked = false;

/** What lies over the canvas and gives way to a mass under the pointer. @param {EventTarget | null} target */
const givesWay = (target) => target instanceof Element && target.closest(".softrod-instruments") !== null;

/**
 * The mass under a place on the screen, or -1.
 *
 * @param {{x: number, y: number}} place
 * @param {string} kind of pointer; "disc" for the disc itself and nothing around it
 * @param {number[]} [others] masses that do not count
 */
export function massAt(place, kind, others = []) {
  const { pictured: plan, frame } = shown();
  const on = screen();
  if (!plan || !frame || !on) return -1;
  const radii = plan.radius.map((radius) => radius * on.step);
  for (const mass of others) radii[mass] = NaN;
  return nearest(onScreen(plan, frame.positions, on), radii, place, REACH[/** @type {"mouse"} */ (kind)] ?? REACH.mouse);
}

/** @param {Place} place */
function pointAt(place) {
  const on = screen();
  const point = on && worldAt(place, on);
  return point && Number.isFinite(point.x) && Number.isFinite(point.y) ? point : null;
}

function report() {
  asked = false;
  const hands = [];
  for (const hold of holds.values()) {
    const point = hold.told ? null : pointAt(hold.at);
    if (point) hands.push(handAt(hold.hand, point));
    hold.told = true;
  }
  // That of a free hand is followed without a button.
  const point = pointer && areFree() && pageState().follow ? pointAt(pointer) : null;
  if (point) hands.push(handAt(0, point));
  if (hands.length) send({ do: "at", hands });
}

function reportSoon() {
  if (!asked) requestAnimationFrame(report);
  asked = true;
}

/** Whether a finger that comes down belongs to one that did so just now, for the view. @param {PointerEvent} event */
const isPinch = ({ pointerType, timeStamp }) =>
  pointerType === "touch" && [...viewing.values()].some((since) => timeStamp - since < PINCH);

/** @param {PointerEvent} event */
function press(event) {
  const canvas = viserCanvas();
  const under = event.target === canvas ? event.pointerType : givesWay(event.target) ? "disc" : null;
  if (!canvas || under === null || (under === "disc" && massAt({ x: event.clientX, y: event.clientY }, under) < 0)) return;
  // The keys are the body's again.
  const focused = document.activeElement;
  if (focused instanceof HTMLElement || focused instanceof SVGElement) focused.blur();
  const place = { x: event.clientX, y: event.clientY };
  if (holds.size === 0) pointer = place;
  const isTool = editing.on && editing.tool !== "hand";
  const held = [...holds.values()].map(({ mass }) => mass);
  const mass = event.button === 0 && !isTool && !isPinch(event) ? massAt(place, under, held) : -1;
  const point = mass >= 0 ? pointAt(place) : null;
  const hand = point ? freshHand() : -1;
  if (!point || hand < 0) {
    if (event.pointerType === "touch") viewing.set(event.pointerId, event.timeStamp);
    return;
  }
  // Neither viser nor its camera may hear of it.
  event.preventDefault();
  event.stopImmediatePropagation();
  canvas.setPointerCapture(event.pointerId);
  holds.set(event.pointerId, { mass, hand, start: place, at: place, moved: false, told: true });
  send({ do: "grab", hand, mass, x: wireNumber(point.x), y: wireNumber(point.y) });
}

/** @param {PointerEvent} event */
function move(event) {
  const canvas = viserCanvas();
  const at = { x: event.clientX, y: event.clientY };
  const hold = holds.get(event.pointerId);
  if (hold) {
    event.stopImmediatePropagation();
    hold.at = pointer = at;
    hold.told = false;
    hold.moved ||= Math.hypot(at.x - hold.start.x, at.y - hold.start.y) > CLICK;
    reportSoon();
    return;
  }
  // Off the canvas the pointer counts as staying where it was.
  if (holds.size || event.target !== canvas) return;
  pointer = at;
  if (event.buttons === 0 && event.pointerType !== "touch") {
    document.documentElement.toggleAttribute("data-softrod-near", massAt(at, event.pointerType) >= 0);
  }
  if (pageState().follow) reportSoon();
}

/** @param {PointerEvent} event */
function letGo(event) {
  viewing.delete(event.pointerId);
  const hold = holds.get(event.pointerId);
  if (!hold) return;
  event.stopImmediatePropagation();
  if (asked) report();
  holds.delete(event.pointerId);
  freeHand(hold.hand);
  send({ do: "drop", hand: hold.hand });
  if (!hold.moved && event.type === "pointerup") send({ do: "pick", mass: hold.mass });
}

/** Begins to listen. */
export function listenToPointer() {
  window.addEventListener("pointerdown", press, true);
  window.addEventListener("pointermove", move, true);
  for (const kind of /** @type {const} */ (["pointerup", "pointercancel", "lostpointercapture"])) {
    window.addEventListener(kind, letGo, true);
  }
}
