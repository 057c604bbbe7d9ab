// @ts-check
/** The strips over the bar of time: a head with words and buttons, and below it what a feature has. */
import { make } from "./dialog.js";

/**
 * A strip, which is hidden at first.
 *
 * @param {string} name of its feature, which is in the names of its classes
 * @param {string} label as a screen reader says it
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
    /** What a screen reader reads out when it changes. */
    live,
    /** Shows or hides it; the page's root element has an attribute meanwhile. @param {boolean} on */
    show: (on) => {
      strip.hidden = !on;
      document.documentElement.toggleAttribute(`data-softrod-${name}`, on);
    },
  };
}
