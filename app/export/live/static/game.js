// @ts-check
/**
 * A body for a game loop: what has it move, push, drag and hold its masses.
 *
 * @typedef {import("./body.js").BodyData} BodyData
 * @typedef {import("./steps.js").Hand} Hand
 */
import { Body } from "./body.js";
// ifdef HAS_BELTS
import { BELT } from "./body.js";
// endif
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

/** A copy of lists, maps, objects and what is in them. @param {any} value @returns {any} */
function copied(value) {
  if (Array.isArray(value)) return value.map(copied);
  if (value instanceof Map) return new Map([...value].map(([key, one]) => [key, copied(one)]));
  if (!value || typeof value !== "object") return value;
  return Object.fromEntries(Object.entries(value).map(([key, one]) => [key, copied(one)]));
}

/**
 * A hand that leads a mass a part of the way to where it is to be.
 *
 * @param {Float64Array} positions @param {Hand} hand @param {number} part
 */
function towards(positions, { mass, x, y }, part) {
  const [fromX, fromY] = [positions[2 * mass], positions[2 * mass + 1]];
  return part === 1 ? { mass, x, y } : { mass, x: fromX + part * (x - fromX), y: fromY + part * (y - fromY) };
}

/**
 * A body that moves by the tutorial's step. Masses, springs and joints go by their numbers from 0.
 *
 * To be read: `positions`, `velocities`, `time`, `masses` (how many), `ends` (two masses of each spring), `broken` (1 for
 * each spring that is), `angleOf(joint)`. To be written at any time: `positions`, `velocities`, `gravity`, `airFriction`,
 * `airLaw`, `wind`, `stiffness`, `damping`, `restLength`; and `restAngle` and `jointStiffness`, but call `refresh()` after it.
 */
export class SoftBody extends Body {
  /** @type {Map<number, Hand>} */
  #hands = new Map();
  #owed = 0;
  #before;

  /** @param {BodyData} data the body at its start, which stays as it is @param {number} dt length of a time step, s */
  constructor(data, dt) {
    super(data);
    this.dt = dt;
    /** The tutorial's, or "verlet", which is more exact. @type {keyof typeof METHODS} */
    this.method = "symplectic_euler";
    /** Called before each time step, with the body. @type {((body: SoftBody) => void) | null} */
    this.beforeStep = null;
    this.#before = this.positions.slice();
  }

  /** A body of its own with the same motion, hands and all, but without `beforeStep`. */
  clone() {
    const copy = new SoftBody(this.data, this.dt);
    copy.#take(this);
    copy.method = this.method;
    return copy;
  }

  /** Start again as if nothing had been done to the body; `method` and `beforeStep` stay, and so do its arrays. */
  reset() {
    this.#take(new SoftBody(this.data, this.dt));
  }

  /** Take over the state of another body of the same data. @param {SoftBody} other */
  #take(other) {
    const own = /** @type {Record<string, any>} */ (this);
    for (const [key, value] of Object.entries(other)) {
      if (["data", "method", "beforeStep"].includes(key)) continue;
      // Whoever reads `positions` goes on with the same array.
      if (ArrayBuffer.isView(value)) own[key].set(value);
      else own[key] = copied(value);
    }
    this.#hands = new Map([...other.#hands].map(([mass, hand]) => [mass, { ...hand }]));
    this.#owed = other.#owed;
    this.#before = other.#before.slice();
  }

  /**
   * Do some time steps.
   *
   * @param {number} count
   * @returns {boolean} false once the body has run away, as it does where `dt` is too long for what its springs have become
   */
  step(count = 1) {
    finite("step", count);
    if (!(this.method in METHODS)) {
      throw new RangeError(`step: there is no method ${this.method}, but ${Object.keys(METHODS).join(" and ")}`);
    }
    let goesOn = true;
    for (let left = Math.floor(count); left > 0; ) {
      // Hands go straight to where they are led, so they are led there bit by bit where steps are done apart.
      const now = this.beforeStep ? 1 : left > 1 ? left - 1 : 1;
      this.beforeStep?.(this);
      if (left === now) this.#before.set(this.positions);
      const hands = [...this.#hands.values()].map((hand) => towards(this.positions, hand, now / left));
      goesOn = advance(this, this.method, this.dt, now, hands);
      left -= now;
    }
    return goesOn;
  }

  /**
   * Go on by some time: as many steps as fit into it. The rest is added to the time of the next call.
   *
   * @param {number} seconds
   * @param {number} [most] s, that one call does; what is more is left out, so that a game goes on after a long pause
   *   instead of catching up for ever
   * @returns {boolean} see `step`
   */
  advance(seconds, most = 0.25) {
    finite("advance", seconds, most);
    if (seconds < 0) throw new RangeError(`advance: ${seconds} s is below 0`);
    this.#owed += Math.min(seconds, most);
    // A hair more, so that ten times 0.0025 s are ten steps whatever the rounding.
    const count = Math.floor(this.#owed / this.dt + 1e-9);
    this.#owed = Math.max(0, this.#owed - count * this.dt);
    return this.step(count);
  }

  /** How far between the last two steps the time is that was asked for, from 0 to 1. */
  get alpha() {
    return Math.min(this.#owed / this.dt, 1);
  }

  /**
   * Where the masses are at the time that was asked for, between the last two steps: what a game draws. A screen's frames
   * seldom are a whole number of steps.
   *
   * @param {Float64Array} [into] where it is written, x and y of each mass
   */
  shown(into = new Float64Array(this.positions.length)) {
    const { positions, alpha } = this;
    for (let i = 0; i < positions.length; i++) into[i] = this.#before[i] + alpha * (positions[i] - this.#before[i]);
    return into;
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
    known("release", "mass", mass, this.masses);
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

  /** Strike a mass: a momentum, kg px/s. @param {number} mass @param {number} x @param {number} y */
  impulse(mass, x, y) {
    known("impulse", "mass", mass, this.masses);
    finite("impulse", x, y);
    if (this.held[mass]) return;
    this.velocities[2 * mass] += x / this.mass[mass];
    this.velocities[2 * mass + 1] += y / this.mass[mass];
    // ifdef HAS_RAILS
    this.keepOnRail(mass, this.velocities);
    // endif
  }

  /**
   * A wall's numbers, by name: a point of it, px, the unit vector to its free side, and the rest as in `sim.Wall`.
   *
   * @param {number} wall
   */
  wall(wall) {
    known("wall", "wall", wall, this.walls.length);
    const [x, y, nx, ny, hardness, friction, slipSpeed] = this.walls[wall];
    return { x, y, nx, ny, hardness, friction, slipSpeed };
  }

  /**
   * Move a wall, turn it, or make it another; it lets go of what it held.
   *
   * @param {number} wall
   * @param {Partial<ReturnType<SoftBody["wall"]>>} to the numbers that change
   */
  setWall(wall, to) {
    const before = this.wall(wall);
    const now = { ...before, ...to };
    const strange = Object.keys(to).find((name) => !(name in before));
    if (strange) throw new RangeError(`setWall: there is no ${strange}, but ${Object.keys(before).join(", ")}`);
    const { x, y, hardness, friction, slipSpeed } = now;
    const length = Math.hypot(now.nx, now.ny);
    finite("setWall", x, y, hardness, friction, slipSpeed, length);
    if (!length) throw new RangeError("setWall: a normal of nx 0 and ny 0 has no direction");
    this.walls[wall].splice(0, 7, x, y, now.nx / length, now.ny / length, hardness, friction, slipSpeed);
    this.wallGrips[wall].clear();
  }

  // ifdef HAS_STEERING
  /** Do what held keys do, until told otherwise: each from -1 to 1. @param {number} right @param {number} up */
  steer(right, up = 0) {
    finite("steer", right, up);
    this.steered = [right, up];
  }

  // endif
  // ifdef HAS_BELTS
  /** Run a wall as a belt, px/s along (-ny, nx). @param {number} wall @param {number} speed */
  setBelt(wall, speed) {
    known("setBelt", "wall", wall, this.walls.length);
    finite("setBelt", speed);
    this.walls[wall][BELT] = speed;
  }

  // endif
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
