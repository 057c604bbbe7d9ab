// @ts-check
/** Where lines of text start and end in the window: what lies over the canvas is mirrored as the panel is. */
import { direction } from "../words/words.js";

/** Whether lines start at the right. */
export const startsRight = direction === "rtl";

/** How far a box is from the sides of the window where lines start and end, px. @param {{left: number, right: number}} box */
export function sidesOf({ left, right }) {
  const beyond = window.innerWidth - right;
  return startsRight ? { start: beyond, end: left } : { start: left, end: beyond };
}
