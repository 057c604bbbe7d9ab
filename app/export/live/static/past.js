// @ts-check
/**
 * What a body was like a moment ago, so that one can go back to before it ran away.
 *
 * @typedef {import("./body.js").Body} Body
 */

/** Simulated seconds between two moments that are stored. */
const EVERY = 0.25;
/** Moments that are stored, the last two seconds. */
const MAX_MOMENTS = 8;
/** Stretch of a spring, in rest lengths, from which on a body counts as running away. */
const TORN = 4;
/** Arrays that change while a body moves. */
const ARRAYS = /** @type {("positions" | "velocities" | "broken" | "setLength" | "setAngle" | "hardened" | "efforts")[]} */ (["positions", "velocities", "broken", "setLength", "setAngle", "hardened"]);
// ifdef HAS_EFFORTS
ARRAYS.push("efforts");
// endif

/** @param {Body} body */
function momentOf(body) {
  // Each step makes new maps of grips.
  const { time, scale, shift, fillings, grips, wallGrips } = body;
  return { time, scale, shift, fillings, grips, wallGrips: [...wallGrips], arrays: ARRAYS.map((name) => body[name].slice()) };
}

/** The last moments of a body. */
export class Past {
  /** @param {Body} body */
  constructor(body) {
    this.body = body;
    this.moments = [momentOf(body)];
  }

  /** Store the present moment, if the last one is old enough, and the body is not running away. */
  record() {
    if (this.body.time < this.moments[this.moments.length - 1].time + EVERY || this.#isTorn()) return;
    this.moments.push(momentOf(this.body));
    if (this.moments.length > MAX_MOMENTS) this.moments.shift();
  }

  #isTorn() {
    const { body } = this;
    body.measure();
    return body.lengths.some((length, s) => !body.broken[s] && length > TORN * Math.max(body.restLengthOf(s), 1));
  }

  /** Make the body what it was at the last moment but one: at the last one it may have been on its way out already. */
  goBack() {
    const { body, moments } = this;
    if (moments.length > 1) moments.pop();
    const { time, scale, shift, fillings, grips, wallGrips, arrays } = moments[moments.length - 1];
    Object.assign(body, { time, scale, shift, fillings, grips, wallGrips: [...wallGrips] });
    ARRAYS.forEach((name, i) => body[name].set(arrays[i]));
    body.refresh();
    body.flex();
  }
}
