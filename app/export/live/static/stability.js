// @ts-check
/**
 * The largest stable time step of a body in its present pose, from its forces alone; `sim/motion/stability.py` has the
 * derivation. For motions M a = -K x - C v, a step dt of symplectic Euler is at its limit where the largest eigenvalue of
 * M⁻¹ (dt² K + 2 dt C) is 4; of velocity Verlet, where that of M⁻¹ (dt² K + 4 dt C) is.
 *
 * @typedef {import("./body.js").Body} Body
 */

/** Power iterations of a first look. */
const FIRST = 60;
/** Power iterations of a later one, which starts with the motion found before. */
const LATER = 6;
/** Size of the start of a first look that a later one begins with, too, relative to the motion found before. */
const NOISE = 0.03;
/** Of the damping in the condition above. */
const WEIGHT = { symplectic_euler: 2, verlet: 4 };

/** Looks at a body again and again, and remembers the stiffest motion that it has found. */
export class StabilityMeter {
  /** @param {Body} body @param {keyof typeof WEIGHT} method */
  constructor(body, method) {
    this.body = body;
    this.weight = WEIGHT[method];
    /** The largest stable step, s. */
    this.limit = Infinity;
    // Alternating signs are close to the stiffest motion of a chain, and no motion is without a part of the rest.
    this.start = Float64Array.from(body.positions, (_, i) => ((i >> 1) % 2 ? -1 : 1) + Math.sin(1 + 12.9898 * i));
    this.motion = this.start;
    this.looked = false;
  }

  /** Look at the body as it is, with springs and joints of one side that may act soon, and motors at their speeds; returns the limit, s. */
  look() {
    const { body } = this;
    const release = body.brace();
    // ifdef HAS_MOTORS
    body.atSpeed = true;
    // endif
    const state = [body.positions.slice(), body.velocities.slice()];
    const scale = this.limit < Infinity ? this.limit : 1e-3;
    let limit = Infinity;
    // A little of all motions, for the one found before may be that of another body than the one that is stiffest now.
    const size = Math.sqrt(this.#product(this.motion, this.motion)) / Math.sqrt(this.#product(this.start, this.start));
    const noise = this.looked ? NOISE * size : Infinity;
    if (Number.isFinite(noise)) this.motion = this.motion.map((value, i) => value + noise * this.start[i]);
    else this.motion = this.start;
    for (let i = 0; i < (this.looked ? LATER : FIRST); i++) {
      const norm = Math.sqrt(this.#product(this.motion, this.motion));
      if (!(norm > 0)) break;
      const w = this.motion.map((value) => value / norm);
      const [byPosition, byVelocity] = [this.#along(w, state, "positions"), this.#along(w, state, "velocities")];
      const [k, c] = [this.#product(w, byPosition), (this.weight / 2) * this.#product(w, byVelocity)];
      // dt² k + 2 dt c = 4
      limit = k > 0 ? (Math.sqrt(c * c + 4 * k) - c) / k : c > 0 ? 2 / c : Infinity;
      const dt = limit < Infinity ? limit : scale;
      const next = byPosition.map((value, j) => dt * dt * value + this.weight * dt * byVelocity[j]);
      if (!next.every(Number.isFinite) || next.every((value) => value === 0)) break;
      this.motion = next;
    }
    body.positions.set(state[0]);
    body.velocities.set(state[1]);
    release();
    // ifdef HAS_MOTORS
    body.atSpeed = false;
    // endif
    this.looked = true;
    return (this.limit = limit > 0 ? limit : Infinity);
  }

  /** The sum of m u w. @param {Float64Array} u @param {Float64Array} w */
  #product(u, w) {
    const { mass, held } = this.body;
    return u.reduce((sum, value, i) => (held[i >> 1] ? sum : sum + mass[i >> 1] * value * w[i]), 0);
  }

  /**
   * M⁻¹ K w or M⁻¹ C w, as a difference of accelerations.
   *
   * @param {Float64Array} w @param {Float64Array[]} state positions and velocities, which are put back @param {"positions" | "velocities"} what changes
   */
  #along(w, state, what) {
    const { body } = this;
    const farthest = state[0].reduce((most, value) => Math.max(most, Math.abs(value)), 0);
    const step = (1e-6 * (1 + farthest)) / w.reduce((most, value) => Math.max(most, Math.abs(value)), 1e-300);
    const sides = [step, -step].map((size) => {
      body.positions.set(state[0]);
      body.velocities.set(state[1]);
      w.forEach((value, i) => {
        if (!body.held[i >> 1]) body[what][i] += size * value;
      });
      body.accelerate(0);
      return body.accelerations.slice();
    });
    return sides[0].map((value, i) => (sides[1][i] - value) / (2 * step));
  }
}
