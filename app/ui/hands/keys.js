// @ts-check
/** Keys and the arrow pad: what is held, and what is pressed once. */
import { send } from "../../wire/channel.js";
import { isMeantElsewhere } from "../access.js";
import { ARROWS, heldArrow } from "./arrow_keys.js";
import { listenToPad, releasePad } from "./arrow_pad.js";
import { commandOf } from "./key_table.js";
import { perform } from "../../wire/perform.js";
import { nextStep } from "../clock.js";

/** @typedef {import("../../wire/wire.js").Keys["held"][number]} Key */
/** What Space presses, once it was reached by keys. */
const PRESSED = "button, input, [role=tab], [role=button]";
/** What Space is typed into, or opens. */
const TEXTS = "textarea, select, [contenteditable], input:not([type]), input[type=text], input[type=search], input[type=url]";
/** What a key that is held down does again and again. */
const REPEATED = new Set(["step", "steps", "back", "forward"]);
/** With these viser would move the camera, wherever their letters are printed. */
const CAMERA_KEYS = new Set(["KeyW", "KeyA", "KeyS", "KeyD", "KeyQ", "KeyE"]);
/** Milliseconds between two reports of keys that are held; the server forgets those of which it hears nothing. */
const REPEAT = 150;

/** @type {Set<Key>} */
const held = new Set();
/** Whether the focus was last moved by a click or a touch, and not by the Tab key. */
let byPointer = false;
/** Whether Space is down that has played or paused. */
let spaceDown = false;

/** @param {EventTarget | null} target */
const isTyping = (target) =>
  target instanceof HTMLElement &&
  (target.isContentEditable ||
    target.tagName === "TEXTAREA" ||
    target.tagName === "SELECT" ||
    (target instanceof HTMLInputElement && !["range", "checkbox", "radio", "button"].includes(target.type)));
/** Keys besides the arrows that move a slider. */
const SLIDES = new Set(["Home", "End", "PageUp", "PageDown"]);
/** Whether a slider that was reached with the Tab key takes a key for itself; of the bars of modes see `isTaken`. @param {KeyboardEvent} event */
const isSliding = ({ target, key }) =>
  (key in ARROWS || SLIDES.has(key)) &&
  target instanceof HTMLElement &&
  target.matches('[role="slider"]:not(.softrod-mode):focus-visible, input[type="range"]:focus-visible');
/**
 * Whether what has the focus takes a key for itself: the body, an instrument, a muscle's mark or a bar of a mode arrows and Space, the
 * body with a mass in hand Esc, a plot arrows, a tab that was reached by the Tab key arrows across, the open box of instruments Esc.
 *
 * @param {KeyboardEvent} event
 */
export function isTaken({ target, code, key }) {
  if (!(target instanceof Element)) return false;
  if (key === "Escape") return target.closest(".softrod-box[data-open], .softrod-body[data-holds]") !== null;
  if (target.matches(".softrod-mode")) return (key in ARROWS && target.matches(":focus-visible")) || code === "Space";
  if (target.matches(".softrod-chart")) return key in ARROWS;
  if (target.matches("[role=tab]")) return !byPointer && (key === "ArrowLeft" || key === "ArrowRight");
  if (target.matches(".softrod-steps button")) return key === "ArrowUp" || key === "ArrowDown";
  if (target.matches(".softrod-muscle")) return key in ARROWS || code === "Space";
  return target.matches(".softrod-body, .softrod-grip, .softrod-own-grip") && (key in ARROWS || code === "Space");
}
/**
 * Whether Space plays or pauses, and does not press or type anything. After a click it does, wherever the focus is then;
 * only texts and open lists keep it. Browsers take the focus as one by keys as soon as any key is pressed, so
 * `:focus-visible` cannot tell.
 *
 * @param {KeyboardEvent} event
 */
function isSpaceFree(event) {
  const { target, ctrlKey, metaKey, altKey } = event;
  if (ctrlKey || metaKey || altKey || dialogIsOpen() || menuIsOpen() || isMeantElsewhere(event)) return false;
  if (!(target instanceof Element)) return true;
  if (target.matches(".softrod-number")) return true; // no number has a space
  if (target.matches(TEXTS)) return false;
  return byPointer || !target.matches(PRESSED);
}
/** Whether a key acts on the page, and not on what is typed into, or on a dialog or a menu. @param {KeyboardEvent} event */
export const isFree = (event) =>
  !(event.ctrlKey || event.metaKey || event.altKey || isTyping(event.target) || dialogIsOpen() || menuIsOpen() || isMeantElsewhere(event));
const dialogIsOpen = () => document.querySelector('[role="dialog"], dialog[open]') !== null;
const menuIsOpen = () => document.querySelector('[role="menu"]:not([hidden])') !== null;
/** Nobody else is to act on it. @param {Event} event */
export const swallow = (event) => {
  event.preventDefault();
  event.stopImmediatePropagation();
};

const sendHeld = () => send({ do: "keys", held: [...held] });
/** @param {Key} key */
const hold = (key) => {
  if (!held.has(key)) {
    held.add(key);
    sendHeld();
  }
};
/** @param {Key} key */
const release = (key) => {
  if (held.delete(key)) sendHeld();
};
const releaseAll = () => {
  releasePad();
  if (held.size) {
    held.clear();
    sendHeld();
  }
};

/** Ctrl K. @param {KeyboardEvent} event @returns {boolean} whether that was the key */
function findAnything(event) {
  if (event.altKey || commandOf(event) !== "palette") return false;
  swallow(event);
  if (!dialogIsOpen()) perform("palette");
  return true;
}

/** @param {KeyboardEvent} event */
function press(event) {
  if (findAnything(event)) return;
  const once = commandOf(event);
  if (once === "play") {
    if (!isSpaceFree(event) || isTaken(event)) return;
    swallow(event);
    spaceDown = true;
    if (!event.repeat) perform(once);
    return;
  }
  if (!isFree(event) || isSliding(event) || isTaken(event)) return;
  const arrow = heldArrow(event);
  if (arrow) {
    swallow(event);
    hold(arrow);
    return;
  }
  if (!once && !CAMERA_KEYS.has(event.code)) return;
  swallow(event);
  if (!once) return;
  if (event.repeat && !REPEATED.has(once)) return;
  perform(once === "step" ? nextStep() : once);
}

/** Begins to listen. */
export function listenToKeys() {
  window.addEventListener("pointerdown", () => (byPointer = true), true);
  window.addEventListener("keydown", ({ key }) => key === "Tab" && (byPointer = false), true);
  window.addEventListener("keydown", press, true);
  window.addEventListener(
    "keyup",
    (event) => {
      const arrow = heldArrow(event);
      if (arrow) {
        release(arrow);
        if (!isTyping(event.target)) swallow(event);
      } else if (spaceDown && event.code === "Space") {
        // Some browsers press a button when Space goes up.
        spaceDown = false;
        swallow(event);
      }
    },
    true,
  );
  window.addEventListener("blur", releaseAll);
  document.addEventListener("visibilitychange", releaseAll);
  setInterval(() => held.size && sendHeld(), REPEAT);
  listenToPad(hold, release);
}
