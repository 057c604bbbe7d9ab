// @ts-check
/** Keys and the arrow pad: arrows that are held, and commands of single presses. */
import { onMessage, pageState, send } from "../../wire/channel.js";
import { commandOf } from "./key_table.js";
import { perform } from "../../wire/perform.js";
import { nextStep } from "../clock.js";
import { NUMBER_BOX } from "../viser/widgets.js";

/** @typedef {import("../../wire/wire.js").Keys["held"][number]} Key */
/** @type {Record<string, Key>} */
const ARROWS = { ArrowUp: "up", ArrowDown: "down", ArrowLeft: "left", ArrowRight: "right" };
/** Elements that Space presses if they were focused by keys. */
const PRESSED = "button, input, [role=tab], [role=button]";
/** Elements that Space is typed into or opens. */
const TEXTS = "textarea, select, [contenteditable], input:not([type]), input[type=text], input[type=search], input[type=url]";
/** Commands that are repeated while their key is held. */
const REPEATED = new Set(["step", "steps", "back", "forward"]);
/** Codes of the keys by which viser would move the camera. */
const CAMERA_KEYS = new Set(["KeyW", "KeyA", "KeyS", "KeyD", "KeyQ", "KeyE"]);
/** The key that opens viser's palette, with Ctrl. */
const PALETTE = "k";
/** Milliseconds between two reports of held keys; the server releases those that are not reported. */
const REPORT_EVERY = 150;

/** @type {Set<Key>} */
const held = new Set();
/** True if the focus was last moved by a click or a touch, not by the Tab key. */
let byPointer = false;
/** True while Space is down and has played or paused. */
let spaceDown = false;

/** @param {EventTarget | null} target */
const isTyping = (target) =>
  target instanceof HTMLElement &&
  (target.isContentEditable ||
    target.tagName === "TEXTAREA" ||
    target.tagName === "SELECT" ||
    (target instanceof HTMLInputElement && !["range", "checkbox", "radio", "button"].includes(target.type)));
/** True for a slider focused by keys, which uses the arrows itself; for the bars of modes see `isTaken`. @param {EventTarget | null} target */
const isSlider = (target) =>
  target instanceof HTMLElement && target.matches('[role="slider"]:not(.softrod-mode):focus-visible, input[type="range"]:focus-visible');
/**
 * True if the focused element uses a key itself: arrows and Space for the body, an instrument, the mark of a muscle or the
 * bar of a mode, Esc for the open box of instruments.
 *
 * @param {KeyboardEvent} event
 */
function isTaken({ target, code, key }) {
  if (!(target instanceof Element)) return false;
  if (key === "Escape") return target.closest(".softrod-box[data-open]") !== null;
  if (target.matches(".softrod-mode")) return (key in ARROWS && target.matches(":focus-visible")) || code === "Space";
  if (target.matches(".softrod-steps button")) return key === "ArrowUp" || key === "ArrowDown";
  if (target.matches(".softrod-muscle")) return key in ARROWS || code === "Space";
  return target.matches(".softrod-body, .softrod-grip, .softrod-own-grip") && (key in ARROWS || code === "Space");
}
/**
 * True if Space plays or pauses rather than presses or types something. After a click it does wherever the focus is,
 * except in texts and open lists. Browsers match `:focus-visible` as soon as any key is pressed, so it cannot be used here.
 *
 * @param {KeyboardEvent} event
 */
function isSpaceFree({ target, ctrlKey, metaKey, altKey }) {
  if (ctrlKey || metaKey || altKey || dialogIsOpen() || menuIsOpen()) return false;
  if (!(target instanceof Element)) return true;
  if (target.matches(`${NUMBER_BOX} input`)) return true; // no number has a space
  if (target.matches('[aria-haspopup="listbox"]')) return byPointer && target.ariaExpanded !== "true";
  if (target.matches(TEXTS)) return false;
  return byPointer || !target.matches(PRESSED);
}
/** True if a key acts on the page, not on a text, a dialog or a menu. @param {KeyboardEvent} event */
export const isFree = ({ target, ctrlKey, metaKey, altKey }) =>
  !(ctrlKey || metaKey || altKey || isTyping(target) || dialogIsOpen() || menuIsOpen());
const dialogIsOpen = () => document.querySelector('[role="dialog"], dialog[open]') !== null;
const menuIsOpen = () => document.querySelector('[role="menu"]:not([hidden])') !== null;
/** Stops an event for everybody else. @param {Event} event */
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
  for (const button of document.querySelectorAll(".softrod-on")) button.classList.remove("softrod-on");
  if (held.size) {
    held.clear();
    sendHeld();
  }
};

/**
 * Opens the palette with Ctrl K. viser ignores that key while a control has the focus, so it is dispatched again on the
 * body of the page. The palette returns the focus to the control.
 *
 * @param {KeyboardEvent} event
 * @returns {boolean} true if that was the key
 */
function openPalette(event) {
  if (commandOf(event, "own") !== "palette" || event.altKey || event.shiftKey) return false;
  if (event.target === document.body && event.key === PALETTE && event.code === "KeyK") return true; // viser handles it
  swallow(event);
  const { ctrlKey, metaKey } = event;
  const pressed = { key: PALETTE, code: "KeyK", ctrlKey, metaKey };
  const again = new KeyboardEvent("keydown", { ...pressed, bubbles: true, cancelable: true });
  if (!dialogIsOpen()) document.body.dispatchEvent(again);
  return true;
}

/** @param {KeyboardEvent} event */
function press(event) {
  if (openPalette(event)) return;
  const once = commandOf(event);
  if (once === "play") {
    if (!isSpaceFree(event) || isTaken(event)) return;
    swallow(event);
    spaceDown = true;
    if (!event.repeat) perform(once);
    return;
  }
  if (!isFree(event) || isSlider(event.target) || isTaken(event)) return;
  const arrow = ARROWS[event.key];
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

/** @param {Event} event @returns {HTMLElement | null} */
const padKey = (event) =>
  event.target instanceof Element ? event.target.closest("[data-softrod-key]") : null;

/** @param {HTMLElement} button @param {boolean} down */
const pressPad = (button, down) => {
  button.classList.toggle("softrod-on", down);
  const key = /** @type {Key} */ (button.dataset.softrodKey);
  if (down) hold(key);
  else release(key);
};

function listenToPad() {
  /** Buttons by the fingers that press them; the pad may be removed meanwhile. @type {Map<number, HTMLElement>} */
  const fingers = new Map();
  document.addEventListener("pointerdown", (event) => {
    const button = padKey(event);
    if (!button) return;
    event.preventDefault();
    button.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, button);
    pressPad(button, true);
  });
  for (const kind of /** @type {const} */ (["pointerup", "pointercancel", "lostpointercapture"])) {
    document.addEventListener(kind, ({ pointerId }) => {
      const button = fingers.get(pointerId);
      if (button && fingers.delete(pointerId)) pressPad(button, false);
    });
  }
  for (const kind of /** @type {const} */ (["keydown", "keyup"])) {
    document.addEventListener(kind, (event) => {
      const button = padKey(event);
      if (!button || (event.code !== "Space" && event.key !== "Enter")) return;
      event.preventDefault();
      pressPad(button, kind === "keydown");
    });
  }
  // The Tab key may move the focus while Space is down.
  document.addEventListener("focusout", (event) => {
    const button = padKey(event);
    if (button?.classList.contains("softrod-on")) pressPad(button, false);
  });
  document.addEventListener("contextmenu", (event) => padKey(event) && event.preventDefault());
}

/** Takes the focus from the list of scenes once a scene is chosen, so that keys act on the body. */
function leaveChooser() {
  let scene = pageState().scene;
  onMessage("pageState", () => {
    if (pageState().scene === scene) return;
    scene = pageState().scene;
    const focused = document.activeElement;
    if (focused instanceof HTMLElement && focused.matches('[aria-haspopup="listbox"]')) focused.blur();
  });
}

/** Begins to listen. */
export function listenToKeys() {
  leaveChooser();
  window.addEventListener("pointerdown", () => (byPointer = true), true);
  window.addEventListener("keydown", ({ key }) => key === "Tab" && (byPointer = false), true);
  window.addEventListener("keydown", press, true);
  window.addEventListener(
    "keyup",
    (event) => {
      const arrow = ARROWS[event.key];
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
  setInterval(() => held.size && sendHeld(), REPORT_EVERY);
  listenToPad();
}
