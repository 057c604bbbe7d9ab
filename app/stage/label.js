// @ts-check
/**
 * Finds a place for a word near a body, where neither the body nor other words are. Arithmetic only.
 *
 * @typedef {{x: number, y: number}} Point pixels of the window
 * @typedef {{left: number, right: number, top: number, bottom: number}} Box pixels of the window
 */

/** Half the width and height of a word with its margin, pixels. */
const HALF = { x: 32, y: 15 };

/** Distance of a line from the middle of a word, in its half sizes. @param {Point} word @param {Point} a @param {Point} b */
function distance(word, a, b) {
  const [ax, ay] = [(a.x - word.x) / HALF.x, (a.y - word.y) / HALF.y];
  const [dx, dy] = [(b.x - a.x) / HALF.x, (b.y - a.y) / HALF.y];
  const part = Math.max(0, Math.min(1, -(ax * dx + ay * dy) / (dx * dx + dy * dy || 1)));
  return Math.hypot(ax + part * dx, ay + part * dy);
}

/**
 * The first free place of some, or the first one if none is free.
 *
 * @param {Point[]} places of the word's middle, the best first
 * @param {ArrayLike<number>} springs two masses each
 * @param {ArrayLike<number>} masses x and y of each, pixels
 * @param {ArrayLike<number>} radii of the masses, pixels
 * @param {Box[]} taken by other words
 * @returns {number} its index
 */
export function freePlace(places, springs, masses, radii, taken) {
  /** @param {number} mass */
  const at = (mass) => ({ x: masses[2 * mass], y: masses[2 * mass + 1] });
  const found = places.findIndex((word) => {
    for (const { left, right, top, bottom } of taken) {
      if (word.x + HALF.x > left && word.x - HALF.x < right && word.y + HALF.y > top && word.y - HALF.y < bottom) return false;
    }
    for (let i = 0; i < radii.length; i += 1) {
      const { x, y } = at(i);
      const [dx, dy] = [Math.max(Math.abs(x - word.x) - HALF.x, 0), Math.max(Math.abs(y - word.y) - HALF.y, 0)];
      if (Math.hypot(dx, dy) < radii[i]) return false;
    }
    for (let i = 0; i < springs.length; i += 2) if (distance(word, at(springs[i]), at(springs[i + 1])) < 1) return false;
    return true;
  });
  return Math.max(0, found);
}
