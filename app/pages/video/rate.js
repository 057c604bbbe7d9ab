// @ts-check
/* How many frames a second a video has, from the times of some that were played. */

/** Differences of times that are needed at least. */
const ENOUGH = 4;

/**
 * Frames a second, to a hundredth; null where there are too few times. A frame that was missed leaves a
 * difference of several frames.
 * @param {number[]} times of frames, s, in any order, each at least once
 */
export function rateOf(times) {
  const sorted = [...new Set(times)].sort((a, b) => a - b);
  const steps = sorted.slice(1).map((time, i) => time - sorted[i]);
  if (steps.length < ENOUGH) return null;
  // A short one, but not the shortest: times are rounded, and a phone's frames are not quite even.
  const short = [...steps].sort((a, b) => a - b)[Math.floor(steps.length / 4)];
  const count = steps.reduce((sum, step) => sum + Math.max(1, Math.round(step / short)), 0);
  const rate = count / (sorted[sorted.length - 1] - sorted[0]);
  return Number.isFinite(rate) && rate >= 1 && rate <= 1000 ? Math.round(100 * rate) / 100 : null;
}
