// @ts-check
/**
 * Taking hold of masses with a mouse, a pen or a finger. Where the pointer is in the scene is told to the server
 * at every animation frame while it matters.
 */
import { shown } from "./canvas.js";
import { send, told } from "./channel.js";
import { nearest, onScreen, pointText, screen, worldAt } from "./screen.js";
import { viser } from "./viser.js";

/** Pixels from a mass within which it is taken hold of. */
const REACH = { mouse: 12, pen: 16, touch: 26, disc: 0 };
/** Pixels within which a press counts as a click. */
const CLICK = 4;

/** Where the pointer was last over the canvas, in pixels of the window. @type {{x: number, y: number} | null} */
let pointer = null;
/** The mass in hand, and where it was pressed. @type {{mass: number, id: number, x: number, y: number, moved: boolean} | null} */
let hold = null;
let asked = false;

/** What lies over the canvas and gives way to a mass under the pointer. @param {EventTarget | null} target */
const givesWay = (target) => target instanceof Element && target.closest(".softrod-instruments") !== null;

/**
 * The mass under a place on the screen, or -1.
 *
 * @param {{x: number, y: number}} place
 * @param {string} kind of pointer; "disc" for the disc itself and nothing around it
 */
export function massAt(place, kind) {
  const { pictured: plan, frame } = shown();
  const on = screen();
  if (!plan || !frame || !on) return -1;
  const radii = plan.radius.map((radius) => radius * on.step);
  return nearest(onScreen(plan, frame.positions, on), radii, place, REACH[/** @type {"mouse"} */ (kind)] ?? REACH.mouse);
}

/** @param {{x: number, y: number}} place */
function coordinates(place) {
  const on = screen();
  const point = on && worldAt(place, on);
  if (!point || !Number.isFinite(point.x) || !Number.isFinite(point.y)) return null;
  return pointText(point);
}

/** Whether something goes where the pointer goes. */
const isFollowed = () => hold !== null || told().follow === "1";

function report() {
  asked = false;
  const at = pointer && isFollowed() ? coordinates(pointer) : null;
  if (at) send("at", at);
}

/** @param {PointerEvent} event */
function press(event) {
  const { canvas } = viser() ?? {};
  const under = event.target === canvas ? event.pointerType : givesWay(event.target) ? "disc" : null;
  if (!canvas || under === null || (under === "disc" && massAt({ x: event.clientX, y: event.clientY }, under) < 0)) return;
  // The keys are the body's again.
  const focused = document.activeElement;
  if (focused instanceof HTMLElement || focused instanceof SVGElement) focused.blur();
  pointer = { x: event.clientX, y: event.clientY };
  const at = coordinates(pointer);
  const mass = event.button === 0 && event.isPrimary ? massAt(pointer, under) : -1;
  if (mass < 0 || !at) return;
  // Neither viser nor its camera may hear of it.
  event.preventDefault();
  event.stopImmediatePropagation();
  canvas.setPointerCapture(event.pointerId);
  hold = { mass, id: event.pointerId, ...pointer, moved: false };
  send("grab", `${mass}|${at}`);
}

/** @param {PointerEvent} event */
function move(event) {
  const { canvas } = viser() ?? {};
  // Off the canvas the pointer counts as staying where it was; and a second finger does not move the mass in hand.
  if (hold ? event.pointerId !== hold.id : event.target !== canvas) return;
  pointer = { x: event.clientX, y: event.clientY };
  if (hold) {
    event.stopImmediatePropagation();
    hold.moved ||= Math.hypot(pointer.x - hold.x, pointer.y - hold.y) > CLICK;
  } else if (canvas && event.buttons === 0 && event.pointerType !== "touch") {
    document.documentElement.toggleAttribute("data-softrod-near", massAt(pointer, event.pointerType) >= 0);
  }
  if (isFollowed() && !asked) {
    asked = true;
    requestAnimationFrame(report);
  }
}

/** @param {PointerEvent} event */
function letGo(event) {
  if (!hold || event.pointerId !== hold.id) return;
  event.stopImmediatePropagation();
  if (asked) report();
  send("drop", "");
  if (!hold.moved && event.type === "pointerup") send("pick", String(hold.mass));
  hold = null;
}

/** Begins to listen. */
export function listenToPointer() {
  window.addEventListener("pointerdown", press, true);
  window.addEventListener("pointermove", move, true);
  for (const kind of ["pointerup", "pointercancel"]) window.addEventListener(kind, /** @type {any} */ (letGo), true);
}
