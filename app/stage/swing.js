// @ts-check
/**
 * How muscles change rest lengths and rest angles with time, by the plan of a body, as `sim/forces/muscles.py`.
 *
 * @typedef {import("./plan.js").Plan} Plan
 * @typedef {import("./plan.js").Frame} Frame
 *
 * @typedef {object} Muscle
 * @property {boolean} joint true for a joint's, false for a spring's
 * @property {number} part index of the spring or joint
 * @property {number} amplitude of a spring's a fraction, of a joint's degrees
 * @property {number} phase degrees
 * @property {boolean} pulse its wave is a pulse, not a sine
 * @property {boolean} steady it has no wave, but follows its keys
 * @property {number} perBeat waves in a beat
 * @property {number} keys that work it: 0 Left and Right, 1 Up and Down, -1 none
 */
import { SHARPNESS } from "./looks.js";

/** Numbers before the first muscle. */
const HEAD = 2;
/** Numbers of each muscle. */
const ROW = 7;

/** @param {Plan} plan */
export const countMuscles = ({ muscles }) => Math.max(0, (muscles.length - HEAD) / ROW);

/** @param {Plan} plan @param {number} k @returns {Muscle} */
export function muscleAt({ muscles }, k) {
  const [joint, part, amplitude, phase, wave, perBeat, keys] = muscles.subarray(HEAD + k * ROW, HEAD + (k + 1) * ROW);
  return { joint: joint === 1, part, amplitude, phase, pulse: wave === 1, steady: wave === 2, perBeat, keys };
}

/** Beats until a time, s. @param {Plan} plan @param {number} time */
export const beatsAt = ({ muscles: [frequency = 0, phase = 0] }, time) => frequency * time + phase / 360;

/** The effort of keys in a frame, from -1 to 1; of no keys 1. @param {Frame} frame @param {number} keys 0, 1, or -1 for none */
export const effortOf = ({ efforts }, keys) => (keys < 0 ? 1 : (efforts?.[keys] ?? 0));

/**
 * A muscle's wave in a frame; of one that keys work, with the effort of these, and backwards where that is below 0.
 *
 * @param {Plan} plan @param {Frame} frame @param {Muscle} muscle
 */
export function waveIn(plan, frame, muscle) {
  const effort = effortOf(frame, muscle.keys);
  return muscle.steady ? effort : Math.abs(effort) * waveAt(muscle, beatsAt(plan, effort < 0 ? -frame.time : frame.time));
}

/** A muscle's wave after so many beats: from -1 to 1, a pulse from 0. @param {Muscle} muscle @param {number} beats */
export function waveAt({ phase, pulse, perBeat }, beats) {
  const size = Math.sin(2 * Math.PI * (perBeat * beats + phase / 360));
  return pulse ? Math.exp(SHARPNESS * (size - 1)) : size;
}

/**
 * The effect of all muscles in a frame.
 *
 * @param {Plan} plan @param {Frame} frame
 * @returns {{stretch: Float64Array, turn: Float64Array}} the factor of each spring's rest length, and degrees that are
 *   added to each rest angle; empty where the body has no muscles
 */
export function swings(plan, frame) {
  const count = countMuscles(plan);
  const stretch = new Float64Array(count ? plan.restLength.length : 0).fill(1);
  const turn = new Float64Array(count ? plan.restAngle.length : 0);
  for (let k = 0; k < count; k++) {
    const muscle = muscleAt(plan, k);
    const swing = muscle.amplitude * waveIn(plan, frame, muscle);
    if (muscle.joint) turn[muscle.part] = swing;
    else stretch[muscle.part] = 1 + swing;
  }
  return { stretch, turn };
}
