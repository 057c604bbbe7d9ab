// @ts-check
/** When a card may be made anew: not between a press on it and the click that follows, which its button would not hear of. */

/** Milliseconds after a release within which its click comes, also that of a finger. */
const CLICKS = 100;

/**
 * Looks after the presses on a card.
 *
 * @param {HTMLElement} card
 * @returns {(make: () => void) => void} has the card made anew, at once or after the press that lasts; the last one counts
 */
export function betweenPresses(card) {
  let isPressed = false;
  /** @type {(() => void) | null} */
  let waiting = null;
  const go = () => {
    isPressed = false;
    waiting?.();
    waiting = null;
  };
  card.addEventListener("pointerdown", () => (isPressed = true), true);
  const release = () => isPressed && setTimeout(go, CLICKS);
  for (const kind of ["pointerup", "pointercancel"]) window.addEventListener(kind, release, true);
  window.addEventListener("blur", release); // the window's own: elements lose the focus during a press, too
  return (make) => {
    if (isPressed) waiting = make;
    else make();
  };
}
