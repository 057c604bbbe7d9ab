// @ts-check
/** Strips over the bar of time: a head with words and buttons, and below it the contents of a feature. */
import { make } from "./dialog.js";

/** Strips that are spread out. On a phone the panel's sheet makes room for them, and only the latest one is shown. @type {Set<HTMLElement>} */
const spread = new Set();

/** @param {HTMLElement} strip @param {boolean} on */
function setSpread(strip, on) {
  if (spread.has(strip) !== on) {
    spread.delete(strip);
    if (on) spread.add(strip);
  }
  const latest = [...spread].at(-1);
  for (const one of document.querySelectorAll(".softrod-strip")) one.toggleAttribute("data-latest", one === latest);
  document.documentElement.toggleAttribute("data-softrod-strip", spread.size > 0);
}

/** What folds each strip that can be folded. @type {Map<HTMLElement, () => void>} */
const folds = new Map();

/** Folds the strips that can be: on a phone a control has been asked for, and the sheet with it comes back. */
export function foldStrips() {
  for (const strip of [...spread]) folds.get(strip)?.();
}

/**
 * Makes a strip, hidden at first.
 *
 * @param {string} name of its feature, part of the names of its classes
 * @param {string} label for screen readers
 */
export function makeStrip(name, label) {
  const strip = make("div", `softrod-strip softrod-floats softrod-${name}`);
  strip.setAttribute("role", "group");
  strip.ariaLabel = label;
  strip.hidden = true;
  const head = make("div", `softrod-strip-head softrod-${name}-head`);
  const says = make("span", `softrod-strip-says softrod-${name}-says`);
  const live = make("div", "softrod-tell");
  live.setAttribute("role", "status");
  head.append(says);
  strip.append(head, live);
  document.querySelector(".softrod-transport")?.before(strip);
  return {
    strip,
    head,
    says,
    /** Its text is read out by screen readers when it changes. */
    live,
    /** Shows or hides it, and sets an attribute of the page's root element accordingly. @param {boolean} on */
    show: (on) => {
      if (strip.hidden === on) setSpread(strip, on);
      strip.hidden = !on;
      document.documentElement.toggleAttribute(`data-softrod-${name}`, on);
    },
    /** Can be folded, by this. @param {() => void} fold */
    foldsBy: (fold) => void folds.set(strip, fold),
    /** Tells whether it is spread out, or only its head is there. @param {boolean} on */
    spread: (on) => setSpread(strip, on && !strip.hidden),
  };
}
