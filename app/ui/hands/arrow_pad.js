// @ts-check
/** Buttons that hold the arrow keys, for touch screens: each has the name of its key in `data-softrod-key`. */

import { onMessage } from "../../wire/channel.js";
import { make, makeButton, overCanvas } from "../dialog.js";
import { say } from "../../words/words.js";

/** @typedef {"up" | "down" | "left" | "right"} Key */

/** Each key with its name, its place and its sign. @type {[Key, import("../../words/keys.js").Plain, string, string][]} */
const KEYS = [
  ["up", "ui-pad.up", "1 / 2", "▲"],
  ["left", "ui-pad.left", "2 / 1", "◀"],
  ["down", "ui-pad.down", "2 / 2", "▼"],
  ["right", "ui-pad.right", "2 / 3", "▶"],
];

/** Adds the pad to the page; it is shown on touch screens, with the keys that do anything in the scene. */
export function addPad() {
  const pad = make("div", "softrod-pad");
  pad.setAttribute("role", "group");
  pad.ariaLabel = say("ui-pad");
  pad.hidden = true;
  for (const [key, name, place, sign] of KEYS) {
    const button = makeButton(sign, () => {}, "");
    button.dataset.softrodKey = key;
    button.ariaLabel = say(name);
    button.style.gridArea = place;
    pad.append(button);
  }
  overCanvas().append(pad);
  onMessage("pageState", ({ arrows = [] }) => {
    pad.hidden = arrows.length === 0;
    for (const button of pad.children) button.toggleAttribute("hidden", !arrows.includes(/** @type {HTMLElement} */ (button).dataset.softrodKey ?? ""));
  });
}

/** @param {Event} event @returns {HTMLElement | null} */
const padKey = (event) =>
  event.target instanceof Element ? event.target.closest("[data-softrod-key]") : null;

/** Shows no button as pressed any more. */
export const releasePad = () => {
  for (const button of document.querySelectorAll(".softrod-on")) button.classList.remove("softrod-on");
};

/**
 * Begins to listen to the pad's buttons, wherever they are put.
 *
 * @param {(key: Key) => void} hold @param {(key: Key) => void} release what a button does while it is pressed, and after that
 */
export function listenToPad(hold, release) {
  /** @param {HTMLElement} button @param {boolean} down */
  const press = (button, down) => {
    button.classList.toggle("softrod-on", down);
    (down ? hold : release)(/** @type {Key} */ (button.dataset.softrodKey));
  };
  /** What each finger presses; the pad may be taken out of the page meanwhile. @type {Map<number, HTMLElement>} */
  const fingers = new Map();
  document.addEventListener("pointerdown", (event) => {
    const button = padKey(event);
    if (!button) return;
    event.preventDefault();
    button.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, button);
    press(button, true);
  });
  for (const kind of /** @type {const} */ (["pointerup", "pointercancel", "lostpointercapture"])) {
    document.addEventListener(kind, ({ pointerId }) => {
      const button = fingers.get(pointerId);
      if (button && fingers.delete(pointerId)) press(button, false);
    });
  }
  for (const kind of /** @type {const} */ (["keydown", "keyup"])) {
    document.addEventListener(kind, (event) => {
      const button = padKey(event);
      if (!button || (event.code !== "Space" && event.key !== "Enter")) return;
      event.preventDefault();
      press(button, kind === "keydown");
    });
  }
  // The Tab key may go on while Space is down.
  document.addEventListener("focusout", (event) => {
    const button = padKey(event);
    if (button?.classList.contains("softrod-on")) press(button, false);
  });
  document.addEventListener("contextmenu", (event) => padKey(event) && event.preventDefault());
}
