// @ts-check
/**
 * The numbers of a body that sliders set, by the keys of `sim.settings`. What a body's parts have in different sizes keeps
 * its proportions, and rest angles are all turned by as much.
 *
 * @typedef {import("./body.js").Body} Body
 * @typedef {import("./body.js").BodyData} BodyData
 * @typedef {object} Setting
 * @property {string} key
 * @property {string} label
 * @property {string} unit
 * @property {number} low of the slider
 * @property {number} high
 * @property {boolean} logarithmic
 * @property {number | string} value at first
 * @property {[value: number | string, label: string][]} [options] where it is chosen from a list
 * @property {Record<string, number>} [stiffness] of joints, kg/s², by the rest angle in degrees: for the tutorial's templates
 */
import { setTempo } from "./muscles.js";

const DEGREE = Math.PI / 180;

/**
 * Set all numbers of an array in proportion to what the file has of them.
 *
 * @param {Float64Array | number[]} numbers @param {readonly number[]} own @param {number} value @param {number} first
 */
function scale(numbers, own, value, first) {
  for (let i = 0; i < own.length; i++) numbers[i] = first ? own[i] * (value / first) : value;
}

/** How the wind of a body was set: px/s, degrees from the right upwards, and the part of its own gusts. @type {WeakMap<Body, Blow>} */
const blows = new WeakMap();

/** @typedef {{speed: number, direction: number, gusts: number}} Blow */

/**
 * Set the wind. Gusts keep their waves: these are as much stronger as the wind, and it carries them along.
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

/** @type {Record<string, (body: Body, value: number, setting: {value: number, stiffness?: Record<string, number>}) => void>} */
const WRITE = {
  linear_stiffness: (body, value, { value: first }) => scale(body.stiffness, body.data.stiffness, value, first),
  linear_damping: (body, value, { value: first }) => scale(body.damping, body.data.damping, value, first),
  angular_stiffness: (body, value, { value: first }) => scale(body.jointStiffness, body.data.jointStiffness, value, first),
  angular_damping: (body, value, { value: first }) => scale(body.jointDamping, body.data.jointDamping, value, first),
  rest_length_scale: (body, value, { value: first }) => (body.scale = value / first),
  rest_angle: (body, value, { value: first }) => {
    body.data.restAngle.forEach((angle, j) => (body.restAngle[j] = turned(angle + value - first)));
  },
  template: (body, value, { stiffness }) => {
    body.restAngle.fill(value);
    body.jointStiffness.fill(stiffness?.[String(value)] ?? 0);
  },
  tempo: (body, value) => body.muscles && setTempo(body.muscles, value, body.time),
  gravity: (body, value, { value: first }) => {
    const { gravity, down } = body.data;
    body.gravity = first ? gravity.map((part) => part * (value / first)) : [0, value * down];
  },
  air_friction: (body, value) => (body.airFriction = value),
  wind_speed: (body, value) => blow(body, { speed: value }),
  wind_direction: (body, value) => blow(body, { direction: value }),
  turbulence: (body, value, { value: first }) => blow(body, { gusts: value / first }),
  drag_across: (body, value) => body.medium && (body.medium.across = value),
  drag_along: (body, value) => body.medium && (body.medium.along = value),
  ground_forward: (body, value) => body.ground && (body.ground.forward = value),
  ground_backward: (body, value) => body.ground && (body.ground.backward = value),
  ground_sideways: (body, value) => body.ground && (body.ground.sideways = value),
  wall_friction: (body, value, { value: first }) => {
    body.walls.forEach((wall, i) => (wall[5] = first ? body.data.walls[i][5] * (value / first) : value));
  },
  contact_stiffness: (body, value) => body.contact && (body.contact.stiffness = value),
  contact_friction: (body, value) => body.contact && (body.contact.friction = value),
};

/** An angle in (-180, 180] degrees. @param {number} angle */
const turned = (angle) => angle - 360 * Math.ceil((angle - 180) / 360);

/** Set a number or a choice of a body. @param {Body} body @param {Setting} setting @param {number | string} value */
export function write(body, setting, value) {
  if (setting.key === "force_law") body.law = /** @type {import("./body.js").ForceLaw} */ (value);
  else WRITE[setting.key]?.(body, Number(value), { ...setting, value: Number(setting.value) });
  body.refresh();
}
