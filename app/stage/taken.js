// @ts-check
/** The paper of the canvas that is taken: by what stands over it, and by words that are drawn there. */

/** @typedef {import("./label.js").Box} Box */

/** What stands over the canvas. */
const OVER =
  ".softrod-hud, .softrod-dock, .softrod-panel, .softrod-over > button, .softrod-menu, .softrod-box, .softrod-box-lid, .softrod-edit, .softrod-edit-bar, .softrod-pad, .softrod-strip, .softrod-notice";
/** Milliseconds after which its places are looked up again. */
const OLD = 200;

/** @type {Map<string, Box>} */
const words = new Map();
/** @type {Box[]} */
let over = [];
let lookedAt = -Infinity;

/** Takes the place of a word, or gives it back (null). @param {string} name @param {Box | null} box */
export function takePaper(name, box) {
  if (box) words.set(name, box);
  else words.delete(name);
}

/** All that is taken by others. @param {string} name of the word that asks @returns {Box[]} */
export function takenPaper(name) {
  const now = performance.now();
  if (now - lookedAt > OLD) {
    over = [...document.querySelectorAll(OVER)].map((element) => element.getBoundingClientRect()).filter(({ width }) => width > 0);
    lookedAt = now;
  }
  return [...over, ...[...words].filter(([other]) => other !== name).map(([, box]) => box)];
}
