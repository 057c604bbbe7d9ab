// @ts-check
/**
 * The waves of muscles, which move rest lengths and rest angles; `sim/forces/muscles.py` has the derivation.
 *
 * @typedef {[part: number, amplitude: number, perBeat: number, phase: number, isPulse: 0 | 1]} Muscle of a spring, whose rest
 *   length is multiplied by 1 + amplitude times the wave, or of a joint, to whose rest angle that is added, degrees; waves in
 *   a beat; the phase, degrees
 * @typedef {{frequency: number, phase: number, springs: Muscle[], joints: Muscle[]}} Muscles the beat of all muscles: Hz, and
 *   degrees at time zero
 * // ifdef HAS_EFFORTS
 * @typedef {[part: number, amplitude: number, perBeat: number, phase: number, kind: number, keys: number]} KeyedMuscle such a
 *   row of a body with muscles that keys work: the kind is 0 for a sine, 1 for a pulse, 2 for a steady muscle; of keys
 *   the index in `steered`, or -1
 * // endif
 */

/** Of a pulse exp(SHARPNESS (sin p - 1)). */
const SHARPNESS = 4;

/** The amplitude of a muscle times its wave at a time, s. @param {Muscles} beat @param {Muscle} muscle @param {number} t */
export function wave(beat, muscle, t) {
  // The same sums as in `sim`, so that the last digits are the same.
  const rate = 2 * Math.PI * muscle[2] * beat.frequency;
  const size = Math.sin(rate * t + (muscle[2] * beat.phase + muscle[3]) * (Math.PI / 180));
  return muscle[1] * (muscle[4] ? Math.exp(SHARPNESS * (size - 1)) : size);
}

// ifdef HAS_EFFORTS
const STEADY = 2;
/** The time constant of an effort, s. */
const RISE = 0.05;

/** The same of a muscle that keys may work. @param {Muscles} beat @param {Muscle} muscle @param {number} t @param {ArrayLike<number>} efforts of keys, see `Body` */
export function workedWave(beat, muscle, t, efforts) {
  const [, amplitude, , , kind, keys] = /** @type {KeyedMuscle} */ (/** @type {unknown} */ (muscle));
  if (!(keys >= 0)) return wave(beat, muscle, t);
  const effort = efforts[keys];
  return kind === STEADY ? effort * amplitude : Math.abs(effort) * wave(beat, muscle, effort < 0 ? -t : t);
}

/** Let efforts go on towards what keys do. @param {Float64Array} efforts @param {number[]} steered @param {number} h for how long, s */
export function exert(efforts, steered, h) {
  const rest = Math.exp(-h / RISE);
  steered.forEach((goal, k) => (efforts[k] = goal + (efforts[k] - goal) * rest));
}

// endif
/** Another tempo, Hz, from a time on, s, at which the beat is where it was. @param {Muscles} beat @param {number} frequency @param {number} t */
export function setTempo(beat, frequency, t) {
  const phase = beat.phase + 360 * (beat.frequency - frequency) * t;
  beat.phase = phase - 360 * Math.floor(phase / 360);
  beat.frequency = frequency;
}
