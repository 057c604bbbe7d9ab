// @ts-check
/** Keys and the arrow pad: what is held, and what is pressed once. */
import { fit } from "./camera.js";
import { onTold, send, told } from "./channel.js";
import { toggleProjector } from "./looks.js";
import { ask } from "./mail.js";
import { takePicture } from "./picture.js";
import { nextStep } from "./transport.js";

/** @type {Record<string, string>} */
const ARROWS = { ArrowUp: "U", ArrowDown: "D", ArrowLeft: "L", ArrowRight: "R" };
/** @type {Record<string, string>} */
const ONCE = {
  Space: "play",
  KeyN: "step",
  KeyR: "reset",
  KeyF: "follow",
  KeyG: "plot",
  KeyJ: "second",
  KeyP: "project",
  KeyI: "picture",
  Escape: "pause",
  KeyO: "gallery",
  Digit0: "fit",
  Comma: "back",
  Period: "forward",
};
/** What Space presses, once it was reached with the Tab key. */
const PRESSED = "button:focus-visible, input:focus-visible, [role=tab]:focus-visible, [role=button]:focus-visible";
/** What a key that is held down does again and again. */
const REPEATED = new Set(["step", "back", "forward"]);
/** With these viser would move the camera. */
const CAMERA_KEYS = new Set(["KeyW", "KeyA", "KeyS", "KeyD", "KeyQ", "KeyE"]);
/** Milliseconds between two reports of keys that are held; the server forgets those of which it hears nothing. */
const REPEAT = 150;

/** @type {Set<string>} */
const held = new Set();

/** @param {EventTarget | null} target */
const isTyping = (target) =>
  target instanceof HTMLElement &&
  (target.isContentEditable ||
    target.tagName === "TEXTAREA" ||
    target.tagName === "SELECT" ||
    (target instanceof HTMLInputElement && !["range", "checkbox", "radio", "button"].includes(target.type)));
/** A slider that was reached with the Tab key takes the arrows for itself. @param {EventTarget | null} target */
const isSlider = (target) =>
  target instanceof HTMLElement && target.matches('[role="slider"]:focus-visible, input[type="range"]:focus-visible');
/** While the body or an instrument has the focus, it takes arrows and Space. @param {KeyboardEvent} event */
const isForBody = ({ target, code, key }) =>
  target instanceof Element && target.matches(".softrod-body, .softrod-grip") && (key in ARROWS || code === "Space");
/** Whether a key acts on the page, and not on what is typed into or on a dialog. @param {KeyboardEvent} event */
export const isFree = ({ target, ctrlKey, metaKey, altKey }) =>
  !(ctrlKey || metaKey || altKey || isTyping(target) || dialogIsOpen());
const dialogIsOpen = () => document.querySelector('[role="dialog"], dialog[open]') !== null;
/** Nobody else is to act on it. @param {Event} event */
const swallow = (event) => {
  event.preventDefault();
  event.stopImmediatePropagation();
};

const sendHeld = () => send("keys", [...held].join(""));
/** @param {string} key */
const hold = (key) => {
  if (!held.has(key)) {
    held.add(key);
    sendHeld();
  }
};
/** @param {string} key */
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
 * Ctrl K. viser's palette does not hear it while a control has the focus, so the key is pressed for it once more
 * on the page itself. The control gets the focus back from the palette.
 *
 * @param {KeyboardEvent} event
 * @returns {boolean} whether that was the key
 */
function openPalette(event) {
  if (event.code !== "KeyK" || !(event.ctrlKey || event.metaKey) || event.altKey || event.shiftKey) return false;
  if (event.target === document.body) return true; // viser hears it
  swallow(event);
  const { key, code, ctrlKey, metaKey } = event;
  const again = new KeyboardEvent("keydown", { key, code, ctrlKey, metaKey, bubbles: true, cancelable: true });
  if (!dialogIsOpen()) document.body.dispatchEvent(again);
  return true;
}

/** @param {KeyboardEvent} event */
function press(event) {
  if (openPalette(event)) return;
  if (!isFree(event) || isSlider(event.target) || isForBody(event)) return;
  const arrow = ARROWS[event.key];
  if (arrow) {
    swallow(event);
    hold(arrow);
    return;
  }
  if (CAMERA_KEYS.has(event.code)) {
    swallow(event);
    return;
  }
  const once = ONCE[event.code];
  if (!once) return;
  // What was reached with the Tab key is pressed with Space, as everywhere.
  if (once === "play" && document.activeElement?.matches(PRESSED)) return;
  swallow(event);
  if (event.repeat && !REPEATED.has(once)) return;
  if (once === "fit") fit(true);
  else if (once === "project") toggleProjector();
  else if (once === "gallery") ask({ do: "offer", what: "gallery" });
  else if (once === "picture") void takePicture();
  else if (once === "step") send("do", event.shiftKey ? "steps" : nextStep());
  else send("do", once);
}

/** @param {Event} event @returns {HTMLElement | null} */
const padKey = (event) =>
  event.target instanceof Element ? event.target.closest("[data-softrod-key]") : null;

/** @param {HTMLElement} button @param {boolean} down */
const pressPad = (button, down) => {
  button.classList.toggle("softrod-on", down);
  const key = button.dataset.softrodKey ?? "";
  if (down) hold(key);
  else release(key);
};

function listenToPad() {
  /** What each finger presses; the pad may be taken out of the page meanwhile. @type {Map<number, HTMLElement>} */
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
  // The Tab key may go on while Space is down.
  document.addEventListener("focusout", (event) => {
    const button = padKey(event);
    if (button?.classList.contains("softrod-on")) pressPad(button, false);
  });
  document.addEventListener("contextmenu", (event) => padKey(event) && event.preventDefault());
}

/** Once something is chosen from a box, keys act on the scene and not on the box. */
function leaveChooser() {
  let scene = told().scene;
  onTold(() => {
    if (told().scene === scene) return;
    scene = told().scene;
    const focused = document.activeElement;
    if (focused instanceof HTMLElement && focused.matches('[aria-haspopup="listbox"]')) focused.blur();
  });
}

/** Begins to listen. */
export function listenToKeys() {
  leaveChooser();
  window.addEventListener("keydown", press, true);
  window.addEventListener(
    "keyup",
    (event) => {
      const arrow = ARROWS[event.key];
      if (arrow) {
        release(arrow);
        if (!isTyping(event.target)) swallow(event);
      }
    },
    true,
  );
  window.addEventListener("blur", releaseAll);
  document.addEventListener("visibilitychange", releaseAll);
  setInterval(() => held.size && sendHeld(), REPEAT);
  listenToPad();
}
