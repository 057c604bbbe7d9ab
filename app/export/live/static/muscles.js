// @ts-check
/**
 * The waves of muscles, which move rest lengths and rest angles; `sim/forces/muscles.py` has the derivation.
 *
 * @typedef {[part: number, amplitude: number, perBeat: number, phase: number, isPulse: 0 | 1]} Muscle of a spring, whose rest
 *   length is multiplied by 1 + amplitude times the wave, or of a joint, to whose rest angle that is added, degrees; waves in
 *   a beat; the phase, degrees
 * @typedef {{frequency: number, phase: number, springs: Muscle[], joints: Muscle[]}} Muscles the beat of all muscles: Hz, and
 *   degrees at time zero
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

/** Another tempo, Hz, from a time on, s, at which the beat is where it was. @param {Muscles} beat @param {number} frequency @param {number} t */
export function setTempo(beat, frequency, t) {
  const phase = beat.phase + 360 * (beat.frequency - frequency) * t;
  beat.phase = phase - 360 * Math.floor(phase / 360);
  beat.frequency = frequency;
}
