// @ts-check
/**
 * Contact of masses with springs: a mass that is nearer to a spring than the distance of contact is pushed away, and
 * slowed along it. `sim/forces/touch/pairs.py` has the derivation and the symbols.
 *
 * @typedef {import("./body.js").Body} Body
 * @typedef {import("./body.js").Contact} Contact
 * // ifdef HAS_SOLID
 * @typedef {import("./body.js").SolidContact} SolidContact
 * // endif
 */
import { clamp, pushAndFriction, softened } from "./push.js";

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
  let reach = distance + margin;
  for (let s = 0; s < body.springs; s++) {
    // ifdef HAS_SOLID
    if (!distance) break; // only solid masses touch, and each other
    // endif
    const never = new Set(apart[s]);
    const [a, b] = [2 * ends[2 * s], 2 * ends[2 * s + 1]];
    for (let m = 0; m < body.masses; m++) {
      if (never.has(m)) continue;
      // ifdef HAS_SOLID
      reach = distance + margin + body.sizes[m];
      // endif
      const t = meeting(x, 2 * m, a, b);
      const dx = x[2 * m] - x[a] - t * (x[b] - x[a]);
      const dy = x[2 * m + 1] - x[a + 1] - t * (x[b + 1] - x[a + 1]);
      if (dx * dx + dy * dy < reach * reach) pairs.push(m, s);
    }
  }
  // ifdef HAS_SOLID
  const { solid = [] } = /** @type {SolidContact} */ (body.contact);
  for (const [k, [one, never]] of solid.entries()) {
    for (let m = 0; m < body.masses; m++) {
      if (m <= one || !body.sizes[m] || never.includes(m)) continue;
      reach = body.sizes[one] + body.sizes[m] + margin;
      if (Math.hypot(x[2 * m] - x[2 * one], x[2 * m + 1] - x[2 * one + 1]) < reach) pairs.push(m, body.springs + k);
    }
  }
  // endif
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
  const { accelerations: out } = body;
  forPairs(body, contact, h, ({ i, a, b, t, fx, fy, gx, gy }) => {
    const u = 1 - t;
    out[i] += fx;
    out[i + 1] += fy;
    out[a] -= u * fx + gx;
    out[a + 1] -= u * fy + gy;
    out[b] += gx - t * fx;
    out[b + 1] += gy - t * fy;
  });
}

/**
 * After a step, note the stretch of each tangential spring, and let sliders slide.
 *
 * @param {Body} body @param {Contact} contact @param {number} h length of the step by which pushes are softened, s
 */
export function stickToSprings(body, contact, h) {
  if (!contact.tangential[0]) return;
  const next = new Map();
  forPairs(body, contact, h, ({ key, place, stretch, most }) => {
    next.set(key, [clamp(stretch, most), ...place]);
  });
  body.grips = next;
}

/**
 * What tangential springs had remembered when a body was written: of each, spring, mass and stretch.
 *
 * @param {Body} body @param {Contact} contact @param {number[][]} grips
 */
export function gripSprings(body, contact, grips) {
  const stretches = new Map(grips.map(([s, m, stretch]) => [s * body.masses + m, stretch]));
  body.grips = new Map();
  forPairs(body, contact, 0, ({ key, place }) => {
    const stretch = stretches.get(key);
    if (stretch !== undefined) body.grips.set(key, [stretch, ...place]);
  });
}

/**
 * A pair that touches: first indices of its masses, where it touches, the forces F and G, and of its tangential spring the
 * key, its place (t, the direction of n relative to the spring, |e| and r), the stretch and the most that this may be, px.
 *
 * @typedef {{i: number, a: number, b: number, t: number, fx: number, fy: number, gx: number, gy: number, key: number,
 *   place: number[], stretch: number, most: number}} Pair
 */

/** Look at all pairs that touch. @param {Body} body @param {Contact} contact @param {number} h @param {(pair: Pair) => void} see */
function forPairs(body, contact, h, see) {
  const { positions: x, velocities: v, ends, mass, held, broken } = body;
  const pairs = nearPairs(body, contact);
  const mobilityOf = (/** @type {number} */ m) => (held[m] ? 0 : 1 / mass[m]);
  for (let p = 0; p < pairs.length; p += 2) {
    const m = pairs[p];
    const s = pairs[p + 1];
    if (broken[s]) continue;
    const i = 2 * m;
    let a = 2 * ends[2 * s];
    let b = 2 * ends[2 * s + 1];
    let reach = contact.distance;
    // ifdef HAS_SOLID
    // A solid mass is a spring of length zero.
    const one = s < body.springs ? -1 : /** @type {SolidContact} */ (contact).solid[s - body.springs][0];
    if (one >= 0) a = b = 2 * one;
    reach = body.sizes[m] + (one < 0 ? reach : body.sizes[one]);
    // endif
    const t = meeting(x, i, a, b);
    const dx = x[i] - x[a] - t * (x[b] - x[a]);
    const dy = x[i + 1] - x[a + 1] - t * (x[b + 1] - x[a + 1]);
    const square = dx * dx + dy * dy;
    if (!(square < reach * reach)) continue;
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
    const key = s * body.masses + m;
    const far = Math.sqrt(whole);
    const [ahead, beside] = [(nx * ex + ny * ey) / far, (ex * ny - ey * nx) / far];
    const was = contact.tangential[0] ? body.grips.get(key) : undefined;
    let stretch = 0;
    if (was) {
      const length = 0.5 * (far + was[4]);
      const turned = 0.5 * (r + was[5]) * (was[2] * beside - was[3] * ahead);
      stretch = was[0] + turned - (beside < 0 ? -length : length) * (t - was[1]);
    }
    const [push, rub] = pushAndFriction(
      contact.stiffness, contact.lost, friction, contact.slipSpeed, contact.tangential, h,
      mobility, mobilityAlong, reach - r, speed, along, stretch,
    );
    const [fx, fy, gx, gy] = [push * nx + rub * ny, push * ny - rub * nx, rub * lx, rub * ly];
    const most = (friction * push) / softened(contact.tangential, h, mobilityAlong)[0];
    see({ i, a, b, t, fx, fy, gx, gy, key, place: [t, ahead, beside, far, r], stretch, most });
  }
}
