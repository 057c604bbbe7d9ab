// @ts-check
/**
 * Finds a place for a word near a body, where neither the body nor other words are. Arithmetic only.
 *
 * @typedef {{x: number, y: number}} Point pixels of the window
 * @typedef {{left: number, right: number, top: number, bottom: number}} Box pixels of the window
 */

/** Half the width and height of an angle with its margin, pixels. */
const HALF = { x: 32, y: 15 };

/** Distance of a line from the middle of a word, in its half sizes. @param {Point} word @param {Point} half @param {Point} a @param {Point} b */
function distance(word, half, a, b) {
  const [ax, ay] = [(a.x - word.x) / half.x, (a.y - word.y) / half.y];
  const [dx, dy] = [(b.x - a.x) / half.x, (b.y - a.y) / half.y];
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
 * @param {Point} half the width and height of the word with its margin, pixels
 * @returns {number} its index
 */
export function freePlace(places, springs, masses, radii, taken, half = HALF) {
  /** @param {number} mass */
  const at = (mass) => ({ x: masses[2 * mass], y: masses[2 * mass + 1] });
  const found = places.findIndex((word) => {
    for (const { left, right, top, bottom } of taken) {
      if (word.x + half.x > left && word.x - half.x < right && word.y + half.y > top && word.y - half.y < bottom) return false;
    }
    for (let i = 0; i < radii.length; i += 1) {
      const { x, y } = at(i);
      const [dx, dy] = [Math.max(Math.abs(x - word.x) - half.x, 0), Math.max(Math.abs(y - word.y) - half.y, 0)];
      if (Math.hypot(dx, dy) < radii[i]) return false;
    }
    for (let i = 0; i < springs.length; i += 2) if (distance(word, half, at(springs[i]), at(springs[i + 1])) < 1) return false;
    return true;
  });
  return Math.max(0, found);
}
