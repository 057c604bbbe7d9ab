// @ts-check
/**
 * Contact of masses with springs: a mass that is nearer to a spring than the distance of contact is pushed away, and
 * slowed along it. `sim/forces/contact_pairs.py` has the derivation and the symbols.
 *
 * @typedef {import("./body.js").Body} Body
 * @typedef {import("./body.js").Contact} Contact
 */
import { pushAndFriction } from "./push.js";

/** Pairs that may touch, and the positions for which they were found, by body. @type {WeakMap<Body, {at: Float64Array, pairs: Int32Array}>} */
const found = new WeakMap();

/**
 * The point of a spring that is nearest to a mass, as a fraction of its way.
 *
 * @param {Float64Array} x @param {number} m first index of the mass @param {number} a @param {number} b of the spring's ends
 */
function meeting(x, m, a, b) {
  const ex = x[b] - x[a];
  const ey = x[b + 1] - x[a + 1];
  const t = ((x[m] - x[a]) * ex + (x[m + 1] - x[a + 1]) * ey) / Math.max(ex * ex + ey * ey, 1e-300);
  return Math.min(Math.max(t, 0), 1);
}

/** Whether no coordinate has changed by more than a length. @param {Float64Array} x @param {Float64Array} before @param {number} most */
function hasStayed(x, before, most) {
  for (let i = 0; i < x.length; i++) if (!(Math.abs(x[i] - before[i]) <= most)) return false;
  return true;
}

/** Pairs of a mass and a spring that may touch until anything has moved by half of the margin. @param {Body} body @param {Contact} contact */
function nearPairs(body, { distance, margin, apart }) {
  const { positions: x, ends } = body;
  const before = found.get(body);
  if (before && hasStayed(x, before.at, margin / (2 * Math.SQRT2))) return before.pairs;
  const pairs = [];
  const reach = distance + margin;
  for (let s = 0; s < body.springs; s++) {
    const never = new Set(apart[s]);
    const [a, b] = [2 * ends[2 * s], 2 * ends[2 * s + 1]];
    for (let m = 0; m < body.masses; m++) {
      if (never.has(m)) continue;
      const t = meeting(x, 2 * m, a, b);
      const dx = x[2 * m] - x[a] - t * (x[b] - x[a]);
      const dy = x[2 * m + 1] - x[a + 1] - t * (x[b + 1] - x[a + 1]);
      if (dx * dx + dy * dy < reach * reach) pairs.push(m, s);
    }
  }
  const near = { at: x.slice(), pairs: Int32Array.from(pairs) };
  found.set(body, near);
  return near.pairs;
}

/**
 * Add the forces of all that touches to the body's forces, which are in `body.accelerations` at this time.
 *
 * @param {Body} body @param {Contact} contact @param {number} h length of the step by which pushes are softened, s
 */
export function addContact(body, contact, h) {
  const { positions: x, velocities: v, accelerations: out, ends, mass, held, broken } = body;
  const pairs = nearPairs(body, contact);
  const mobilityOf = (/** @type {number} */ m) => (held[m] ? 0 : 1 / mass[m]);
  for (let p = 0; p < pairs.length; p += 2) {
    const m = pairs[p];
    const s = pairs[p + 1];
    if (broken[s]) continue;
    const i = 2 * m;
    const a = 2 * ends[2 * s];
    const b = 2 * ends[2 * s + 1];
    const t = meeting(x, i, a, b);
    const dx = x[i] - x[a] - t * (x[b] - x[a]);
    const dy = x[i + 1] - x[a + 1] - t * (x[b + 1] - x[a + 1]);
    const square = dx * dx + dy * dy;
    if (!(square < contact.distance * contact.distance)) continue;
    const u = 1 - t;
    const r = Math.sqrt(square);
    const [nx, ny] = [dx / (r + 1e-300), dy / (r + 1e-300)];
    const [ex, ey] = [x[b] - x[a], x[b + 1] - x[a + 1]];
    const whole = Math.max(ex * ex + ey * ey, 1e-300);
    const [lx, ly] = [(-r * ey) / whole, (r * ex) / whole];
    const [wx, wy] = [v[b] - v[a], v[b + 1] - v[a + 1]];
    const [vx, vy] = [v[i] - v[a] - t * wx, v[i + 1] - v[a + 1] - t * wy];
    const speed = vx * nx + vy * ny;
    const along = vy * nx - vx * ny - (wx * lx + wy * ly);
    const [wm, wa, wb] = [mobilityOf(m), mobilityOf(a / 2), mobilityOf(b / 2)];
    const mobility = wm + u * u * wa + t * t * wb;
    const mobilityAlong = wm + wa * ((lx + u * ny) ** 2 + (ly - u * nx) ** 2) + wb * ((lx - t * ny) ** 2 + (ly + t * nx) ** 2);
    const friction = contact.friction * Math.min(whole / (contact.distance * contact.distance), 1);
    const [push, rub] = pushAndFriction(
      contact.stiffness, contact.damping, contact.hysteresis, friction, contact.slipSpeed, h, mobility, mobilityAlong,
      contact.distance - r, speed, along,
    );
    const [fx, fy, gx, gy] = [push * nx + rub * ny, push * ny - rub * nx, rub * lx, rub * ly];
    out[i] += fx;
    out[i + 1] += fy;
    out[a] -= u * fx + gx;
    out[a + 1] -= u * fy + gy;
    out[b] += gx - t * fx;
    out[b + 1] += gy - t * fy;
  }
}
