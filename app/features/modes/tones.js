// @ts-check
/**
 * The tones of modes: one each, all transposed by the same number of octaves, so that intervals are preserved. Arithmetic
 * only, without a page.
 */

/** Hz from which the slowest mode can be heard well. */
export const LOWEST = 110;
/** Hz beyond which a tone is left out: few loudspeakers have it, and nobody hears its pitch. */
export const HIGHEST = 7000;
/** Loudness of one mode at a full bar; several may sound together. */
const LOUDEST = 0.25;

/**
 * @typedef {object} Tone
 * @property {number} pitch Hz
 * @property {number} decay by which its amplitude falls, 1/s
 * @property {number} gain amplitude, 0..1
 */

/** Octaves by which frequencies are transposed so that the slowest can be heard; negative for high ones. @param {ArrayLike<number>} frequencies Hz, the slowest first */
export function octavesOf(frequencies) {
  const slowest = frequencies[0];
  return slowest > 0 ? Math.ceil(Math.log2(LOWEST / slowest) - 1e-9) : 0;
}

/**
 * The tones of modes.
 *
 * A mode with frequency f and damping ratio z swings f √(1 − z²) times a second, and its amplitude falls with the rate
 * 2π f z. The pitch is transposed; the decay is that of the body.
 *
 * @param {ArrayLike<number>} frequencies without damping, Hz, the slowest first
 * @param {ArrayLike<number>} dampings ratios
 * @param {ArrayLike<number>} amplitudes in those of full bars
 * @param {number} [speed] simulated seconds in a second
 * @returns {Tone[]}
 */
export function tonesOf(frequencies, dampings, amplitudes, speed = 1) {
  const up = 2 ** octavesOf(frequencies);
  return Array.from(frequencies, (frequency, i) => {
    const damping = Math.max(dampings[i] ?? 0, 0);
    const pitch = damping < 1 ? frequency * Math.sqrt(1 - damping * damping) * up : 0;
    const sounds = pitch > 0 && pitch <= HIGHEST;
    // As a full bar has the same action in each mode, its loudness is that of its speed.
    const gain = sounds && amplitudes[i] > 0 ? LOUDEST * Math.min(amplitudes[i], 1) : 0;
    return { pitch, decay: 2 * Math.PI * frequency * damping * speed, gain };
  });
}
