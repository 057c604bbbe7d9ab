// @ts-check
/** Round numbers, and axes that are marked at them. */

/** Range of an axis on either side, at least, as a part of the largest value on it: its marks have different numbers. */
const MIN_PART = 2e-3;
/** Free space beyond the values of an axis on either side, as a part of their range. */
const ROOM = 0.06;
/** Relative difference by which a number counts as round in spite of its last digits. */
const ROUNDING = 1e-9;

/** The next of 1, 2, 5, 10, 20, ... at or above a positive number. @param {number} least */
export function roundUp(least) {
  const power = 10 ** Math.floor(Math.log10(least));
  return power * ([1, 2, 5].find((step) => step * power >= least * (1 - ROUNDING)) ?? 10);
}

/** The last of 1, 2, 5, 10, 20, ... at or below a positive number. @param {number} most */
export function roundDown(most) {
  const power = 10 ** Math.floor(Math.log10(most));
  return power * ([10, 5, 2].find((step) => step * power <= most * (1 + ROUNDING)) ?? 1);
}

/** Evenly spaced round numbers in a range. @param {number} low @param {number} high @param {number} count at most, but for one */
export function axisMarks(low, high, count) {
  const step = roundUp((high - low) / count);
  const first = Math.ceil(low / step);
  return Array.from({ length: Math.floor(high / step) - first + 1 }, (_, i) => Number(((first + i) * step).toPrecision(12)));
}

/** The range of an axis that shows some values, with a little room; 0 to 1 where there are none. @param {number[][]} all @returns {[low: number, high: number]} */
export function rangeOf(all) {
  let [low, high] = [Infinity, -Infinity];
  for (const values of all) {
    for (const value of values) {
      if (value < low) low = value;
      if (value > high) high = value;
    }
  }
  if (!(high >= low)) return [0, 1];
  const room = Math.max(ROOM * (high - low), MIN_PART * Math.max(Math.abs(low), Math.abs(high), 1));
  return [low - room, high + room];
}
