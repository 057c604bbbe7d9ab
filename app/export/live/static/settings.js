// @ts-check
/**
 * The numbers of a body that sliders set. Where the parts of a body have different numbers, these keep their proportions, and
 * rest angles are all turned by the same angle.
 *
 * @typedef {import("./body.js").Body} Body
 * @typedef {object} Setting as `app/export/live/sliders.py` writes it, from the catalogue `sim.settings`
 * @property {string} key
 * @property {string} label
 * @property {string} unit
 * @property {number} low of the slider
 * @property {number} high
 * @property {boolean} logarithmic
 * @property {number | string} value at first
 * @property {any[]} sets the name of what sets it, and of what in the body
 * @property {[value: number | string, label: string][]} [options] where it is chosen from a list
 * @property {Record<string, number>} [stiffness] of joints, kg/s², by the rest angle in degrees: for the tutorial's templates
 */
import { setTempo } from "./muscles.js";

const DEGREE = Math.PI / 180;
/** Where a wall has its friction. */
const FRICTION = 5;

/** An angle in (-180, 180] degrees. @param {number} angle */
const turned = (angle) => angle - 360 * Math.ceil((angle - 180) / 360);

/**
 * The numbers of parts whose largest, or first, was `first` and is to be `value`: the same parts of each other as before.
 *
 * @param {number[]} own @param {number} value @param {Setting} setting whose value is the first
 */
const scaled = (own, value, { value: first }) => own.map((number) => (first ? number * (value / Number(first)) : value));

/** How the wind of a body was set: px/s, degrees from the right upwards, and the part of its own gusts. @type {WeakMap<Body, Blow>} */
const blows = new WeakMap();

/** @typedef {{speed: number, direction: number, gusts: number}} Blow */

/**
 * Set the wind. Gusts have the waves of the file: in proportion to the wind, which carries them along.
 *
 * @param {Body} body @param {Partial<Blow>} change
 */
function blow(body, change) {
  const { wind: [u, v], waves, down } = body.data;
  const own = Math.hypot(u, v);
  const before = blows.get(body) ?? { speed: own, direction: Math.atan2(-v * down, u) / DEGREE, gusts: 1 };
  const { speed, direction, gusts } = { ...before, ...change };
  blows.set(body, { speed, direction, gusts });
  const [x, y] = [speed * Math.cos(direction * DEGREE), -speed * Math.sin(direction * DEGREE) * down];
  const part = own ? (gusts * speed) / own : 0;
  body.wind = [x, y];
  body.waves = waves.map(([kx, ky, du, dv, phase]) => [kx, ky, du * part, dv * part, phase, -(kx * x + ky * y)]);
}

/**
 * What sets a number or a choice, by the first name in `Setting.sets`; `names` are the others.
 *
 * @type {Record<string, (body: any, value: any, names: any[], setting: Setting) => void>}
 */
const SETTERS = {
  field: (body, value, names) => {
    const name = names[names.length - 1];
    const owner = names.length > 1 ? body[names[0]] : body;
    if (owner) owner[name] = value;
  },
  all: (body, value, [name], setting) => body[name].set(scaled(body.data[name], value, setting)),
  stretch: (body, value, _, { value: first }) => (body.scale = value / Number(first)),
  turn: (body, value, _, { value: first }) => {
    body.restAngle.set(body.data.restAngle.map((/** @type {number} */ angle) => turned(angle + value - Number(first))));
  },
  template: (body, value, _, { stiffness }) => {
    body.restAngle.fill(value);
    body.jointStiffness.fill(stiffness?.[value] ?? 0);
  },
  tempo: (body, value) => body.muscles && setTempo(body.muscles, value, body.time),
  gravity: (body, value, _, setting) => {
    const { gravity, down } = body.data;
    body.gravity = setting.value ? scaled(gravity, value, setting) : [0, value * down];
  },
  wind: (body, value, [name]) => blow(body, { [name]: value }),
  gusts: (body, value, _, { value: first }) => blow(body, { gusts: value / Number(first) }),
  // ifdef HAS_MOTORS
  motors: (body, value, [at, unit = 1], setting) => {
    const own = body.data.motors.map((/** @type {number[]} */ motor) => motor[at]);
    const first = Number(setting.value) * unit;
    scaled(own, value * unit, { ...setting, value: first }).forEach((to, k) => (body.motors[k][at] = to));
  },
  // endif
  walls: (body, value, [at = FRICTION], setting) => {
    const own = body.data.walls.map((/** @type {(number | null)[]} */ wall) => wall[at]);
    scaled(own, value, setting).forEach((to, k) => own[k] !== null && (body.walls[k][at] = to));
  },
};

/** Set a number or a choice of a body. @param {Body} body @param {Setting} setting @param {number | string} value */
export function write(body, setting, value) {
  const [setter, ...names] = setting.sets;
  SETTERS[setter]?.(body, value, names, setting);
  body.refresh();
}
