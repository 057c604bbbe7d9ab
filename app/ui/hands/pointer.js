// @ts-check
/**
 * Dragging masses with a mouse, pens and fingers, each with a mass of its own. The places of the pointers are sent at every
 * animation frame while they matter.
 */
import { onPicture, shown } from "../../stage/canvas.js";
import { pageState, send } from "../../wire/channel.js";
import { editing } from "../../features/edit/editing.js";
import { access } from "../access.js";
import { areFree, freeHand, takeHand, tellGrasp, handAt } from "./hands.js";
import { nearest, onScreen, REACH, wireNumber, worldAt } from "../../stage/screen.js";
import { screen } from "../viser/screen.js";
import { viserCanvas } from "../viser/viser.js";
import { MISSED, takePointer } from "./take.js";
import { say } from "../../words/words.js";

/** Pixels by which a pointer may move in a click. */
export const CLICK = 4;
/** Milliseconds after a finger on the background in which a second one zooms, whatever is under it. */
const PINCH = 250;

/** Pixels around a mass in which a tap instead of a drag takes it, besides those that it has moved of late; and ms of that. */
const [TAP_REACH, OF_LATE] = [24, 100];

/** @typedef {{x: number, y: number}} Place pixels of the window */

/** Pictures of that time, the oldest first, while taps stand for drags. @type {{at: number, generation: number, positions: ArrayLike<number>}[]} */
let past = [];

/** The last place of the pointer over the canvas. @type {Place | null} */
let pointer = null;
/**
 * Held masses by pointer: the hand, where the pointer was pressed and is now, whether that has been sent, and whether it has
 * been grabbed. While the clock stands still a mass is grabbed only once the pointer moves: a click would take its velocity.
 *
 * @type {Map<number, {mass: number, hand: number, start: Place, at: Place, moved: boolean, sent: boolean, grabbed: boolean}>}
 */
const holds = new Map();
/** Times at which fingers came down on the background, ms of the events' clock. @type {Map<number, number>} */
const viewing = new Map();
let asked = false;

/** True for what lies over the canvas but lets a mass under it be grabbed. @param {EventTarget | null} target */
const givesWay = (target) => target instanceof Element && target.closest(".softrod-instruments") !== null;

/**
 * The mass at a place on the screen, or -1.
 *
 * @param {Place} place
 * @param {string} kind of pointer; "disc" for only the disc itself
 * @param {number[]} [others] masses that are ignored
 */
export function massAt(place, kind, others = []) {
  const { pictured: plan, frame } = shown();
  const on = screen();
  if (!plan || !frame || !on) return -1;
  const radii = plan.radius.map((radius) => radius * on.step);
  for (const mass of others) radii[mass] = NaN;
  const reach = kind === "disc" ? 0 : (REACH[/** @type {"mouse"} */ (kind)] ?? REACH.mouse);
  return nearest(onScreen(plan, frame.positions, on), radii, place, reach);
}

/** Where a mass is in the window. @param {number} mass */
function placeOf(mass) {
  const { pictured: plan, frame } = shown();
  const on = screen();
  if (!plan || !frame || !on) return undefined;
  const places = onScreen(plan, frame.positions, on);
  return { x: places[2 * mass], y: places[2 * mass + 1] };
}

/** @param {import("../../stage/plan.js").Frame} frame */
function remember({ generation, positions }) {
  if (!access().taps) return;
  const at = performance.now();
  past = past.filter((one) => one.generation === generation && at - one.at <= OF_LATE);
  past.push({ at, generation, positions });
}

/** The mass that a tap is meant for, which moves while one aims at it, or -1. @param {Place} place */
function massOfTap(place) {
  const { pictured: plan, frame } = shown();
  const on = screen();
  if (!plan || !frame || !on) return -1;
  const places = onScreen(plan, frame.positions, on);
  const isOf = past[0]?.generation === frame.generation && performance.now() - past[0].at <= 2 * OF_LATE;
  const before = isOf ? onScreen(plan, past[0].positions, on) : places;
  const reaches = plan.radius.map((radius, i) => {
    const moved = Math.hypot(places[2 * i] - before[2 * i], places[2 * i + 1] - before[2 * i + 1]);
    return Math.max(radius * on.step, TAP_REACH + moved);
  });
  return nearest(places, reaches, place, 0);
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
    const point = hold.sent || !hold.grabbed ? null : pointAt(hold.at);
    if (point) hands.push(handAt(hold.hand, point));
    hold.sent = true;
  }
  // A body may follow the pointer without a button pressed.
  const point = pointer && areFree() && pageState().follow ? pointAt(pointer) : null;
  if (point) hands.push(handAt(0, point));
  if (hands.length) send({ do: "at", hands });
}

function reportSoon() {
  if (!asked) requestAnimationFrame(report);
  asked = true;
}

/** True if a finger comes down just after another one, to zoom. @param {PointerEvent} event */
const isPinch = ({ pointerType, timeStamp }) =>
  pointerType === "touch" && [...viewing.values()].some((since) => timeStamp - since < PINCH);

/** @param {PointerEvent} event */
function press(event) {
  const canvas = viserCanvas();
  const under = event.target === canvas ? event.pointerType : givesWay(event.target) ? "disc" : null;
  if (!canvas || under === null || (under === "disc" && massAt({ x: event.clientX, y: event.clientY }, under) < 0)) return;
  // Return keyboard focus to the canvas.
  const focused = document.activeElement;
  if (focused instanceof HTMLElement || focused instanceof SVGElement) focused.blur();
  const place = { x: event.clientX, y: event.clientY };
  if (holds.size === 0) pointer = place;
  const isTool = editing.on && editing.tool !== "hand";
  const held = [...holds.values()].map(({ mass }) => mass);
  const takes = event.button === 0 && !isTool && !isPinch(event);
  const isTap = takes && under !== "disc" && holds.size === 0 && access().taps;
  const direct = takes ? massAt(place, under, held) : -1;
  const mass = direct < 0 && isTap ? massOfTap(place) : direct;
  if (isTap && mass < 0) canvas.dispatchEvent(new CustomEvent(MISSED, { bubbles: true, detail: event }));
  const point = mass >= 0 ? pointAt(place) : null;
  const hand = point ? takeHand() : -1;
  if (!point || hand < 0) {
    if (event.pointerType === "touch") viewing.set(event.pointerId, event.timeStamp);
    return;
  }
  // Hide it from viser and its camera.
  event.preventDefault();
  event.stopImmediatePropagation();
  takePointer(canvas, event, { name: say("edit-mass", { number: String(mass) }), at: placeOf(mass) });
  const hold = { mass, hand, start: place, at: place, moved: false, sent: true, grabbed: false };
  holds.set(event.pointerId, hold);
  if (pageState().playing) grab(hold, point);
}

/** @param {{mass: number, hand: number, grabbed: boolean}} hold @param {{x: number, y: number}} point of the scene */
function grab(hold, { x, y }) {
  hold.grabbed = true;
  send({ do: "grab", hand: hold.hand, mass: hold.mass, x: wireNumber(x), y: wireNumber(y) });
  tellGrasp(hold.mass, true);
}

/** @param {PointerEvent} event */
function move(event) {
  const canvas = viserCanvas();
  const at = { x: event.clientX, y: event.clientY };
  const hold = holds.get(event.pointerId);
  if (hold) {
    event.stopImmediatePropagation();
    hold.at = pointer = at;
    hold.sent = false;
    hold.moved ||= Math.hypot(at.x - hold.start.x, at.y - hold.start.y) > CLICK;
    const start = hold.moved && !hold.grabbed ? pointAt(hold.start) : null;
    if (start) grab(hold, start);
    if (hold.grabbed) reportSoon();
    return;
  }
  // Off the canvas, the last place on it counts.
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
  if (hold.grabbed) {
    send({ do: "drop", hand: hold.hand });
    tellGrasp(hold.mass, false);
  }
  if (!hold.moved && event.type === "pointerup") send({ do: "pick", mass: hold.mass });
}

/** Begins to listen. */
export function listenToPointer() {
  onPicture(remember);
  window.addEventListener("pointerdown", press, true);
  window.addEventListener("pointermove", move, true);
  for (const kind of /** @type {const} */ (["pointerup", "pointercancel", "lostpointercapture"])) {
    window.addEventListener(kind, letGo, true);
  }
}
