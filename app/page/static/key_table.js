// @ts-check
/**
 * The page's keys, by what is printed on them: letters stand in other places on Dvorak and AZERTY keyboards, and a key is
 * looked for by its letter.
 */

/** What is pressed once. @type {Record<string, string>} */
export const ONCE = {
  " ": "play",
  n: "step",
  r: "reset",
  f: "follow",
  g: "plot",
  j: "second",
  p: "project",
  i: "picture",
  Escape: "pause",
  o: "gallery",
  0: "fit",
  ",": "back",
  ".": "forward",
};
/** Shows and hides the tools that change the body. */
export const EDIT = "e";
/** Holds the masses where they are while the tools are shown; else this key is one of `ONCE`. */
export const PIN = "p";
/** The tools, while they are shown. @type {Record<string, import("./editing.js").Tool>} */
export const TOOLS = { h: "hand", b: "build", k: "joint", s: "select", c: "cut" };
/** The buttons of the stopwatch. */
export const WATCH = ["t", "l"];
/** Opens the palette, with Ctrl. */
export const PALETTE = "k";

/** What the places of keys have on them on an American keyboard. @type {Record<string, string>} */
const PLACES = { Space: " ", Comma: ",", Period: "." };

/**
 * What is printed on a key, in lower case. Where that is no Latin letter (a Cyrillic or Greek one, or a key of an input
 * method), what an American keyboard has in its place.
 *
 * @param {{key: string, code: string}} event of a keyboard
 */
export function printed({ key, code }) {
  if (/^[ -~]$/.test(key)) return key.toLowerCase();
  if (key.length > 1 && !["Dead", "Process", "Unidentified"].includes(key)) return key;
  return PLACES[code] ?? (/^(?:Key([A-Z])|Digit(\d))$/.test(code) ? code.slice(-1).toLowerCase() : key);
}

/** The name of the key that does something, for tooltips. @param {string} what */
export function keyOf(what) {
  const [key = ""] = Object.entries({ ...ONCE, ...TOOLS }).find(([, does]) => does === what) ?? [];
  return key === " " ? "Space" : key.toUpperCase();
}
