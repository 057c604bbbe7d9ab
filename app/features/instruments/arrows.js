// @ts-check
/**
 * Arrows of forces, velocities and torques: reads their numbers (written by arrows.py), chooses a scale, and computes
 * their outlines on the screen. Arithmetic only, without a page.
 *
 * @typedef {import("../../stage/plan.js").Plan} Plan
 * @typedef {import("../../stage/edge.js").Box} Box
 */
import { arrow, head, headOf } from "../../stage/arrow_shapes.js";
import { roundUp } from "../../stage/axes.js";

/** Sets of numbers that are stored to interpolate between. */
const MAX_SETS = 8;
/** Seconds for which all arrows have to be short before the scale becomes finer. */
const PATIENCE = 1.5;
/** The scale becomes finer only if arrows that are so many times longer would still fit it. */
const HEADROOM = 1.2;
/** Radians of the longest arc. */
const FULL_TURN = 1.5 * Math.PI;
/** Radians below which an arc is not drawn. */
const MIN_TURN = 0.2;
/** Pixels between a mass and the arc of its joint. */
const ARC = 12;

/** @typedef {import("../../wire/wire.js").Layouts["arrows"]} Numbers */

/** The masses that have arrows, in their order. @param {Numbers} numbers @param {number} count of masses */
export function massesOf({ step, held }, count) {
  const masses = [];
  for (let mass = 0; mass < count; mass += step) masses.push(mass);
  for (const mass of held) if (mass % step) masses.push(mass);
  return masses;
}

/** The last few sets of numbers, and interpolation between two of them. */
export class Series {
  constructor() {
    /** @type {Numbers[]} */
    this.sets = [];
  }

  /** @param {Numbers} numbers */
  take(numbers) {
    // Time went back, or the settings changed: what came later is void.
    this.sets = this.sets.filter(({ generation, time }) => generation === numbers.generation && time < numbers.time);
    this.sets.push(numbers);
    if (this.sets.length > MAX_SETS) this.sets.shift();
  }

  clear() {
    this.sets = [];
  }

  /** The numbers at a simulated time, or the nearest ones. @param {number} time */
  at(time) {
    const next = this.sets.findIndex((numbers) => numbers.time >= time);
    if (next === 0) return this.sets[0];
    if (next < 0) return this.sets.at(-1) ?? null;
    const [one, two] = [this.sets[next - 1], this.sets[next]];
    const part = (time - one.time) / (two.time - one.time);
    /** @param {Float32Array} a @param {Float32Array} b */
    const mixed = (a, b) => (a.length === b.length ? b.map((value, i) => a[i] + (value - a[i]) * part) : b);
    return {
      ...two,
      time,
      forces: mixed(one.forces, two.forces),
      velocities: mixed(one.velocities, two.velocities),
      torques: mixed(one.torques, two.torques),
    };
  }
}

/** The value of the longest arrow: a round number that grows at once and shrinks only after a while. */
export class Scale {
  constructor() {
    this.full = 0;
    /** The largest value since all arrows have been short, and since when. */
    this.peak = 0;
    this.since = -Infinity;
  }

  /**
   * @param {number} largest value to draw
   * @param {number} least value that the longest arrow may have
   * @param {number} now seconds of any clock
   */
  update(largest, least, now) {
    const wanted = Math.max(largest, least);
    if (!(this.full > 0) || wanted > this.full) this.full = roundUp(wanted);
    if (roundUp(HEADROOM * wanted) >= this.full) {
      this.since = now;
      this.peak = 0;
    } else this.peak = Math.max(this.peak, wanted);
    if (this.settling && now - this.since >= PATIENCE) {
      this.full = roundUp(this.peak);
      this.since = now;
      this.peak = 0;
    }
    return this.full;
  }

  /** Whether it may shrink soon without new numbers. */
  get settling() {
    return this.peak > 0;
  }
}

/** The largest magnitude. @param {ArrayLike<number>} values @param {number} width numbers per value: 1 or 2 */
export function largest(values, width) {
  let most = 0;
  for (let i = 0; i < values.length; i += width) {
    const size = width === 2 ? Math.hypot(values[i], values[i + 1]) : Math.abs(values[i]);
    if (size > most) most = size;
  }
  return most;
}

/** @param {number} value */
const text = (value) => value.toFixed(1);

/**
 * An arc with a head; nothing if it is too short to be seen.
 *
 * @param {number} x centre, pixels
 * @param {number} y
 * @param {number} radius
 * @param {number} from radians on the screen, clockwise from the right
 * @param {number} turn radians, clockwise
 */
export function turnArrow(x, y, radius, from, turn) {
  if (!(Math.abs(turn) >= MIN_TURN)) return "";
  const sense = Math.sign(turn);
  const size = headOf(0.7 * radius * Math.abs(turn));
  /** @param {number} angle */
  const at = (angle) => `${text(x + radius * Math.cos(angle))} ${text(y + radius * Math.sin(angle))}`;
  const end = from + turn;
  const stop = end - (sense * size) / radius;
  const large = Math.abs(stop - from) > Math.PI ? 1 : 0;
  /** @param {number} way @param {number} to */
  const along = (way, to) => `A${text(radius)} ${text(radius)} 0 ${large} ${way > 0 ? 1 : 0} ${at(to)}`;
  // There and back, so that the arc encloses nothing and only the head is filled.
  const arc = `M${at(from)}${along(sense, stop)}${along(-sense, from)}`;
  // The head is straight: it points along the chord of its part of the arc.
  const pointing = end + (sense * Math.PI) / 2 - (sense * size) / (2 * radius);
  return arc + head(x + radius * Math.cos(end), y + radius * Math.sin(end), pointing, size, false);
}

/**
 * The arrows of a vector at each mass in view.
 *
 * @param {number[]} masses
 * @param {Float32Array} values x and y of each
 * @param {Float64Array} places of all masses on the screen
 * @param {number} perUnit pixels of an arrow of 1
 * @param {number} flip -1 where y grows downwards
 * @param {Box} view
 * @param {{open?: boolean, only?: (mass: number) => boolean}} [how] the heads, and which masses
 */
export function vectorArrows(masses, values, places, perUnit, flip, view, { open = false, only = () => true } = {}) {
  let path = "";
  masses.forEach((mass, i) => {
    const [x, y] = [places[2 * mass], places[2 * mass + 1]];
    if (!only(mass) || !isIn(view, x, y)) return;
    path += arrow(x, y, values[2 * i] * perUnit, -values[2 * i + 1] * perUnit * flip, open);
  });
  return path;
}

/** @param {Box} view @param {number} x @param {number} y */
const isIn = (view, x, y) => x >= view.left && x <= view.right && y >= view.top && y <= view.bottom;

/**
 * The arcs of a torque at each joint in view. They begin at the first spring and show how it is turned.
 *
 * @param {Plan} plan
 * @param {Numbers} numbers
 * @param {Float64Array} places of all masses on the screen
 * @param {number} full torque of a full arc
 * @param {number} step pixels of a unit of the world
 * @param {Box} view
 */
export function torqueArrows(plan, { torques, jointStep }, places, full, step, view) {
  let path = "";
  const { joints, springs } = plan;
  torques.forEach((torque, i) => {
    const [spring, , mass] = joints.subarray(4 * i * jointStep, 4 * i * jointStep + 4);
    const [x, y] = [places[2 * mass], places[2 * mass + 1]];
    if (!isIn(view, x, y)) return;
    const far = springs[2 * spring + (springs[2 * spring] === mass ? 1 : 0)];
    const from = Math.atan2(places[2 * far + 1] - y, places[2 * far] - x);
    path += turnArrow(x, y, plan.radius[mass] * step + ARC, from, ((-torque * plan.flip) / full) * FULL_TURN);
  });
  return path;
}
