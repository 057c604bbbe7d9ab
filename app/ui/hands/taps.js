// @ts-check
/**
 * Taps instead of drags: a tap on what can be dragged picks it up, and the next tap says where it goes. Whatever drags it
 * need not know: the release of the first tap is kept from it, and after the second one it gets moves from here to there,
 * and then the release.
 */
import { access } from "../access.js";
import { make, makeButton, overCanvas } from "../dialog.js";
import { MISSED, PICKED_UP, TAKEN } from "./take.js";
import { say } from "../../words/words.js";

/**
 * @typedef {{x: number, y: number}} Place in the window
 * @typedef {import("./take.js").Dragged & {element: Element, start: PointerEvent}} Drag
 */

/** Pixels by which a pointer may move in a tap; as near is a tap on the same thing. @type {Record<string, number>} */
const TAP = { mouse: 6, pen: 9, touch: 14 };
/** As much more for whoever has asked for taps: a hand that is not steady slips. */
const SLIP = 2;
/** Pixels that what was picked up goes in a picture, and in how many pictures it goes at least and at most: a body follows. */
const STRIDE = 30;
const [LEAST, MOST] = [4, 24];
/** Milliseconds for which it is held there: a mass is put down, not thrown. */
const RESTS = 150;
/** Milliseconds in which a second tap on what was just picked up comes from a hand that trembles. */
const TREMBLES = 300;
/** Milliseconds for which it is said that nothing is there. */
const SAID = 5000;
/** What works as ever while something is picked up, and does not say where it goes. */
const CONTROLS = "button, a, input, select, textarea, summary, label, [role=tab], [role=menu]";
/** Tools: a press on one puts down what is picked up of the body. */
const TOOLS = ".softrod-edit-bar, .softrod-box, .softrod-instrument [role=button]";
/** What has places of its own. */
const SURFACES = "dialog, .softrod-panel, .softrod-class";

/** The press that drags something. @type {Drag | null} */
let pressed = null;
/** Whether that has gone farther than a tap does. */
let isDrag = false;
/** The press that found nothing to drag. @type {PointerEvent | null} */
let missed = null;
/** @type {ReturnType<typeof setTimeout> | undefined} */
let said;
/** What is picked up. @type {Drag | null} */
let held = null;
/** When that was, by the clock of events. */
let since = 0;
/** The pointer that is about to say where it goes, or -1. */
let tapping = -1;
/** Whether it is on its way. */
let goes = false;
/** Whether an event is one of these here. */
let isOwn = false;
/** Whether the next click comes from a tap that has done something. */
let isDone = false;

/** @type {HTMLElement} */
let note;
/** @type {HTMLElement} */
let ring;
/** @type {HTMLElement} */
let live;
/** @type {HTMLButtonElement} */
let back;

/** @param {PointerEvent} event @returns {Place} */
const placeOf = ({ clientX, clientY }) => ({ x: clientX, y: clientY });
/** @param {PointerEvent} one @param {PointerEvent} two @param {number} [times] the pixels of a tap */
const areNear = (one, two, times = 1) =>
  Math.hypot(one.clientX - two.clientX, one.clientY - two.clientY) <= times * (TAP[two.pointerType] ?? TAP.mouse);
/** Whether a press may still be a tap. @param {Drag} drag @param {PointerEvent} event */
const isTap = ({ start }, event) => !isDrag && areNear(event, start, access().taps ? SLIP : 1);
/** @param {Event} event */
function swallow(event) {
  event.preventDefault();
  event.stopImmediatePropagation();
}

/** Whether a press is for something else than what is picked up. @param {EventTarget | null} target @param {Drag} drag */
function isElsewhere(target, { element }) {
  if (!(target instanceof Element) || element.contains(target)) return false;
  return target.closest(CONTROLS) !== null || target.closest(SURFACES) !== element.closest(SURFACES);
}

/** Has what is dragged hear of a pointer. @param {Drag} drag @param {"pointermove" | "pointerup" | "pointercancel"} kind @param {Place} at */
function tell({ element, start }, kind, { x, y }) {
  const { pointerId, pointerType, isPrimary, shiftKey, altKey, ctrlKey } = start;
  const isMove = kind === "pointermove";
  const pointer = { pointerId, pointerType, isPrimary, button: isMove ? -1 : 0, buttons: isMove ? 1 : 0, clientX: x, clientY: y };
  isOwn = true;
  element.dispatchEvent(new PointerEvent(kind, { ...pointer, shiftKey, altKey, ctrlKey, bubbles: true, cancelable: true }));
  isOwn = false;
}

// ------------------------------------------------------------------------- what is picked up
/** Shows what is picked up, and says what has become of it. @param {string} text */
function show(text) {
  clearTimeout(said);
  live.textContent = text;
  note.hidden = ring.hidden = !held;
  back.hidden = false;
  if (!held) return;
  /** @type {HTMLElement} */ (note.firstChild).textContent = text;
  const { x, y } = held.at ?? placeOf(held.start);
  ring.style.translate = `${x}px ${y}px`;
}

/** Says for some seconds that there is nothing to pick up. */
function tellMissed() {
  const text = say("taps-nothing");
  show(live.textContent === text ? `${text}\u00a0` : text); // a screen reader says it again
  /** @type {HTMLElement} */ (note.firstChild).textContent = text;
  back.hidden = true;
  note.hidden = false;
  said = setTimeout(() => (note.hidden = !held), SAID);
}

/** @param {Drag} drag */
function pickUp(drag) {
  held = drag;
  drag.element.dispatchEvent(new CustomEvent(PICKED_UP, { bubbles: true }));
  show(say("taps-held", { thing: drag.name }));
}

/** Ends it where it was. @param {"pointerup" | "pointercancel"} kind with the first, a tap on it is what it was without all this */
function putBack(kind) {
  const drag = held;
  if (!drag) return;
  held = null;
  tell(drag, kind, placeOf(drag.start));
  show(say("taps-back", { thing: drag.name }));
}

/** Has it go somewhere. @param {Drag} drag @param {Place} to */
function go(drag, to) {
  const from = placeOf(drag.start), { x, y } = drag.at ?? from;
  const [dx, dy] = [to.x - x, to.y - y];
  const steps = Math.ceil(Math.min(Math.max(Math.hypot(dx, dy) / STRIDE, LEAST), MOST));
  goes = true;
  note.hidden = ring.hidden = true;
  let at = from;
  const end = () => {
    goes = false;
    if (held !== drag) return;
    held = null;
    tell(drag, "pointerup", at);
    show(say("taps-put", { thing: drag.name }));
  };
  /** @param {number} step */
  const move = (step) => {
    if (held !== drag) {
      goes = false;
      return;
    }
    at = { x: from.x + (dx * step) / steps, y: from.y + (dy * step) / steps };
    tell(drag, "pointermove", at);
    if (step < steps) requestAnimationFrame(() => move(step + 1));
    else setTimeout(end, RESTS);
  };
  requestAnimationFrame(() => move(1)); // when all have seen that it is pressed
}

// ------------------------------------------------------------------------- pointers
/** @param {PointerEvent} event */
function down(event) {
  if (isOwn) return;
  isDone = isDrag = false;
  pressed = missed = null;
  note.hidden = !held || goes;
  if (held && !held.element.isConnected) putBack("pointercancel");
  if (held?.element instanceof HTMLCanvasElement && event.target instanceof Element && event.target.closest(TOOLS)) putBack("pointercancel");
  if (!held) return;
  // What drags it is not to take another press for its own.
  if (isElsewhere(event.target, held)) {
    if (event.pointerId === held.start.pointerId) event.stopImmediatePropagation();
    return;
  }
  swallow(event);
  if (!goes && tapping < 0 && event.button === 0) tapping = event.pointerId;
}

/** @param {PointerEvent} event */
function move(event) {
  if (isOwn) return;
  if (held && [tapping, held.start.pointerId].includes(event.pointerId)) event.stopImmediatePropagation();
  if (pressed?.start.pointerId !== event.pointerId) return;
  // What a tap picks up is where it was, however the tap slips.
  if (isTap(pressed, event)) event.stopImmediatePropagation();
  else isDrag = true;
}

/** @param {PointerEvent} event */
function up(event) {
  if (isOwn) return;
  const { pointerId, type } = event;
  const drag = pressed;
  if (held) {
    if (pointerId === tapping || pointerId === held.start.pointerId) event.stopImmediatePropagation();
    if (pointerId !== tapping) return;
    tapping = -1;
    if (type === "pointercancel") return;
    isDone = true;
    if (event.timeStamp - since <= TREMBLES && areNear(event, held.start, SLIP)) return;
    if (areNear(event, held.start)) putBack("pointerup");
    else go(held, placeOf(event));
  } else if (missed?.pointerId === pointerId) {
    if (type === "pointerup" && areNear(event, missed, SLIP)) tellMissed();
    missed = null;
  } else if (drag && drag.start.pointerId === pointerId) {
    pressed = null;
    if (type === "pointercancel" || !isTap(drag, event)) return;
    event.stopImmediatePropagation();
    isDone = true;
    since = event.timeStamp;
    pickUp(drag);
  }
}

/** A pointer that is picked up is still taken, and one that was let go drags nothing. @param {PointerEvent} event */
function lost(event) {
  if (event.pointerId === held?.start.pointerId) event.stopImmediatePropagation();
  else if (event.pointerId === pressed?.start.pointerId) pressed = null;
}

/** Begins to listen, before all that drags. */
export function listenToTaps() {
  note = make("div", "softrod-taps softrod-floats");
  note.hidden = true;
  back = makeButton(say("taps-button"), () => putBack("pointercancel"));
  note.append(make("span", ""), back);
  ring = make("div", "softrod-taps-ring");
  ring.hidden = true;
  live = make("div", "softrod-tell");
  live.setAttribute("role", "status");
  overCanvas().append(ring, note, live);
  window.addEventListener(TAKEN, (event) => {
    const { target, detail } = /** @type {CustomEvent} */ (event);
    if (!held && (detail.always || access().taps)) pressed = { ...detail, element: target };
  });
  window.addEventListener(MISSED, (event) => void (missed = held ? null : /** @type {CustomEvent} */ (event).detail));
  window.addEventListener("pointerdown", down, true);
  window.addEventListener("pointermove", move, true);
  for (const kind of /** @type {const} */ (["pointerup", "pointercancel"])) window.addEventListener(kind, up, true);
  window.addEventListener("lostpointercapture", lost, true);
  window.addEventListener("click", (event) => {
    if (isDone && event.detail > 0) swallow(event);
    isDone = false;
  }, true);
  window.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || !held || document.querySelector("dialog[open]")) return;
    swallow(event);
    putBack("pointercancel");
  }, true);
}
