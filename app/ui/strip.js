// @ts-check
/** Strips over the bar of time: a head with words and buttons, and below it the contents of a feature. */
import { make } from "./dialog.js";

/**
 * Makes a strip, hidden at first.
 *
 * @param {string} name of its feature, part of the names of its classes
 * @param {string} label for screen readers
 */
export function makeStrip(name, label) {
  const strip = make("div", `softrod-strip softrod-${name}`);
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
      strip.hidden = !on;
      document.documentElement.toggleAttribute(`data-softrod-${name}`, on);
    },
  };
}
