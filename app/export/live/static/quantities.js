// @ts-check
/**
 * What can be measured of a body, by the names of `sim/motion/quantities.py`.
 *
 * @typedef {import("./body.js").Body} Body
 * @typedef {{goal: Goal | null, names: string[]}} Measured
 * @typedef {object} Goal what is to be reached: a reading from `low` to `high`, for some seconds in one go
 * @property {string} quantity
 * @property {"value" | "period"} of its present value, or the period of its swings, s
 * @property {number | null} low
 * @property {number | null} high
 * @property {number} seconds
 */
import { acts } from "./body.js";
// ifdef HAS_DERIVED
import { valueOf } from "./derived.js";
// endif
import { energies } from "./energy.js";
import { swings } from "./swings.js";

const DEGREE = Math.PI / 180;
/** Simulated seconds from which a period is determined, at most. */
const SPAN = 60;

/** By kind of part and what is measured of it. @type {Record<string, (body: Body, index: number) => number>} */
const READ = {
  "joint.angle": (body, j) => body.angleOf(j),
  "joint.wrapped_angle": (body, j) => body.angleOf(j),
  "joint.rest_angle": (body, j) => body.restAngleOf(j),
  "joint.rate": (body, j) => {
    body.measure();
    const [p, q] = [body.heldSprings[2 * j], body.heldSprings[2 * j + 1]];
    return (body.turning(q) - body.turning(p)) / DEGREE;
  },
  "joint.torque": (body, j) => {
    body.measure();
    return body.wholeTorqueOf(j);
  },
  "spring.direction": (body, s) => directionOf(body, s),
  "spring.wrapped_direction": (body, s) => directionOf(body, s),
  "spring.length": (body, s) => lengthOf(body, s),
  "spring.elongation": (body, s) => lengthOf(body, s) - body.restLengthOf(s),
  "spring.force": (body, s) => {
    if (body.broken[s]) return 0;
    body.measure();
    const { vectors, velocities: v, ends, lengths } = body;
    const [a, b] = [2 * ends[2 * s], 2 * ends[2 * s + 1]];
    const along = (vectors[2 * s] * (v[b] - v[a]) + vectors[2 * s + 1] * (v[b + 1] - v[a + 1])) / lengths[s];
    const elastic = body.stiffness[s] * (lengths[s] - body.restLengthOf(s));
    const whole = elastic + body.damping[s] * along;
    return body.sides && !acts(body.sides.springs[s], elastic, whole) ? 0 : whole;
  },
  "mass.x": (body, m) => body.positions[2 * m],
  "mass.y": (body, m) => body.positions[2 * m + 1],
  "mass.vx": (body, m) => body.velocities[2 * m],
  "mass.vy": (body, m) => body.velocities[2 * m + 1],
  "mass.speed": (body, m) => Math.hypot(body.velocities[2 * m], body.velocities[2 * m + 1]),
  "energy.kinetic": (body) => energies(body).kinetic,
  "energy.linear": (body) => energies(body).linear ?? 0,
  "energy.angular": (body) => energies(body).angular ?? 0,
};

/** Angles that go on beyond half a turn while they are followed. */
const UNWRAPPED = /^(joint\d+\.angle|spring\d+\.direction)$/;

/** An angle that goes on from the one before. @param {number} angle @param {number | undefined} before */
const unwrapped = (angle, before = NaN) =>
  Number.isFinite(before) ? angle + 360 * Math.round((before - angle) / 360) : angle;

/** Degrees, from +x towards +y. @param {Body} body @param {number} s */
function directionOf({ positions: x, ends }, s) {
  const [a, b] = [2 * ends[2 * s], 2 * ends[2 * s + 1]];
  return Math.atan2(x[b + 1] - x[a + 1], x[b] - x[a]) / DEGREE;
}

/** @param {Body} body @param {number} s */
function lengthOf({ positions: x, ends }, s) {
  const [a, b] = [2 * ends[2 * s], 2 * ends[2 * s + 1]];
  return Math.hypot(x[b] - x[a], x[b + 1] - x[a + 1]);
}

// ifdef HAS_DERIVED
/** What is computed, by its name. @type {Map<string, {node: import("./derived.js").Node, unwrapped: boolean}>} */
const derived = new Map();

/** Know more that is computed. @param {Record<string, {node: import("./derived.js").Node, unwrapped: boolean}>} more */
export function addDerived(more) {
  for (const [name, one] of Object.entries(more)) derived.set(name, one);
}

// endif
/** The present value of a quantity; NaN for what is not known. @param {Body} body @param {string} name such as "mass1.y" */
export function measure(body, name) {
  // ifdef HAS_DERIVED
  const own = derived.get(name);
  if (own) return valueOf(body, own.node, measure);
  // endif
  const [, of, index, what] = /^([a-z]+)(\d*)\.([a-z_]+)$/.exec(name) ?? [];
  return READ[`${of}.${what}`]?.(body, Number(index)) ?? NaN;
}

/** The values of some quantities over the last minute, and whether a goal was reached. */
export class Recording {
  /** @param {Measured} measured */
  constructor({ goal, names }) {
    this.goal = goal;
    this.names = [...new Set([...names, ...(goal ? [goal.quantity] : [])])];
    /** @type {number[]} */
    this.times = [];
    /** @type {Map<string, number[]>} */
    this.values = new Map(this.names.map((name) => [name, []]));
    this.reached = false;
    /** The reading of the goal now; NaN where there is none. */
    this.reading = NaN;
    this.since = NaN;
  }

  /**
   * Look at a body. Time may have gone back: what was read after that is forgotten.
   *
   * @param {Body} body @param {boolean} runs whether it has not run away @param {number} part that its step is of the limit
   */
  take(body, runs, part) {
    const { times } = this;
    const all = [...this.values.values()];
    while (times.length && times[times.length - 1] >= body.time) [times, ...all].forEach((one) => one.pop());
    times.push(body.time);
    for (const [name, values] of this.values) {
      const value = name === "stability.dt_over_limit" ? part : measure(body, name);
      // ifdef HAS_DERIVED
      if (derived.get(name)?.unwrapped) {
        values.push(unwrapped(value, values[values.length - 1]));
        continue;
      }
      // endif
      values.push(UNWRAPPED.test(name) ? unwrapped(value, values[values.length - 1]) : value);
    }
    if (times[0] < body.time - SPAN - 1) {
      const old = times.findIndex((time) => time >= body.time - SPAN);
      [times, ...all].forEach((one) => one.splice(0, old));
    }
    if (this.goal) this.#judge(this.goal, body.time, runs);
  }

  /** Period and amplitude of a quantity; null where it does not swing. @param {string} name */
  swings(name) {
    const values = this.values.get(name) ?? [];
    return values.every(Number.isFinite) ? swings(this.times, values) : null;
  }

  /** @param {Goal} goal @param {number} now @param {boolean} runs */
  #judge({ quantity, of, low, high, seconds }, now, runs) {
    const values = this.values.get(quantity) ?? [];
    this.reading = of === "period" ? (this.swings(quantity)?.period ?? NaN) : values[values.length - 1];
    const inside = runs && this.reading >= (low ?? -Infinity) && this.reading <= (high ?? Infinity);
    if (!inside) this.since = NaN;
    else if (!(now >= this.since)) this.since = now;
    if (inside && now - this.since >= seconds) this.reached = true;
  }
}
