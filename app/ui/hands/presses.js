// @ts-check
/**
 * Filters the pointers of the page before all other listeners: a press whose release never reached the page is cancelled,
 * and the palm beside a pen is ignored.
 */
import { viserCanvas } from "../viser/viser.js";

/** Milliseconds before and after the use of a pen in which a finger counts as a palm. */
const PALM = 500;
/** Milliseconds without an event of a pressed pen after which it counts as gone: a held pen always trembles. */
const GONE = 5000;

/** The events that began the present presses. @type {Map<number, PointerEvent>} */
const presses = new Map();
/** @type {Set<number>} */
const palms = new Set();
/** Time of the last event of a pen, ms of the events' clock. */
let penAt = -Infinity;

/** True for the canvas and the instruments over it, where a palm may rest. @param {EventTarget | null} target */
const isOnCanvas = (target) =>
  target instanceof Element && (target === viserCanvas() || target.closest(".softrod-instruments") !== null);

/** True if a pen is in use, or was just now. @param {number} now ms of the events' clock */
function isWriting(now) {
  const isDown = [...presses.values()].some(({ pointerType }) => pointerType === "pen");
  return now - penAt < (isDown ? GONE : PALM);
}

/** Cancels a press for all listeners. @param {PointerEvent} press */
function cancel(press) {
  const { pointerId, pointerType, isPrimary, clientX, clientY, target } = press;
  const init = { pointerId, pointerType, isPrimary, clientX, clientY, bubbles: true };
  const there = target instanceof Element && target.isConnected ? target : document.body;
  there.dispatchEvent(new PointerEvent("pointercancel", init));
  for (const element of [there, viserCanvas()]) {
    if (element?.hasPointerCapture(pointerId)) element.releasePointerCapture(pointerId);
  }
}

/** @param {PointerEvent} event */
function down(event) {
  const { pointerId, pointerType, target, timeStamp } = event;
  const before = presses.get(pointerId);
  if (before) cancel(before);
  if (pointerType === "pen") {
    penAt = timeStamp;
    for (const [id, press] of presses) {
      if (press.pointerType !== "touch" || !isOnCanvas(press.target) || timeStamp - press.timeStamp > PALM) continue;
      cancel(press);
      palms.add(id);
    }
  }
  if (pointerType === "touch" && isOnCanvas(target) && isWriting(timeStamp)) palms.add(pointerId);
  if (palms.has(pointerId)) event.stopImmediatePropagation();
  else presses.set(pointerId, event);
}

/** @param {PointerEvent} event */
function move(event) {
  const { pointerId, pointerType, buttons, timeStamp } = event;
  if (pointerType === "pen") penAt = timeStamp;
  if (palms.has(pointerId)) event.stopImmediatePropagation();
  const press = presses.get(pointerId);
  if (press && buttons === 0 && pointerType !== "touch") cancel(press);
}

/** @param {PointerEvent} event */
function up(event) {
  const { pointerId, pointerType, timeStamp } = event;
  if (pointerType === "pen") penAt = timeStamp;
  presses.delete(pointerId);
  if (palms.delete(pointerId)) event.stopImmediatePropagation();
}

/** Begins to listen, before all others. */
export function listenToPresses() {
  window.addEventListener("pointerdown", down, true);
  window.addEventListener("pointermove", move, true);
  for (const kind of /** @type {const} */ (["pointerup", "pointercancel"])) window.addEventListener(kind, up, true);
  window.addEventListener("blur", () => [...presses.values()].forEach(cancel));
}
