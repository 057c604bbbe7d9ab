// @ts-check
/** The icons of a class's pages: strokes in 24 by 24, since not every font has such letters. */
import { SVG } from "../../stage/svg.js";

const ICONS = {
  hand: "M7 12V6M10.5 11V3.5M14 11V4.5M17.5 12V7.5V16a6 6 0 0 1-6 6c-3.5 0-5-2.5-8-7.5L5.5 13 7 15",
  star: "M12 3l2.8 5.9 6.2.8-4.6 4.4 1.2 6.4L12 17.4 6.4 20.5l1.2-6.4L3 9.7l6.2-.8z",
};

/** One of them, which says nothing to a screen reader. @param {keyof typeof ICONS} name */
export function icon(name) {
  const svg = document.createElementNS(SVG, "svg");
  svg.setAttribute("viewBox", "0 0 24 24");
  svg.setAttribute("aria-hidden", "true");
  svg.classList.add("softrod-class-icon");
  const path = document.createElementNS(SVG, "path");
  path.setAttribute("d", ICONS[name]);
  svg.append(path);
  return svg;
}
