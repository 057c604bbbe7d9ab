// @ts-check
/**
 * How muscles change rest lengths and rest angles with time, by the plan of a body, as `sim/forces/muscles.py`.
 *
 * @typedef {import("./plan.js").Plan} Plan
 *
 * @typedef {object} Muscle
 * @property {boolean} joint true for a joint's, false for a spring's
 * @property {number} part index of the spring or joint
 * @property {number} amplitude of a spring's a fraction, of a joint's degrees
 * @property {number} phase degrees
 * @property {boolean} pulse its wave is a pulse, not a sine
 * @property {number} perBeat waves in a beat
 */
import { SHARPNESS } from "./looks.js";

/** Numbers before the first muscle. */
const HEAD = 2;
/** Numbers of each muscle. */
const ROW = 6;

/** @param {Plan} plan */
export const countMuscles = ({ muscles }) => Math.max(0, (muscles.length - HEAD) / ROW);

/** @param {Plan} plan @param {number} k @returns {Muscle} */
export function muscleAt({ muscles }, k) {
  const [joint, part, amplitude, phase, pulse, perBeat] = muscles.subarray(HEAD + k * ROW, HEAD + (k + 1) * ROW);
  return { joint: joint === 1, part, amplitude, phase, pulse: pulse === 1, perBeat };
}

/** Beats until a time, s. @param {Plan} plan @param {number} time */
export const beatsAt = ({ muscles: [frequency = 0, phase = 0] }, time) => frequency * time + phase / 360;

/** A muscle's wave after so many beats: from -1 to 1, a pulse from 0. @param {Muscle} muscle @param {number} beats */
export function waveAt({ phase, pulse, perBeat }, beats) {
  const size = Math.sin(2 * Math.PI * (perBeat * beats + phase / 360));
  return pulse ? Math.exp(SHARPNESS * (size - 1)) : size;
}

/**
 * The effect of all muscles at a time.
 *
 * @param {Plan} plan @param {number} time s
 * @returns {{stretch: Float64Array, turn: Float64Array}} the factor of each spring's rest length, and degrees that are
 *   added to each rest angle; empty where the body has no muscles
 */
export function swings(plan, time) {
  const count = countMuscles(plan);
  const stretch = new Float64Array(count ? plan.restLength.length : 0).fill(1);
  const turn = new Float64Array(count ? plan.restAngle.length : 0);
  const beats = beatsAt(plan, time);
  for (let k = 0; k < count; k++) {
    const muscle = muscleAt(plan, k);
    const swing = muscle.amplitude * waveAt(muscle, beats);
    if (muscle.joint) turn[muscle.part] = swing;
    else stretch[muscle.part] = 1 + swing;
  }
  return { stretch, turn };
}
