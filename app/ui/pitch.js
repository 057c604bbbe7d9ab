// @ts-check
/**
 * Plots as sound: pitch by value, sides by line, a click at each passing of zero. Arithmetic only, without a page.
 *
 * The pitch goes from `LOW` at the bottom of the plot to `HIGH` at its top, by equal intervals for equal steps. An angle that
 * goes round has circular tones instead (Shepard 1964): a turn is an octave, and the components of a tone are an octave apart
 * under a fixed bell of loudness. A turn on it is the same tone, and nothing jumps at 180 degrees.
 */

/** Hz of the lowest and of the highest value of a plot. */
export const LOW = 220;
export const HIGH = 880;
/** Hz of the lowest component of a circular tone, and their number. */
export const DEEPEST = 55;
export const COMPONENTS = 6;
/** Degrees of a turn. */
const TURN = 360;

/**
 * @typedef {{pitch: number, gain: number}} Tone a pitch in Hz, and a loudness from 0 to 1
 * @typedef {import("../wire/wire.js").HeardLine} Line
 * @typedef {Pick<Line, "bottom" | "top" | "turns">} Bounds
 */

/**
 * The pitch of a value, Hz.
 *
 * @param {number} value @param {Bounds} bounds
 */
export function pitchOf(value, { bottom, top }) {
  const part = top === bottom ? 0.5 : (value - bottom) / (top - bottom);
  return LOW * (HIGH / LOW) ** Math.min(Math.max(part, 0), 1);
}

/** The components of the circular tone of an angle; the loudness of all together is 1. @param {number} degrees @returns {Tone[]} */
export function circularTones(degrees) {
  return Array.from({ length: COMPONENTS }, (_, i) => {
    const octaves = (((degrees / TURN + i) % COMPONENTS) + COMPONENTS) % COMPONENTS;
    // A component that has gone up by all octaves begins again at the bottom: it is silent at either end.
    const bell = Math.sin((Math.PI * octaves) / COMPONENTS) ** 4;
    return { pitch: DEEPEST * 2 ** octaves, gain: bell / (0.375 * COMPONENTS) };
  });
}

/** What is heard of a value; nothing where there is none. @param {number | null} value @param {Bounds} bounds @returns {Tone[]} */
export function tonesAt(value, bounds) {
  if (value === null) return [];
  return bounds.turns ? circularTones(value) : [{ pitch: pitchOf(value, bounds), gain: 1 }];
}

/** An angle as it goes on from the one before, by the shorter way. @param {number} degrees @param {number} before */
export const onward = (degrees, before) => degrees + TURN * Math.round((before - degrees) / TURN);

/** Where a line is heard, from -1 at the left to 1 at the right. @param {number} line @param {number} count of lines */
export const panOf = (line, count) => (count < 2 ? 0 : -1 + (2 * line) / (count - 1));

/** Whether zero is passed between two values; of an angle that goes round, that of any turn. @param {number} before @param {number} value @param {boolean} turns */
export function passesZero(before, value, turns) {
  if (turns) return Math.floor(before / TURN) !== Math.floor(value / TURN);
  return before < 0 ? value >= 0 : before > 0 && value <= 0;
}

/** Follows one line from value to value. */
export class Follower {
  /** @type {number | null} */
  #before = null;

  /**
   * What is heard of the next value, and whether it has passed zero.
   *
   * @param {number | null} value @param {Bounds} bounds
   * @returns {{tones: Tone[], clicks: boolean}}
   */
  next(value, bounds) {
    const before = this.#before;
    if (value !== null && before !== null && bounds.turns) value = onward(value, before);
    if (value !== null) this.#before = value;
    return { tones: tonesAt(value, bounds), clicks: value !== null && before !== null && passesZero(before, value, bounds.turns) };
  }
}

/**
 * A line as it is played from its first value to its last.
 *
 * @param {Line} line @param {number} seconds
 * @returns {{at: number, tones: Tone[], clicks: boolean}[]} each value's time from the beginning, s
 */
export function scoreOf(line, seconds) {
  const follower = new Follower();
  return line.values.map((value, i) => ({ at: (i / line.values.length) * seconds, ...follower.next(value, line) }));
}
