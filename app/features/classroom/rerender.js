// @ts-check
/**
 * Cards that are remade whenever the class has changed. The focus stays where it was, and nothing is remade between a
 * press and the click that follows, which its button would not get.
 */

/** Milliseconds after a release in which its click may come, however late a busy device delivers it. */
const CLICK_WITHIN = 1000;

/**
 * Watches the presses on a card.
 *
 * @param {HTMLElement} card
 * @returns {(make: () => void) => void} remakes the card at once, or after a press that is under way; the last call counts
 */
export function deferWhilePressed(card) {
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
  const release = () => soon(CLICK_WITHIN);
  const press = () => {
    clearTimeout(timer);
    isPressed = true;
  };
  card.addEventListener("pointerdown", press, true);
  card.addEventListener("click", () => soon(0)); // once all have heard it
  for (const kind of ["pointerup", "pointercancel"]) window.addEventListener(kind, release, true);
  window.addEventListener("blur", release); // the window's own: elements lose the focus during a press, too
  return (make) => {
    if (isPressed) waiting = make;
    else make();
  };
}

/** A card that is remade when what it shows has changed. */
export class Card {
  /** What it was made for. */
  #made = "";

  /** @param {HTMLElement} element @param {() => HTMLElement[]} parts makes what is in it */
  constructor(element, parts) {
    this.element = element;
    this.parts = parts;
    this.defer = deferWhilePressed(element);
  }

  /**
   * Remakes it if it is to show something else than before.
   *
   * @param {unknown} shows
   * @returns {boolean} whether it was remade, and nothing in it has the focus
   */
  show(shows) {
    const now = JSON.stringify(shows);
    if (now === this.#made) return false;
    this.#made = now;
    const focused = document.activeElement?.getAttribute("data-focus");
    this.element.replaceChildren(...this.parts());
    // It had the focus before: whoever has scrolled away from it stays there.
    return !(focused && this.focus(`[data-focus="${focused}"]`, true));
  }

  /** Moves the focus to an element, if there is one. @param {string} selector @param {boolean} [preventScroll] */
  focus(selector, preventScroll = false) {
    const element = /** @type {HTMLElement | null} */ (this.element.querySelector(selector));
    element?.focus({ preventScroll });
    return element !== null;
  }
}
