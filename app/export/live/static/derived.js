// @ts-check
/**
 * What is computed of masses together, and by formulas; `sim/motion/quantities.py` and `sim/motion/formulas.py` have the same.
 *
 * @typedef {import("./body.js").Body} Body
 * @typedef {{what: string, masses: number[]}} Whole something of some masses, such as their momentum
 * @typedef {number | string | Whole | any[]} Node a number, the name of a quantity, something of some masses, or an operation
 *   and what it is done with
 */

const DEGREE = Math.PI / 180;

/** By name, with the mass, kg, the centre, px, its velocity, px/s, and the angular momenta about it and the origin. @type {Record<string, (of: ReturnType<typeof together>) => number>} */
const WHOLE = {
  mass: ({ mass }) => mass,
  x: ({ x }) => x,
  y: ({ y }) => y,
  vx: ({ u }) => u,
  vy: ({ v }) => v,
  momentum_x: ({ mass, u }) => mass * u,
  momentum_y: ({ mass, v }) => mass * v,
  angular_momentum: ({ mass, x, y, u, v, about }) => about - mass * (x * v - y * u),
  angular_momentum_about_origin: ({ about }) => about,
};

/** @type {Record<string, (...of: number[]) => number>} */
const DO = {
  "+": (a, b) => a + b,
  "-": (a, b) => a - b,
  "*": (a, b) => a * b,
  "/": (a, b) => a / b,
  "^": (a, b) => a ** b,
  negative: (a) => -a,
  abs: Math.abs,
  sqrt: Math.sqrt,
  sin: (angle) => Math.sin(angle * DEGREE),
  cos: (angle) => Math.cos(angle * DEGREE),
  atan2: (y, x) => Math.atan2(y, x) / DEGREE,
};

/** @param {Body} body @param {number[]} masses */
function together({ mass: kg, positions, velocities }, masses) {
  let [mass, x, y, u, v, about] = [0, 0, 0, 0, 0, 0];
  for (const m of masses) {
    const [px, py] = [kg[m] * velocities[2 * m], kg[m] * velocities[2 * m + 1]];
    mass += kg[m];
    x += kg[m] * positions[2 * m];
    y += kg[m] * positions[2 * m + 1];
    u += px;
    v += py;
    about += positions[2 * m] * py - positions[2 * m + 1] * px;
  }
  return { mass, x: x / mass, y: y / mass, u: u / mass, v: v / mass, about };
}

/**
 * The value of a node; NaN where a formula has none.
 *
 * @param {Body} body @param {Node} node @param {(body: Body, name: string) => number} measure
 * @returns {number}
 */
export function valueOf(body, node, measure) {
  if (typeof node === "number") return node;
  if (typeof node === "string") return measure(body, node);
  if (!Array.isArray(node)) return WHOLE[node.what](together(body, node.masses));
  const value = DO[node[0]](...node.slice(1).map((one) => valueOf(body, one, measure)));
  return Number.isFinite(value) ? value : NaN;
}
