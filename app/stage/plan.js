// @ts-check
/**
 * Reads what the server sends of a body, written by plan.py: once its parts and surroundings (a plan), then the positions of
 * its masses (frames), and which springs have yielded and broken (damage) when that changes.
 */

import { unpack } from "../wire/unpack.js";

/** @typedef {import("../wire/wire.js").Layouts["plan"]} Plan */

/** @param {Float32Array} data @returns {Plan} */
export const readPlan = (data) => unpack("plan", data);

/**
 * @typedef {object} Damage
 * @property {number} generation of the body
 * @property {Set<number>} broken the broken springs
 * @property {Float32Array} setLength px by which each rest length has moved for good; empty if none has
 * @property {Float32Array} setAngle degrees by which each rest angle has moved for good; empty if none has
 * @property {Set<number>} ghostBroken the broken springs of the ghost
 * @property {Damage} [second] of a second body
 */

/** @param {Float32Array} data @returns {Damage} */
export function readDamage(data) {
  const { generation, broken, setLength, setAngle, ghostBroken, ...second } = unpack("damage", data);
  return {
    ...{ generation, broken: new Set(broken), setLength, setAngle, ghostBroken: new Set(ghostBroken) },
    second: {
      ...{ generation, broken: new Set(second.secondBroken), ghostBroken: new Set() },
      ...{ setLength: second.secondSetLength, setAngle: second.secondSetAngle },
    },
  };
}

/** The damage of an intact body. */
export const UNHARMED = readDamage(new Float32Array([1, -1]));

/**
 * @typedef {object} Frame
 * @property {number} generation of the body
 * @property {number} time simulated seconds
 * @property {number} lengthScale factor of all rest lengths
 * @property {number} angleShift degrees added to all rest angles
 * @property {Float32Array} positions px, x and y of each mass
 * @property {Float32Array | null} ghost px, positions of the ghost
 * @property {Float32Array} [efforts] of the keys that work muscles, motors and forces, see `swing.js`
 * @property {Frame | null} [second] a second body
 */

/** @param {Float32Array} data @returns {Frame} */
export function readFrame(data) {
  const { generation, time, timeRest, lengthScale, angleShift, positions, ghost, secondMoment, secondPositions, efforts, secondEfforts } = unpack("frame", data);
  // A time is the sum of two numbers, since single precision is too coarse for long times.
  const frame = { generation, time: time + timeRest, lengthScale, angleShift, positions, ghost: ghost.length ? ghost : null, efforts };
  if (!secondMoment.length) return frame;
  const [second, scale, shift, rest = 0] = secondMoment;
  return { ...frame, second: { generation, time: second + rest, lengthScale: scale, angleShift: shift, positions: secondPositions, ghost: null, efforts: secondEfforts } };
}

/**
 * Interpolates between frames.
 *
 * @param {Frame} one @param {Frame} two
 * @param {number} part of the way from one to two
 * @returns {Frame}
 */
export function between(one, two, part) {
  /** @param {number} a @param {number} b */
  const mix = (a, b) => a + (b - a) * part;
  /** @param {Float32Array} a @param {Float32Array} b */
  const mixed = (a, b) => a.map((value, i) => mix(value, b[i]));
  return {
    ...two,
    time: mix(one.time, two.time),
    lengthScale: mix(one.lengthScale, two.lengthScale),
    angleShift: mix(one.angleShift, two.angleShift),
    positions: mixed(one.positions, two.positions),
    ghost: one.ghost && two.ghost ? mixed(one.ghost, two.ghost) : two.ghost,
    second: one.second && two.second && one.second.positions.length === two.second.positions.length ? between(one.second, two.second, part) : two.second,
  };
}
