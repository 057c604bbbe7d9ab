// @ts-check
/**
 * Arrows of forces, velocities and torques: reading their numbers (written by arrows.py), choosing a scale, and their
 * outlines on the screen. Arithmetic only, without a page.
 *
 * @typedef {import("../../stage/plan.js").Plan} Plan
 * @typedef {import("../../stage/edge.js").Box} Box
 */
import { arrow, head, headOf } from "../../stage/arrow_shapes.js";
import { roundUp } from "../../stage/measures.js";
import { sections } from "../../wire/unpack.js";

/** Sets of numbers that are kept to glide between. */
const KEPT = 8;
/** Seconds for which all arrows have to be short before they get a finer scale. */
const PATIENCE = 1.5;
/** How many times larger all may become and still fit a finer scale, before there is one. */
const ROOM = 1.2;
/** Radians of a full arc, and below which it is not drawn. */
const [FULL_TURN, MIN_TURN] = [1.5 * Math.PI, 0.2];
/** Pixels between a mass and the arc of its joint. */
const ARC = 12;

/**
 * @typedef {object} Numbers
 * @property {number} generation of the body
 * @property {number} time simulated seconds
 * @property {number} step every so many masses have arrows, and the held ones
 * @property {number} jointStep every so many joints
 * @property {number[]} least force, speed and torque that are next to nothing
 * @property {Float32Array} held masses that are held
 * @property {Float32Array} forces x and y of each
 * @property {Float32Array} velocities x and y of each
 * @property {Float32Array} torques one each
 */

/** @param {Float32Array} data sections, each after its length @returns {Numbers} */
export function readArrows(data) {
  const take = sections(data);
  const [generation, time, step, jointStep, ...least] = take();
  return { generation, time, step, jointStep, least, held: take(), forces: take(), velocities: take(), torques: take() };
}

/** The masses that have arrows, in their order. @param {Numbers} numbers @param {number} count of masses */
export function massesOf({ step, held }, count) {
  const masses = [];
  for (let mass = 0; mass < count; mass += step) masses.push(mass);
  for (const mass of held) if (mass % step) masses.push(mass);
  return masses;
}

/** The last few sets of numbers, and what there is between two of them. */
export class Series {
  constructor() {
    /** @type {Numbers[]} */
    this.kept = [];
  }

  /** @param {Numbers} numbers */
  take(numbers) {
    // Gone back in time, or the same moment with other settings: what was to come is no longer so.
    this.kept = this.kept.filter(({ generation, time }) => generation === numbers.generation && time < numbers.time);
    this.kept.push(numbers);
    if (this.kept.length > KEPT) this.kept.shift();
  }

  /** The numbers at a simulated time; the nearest ones where there are none. @param {number} time */
  at(time) {
    const next = this.kept.findIndex((numbers) => numbers.time >= time);
    if (next === 0) return this.kept[0];
    if (next < 0) return this.kept.at(-1) ?? null;
    const [one, two] = [this.kept[next - 1], this.kept[next]];
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

/** What the longest arrow stands for: a round number that grows at once and shrinks only after a while. */
export class Scale {
  constructor() {
    this.full = 0;
    /** The largest number since all have been short, and since when. */
    this.peak = 0;
    this.since = -Infinity;
  }

  /**
   * @param {number} largest number that is to be drawn
   * @param {number} least that the longest arrow stands for
   * @param {number} now seconds of any clock
   */
  update(largest, least, now) {
    const wanted = Math.max(largest, least);
    if (!(this.full > 0) || wanted > this.full) this.full = roundUp(wanted);
    if (roundUp(ROOM * wanted) >= this.full) {
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

  /** Whether it may shrink soon without any new number. */
  get settling() {
    return this.peak > 0;
  }
}

/** @param {ArrayLike<number>} values @param {number} width numbers of each */
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
 * @param {number} x its middle, pixels
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
  // There and back: nothing is enclosed, and only the head is filled.
  const arc = `M${at(from)}${along(sense, stop)}${along(-sense, from)}`;
  // A head is straight: it points along the chord of its part of the arc.
  const pointing = end + (sense * Math.PI) / 2 - (sense * size) / (2 * radius);
  return arc + head(x + radius * Math.cos(end), y + radius * Math.sin(end), pointing, size, false);
}

/**
 * The arrows of a vector at each mass that is in view.
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
 * The arcs of a torque at each joint that is in view. They begin at the first spring and show how it is turned.
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
