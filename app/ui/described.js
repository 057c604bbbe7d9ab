// @ts-check
/** The card with the description of a body: to be read by eye, and said by a screen reader. */
import { addTeller, make, makeClose, overCanvas } from "./dialog.js";
import { say } from "../words/words.js";

/**
 * Adds the card, closed.
 *
 * @param {string} body selects what has the focus once the card is closed, if nothing had it before
 */
export function makeDescribed(body) {
  const card = make("section", "softrod-described softrod-floats");
  card.setAttribute("aria-label", say("describe-title"));
  const text = make("p", "");
  /** What had the focus before. @type {Element | null} */
  let before = null;
  /** @param {boolean} on */
  const show = (on) => {
    card.hidden = !on;
    document.documentElement.toggleAttribute("data-softrod-described", on);
  };
  const close = () => {
    const target = before && before.isConnected && before !== document.body ? before : document.querySelector(body);
    if (card.contains(document.activeElement) && target instanceof HTMLElement) target.focus();
    show(false);
  };
  card.append(text, makeClose(close, say("describe-close")));
  show(false);
  overCanvas().append(card);
  // The card is hidden while it is closed, and what is hidden is not read.
  const tell = addTeller();
  return {
    /** Whether it is there. */
    get isOpen() {
      return !card.hidden;
    },
    close,
    /** @param {string} told */
    tell(told) {
      text.textContent = told;
      tell(told);
      if (!card.contains(document.activeElement)) before = document.activeElement;
      show(true);
      card.scrollTop = 0;
    },
  };
}
