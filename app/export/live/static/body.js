// @ts-check
/**
 * The physics of a body, in plain JavaScript: masses, linear springs, joints that hold two springs at an angle, air and
 * wind, a medium, the ground, walls, gases and liquids. `sim/forces/reference.py` has the same with its derivations; the names are those of `sim`.
 *
 * Positions and velocities are flat: x and y of the first mass, of the second one, and so on. x grows to the right; which
 * way y grows is up to the scene, and no force depends on it. Lengths are in px, angles of rest in degrees.
 */
import { addContact, gripSprings, stickToSprings } from "./contact.js";
import { wave } from "./muscles.js";
// ifdef HAS_EFFORTS
import { exert, workedWave } from "./muscles.js";
// endif
import { clamp, pushAndFriction, softened } from "./push.js";

/**
 * @typedef {"tutorial" | "conservative" | "angle"} ForceLaw
 * @typedef {"isotropic" | "tutorial" | "linear"} AirLaw
 * @typedef {{mass: number, x: number, y: number, radius: number, frequency: number, ramp: number}} Circle a held mass that
 *   goes round: where it would be at time zero, px; turns per second; the time constant with which it speeds up, s
 * @typedef {{masses: number[], isGas: boolean, strength: number, outside: number, area: number}} Filling the pressure of a gas
 *   at its area, or the bulk modulus of a liquid, and the pressure outside, kg/s²; px²; masses so that the area is positive
 * @typedef {[x: number, y: number, nx: number, ny: number, hardness: number, friction: number, slipSpeed: number,
 *   ...lost: number[]]} Wall a point, the unit vector to the free side, 1/(px s²), 1, px/s, and the numbers of `Lost` and, for a
 *   mass of 1 kg, of `Tangential`
 * // ifdef HAS_BELTS
 *   and, at `BELT`, the speed of the surface along the wall, px/s, or null
 * // endif
 * // ifdef HAS_STATIC
 *   and, at `STATIC`, the coefficient of static friction, or null
 * // endif
 * @typedef {[x: number, y: number, u: number, v: number, phase: number, rate: number]} Wave of gusts: its wave vector, 1/px,
 *   its amplitude, px/s, its phase at time zero, and the rate of that, 1/s
 * @typedef {{across: number, along: number}} Medium kg/(px s)
 * @typedef {{gravity: number, forward: number, backward: number, sideways: number, slipSpeed: number}} Ground px/s²; coefficients
 *   of friction; px/s
 * @typedef {{distance: number, stiffness: number, friction: number, slipSpeed: number,
 *   lost: Lost, tangential: Tangential, margin: number, apart: number[][]}} Contact
 *   px, kg/(px s²), 1, px/s; px; for each spring, the masses that never touch it
 * // ifdef HAS_SOLID
 * @typedef {Contact & {solid: [mass: number, apart: number[]][]}} SolidContact with solid masses, each with those that never
 *   touch it
 * // endif
 * @typedef {{walls: number[][], springs: number[][]}} Grips of the tangential springs of walls and of springs: wall or spring,
 *   mass, and stretch, px
 * // ifdef HAS_STATIC
 * @typedef {Grips & {sliding: number[][]}} SlidingGrips with what slides in spite of static friction: wall and mass
 * // endif
 * @typedef {{strength: number[], yieldForce: number[], hardening: number[], yieldTorque: number[]}} Limits of springs and
 *   joints: kg px/s², kg/s², kg px²/s²; 1e300 for what has none
 * @typedef {{length: number[], hardened: number[], angle: number[]}} Yielded what has yielded before: rest lengths by how
 *   much, px, yield forces, kg px/s², rest angles, degrees; empty where none has
 * @typedef {{springs: number[], joints: number[]}} Sides of springs and joints: 1 for one that acts only beyond its rest length
 *   or rest angle, -1 for one that acts only below it, 0 for one that acts on both sides
 * // ifdef HAS_MOTORS
 * @typedef {[joint: number, speed: number, torque: number, slip: number, steer: number]} Motor the rate at which the angle
 *   of the joint should grow, 1/s; the largest torque, kg px²/s²; how far the rate is off where three quarters of it act, 1/s;
 *   the index in `steered` of what steers it, or -1
 * // endif
 * // ifdef HAS_PUSHES
 * @typedef {[mass: number, x: number, y: number, steer: number]} Push a force that keys work, kg px/s², and the index in
 *   `steered` of what works it
 * // endif
 * // ifdef HAS_RAILS
 * @typedef {[mass: number, x: number, y: number]} Rail a mass on a rail, and the unit vector of that
 * // endif
 * @typedef {import("./muscles.js").Muscles} Muscles
 * @typedef {import("./push.js").Lost} Lost
 * @typedef {import("./push.js").Tangential} Tangential
 *
 * @typedef {object} BodyData a body at one moment, as `app/export/live/data.py` writes it
 * @property {number} time s
 * @property {ForceLaw} law
 * @property {number[]} gravity px/s²
 * @property {number} down sign of y on the way down the screen
 * @property {number} airFriction kg/px, or kg/s under the linear law
 * @property {AirLaw} [airLaw] the tutorial's, if there is none
 * @property {number[]} wind px/s
 * @property {Wave[]} waves
 * @property {Medium | null} medium
 * @property {Ground | null} ground
 * @property {number} softening px²: the length of a spring with the vector L is sqrt(L² + softening)
 * @property {number[]} positions px
 * @property {number[]} velocities px/s
 * @property {number[]} mass kg
 * @property {number[]} held 1 where a mass is held, else 0
 * @property {[mass: number, x: number, y: number][]} loads constant forces, kg px/s²
 * @property {Circle[]} circles
 * @property {number[]} ends the two masses of each spring
 * @property {number[]} stiffness kg/s²
 * @property {number[]} damping kg/s
 * @property {number[]} restLength px
 * @property {number[]} joints the two springs of each joint
 * @property {number[]} jointStiffness kg/s²
 * @property {number[]} jointDamping kg/s
 * @property {number[]} restAngle degrees
 * @property {Sides | null} sides
 * @property {number[]} broken springs that are broken
 * @property {Wall[]} walls
 * @property {Filling[]} fillings
 * @property {Contact | null} contact
 * @property {Limits | null} limits
 * @property {Yielded | null} yielded
 * @property {Grips | null} grips
 * @property {Muscles | null} muscles
 * // ifdef HAS_MOTORS
 * @property {Motor[]} [motors]
 * // endif
 * // ifdef HAS_PUSHES
 * @property {Push[]} [pushes]
 * // endif
 * // ifdef HAS_EFFORTS
 * @property {number[]} [efforts] of keys, from -1 to 1
 * // endif
 * // ifdef HAS_SOLID
 * @property {number[]} [sizes] the radius of each solid mass, px, 0 of all others
 * // endif
 * // ifdef HAS_RAILS
 * @property {Rail[]} [rails]
 * // endif
 */

/** Area of a gas, as a fraction of its own area, below which its pressure grows linearly. */
const SMALLEST = 0.01;
const DEGREE = Math.PI / 180;
// ifdef HAS_BELTS
/** Where a wall has the speed of its surface. */
export const BELT = 12;
// endif
// ifdef HAS_STATIC
/** Where a wall has its coefficient of friction, and that of static friction. */
const [SLIDING, STATIC] = [5, 13];
/** Part of the largest stretch from which a tangential spring counts as sliding: it is cut to that, rounded. */
const WHOLE = 1 - 1e-9;
// endif
/** Of a circle, radians. */
export const TURN = 2 * Math.PI;

/** An angle, wrapped once into (-180, 180] degrees. @param {number} angle */
const wrapped = (angle) => (angle > 180 ? angle - 360 : angle <= -180 ? angle + 360 : angle);

/**
 * Whether a part acts that acts on one side: on its side, and not where damping would turn its force round.
 *
 * @param {number} side see `Sides` @param {number} off how far it is from its rest, in any unit @param {number} whole its force
 */
export const acts = (side, off, whole) => !side || (side * off > 0 && side * whole > 0);

// ifdef HAS_RAILS
/** Take what is across a rail out of the vector of its mass, see `Body.keepOnRail`. @param {Rail} rail @param {Float64Array} vectors @param {number} fromX @param {number} fromY */
function keepAlong([m, x, y], vectors, fromX, fromY) {
  const along = x * (vectors[2 * m] - fromX) + y * (vectors[2 * m + 1] - fromY);
  vectors[2 * m] = fromX + x * along;
  vectors[2 * m + 1] = fromY + y * along;
}

// endif
/** A body, and what acts on it. */
export class Body {
  /** @param {BodyData} data */
  constructor(data) {
    this.data = data;
    this.masses = data.mass.length;
    this.springs = data.stiffness.length;
    this.joints = data.jointStiffness.length;
    this.time = data.time;
    this.law = data.law;
    this.gravity = [...data.gravity];
    this.airFriction = data.airFriction;
    this.airLaw = data.airLaw ?? "tutorial";
    this.wind = [...data.wind];
    this.medium = data.medium && { ...data.medium };
    this.ground = data.ground && { ...data.ground };
    this.positions = Float64Array.from(data.positions);
    this.velocities = Float64Array.from(data.velocities);
    this.accelerations = new Float64Array(2 * this.masses);
    this.mass = Float64Array.from(data.mass);
    this.held = Uint8Array.from(data.held);
    this.ends = Int32Array.from(data.ends);
    this.stiffness = Float64Array.from(data.stiffness);
    this.damping = Float64Array.from(data.damping);
    this.restLength = Float64Array.from(data.restLength);
    this.heldSprings = Int32Array.from(data.joints);
    this.jointStiffness = Float64Array.from(data.jointStiffness);
    this.jointDamping = Float64Array.from(data.jointDamping);
    this.restAngle = Float64Array.from(data.restAngle);
    this.sides = data.sides;
    this.broken = new Uint8Array(this.springs);
    this.loads = data.loads.map(([mass, x, y]) => ({ mass, x, y }));
    this.walls = data.walls.map((wall) => /** @type {Wall} */ ([...wall]));
    this.waves = data.waves;
    this.fillings = data.fillings.map((filling) => ({ ...filling }));
    this.contact = data.contact && { ...data.contact };
    this.muscles = data.muscles && { ...data.muscles };
    // ifdef HAS_SOLID
    this.sizes = Float64Array.from(data.sizes ?? data.mass.map(() => 0));
    // endif
    // ifdef HAS_MOTORS
    this.motors = (data.motors ?? []).map((motor) => /** @type {Motor} */ ([...motor]));
    /** Whether motors brake as they do at their speeds, where they are stiffest. */
    this.atSpeed = false;
    // endif
    // ifdef HAS_STEERING
    /** What keys do, each from -1 to 1: to the right, and up. */
    this.steered = [0, 0];
    // endif
    // ifdef HAS_PUSHES
    this.pushes = data.pushes ?? [];
    // endif
    // ifdef HAS_EFFORTS
    /** The efforts with which keys work muscles: they follow `steered` a little later. */
    this.efforts = Float64Array.from(data.efforts ?? [0, 0]);
    // endif
    // ifdef HAS_RAILS
    this.rails = data.rails ?? [];
    // endif
    // What muscles make of rest lengths and rest angles now: how many times as long, and by how many degrees more.
    this.stretched = new Float64Array(this.muscles ? this.springs : 0).fill(1);
    this.bent = new Float64Array(this.muscles ? this.joints : 0);
    /** What held keys have made of all rest lengths and rest angles: a factor, and degrees. */
    this.scale = 1;
    this.shift = 0;
    // What has yielded: rest lengths, px, rest angles, degrees, and by how much yield forces have grown, kg px/s².
    this.setLength = new Float64Array(this.springs);
    this.setAngle = new Float64Array(this.joints);
    this.hardened = new Float64Array(this.springs);
    this.setLength.set(data.yielded?.length ?? []);
    this.setAngle.set(data.yielded?.angle ?? []);
    this.hardened.set(data.yielded?.hardened ?? []);
    /** How far rest lengths move in the step that is being made, px. */
    this.yielding = new Float64Array(this.springs);
    // Of each spring, in each evaluation: its vector, px, its length, px, and the force on its b end, kg px/s².
    this.vectors = new Float64Array(2 * this.springs);
    this.lengths = new Float64Array(this.springs);
    this.forces = new Float64Array(2 * this.springs);
    // Of each joint: its stiffness times the cosine and the sine of its rest angle, and that angle, radians.
    this.cosine = new Float64Array(this.joints);
    this.sine = new Float64Array(this.joints);
    this.rest = new Float64Array(this.joints);
    // Of each mass: how many whole springs it has; filled where there is ground.
    this.bearers = new Float64Array(this.masses);
    // The velocity of the air where it was last asked for, px/s.
    this.blow = new Float64Array(2);
    for (const spring of data.broken) this.broken[spring] = 1;
    // What tangential springs remember: of each pair of a spring and a mass, and of each wall by mass.
    /** @type {Map<number, number[]>} */
    this.grips = new Map();
    /** @type {Map<number, number[]>[]} */
    this.wallGrips = this.walls.map(() => new Map());
    // ifdef HAS_STATIC
    /** Whether friction fell in the last step, as static friction was too small for a mass. */
    this.jumped = false;
    // endif
    this.#grip(data.grips);
    this.refresh();
    this.flex();
  }

  /** The rest length of a spring, px. @param {number} s */
  restLengthOf(s) {
    const own = this.restLength[s] * this.scale;
    return (this.muscles ? own * this.stretched[s] : own) + this.setLength[s];
  }

  /** The rest angle of a joint, degrees in (-180, 180]. @param {number} j */
  restAngleOf(j) {
    const own = wrapped(wrapped(this.restAngle[j] + this.shift) + this.setAngle[j]);
    return this.muscles ? wrapped(own + this.bent[j]) : own;
  }

  /** Whether a joint holds nothing any more, because one of its springs is broken. @param {number} j */
  isLoose(j) {
    return this.broken[this.heldSprings[2 * j]] + this.broken[this.heldSprings[2 * j + 1]] > 0;
  }

  /** Update what follows from rest angles, stiffnesses and broken springs; call it after changing these. */
  refresh() {
    if (this.ground) {
      this.bearers.fill(0);
      for (let i = 0; i < this.ends.length; i++) this.bearers[this.ends[i]] += 1 - this.broken[i >> 1];
    }
    for (let j = 0; j < this.joints; j++) this.turnRest(j, 0);
  }

  /** Go to a time, s: gusts and muscles are then what they are at it. @param {number} time */
  at(time) {
    // ifdef HAS_EFFORTS
    exert(this.efforts, this.steered, time - this.time);
    // endif
    this.time = time;
    this.flex();
  }

  /** Let muscles move rest lengths and rest angles to where they are now. */
  flex() {
    const { muscles, stretched, bent } = this;
    if (!muscles) return;
    for (let i = 0; i < muscles.springs.length; i++) {
      stretched[muscles.springs[i][0]] = 1 + wave(muscles, muscles.springs[i], this.time);
      // ifdef HAS_EFFORTS
      stretched[muscles.springs[i][0]] = 1 + workedWave(muscles, muscles.springs[i], this.time, this.efforts);
      // endif
    }
    for (let i = 0; i < muscles.joints.length; i++) {
      const j = muscles.joints[i][0];
      bent[j] = wave(muscles, muscles.joints[i], this.time);
      // ifdef HAS_EFFORTS
      bent[j] = workedWave(muscles, muscles.joints[i], this.time, this.efforts);
      // endif
      this.turnRest(j, 0);
    }
  }

  /**
   * Find what follows from the rest angle and the stiffness of a joint.
   *
   * @param {number} j @param {number} more radians by which it yields in the step that is being made
   */
  turnRest(j, more) {
    let rest = this.restAngleOf(j) * DEGREE + more;
    if (Math.abs(rest) > Math.PI) rest -= Math.sign(rest) * TURN;
    const stiffness = this.isLoose(j) ? 0 : this.jointStiffness[j];
    this.rest[j] = rest;
    this.cosine[j] = stiffness * Math.cos(rest);
    this.sine[j] = stiffness * Math.sin(rest);
  }

  /**
   * Find the accelerations of all masses in their present state, px/s².
   *
   * @param {number} softeningStep length of the step, s, by which walls and contact are softened so that a bounce in few
   *   steps gains no energy, see `sim/forces/touch/push.py`
   */
  accelerate(softeningStep) {
    const { accelerations: a, mass, held, gravity } = this;
    a.fill(0);
    for (const load of this.loads) {
      a[2 * load.mass] += load.x;
      a[2 * load.mass + 1] += load.y;
    }
    // ifdef HAS_PUSHES
    for (const [m, x, y, keys] of this.pushes) {
      a[2 * m] += x * this.steered[keys];
      a[2 * m + 1] += y * this.steered[keys];
    }
    // endif
    this.#addSprings();
    if (this.medium || this.ground) this.#addResistance();
    this.#addFillings();
    if (this.contact) addContact(this, this.contact, softeningStep);
    this.#addAir();
    for (let m = 0; m < this.masses; m++) {
      const w = held[m] ? 0 : 1 / mass[m];
      a[2 * m] = a[2 * m] * w + (held[m] ? 0 : gravity[0]);
      a[2 * m + 1] = a[2 * m + 1] * w + (held[m] ? 0 : gravity[1]);
    }
    for (let k = 0; k < this.walls.length; k++) this.#addWall(k, softeningStep);
    // ifdef HAS_RAILS
    for (const rail of this.rails) keepAlong(rail, a, 0, 0);
    // endif
  }
  // ifdef HAS_RAILS

  /**
   * Take what is across the rail of a mass, if it is on one, out of its position or velocity.
   *
   * @param {number} m @param {Float64Array} vectors of all masses @param {number} fromX @param {number} fromY from where it is measured
   */
  keepOnRail(m, vectors, fromX = 0, fromY = 0) {
    const rail = this.rails.find(([mass]) => mass === m);
    if (rail) keepAlong(rail, vectors, fromX, fromY);
  }

  /** The place nearest to another one that a mass can be led to: on its rail, if it is on one. @param {number} m @param {number} x @param {number} y */
  reachable(m, x, y) {
    const places = this.positions.slice();
    const [fromX, fromY] = [places[2 * m], places[2 * m + 1]];
    [places[2 * m], places[2 * m + 1]] = [x, y];
    this.keepOnRail(m, places, fromX, fromY);
    return [places[2 * m], places[2 * m + 1]];
  }
  // endif

  /** Find the vectors and lengths of all springs as they are now. */
  measure() {
    const { positions: x, ends, vectors, lengths, data } = this;
    for (let s = 0; s < this.springs; s++) {
      const a = 2 * ends[2 * s];
      const b = 2 * ends[2 * s + 1];
      const dx = x[b] - x[a];
      const dy = x[b + 1] - x[a + 1];
      vectors[2 * s] = dx;
      vectors[2 * s + 1] = dy;
      lengths[s] = Math.sqrt(dx * dx + dy * dy + data.softening);
    }
  }

  /** The angle of a joint, from its first spring to its second one, degrees. @param {number} j */
  angleOf(j) {
    this.measure();
    const { heldSprings } = this;
    const [p, q] = [heldSprings[2 * j], heldSprings[2 * j + 1]];
    return Math.atan2(this.#cross(p, q), this.#dot(p, q)) / DEGREE;
  }

  // What runs at every step allocates no arrays: half of the time would go into collecting them.
  #addSprings() {
    const { velocities: v, accelerations: a, ends, vectors, lengths, forces, sides } = this;
    this.measure();
    for (let s = 0; s < this.springs; s++) {
      if (this.broken[s]) {
        forces[2 * s] = forces[2 * s + 1] = 0;
        continue;
      }
      const one = 2 * ends[2 * s];
      const two = 2 * ends[2 * s + 1];
      const dx = vectors[2 * s];
      const dy = vectors[2 * s + 1];
      const length = lengths[s];
      const along = (dx * (v[two] - v[one]) + dy * (v[two + 1] - v[one + 1])) / (length * length);
      const elastic = this.stiffness[s] * ((this.restLengthOf(s) + this.yielding[s]) / length - 1);
      const whole = elastic - this.damping[s] * along;
      const pull = sides && !acts(-sides.springs[s], elastic, whole) ? 0 : whole;
      forces[2 * s] = pull * dx;
      forces[2 * s + 1] = pull * dy;
    }
    this.#addJoints();
    // ifdef HAS_MOTORS
    this.#addMotors();
    // endif
    for (let s = 0; s < this.springs; s++) {
      const one = 2 * ends[2 * s];
      const two = 2 * ends[2 * s + 1];
      a[one] -= forces[2 * s];
      a[one + 1] -= forces[2 * s + 1];
      a[two] += forces[2 * s];
      a[two + 1] += forces[2 * s + 1];
    }
  }

  /** Rate at which a spring turns, 1/s. @param {number} s */
  turning(s) {
    const { velocities: v, ends, vectors, lengths } = this;
    const one = 2 * ends[2 * s];
    const two = 2 * ends[2 * s + 1];
    const cross = vectors[2 * s] * (v[two + 1] - v[one + 1]) - vectors[2 * s + 1] * (v[two] - v[one]);
    return cross / (lengths[s] * lengths[s]);
  }

  /** The cross product of the springs of a joint, px². @param {number} p @param {number} q */
  #cross(p, q) {
    const { vectors } = this;
    return vectors[2 * p] * vectors[2 * q + 1] - vectors[2 * p + 1] * vectors[2 * q];
  }

  /** Their dot product, px². @param {number} p @param {number} q */
  #dot(p, q) {
    const { vectors } = this;
    return vectors[2 * p] * vectors[2 * q] + vectors[2 * p + 1] * vectors[2 * q + 1];
  }

  /** How far a joint is from its rest angle, radians. @param {number} j @param {number} p @param {number} q */
  #off(j, p, q) {
    const off = Math.atan2(this.#cross(p, q), this.#dot(p, q)) - this.rest[j];
    return off > Math.PI ? off - TURN : off < -Math.PI ? off + TURN : off;
  }

  /** The torque of a joint without damping, kg px²/s². @param {number} j */
  torqueOf(j) {
    if (this.isLoose(j)) return 0;
    const { heldSprings, lengths } = this;
    const p = heldSprings[2 * j];
    const q = heldSprings[2 * j + 1];
    if (this.law === "angle") return this.jointStiffness[j] * lengths[p] * lengths[q] * this.#off(j, p, q);
    return this.cosine[j] * this.#cross(p, q) - this.sine[j] * this.#dot(p, q);
  }

  /**
   * The energy of a joint, kg px²/s². The tutorial's law has that of the conservative one, but no force along the springs
   * from it. A joint that acts on one side has none on the other.
   *
   * @param {number} j
   */
  energyOf(j) {
    if (this.isLoose(j)) return 0;
    const { heldSprings, lengths, sides } = this;
    const p = heldSprings[2 * j];
    const q = heldSprings[2 * j + 1];
    if (sides && sides.joints[j] * this.#off(j, p, q) < 0) return 0;
    if (this.law === "angle") return 0.5 * this.torqueOf(j) * this.#off(j, p, q);
    return this.jointStiffness[j] * lengths[p] * lengths[q] - this.cosine[j] * this.#dot(p, q) - this.sine[j] * this.#cross(p, q);
  }

  /** The torque of a joint with its damping, kg px²/s²; 0 where it does not act. @param {number} j */
  wholeTorqueOf(j) {
    if (this.isLoose(j)) return 0;
    const { heldSprings, lengths, sides } = this;
    const p = heldSprings[2 * j];
    const q = heldSprings[2 * j + 1];
    let torque = this.torqueOf(j);
    if (this.jointDamping[j]) {
      torque += this.jointDamping[j] * lengths[p] * lengths[q] * (this.turning(q) - this.turning(p));
    }
    return sides && !acts(sides.joints[j], this.#off(j, p, q), torque) ? 0 : torque;
  }

  /**
   * Have springs and joints of one side act on both: those that do not act, as if they were at rest where they are.
   *
   * @returns {() => void} what takes it back
   */
  brace() {
    const { sides, yielding, lengths } = this;
    if (!sides) return () => {};
    const before = yielding.slice();
    this.measure();
    sides.springs.forEach((side, s) => {
      const longer = lengths[s] - this.restLengthOf(s);
      if (side * longer < 0) yielding[s] = longer;
    });
    sides.joints.forEach((side, j) => {
      const off = this.#off(j, this.heldSprings[2 * j], this.heldSprings[2 * j + 1]);
      if (side * off < 0) this.turnRest(j, off);
    });
    this.sides = null;
    return () => {
      this.sides = sides;
      yielding.set(before);
      this.refresh();
    };
  }

  #addJoints() {
    const { heldSprings, sides } = this;
    for (let j = 0; j < this.joints; j++) {
      if (this.isLoose(j)) continue;
      const torque = this.wholeTorqueOf(j);
      if (sides && sides.joints[j] && !torque) continue;
      const energy = this.law === "tutorial" ? 0 : this.energyOf(j);
      this.#turn(heldSprings[2 * j], torque, energy);
      this.#turn(heldSprings[2 * j + 1], -torque, energy);
    }
  }

  /**
   * A torque turns both springs of a joint towards the rest angle; the energy grows with their lengths, and pulls along them.
   *
   * @param {number} s @param {number} torque @param {number} energy
   */
  #turn(s, torque, energy) {
    const { vectors, lengths, forces } = this;
    const x = vectors[2 * s];
    const y = vectors[2 * s + 1];
    const square = lengths[s] * lengths[s];
    forces[2 * s] += (-torque * y - energy * x) / square;
    forces[2 * s + 1] += (torque * x - energy * y) / square;
  }

  // ifdef HAS_MOTORS
  #addMotors() {
    const { heldSprings, motors } = this;
    for (const motor of motors) {
      const j = motor[0];
      if (this.isLoose(j)) continue;
      const p = heldSprings[2 * j];
      const q = heldSprings[2 * j + 1];
      let wanted = motor[1];
      // ifdef HAS_STEERING
      if (motor[4] >= 0) wanted *= this.steered[motor[4]];
      // endif
      const turning = this.turning(q) - this.turning(p);
      const part = this.atSpeed ? -turning / motor[3] : Math.tanh((wanted - turning) / motor[3]);
      const torque = motor[2] * part;
      this.#turn(p, -torque, 0);
      this.#turn(q, torque, 0);
    }
  }

  // endif
  #addFillings() {
    const { positions: x, accelerations: a } = this;
    for (const { masses, isGas, strength, outside, area: size } of this.fillings) {
      const n = masses.length;
      const area = this.areaOf(masses);
      const least = SMALLEST * size;
      const parts = area > least ? size / area : (size / least) * (2 - area / least);
      const pressure = isGas ? strength * parts - outside : strength * (1 - area / size);
      for (let i = 0; i < n; i++) {
        const [before, after] = [2 * masses[(i + n - 1) % n], 2 * masses[(i + 1) % n]];
        a[2 * masses[i]] += 0.5 * pressure * (x[after + 1] - x[before + 1]);
        a[2 * masses[i] + 1] -= 0.5 * pressure * (x[after] - x[before]);
      }
    }
  }

  /** The area that masses go round, px². @param {number[]} masses */
  areaOf(masses) {
    const { positions: x } = this;
    const [x0, y0] = [x[2 * masses[0]], x[2 * masses[0] + 1]];
    let twice = 0;
    masses.forEach((m, i) => {
      const n = masses[(i + 1) % masses.length];
      twice += (x[2 * m] - x0) * (x[2 * n + 1] - y0) - (x[2 * n] - x0) * (x[2 * m + 1] - y0);
    });
    return 0.5 * twice;
  }

  /** Find the velocity of the air at a mass, into `blow`. @param {number} i twice the mass */
  #blowAt(i) {
    const { positions: x, waves, wind, blow, time } = this;
    blow[0] = wind[0];
    blow[1] = wind[1];
    for (let k = 0; k < waves.length; k++) {
      const wave = waves[k];
      const size = Math.sin(wave[0] * x[i] + wave[1] * x[i + 1] + wave[4] + wave[5] * time);
      blow[0] += wave[2] * size;
      blow[1] += wave[3] * size;
    }
  }

  /** What a medium and the ground do to the ends of springs, see `sim/forces/resistance.py`. */
  #addResistance() {
    const { velocities: v, accelerations: a, ends, vectors, lengths, mass, bearers, medium, ground, blow } = this;
    for (let end = 0; end < ends.length; end++) {
      const s = end >> 1;
      if (this.broken[s]) continue;
      const i = 2 * ends[end];
      const x = vectors[2 * s] / lengths[s];
      const y = vectors[2 * s + 1] / lengths[s];
      let ahead = 0;
      let beside = 0;
      if (medium) {
        this.#blowAt(i);
        const u = v[i] - blow[0];
        const w = v[i + 1] - blow[1];
        ahead += 0.5 * lengths[s] * medium.along * (x * u + y * w);
        beside += 0.5 * lengths[s] * medium.across * (x * w - y * u);
      }
      if (ground) {
        const weight = (ground.gravity * mass[ends[end]]) / bearers[ends[end]];
        const along = x * v[i] + y * v[i + 1];
        const across = x * v[i + 1] - y * v[i];
        const held = weight / Math.hypot(along, across, ground.slipSpeed);
        ahead += held * (along > 0 ? ground.forward : ground.backward) * along;
        beside += held * ground.sideways * across;
      }
      a[i] -= ahead * x - beside * y;
      a[i + 1] -= ahead * y + beside * x;
    }
  }

  #addAir() {
    const { velocities: v, accelerations: a, airFriction, airLaw, blow } = this;
    if (!airFriction) return;
    for (let i = 0; i < 2 * this.masses; i += 2) {
      this.#blowAt(i);
      const past = v[i] - blow[0];
      const beside = v[i + 1] - blow[1];
      // By what each component is multiplied.
      const speed = airLaw === "linear" ? 1 : Math.sqrt(past * past + beside * beside);
      a[i] -= airFriction * past * (airLaw === "tutorial" ? Math.abs(past) : speed);
      a[i + 1] -= airFriction * beside * (airLaw === "tutorial" ? Math.abs(beside) : speed);
    }
  }

  /** @param {number} k @param {number} h */
  #addWall(k, h) {
    const { accelerations: a } = this;
    this.#forMassesIn(k, h, (i, _depth, push, rub) => {
      const [, , nx, ny] = this.walls[k];
      a[i] += push * nx + rub * ny;
      a[i + 1] += push * ny - rub * nx;
    });
  }

  /**
   * Look at the masses in a wall: first index, depth, push and friction, stretch of the tangential spring, place along the wall.
   *
   * @param {number} k @param {number} h
   * @param {(i: number, depth: number, push: number, rub: number, stretch: number, place: number) => void} see
   */
  #forMassesIn(k, h, see) {
    const { positions: x, velocities: v, held } = this;
    let [px, py, nx, ny, hardness, friction, slipSpeed, damping, hysteresis, calm, stiffness, resisting] = this.walls[k];
    for (let m = 0; m < this.masses; m++) {
      const i = 2 * m;
      let depth = (px - x[i]) * nx + (py - x[i + 1]) * ny;
      // ifdef HAS_SOLID
      depth += this.sizes[m];
      // endif
      if (!(depth > 0) || held[m]) continue;
      const speed = v[i] * nx + v[i + 1] * ny;
      let along = v[i + 1] * nx - v[i] * ny;
      const place = x[i + 1] * nx - x[i] * ny;
      const was = stiffness ? this.wallGrips[k].get(m) : undefined;
      let stretch = was ? was[0] + (place - was[1]) : 0;
      // ifdef HAS_STATIC
      friction = this.#limit(k, m);
      // endif
      // ifdef HAS_BELTS
      const belt = this.walls[k][BELT] ?? 0;
      along -= belt;
      if (was) stretch -= belt * (this.time - was[2]);
      // endif
      const [push, rub] = pushAndFriction(
        hardness, [damping, hysteresis, calm], friction, slipSpeed, [stiffness, resisting], h, 1, 1, depth, speed, along,
        stretch,
      );
      see(i, depth, push, rub, stretch, place);
    }
  }

  /** After a step of h seconds, note the stretch of each tangential spring, and let sliders slide. @param {number} h */
  stick(h) {
    if (this.contact) stickToSprings(this, this.contact, h);
    // ifdef HAS_STATIC
    this.jumped = false;
    // endif
    this.walls.forEach((wall, k) => {
      if (!wall[10]) return;
      const [stiffness] = softened([wall[10], wall[11]], h, 1);
      const next = new Map();
      this.#forMassesIn(k, h, (i, _depth, push, _rub, stretch, place) => {
        next.set(i / 2, [clamp(stretch, (wall[5] * push) / stiffness), place]);
        // ifdef HAS_BELTS
        next.get(i / 2).push(this.time);
        // endif
        // ifdef HAS_STATIC
        this.#slide(k, i / 2, next.get(i / 2), stretch, push / stiffness);
        // endif
      });
      this.wallGrips[k] = next;
    });
  }

  // ifdef HAS_STATIC
  /** The coefficient of the friction between a wall and a mass. @param {number} k @param {number} m */
  #limit(k, m) {
    const wall = this.walls[k];
    const slides = this.wallGrips[k].get(m)?.at(-1);
    return wall[STATIC] > wall[SLIDING] && !slides ? wall[STATIC] : wall[SLIDING];
  }

  /**
   * Let a mass slide for which static friction is too small, until it turns round. The last number of what is remembered says
   * whether it slides.
   *
   * @param {number} k @param {number} m @param {number[]} grip what is remembered, its stretch first @param {number} stretch px
   * @param {number} reach the largest stretch by a friction of 1, px
   */
  #slide(k, m, grip, stretch, reach) {
    const { velocities: v } = this;
    const wall = this.walls[k];
    const limit = this.#limit(k, m);
    let slides = 0;
    if (wall[STATIC] > wall[SLIDING]) {
      grip[0] = clamp(stretch, limit * reach);
      const along = v[2 * m + 1] * wall[2] - v[2 * m] * wall[3] - (wall[12] ?? 0);
      if (limit < wall[STATIC]) slides = Number(grip[0] * along > 0);
      else if (Math.abs(grip[0]) >= WHOLE * limit * reach) {
        slides = 1;
        this.jumped = true;
        grip[0] = clamp(grip[0], wall[SLIDING] * reach);
      }
    }
    grip.push(slides);
  }

  // endif
  /** Let tangential springs have the stretches with which the body was written. @param {Grips | null} grips */
  #grip(grips) {
    const { positions: x } = this;
    for (const [k, m, stretch] of grips?.walls ?? []) {
      const [, , nx, ny] = this.walls[k];
      this.wallGrips[k].set(m, [stretch, x[2 * m + 1] * nx - x[2 * m] * ny]);
      // ifdef HAS_BELTS
      this.wallGrips[k].get(m)?.push(this.time);
      // endif
      // ifdef HAS_STATIC
      const { sliding = [] } = /** @type {SlidingGrips} */ (grips);
      this.wallGrips[k].get(m)?.push(Number(sliding.some(([wall, mass]) => wall === k && mass === m)));
      // endif
    }
    if (this.contact && grips) gripSprings(this, this.contact, grips.springs);
  }
}
