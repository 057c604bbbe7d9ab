// @ts-check
/** Keys and the arrow pad: what is held, and what is pressed once. */
import { fit } from "./camera.js";
import { project } from "./looks.js";
import { onTold, send, told } from "./channel.js";
import { nextStep } from "./transport.js";

/** @type {Record<string, string>} */
const ARROWS = { ArrowUp: "U", ArrowDown: "D", ArrowLeft: "L", ArrowRight: "R" };
/** @type {Record<string, string>} */
const ONCE = { Space: "play", KeyN: "step", KeyR: "reset", KeyF: "follow", Escape: "pause", Digit0: "fit",
  Comma: "back", Period: "forward", KeyJ: "second", KeyP: "project" };
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
/** While the body has the focus, it takes arrows, Space and Enter. @param {KeyboardEvent} event */
const isBodys = ({ target, code, key }) =>
  target instanceof HTMLElement && target.classList.contains("softrod-body") && (key in ARROWS || code === "Space" || key === "Enter");
const dialogIsOpen = () => document.querySelector('[role="dialog"]') !== null;
/** @param {Event} event */
const keep = (event) => {
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
  if (held.size) {
    held.clear();
    sendHeld();
  }
};

/** @param {KeyboardEvent} event */
function press(event) {
  if (event.ctrlKey || event.metaKey || event.altKey || isTyping(event.target) || dialogIsOpen()) return;
  const arrow = ARROWS[event.key];
  if (isSlider(event.target) || isBodys(event)) return;
  if (arrow) {
    keep(event);
    hold(arrow);
    return;
  }
  if (CAMERA_KEYS.has(event.code)) {
    keep(event);
    return;
  }
  const once = ONCE[event.code];
  if (!once) return;
  // What was reached with the Tab key is pressed with Space, as everywhere.
  if (once === "play" && document.activeElement?.matches(PRESSED)) return;
  keep(event);
  if (event.repeat && !REPEATED.has(once)) return;
  if (once === "fit") fit();
  else if (once === "project") project();
  else if (once === "step") send("do", event.shiftKey ? "steps" : nextStep());
  else send("do", once);
}

/** @param {Event} event @returns {HTMLElement | null} */
const padKey = (event) =>
  event.target instanceof Element ? event.target.closest("[data-softrod-key]") : null;

function listenToPad() {
  document.addEventListener("pointerdown", (event) => {
    const button = padKey(event);
    if (!button) return;
    event.preventDefault();
    button.setPointerCapture(event.pointerId);
    button.classList.add("softrod-on");
    hold(button.dataset.softrodKey ?? "");
  });
  for (const kind of ["pointerup", "pointercancel", "lostpointercapture"]) {
    document.addEventListener(kind, (event) => {
      const button = padKey(event);
      if (!button) return;
      button.classList.remove("softrod-on");
      release(button.dataset.softrodKey ?? "");
    });
  }
  for (const kind of ["keydown", "keyup"]) {
    document.addEventListener(kind, (event) => {
      const button = padKey(event);
      if (!button || !(event instanceof KeyboardEvent) || (event.code !== "Space" && event.key !== "Enter")) return;
      event.preventDefault();
      button.classList.toggle("softrod-on", kind === "keydown");
      if (kind === "keydown") hold(button.dataset.softrodKey ?? "");
      else release(button.dataset.softrodKey ?? "");
    });
  }
  document.addEventListener("contextmenu", (event) => padKey(event) && event.preventDefault());
}

/** A scene was chosen: its keys shall act on it, not on the box that it was chosen from. */
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
        if (!isTyping(event.target)) keep(event);
      }
    },
    true,
  );
  window.addEventListener("blur", releaseAll);
  document.addEventListener("visibilitychange", releaseAll);
  setInterval(() => held.size && sendHeld(), REPEAT);
  listenToPad();
}
