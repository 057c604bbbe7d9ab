// @ts-check
/**
 * The time of a live file: how many steps are due for each picture, and how long they are. If there is not enough time to
 * compute them, the clock lags, and the file says so.
 *
 * @typedef {import("./body.js").Body} Body
 * @typedef {import("./steps.js").Hand} Hand
 * @typedef {import("./steps.js").Presses} Presses
 */
import { decimal, say } from "../../../words/words.js";
import { Past } from "./past.js";
import { StabilityMeter } from "./stability.js";
import { advance, METHODS } from "./steps.js";

/** Longest time between two pictures that is made up for, s; after a longer one, as in a tab in the background, time has stood. */
const LONGEST = 0.1;
/** Fraction of the stability limit that a step of Verlet has. */
const SAFETY = 0.4;
/** Longest step of Verlet, s: springs may turn far in a longer one. */
const LONGEST_STEP = 1 / 240;
/** Milliseconds that computing may take for a picture: of the 16 at 60 Hz, the rest is for drawing. */
const BUDGET = 11;
/** Seconds between two computations of the stability limit. */
const LOOK_EVERY = 0.5;
/** Coordinate, px, beyond which a body has run away. */
const FAR = 1e6;

/** Speed of a hand, px/s, that is always allowed. */
const SLOWEST = 100;

/**
 * The largest speed at which a hand may lead a mass, px/s: that at which a pull travels through its springs. A mass that is
 * led faster would tear them apart, or press them to nothing; see `sim/motion/hands.py`.
 *
 * @param {Body} body @param {number} led
 */
function fastest(body, led) {
  const { ends, mass, held, stiffness } = body;
  let speed = Infinity;
  ends.forEach((end, i) => {
    const [s, other] = [i >> 1, ends[i ^ 1]];
    if (end !== led || body.broken[s] || !(stiffness[s] > 0) || held[other]) return;
    speed = Math.min(speed, body.restLengthOf(s) * Math.sqrt(stiffness[s] / mass[other]));
  });
  return Math.max(speed, SLOWEST);
}

/** @param {number} seconds */
const number = (seconds) => decimal(String(Number(seconds.toPrecision(2))));

/** A body in time. */
export class Clock {
  /**
   * @param {Body} body
   * @param {keyof typeof METHODS} method symplectic Euler has the step of its scene; Verlet one far below its limit
   * @param {number} dt length of a step of symplectic Euler, s
   */
  constructor(body, method, dt) {
    this.body = body;
    this.method = method;
    this.dt = dt;
    this.meter = new StabilityMeter(body, method);
    /** How much of real time the last pictures had. */
    this.rate = 1;
    this.exploded = false;
    /** Why it has, as a sentence. */
    this.cause = "";
    this.past = new Past(body);
    this.owed = 0;
    this.due = 0;
    /** The smallest limit that was found since the body's numbers changed, s: on its way out a body has others. */
    this.least = Infinity;
    /** What the last good picture had. */
    this.good = { positions: body.positions.slice(), velocities: body.velocities.slice() };
  }

  /** The length of a step, s. */
  get step() {
    return this.method === "symplectic_euler" ? this.dt : Math.min(SAFETY * this.meter.limit, LONGEST_STEP);
  }

  /** The body has other numbers: look at its limit at once. */
  changed() {
    this.meter.looked = false;
    this.due = 0;
    this.least = Infinity;
  }

  /** Bring the body back to before it ran away. */
  goBack() {
    this.past.goBack();
    this.good.positions.set(this.body.positions);
    this.good.velocities.set(this.body.velocities);
    this.exploded = false;
    this.changed();
  }

  /**
   * Go on by what is due.
   *
   * @param {number} seconds since the picture before, times the speed
   * @param {readonly Hand[]} hands @param {Presses} presses
   */
  go(seconds, hands, presses) {
    const began = performance.now();
    if (began >= this.due) {
      this.least = Math.min(this.least, this.meter.look());
      this.due = began + 1e3 * LOOK_EVERY;
    }
    this.owed += Math.min(seconds, LONGEST);
    const h = this.step;
    let left = Math.floor(this.owed / h + 1e-9);
    const all = left;
    const goals = hands.map((hand) => this.#within(hand, all * h));
    while (left > 0) {
      // Hands move in proportion, also where computing ends early.
      const count = Math.min(left, 16);
      const part = count / left;
      const ways = goals.map(({ mass, x, y }) => {
        const [atX, atY] = [this.body.positions[2 * mass], this.body.positions[2 * mass + 1]];
        return { mass, x: atX + part * (x - atX), y: atY + part * (y - atY) };
      });
      if (!this.advance(h, count, ways, presses)) return;
      left -= count;
      if (performance.now() - began > BUDGET) break;
    }
    this.owed -= all * h; // what is left is not caught up with
    if (all) this.rate += 0.1 * ((all - left) / all - this.rate);
  }

  /** As far on the way of a hand as it may lead its mass in some time (s). @param {Hand} hand @param {number} time @returns {Hand} */
  #within({ mass, x, y }, time) {
    // ifdef HAS_RAILS
    [x, y] = this.body.reachable(mass, x, y);
    // endif
    const { positions } = this.body;
    const [dx, dy] = [x - positions[2 * mass], y - positions[2 * mass + 1]];
    const part = Math.min(1, (fastest(this.body, mass) * time) / Math.max(Math.hypot(dx, dy), 1e-9));
    return { mass, x: positions[2 * mass] + part * dx, y: positions[2 * mass + 1] + part * dy };
  }

  /** Do some steps; says whether the body is still there. @param {number} h @param {number} count @param {readonly Hand[]} hands @param {Presses} presses */
  advance(h, count, hands, presses) {
    const { body } = this;
    const isFinite = advance(body, this.method, h, count, hands, presses);
    if (isFinite && body.positions.every((value) => Math.abs(value) < FAR)) {
      this.good.positions.set(body.positions);
      this.good.velocities.set(body.velocities);
      this.past.record();
      return true;
    }
    body.positions.set(this.good.positions);
    body.velocities.set(this.good.velocities);
    this.exploded = true;
    this.cause = this.#cause();
    return false;
  }

  /** The likely cause, as `sim/motion/divergence.py` says it: the limit is that of the body at its start, if it is passed. */
  #cause() {
    const { body, method, dt } = this;
    if (method !== "symplectic_euler") return say("live-cause.violent");
    const { positions, velocities, jointStiffness, jointDamping } = body;
    const arrays = [positions, velocities, jointStiffness, jointDamping];
    const before = arrays.map((array) => array.slice());
    const limitNow = () => new StabilityMeter(body, method).look();
    // Its speed is a consequence of running away.
    velocities.fill(0);
    positions.set(body.data.positions);
    const atStart = limitNow();
    if (!(dt > atStart)) positions.set(before[0]);
    const limit = dt > atStart ? atStart : this.least;
    jointStiffness.fill(0);
    jointDamping.fill(0);
    body.refresh();
    const linear = limitNow();
    arrays.forEach((array, i) => array.set(before[i]));
    body.refresh();
    this.meter.limit = limit;
    if (!(dt > limit)) return say("live-cause.small");
    const key = body.joints && linear > 1.2 * limit ? "live-cause.angular" : "live-cause.linear";
    return say(key, { step: number(dt), limit: number(limit) });
  }
}
