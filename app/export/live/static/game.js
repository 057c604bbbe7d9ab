// @ts-check
/**
 * A body for a game loop: what has it move, push, drag and hold its masses.
 *
 * @typedef {import("./body.js").BodyData} BodyData
 * @typedef {import("./steps.js").Hand} Hand
 */
import { Body } from "./body.js";
import { energies } from "./energy.js";
import { leak } from "./limits.js";
import { setTempo } from "./muscles.js";
import { advance, METHODS } from "./steps.js";

/** Refuse what is no finite number. @param {string} name of what is done with them @param {number[]} numbers */
function finite(name, ...numbers) {
  const wrong = numbers.find((number) => !Number.isFinite(number));
  if (wrong !== undefined) throw new RangeError(`${name}: ${wrong} is not a finite number`);
}

/**
 * Refuse a number that no part has.
 *
 * @param {string} name of what is done with the part @param {string} kind of part @param {number} number
 * @param {number} count of parts
 */
function known(name, kind, number, count) {
  if (Number.isInteger(number) && number >= 0 && number < count) return;
  throw new RangeError(`${name}: there is no ${kind} ${number}${count ? `, but 0 to ${count - 1}` : ""}`);
}

/**
 * A body that moves by the tutorial's step. Masses, springs and joints go by their numbers from 0.
 *
 * To be read: `positions`, `velocities`, `time`, `masses` (how many), `ends` (two masses of each spring), `broken` (1 for
 * each spring that is), `angleOf(joint)`. To be written at any time: `positions`, `velocities`, `gravity`, `airFriction`,
 * `wind`, `stiffness`, `damping`, `restLength`; and `restAngle` and `jointStiffness`, but call `refresh()` after it.
 */
export class SoftBody extends Body {
  /** @type {Map<number, Hand>} */
  #hands = new Map();
  #owed = 0;

  /** @param {BodyData} data the body at its start, which stays as it is @param {number} dt length of a time step, s */
  constructor(data, dt) {
    super(data);
    this.dt = dt;
    /** The tutorial's, or "verlet", which is more exact. @type {keyof typeof METHODS} */
    this.method = "symplectic_euler";
  }

  /**
   * Do some time steps.
   *
   * @param {number} count
   * @returns {boolean} false once the body has run away, as it does where `dt` is too long for what its springs have become
   */
  step(count = 1) {
    finite("step", count);
    return count < 1 || advance(this, this.method, this.dt, Math.floor(count), [...this.#hands.values()]);
  }

  /**
   * Go on by some time: as many steps as fit into it, the rest being kept for the next call.
   *
   * @param {number} seconds
   * @returns {boolean} as of `step`
   */
  advance(seconds) {
    finite("advance", seconds);
    this.#owed += seconds;
    // A hair more, so that ten times 0.0025 s are ten steps whatever the rounding.
    const count = Math.floor(this.#owed / this.dt + 1e-9);
    this.#owed = Math.max(0, this.#owed - count * this.dt);
    return this.step(count);
  }

  /**
   * Lead a mass to a place, px: in a straight line during the next steps that one call does. It stays there, and can be
   * led on, until it is released.
   *
   * @param {number} mass @param {number} x @param {number} y
   */
  drag(mass, x, y) {
    known("drag", "mass", mass, this.masses);
    finite("drag", x, y);
    this.#hands.set(mass, { mass, x, y });
  }

  /** Let go of a mass that is dragged: a held one stays where it is, a free one falls. @param {number} mass */
  release(mass) {
    this.#hands.delete(mass);
  }

  /** Hold a mass where it is, as an anchor, or make it free. @param {number} mass @param {boolean} isHeld */
  hold(mass, isHeld = true) {
    known("hold", "mass", mass, this.masses);
    this.held[mass] = Number(isHeld);
    this.velocities.fill(0, 2 * mass, 2 * mass + 2);
  }

  /** Push a mass, until it is pushed otherwise: a force, kg px/s². @param {number} mass @param {number} x @param {number} y */
  push(mass, x, y) {
    known("push", "mass", mass, this.masses);
    finite("push", x, y);
    const load = this.loads.find((one) => one.mass === mass);
    if (load) Object.assign(load, { x, y });
    else this.loads.push({ mass, x, y });
  }

  /** Cut a spring for good, and let out what a loop with it holds. @param {number} spring */
  cut(spring) {
    known("cut", "spring", spring, this.springs);
    this.broken[spring] = 1;
    leak(this);
    this.refresh();
  }

  /** Make all rest lengths this many times as long as at first. @param {number} factor */
  stretch(factor) {
    finite("stretch", factor);
    if (factor <= 0) throw new RangeError(`stretch: ${factor} is not greater than 0`);
    this.scale = factor;
  }

  /** Turn all rest angles by this much from what they were at first. @param {number} degrees */
  bend(degrees) {
    finite("bend", degrees);
    this.shift = degrees - 360 * Math.ceil((degrees - 180) / 360);
    this.refresh();
  }

  /** Set the tempo of the muscles, Hz; their beat goes on from where it is. @param {number} frequency */
  setTempo(frequency) {
    finite("setTempo", frequency);
    if (this.muscles) setTempo(this.muscles, frequency, this.time);
  }

  /**
   * Energies, kg px²/s²: kinetic, of the height, of linear springs and of joints, as far as there are such. What gases,
   * liquids, walls and contact hold is not counted.
   */
  energy() {
    return energies(this);
  }
}
