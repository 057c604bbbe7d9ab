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
 * @property {number} value at first
 * @property {Record<string, number>} [stiffness] of joints, kg/s², by the rest angle in degrees: for the tutorial's templates
 */

/**
 * Set all numbers of an array in proportion to what the file has of them.
 *
 * @param {Float64Array | number[]} numbers @param {readonly number[]} own @param {number} value @param {number} first
 */
function scale(numbers, own, value, first) {
  for (let i = 0; i < own.length; i++) numbers[i] = first ? own[i] * (value / first) : value;
}

/** @type {Record<string, (body: Body, value: number, setting: Setting) => void>} */
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
  gravity: (body, value, { value: first }) => {
    const { gravity, down } = body.data;
    body.gravity = first ? gravity.map((part) => part * (value / first)) : [0, value * down];
  },
  air_friction: (body, value) => (body.airFriction = value),
  wind_speed: (body, value, { value: first }) => {
    const part = first ? value / first : 0;
    body.wind = body.data.wind.map((speed) => speed * part);
    body.waves = body.data.waves.map(([x, y, u, v, phase, rate]) => [x, y, u * part, v * part, phase, rate * part]);
  },
  wall_friction: (body, value, { value: first }) => {
    body.walls.forEach((wall, i) => (wall[5] = first ? body.data.walls[i][5] * (value / first) : value));
  },
  contact_stiffness: (body, value) => body.contact && (body.contact.stiffness = value),
  contact_friction: (body, value) => body.contact && (body.contact.friction = value),
};

/** The settings that a file can have. */
export const KEYS = Object.keys(WRITE);

/** An angle in (-180, 180] degrees. @param {number} angle */
const turned = (angle) => angle - 360 * Math.ceil((angle - 180) / 360);

/** Set a number of a body. @param {Body} body @param {Setting} setting @param {number} value */
export function write(body, setting, value) {
  WRITE[setting.key]?.(body, value, setting);
  body.refresh();
}
