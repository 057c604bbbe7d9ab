// @ts-check
/**
 * What the server sends of a body: once, what it is made of and what surrounds it (a plan), then where its masses
 * are (frames), and what has yielded and broken of it (damage) when that changes. All are written by plan.py.
 */

/**
 * @typedef {object} Plan
 * @property {number} generation which body this is; frames carry the same number
 * @property {number} scale from px to the page's world
 * @property {number} x the middle of the scene's frame, px
 * @property {number} y
 * @property {number} flip -1 where y grows downwards
 * @property {boolean} many whether there are so many masses that they are drawn with less
 * @property {boolean} bars whether springs are bars instead of coils
 * @property {number} slices triangles of a wedge
 * @property {number} driven the mass that the pointer drives, or -1
 * @property {Float32Array} radius of each mass, in the world
 * @property {Float32Array} springs two masses each
 * @property {Float32Array} restLength px, one for each spring
 * @property {Float32Array} thickness amplitude of the coil or width of the bar, in the world
 * @property {Float32Array} fullStrain relative stretch at which each spring has its full colour; or one for all
 * @property {Float32Array} joints spring a, spring b, the mass at the tip, and whether b leaves it (1) or not (-1)
 * @property {Float32Array} restAngle degrees
 * @property {Float32Array} pinned the held masses that have a support
 * @property {Float32Array} massColors three a mass: of rim, fill and shine
 * @property {Float32Array} strainColors a table, from full compression to full stretch
 * @property {Float32Array} turnColors a table, from the full negative deviation to the full positive one
 * @property {Float32Array} inkColors of pins, ring, ghost and the mark of springs that have yielded
 * @property {Float32Array} walls of each a point of the surface, px, and the unit vector to the free side
 * @property {Float32Array} fillings of each whether it is a gas, how many masses its loop has, and which
 * @property {Float32Array} wind velocity, px/s; of each wave of its gusts wave vector, amplitude and phase; or nothing
 * @property {number} contact px, the distance at which contact begins; 0 where there is none
 * @property {Float32Array} loads of each constant force which mass it acts on, and its arrow, in the world
 * @property {Float32Array} muscles frequency, Hz, and phase of the beat, and of each muscle what swing.js says; or nothing
 * @property {Float32Array} muscleColors a table, from a muscle at its longest to one at its shortest
 * @property {boolean} medium whether the body is in a medium
 * @property {boolean} ground whether it lies on the ground, seen from above
 */

/**
 * @param {Float32Array} data sections, each after its length
 * @returns {Plan}
 */
export function readPlan(data) {
  const take = sections(data);
  const [generation, scale, x, y, flip, many, bars, slices, driven] = take();
  const plan = {
    generation, scale, x, y, flip, many: many === 1, bars: bars === 1, slices, driven,
    radius: take(), springs: take(), restLength: take(), thickness: take(), fullStrain: take(), joints: take(),
    restAngle: take(), pinned: take(), massColors: take(), strainColors: take(), turnColors: take(),
    inkColors: take(), walls: take(), fillings: take(), wind: take(), contact: take()[0] ?? 0,
    loads: take(), muscles: take(), muscleColors: take(),
  };
  const [medium, ground] = take();
  return { ...plan, medium: medium === 1, ground: ground === 1 };
}

/**
 * Reads one section after the other; what a body does not have is left out at the end.
 *
 * @param {Float32Array} data sections, each after its length
 */
export function sections(data) {
  let at = 0;
  return () => {
    const length = data[at] ?? 0;
    const section = data.subarray(at + 1, at + 1 + length);
    at += 1 + length;
    return section;
  };
}

/**
 * @typedef {object} Damage
 * @property {number} generation of the body
 * @property {Set<number>} broken the springs that are broken
 * @property {Float32Array} setLength px by which each rest length has moved for good; empty if none has
 * @property {Float32Array} setAngle degrees by which each rest angle has moved for good; empty if none has
 * @property {Set<number>} ghostBroken the springs of a second body that are broken
 * @property {Damage} [second] of a second body
 */

/**
 * @param {Float32Array} data sections, each after its length
 * @returns {Damage}
 */
export function readDamage(data) {
  const take = sections(data);
  const [generation] = take();
  const one = () => ({ broken: new Set(take()), setLength: take(), setAngle: take(), ghostBroken: new Set() });
  const own = { generation, ...one(), ghostBroken: new Set(take()) };
  return { ...own, second: { generation, ...one() } };
}

/** Nothing has yielded or broken. */
export const UNHARMED = readDamage(new Float32Array([1, -1]));

/**
 * @typedef {object} Frame
 * @property {number} generation of the body
 * @property {number} time simulated seconds
 * @property {number} lengthScale factor of all rest lengths
 * @property {number} angleShift degrees added to all rest angles
 * @property {Float32Array} positions px, x and y of each mass
 * @property {Float32Array | null} ghost of a second body
 * @property {Frame | null} [second] a second body
 */

/**
 * @param {Float32Array} data sections, each after its length
 * @returns {Frame}
 */
export function readFrame(data) {
  const take = sections(data);
  /** A time is the sum of two numbers, since one of single precision is too coarse for a long one. @param {number[]} moment */
  const momentOf = ([time, lengthScale, angleShift, left = 0]) => ({ time: time + left, lengthScale, angleShift });
  const [generation, ...own] = take();
  const [positions, ghost, moment] = [take(), take(), take()];
  const frame = { generation, ...momentOf(own), positions, ghost: ghost.length ? ghost : null };
  if (!moment.length) return frame;
  return { ...frame, second: { generation, ...momentOf([...moment]), positions: take(), ghost: null } };
}

/**
 * @param {Frame} one
 * @param {Frame} two
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
