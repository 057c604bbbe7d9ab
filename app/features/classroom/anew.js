// @ts-check
/** When a card may be made anew: not between a press on it and the click that follows, which its button would not hear of. */

/** Milliseconds after a release for which its click is waited for, however late a busy device has it. */
const CLICKS = 1000;

/**
 * Looks after the presses on a card.
 *
 * @param {HTMLElement} card
 * @returns {(make: () => void) => void} has the card made anew, at once or after the press that lasts; the last one counts
 */
export function betweenPresses(card) {
  let isPressed = false, timer = 0;
  /** @type {(() => void) | null} */
  let waiting = null;
  const go = () => {
    clearTimeout(timer);
    isPressed = false;
    waiting?.();
    waiting = null;
  };
  /** @param {number} after milliseconds */
  const soon = (after) => {
    clearTimeout(timer);
    if (isPressed) timer = window.setTimeout(go, after);
  };
  const release = () => soon(CLICKS);
  card.addEventListener(
    "pointerdown",
    () => {
      clearTimeout(timer);
      isPressed = true;
    },
    true,
  );
  card.addEventListener("click", () => soon(0)); // once all have heard it
  for (const kind of ["pointerup", "pointercancel"]) window.addEventListener(kind, release, true);
  window.addEventListener("blur", release); // the window's own: elements lose the focus during a press, too
  return (make) => {
    if (isPressed) waiting = make;
    else make();
  };
}
