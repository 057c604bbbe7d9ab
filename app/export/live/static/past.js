// @ts-check
/**
 * What a body was like a moment ago, so that one can go back to before it ran away.
 *
 * @typedef {import("./body.js").Body} Body
 */

/** Simulated seconds between two moments that are kept, and how many there are. */
const [EVERY, KEPT] = [0.25, 8];
/** Times its rest length to which a spring is pulled in a body that runs away. */
const TORN = 4;
/** What changes while a body moves, beside its time. */
const ARRAYS = /** @type {const} */ (["positions", "velocities", "broken", "setLength", "setAngle", "hardened"]);

/** @param {Body} body */
function momentOf(body) {
  // Maps of grips are made anew in each step.
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

  /** Keep the present moment, if the last one that was kept is some time ago, and the body is not running away. */
  keep() {
    if (this.body.time < this.moments[this.moments.length - 1].time + EVERY || this.#isTorn()) return;
    this.moments.push(momentOf(this.body));
    if (this.moments.length > KEPT) this.moments.shift();
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
