// @ts-check
/** The period and the amplitude of what swings, read off a curve; `sim/analysis/swings.py` has the derivation. */

/** Part of the curve's range by which it must go back after an extreme, or that is a ripple and none. */
const RIPPLE = 0.03;
/** How far a cycle may be from the median one, as a part of that, in what counts as swinging. */
const REGULAR = 0.25;
/** Range, relative to the largest size of a value, that counts as rest. */
const STILL = 1e-9;

/** Indices of maxima and minima in turn; both ends of the curve are none. @param {readonly number[]} values @param {number} least */
function turns(values, least) {
  const found = [];
  let [high, low] = [0, 0];
  /** @type {boolean | null} */
  let rises = null;
  for (let i = 0; i < values.length; i++) {
    if (values[i] > values[high]) high = i;
    if (values[i] < values[low]) low = i;
    if (rises !== false && values[high] - values[i] > least) {
      found.push(high);
      [rises, low] = [false, i];
    } else if (rises !== true && values[i] - values[low] > least) {
      found.push(low);
      [rises, high] = [true, i];
    }
  }
  return found.filter((i) => i > 0 && i < values.length - 1);
}

/** The extreme of the parabola through three samples. @param {readonly number[]} values @param {number} i */
function vertex(values, i) {
  const [before, here, after] = values.slice(i - 1, i + 2);
  const bend = before - 2 * here + after;
  return bend ? here - (after - before) ** 2 / (8 * bend) : here;
}

/** About what it swings: the mean of Aitken's limits; large swings have more weight. @param {number[]} extremes */
function centreOf(extremes) {
  let [sum, weight] = [0, 0];
  for (let i = 2; i < extremes.length; i++) {
    const [one, two, three] = extremes.slice(i - 2, i + 1);
    const bend = one - 2 * two + three;
    sum += Math.abs(bend) * (two - ((two - one) * (three - two)) / bend);
    weight += Math.abs(bend);
  }
  return sum / weight;
}

/** The slope of the straight line through equally spaced values, by least squares. @param {number[]} values */
function slope(values) {
  const middle = (values.length - 1) / 2;
  const mean = values.reduce((sum, value) => sum + value, 0) / values.length;
  let [up, across] = [0, 0];
  values.forEach((value, i) => {
    up += (i - middle) * (value - mean);
    across += (i - middle) ** 2;
  });
  return up / across;
}

/**
 * @param {readonly number[]} time s, ascending @param {readonly number[]} values finite, in any unit
 * @returns {{period: number, amplitude: number} | null} null where there are not two cycles, or no regular ones
 */
export function swings(time, values) {
  const size = values.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
  const reach = values.reduce((most, value) => Math.max(most, value), -Infinity) - values.reduce((least, value) => Math.min(least, value), Infinity);
  if (values.length < 8 || !(reach > STILL * size)) return null;
  const at = turns(values, RIPPLE * reach);
  if (at.length < 4) return null;
  const extremes = at.map((i) => vertex(values, i));
  const centre = centreOf(extremes);
  /** @type {number[]} */
  const moments = [];
  for (let i = at[0]; i < at[at.length - 1]; i++) {
    const [one, two] = [values[i] - centre, values[i + 1] - centre];
    if (one >= 0 !== two >= 0) moments.push(time[i] + (one / (one - two)) * (time[i + 1] - time[i]));
  }
  if (moments.length < 4) return null;
  const cycles = moments.slice(2).map((moment, i) => moment - moments[i]);
  const sorted = [...cycles].sort((a, b) => a - b);
  const half = sorted.length >> 1;
  const middle = sorted.length % 2 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2;
  if (!cycles.every((cycle) => Math.abs(cycle - middle) <= REGULAR * middle)) return null;
  return { period: 2 * slope(moments), amplitude: Math.abs(extremes[extremes.length - 1] - extremes[extremes.length - 2]) / 2 };
}
