// @ts-check
/** Drags: whatever drags something takes its pointer here, so that taps can do the same (taps.js). */

/**
 * @typedef {object} Dragged
 * @property {string} name what is dragged, for the one who drags it
 * @property {{x: number, y: number}} [at] where in the window the thing itself is, if it may be pressed beside that
 * @property {boolean} [always] whether taps move it without being asked for: a tap on it does nothing else
 */

/** The events by which taps hear that a pointer was taken, or found nothing to take, and what was dragged that it is picked up. */
export const TAKEN = "softrod-taken";
export const MISSED = "softrod-missed";
export const PICKED_UP = "softrod-picked-up";

/**
 * Has all further events of a pointer go to an element, which drags something with it.
 *
 * @param {Element} element @param {PointerEvent} event by which it was pressed @param {Dragged} dragged
 */
export function takePointer(element, event, dragged) {
  element.setPointerCapture(event.pointerId);
  if (event.type !== "pointerdown") return; // it has moved before it was taken
  element.dispatchEvent(new CustomEvent(TAKEN, { bubbles: true, detail: { start: event, ...dragged } }));
}
