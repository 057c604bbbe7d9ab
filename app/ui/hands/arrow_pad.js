// @ts-check
/** Buttons that hold the arrow keys, for touch screens: each has the name of its key in `data-softrod-key`. */

/** @typedef {"up" | "down" | "left" | "right"} Key */

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
