// @ts-check
/**
 * Time steps of a body, and what leads it: hands, held keys, circles.
 *
 * @typedef {import("./body.js").Body} Body
 * @typedef {{mass: number, x: number, y: number}} Hand a mass that is led, and where to, px
 * @typedef {{factor: number, angle: number}} Presses what held keys do in a second: a factor of all rest lengths, and degrees
 *   that all rest angles grow by
 * // ifdef HAS_STEERING
 * @typedef {Presses & {steered?: number[]}} Steering and what keys do, to the right and up
 * // endif
 */
import { TURN } from "./body.js";
import { settle, yieldHere } from "./limits.js";

/** Smallest factor of all rest lengths. */
const MIN_SCALE = 0.01;
/** Largest factor of all rest lengths. */
const MAX_SCALE = 100;

/** Put the masses that go round where they are at a time (s). @param {Body} body @param {number} t */
export function goRound(body, t) {
  const { positions: x, velocities: v } = body;
  for (const { mass, x: atX, y: atY, radius, frequency, ramp } of body.data.circles) {
    const fade = Math.exp(-t / ramp);
    const [phase, rate] = [TURN * frequency * (t - ramp * (1 - fade)), TURN * frequency * (1 - fade)];
    const [sine, cosine] = [Math.sin(phase), Math.cos(phase)];
    x[2 * mass] = atX + radius * sine;
    x[2 * mass + 1] = atY + radius * (1 - cosine);
    v[2 * mass] = radius * cosine * rate;
    v[2 * mass + 1] = radius * sine * rate;
    // ifdef HAS_RAILS
    body.keepOnRail(mass, x, atX, atY);
    body.keepOnRail(mass, v);
    // endif
  }
}

/** Let held keys act for some time (s). @param {Body} body @param {Presses} presses @param {number} h */
function press(body, { factor, angle }, h) {
  if (factor === 1 && angle === 0) return;
  body.scale = Math.min(Math.max(body.scale * factor ** h, MIN_SCALE), MAX_SCALE);
  const shift = body.shift + angle * h;
  body.shift = 180 - ((((180 - shift) % 360) + 360) % 360);
  body.refresh();
}

/** Find the accelerations where a step leads to, by what yields in it. @param {Body} body @param {number} h s */
function accelerateHere(body, h) {
  yieldHere(body);
  body.accelerate(h);
}

/**
 * Symplectic Euler, the tutorial's method: v += h a(x, v), then x += h v.
 *
 * @param {Body} body @param {number} h s
 * @param {(t: number, roundAt: number) => void} lead puts masses where hands lead them at time t, and circles at `roundAt`
 */
function eulerStep(body, h, lead) {
  const { positions: x, velocities: v, accelerations: a, held } = body;
  const end = body.time + h;
  // As in the tutorial, forces see hands where they are in the end; circles go on with the masses.
  lead(end, body.time);
  body.at(end);
  accelerateHere(body, h);
  for (let i = 0; i < x.length; i++) {
    if (held[i >> 1]) continue;
    v[i] += h * a[i];
    x[i] += h * v[i];
  }
  lead(end, end);
}

/** Arrays for the state of a body at the beginning of a step, made once. @type {WeakMap<Body, {v: Float64Array, a: Float64Array}>} */
const rooms = new WeakMap();

/**
 * Velocity Verlet: x += h v + h²/2 a, v += h/2 (a + a'). Forces at the end of the step see the velocities v + h a.
 *
 * @param {Body} body @param {number} h s @param {(t: number, roundAt: number) => void} lead see `eulerStep`
 */
function verletStep(body, h, lead) {
  const { positions: x, velocities: v, accelerations: a, held } = body;
  const end = body.time + h;
  const before = rooms.get(body) ?? { v: new Float64Array(v.length), a: new Float64Array(v.length) };
  rooms.set(body, before);
  before.v.set(v);
  before.a.set(a);
  for (let i = 0; i < x.length; i++) {
    if (held[i >> 1]) continue;
    x[i] += h * (v[i] + 0.5 * h * a[i]);
    v[i] += h * a[i];
  }
  lead(end, end);
  body.at(end);
  accelerateHere(body, h);
  for (let i = 0; i < x.length; i++) {
    if (!held[i >> 1]) v[i] = before.v[i] + 0.5 * h * (before.a[i] + a[i]);
  }
}

/** The two methods: the tutorial's, and one of second order whose steps are chosen. */
export const METHODS = /** @type {const} */ ({ symplectic_euler: eulerStep, verlet: verletStep });

/**
 * Do some steps of equal length.
 *
 * @param {Body} body
 * @param {keyof typeof METHODS} method
 * @param {number} h length of a step, s
 * @param {number} count of steps
 * @param {readonly Hand[]} hands masses that are led in straight lines, to be there in the end; they count as held
 * @param {Presses} presses
 * @returns {boolean} whether all is still finite
 */
export function advance(body, method, h, count, hands = [], presses = { factor: 1, angle: 0 }) {
  const { positions: x, velocities: v } = body;
  const start = body.time;
  const duration = h * count;
  // Under the tutorial's law, the damping treats a led mass as being at rest.
  const seen = body.law === "tutorial" ? 0 : 1 / duration;
  const ways = hands.map(({ mass, x: toX, y: toY }) => {
    const i = 2 * mass;
    // ifdef HAS_RAILS
    [toX, toY] = body.reachable(mass, toX, toY);
    // endif
    return { i, x: x[i], y: x[i + 1], dx: toX - x[i], dy: toY - x[i + 1] };
  });
  const before = hands.map(({ mass }) => body.held[mass]);
  for (const { mass } of hands) body.held[mass] = 1;
  const lead = (/** @type {number} */ t, /** @type {number} */ roundAt) => {
    goRound(body, roundAt);
    const part = Math.min((t - start) / duration, 1);
    for (const way of ways) {
      x[way.i] = way.x + part * way.dx;
      x[way.i + 1] = way.y + part * way.dy;
      v[way.i] = way.dx * seen;
      v[way.i + 1] = way.dy * seen;
    }
  };
  // ifdef HAS_STEERING
  const { steered } = /** @type {Steering} */ (presses);
  if (steered) body.steered = steered;
  // endif
  const step = METHODS[method];
  lead(start, start);
  if (start === body.data.time) settle(body); // it may be beyond its limits where it was put
  if (method === "verlet") accelerateHere(body, h);
  for (let i = 1; i <= count; i++) {
    press(body, presses, h);
    step(body, h, lead);
    body.stick(h);
    // ifdef HAS_STATIC
    if (body.jumped && method === "verlet") accelerateHere(body, h);
    // endif
    if (settle(body) && method === "verlet") accelerateHere(body, h);
  }
  hands.forEach(({ mass }, i) => {
    body.held[mass] = before[i];
    v[2 * mass] = v[2 * mass + 1] = 0;
  });
  return x.every(Number.isFinite) && v.every(Number.isFinite);
}
