// @ts-check
/**
 * Limits of springs and joints, beyond which a spring yields or breaks, and a joint yields. `sim/forces/plasticity.py` has
 * the derivation.
 *
 * @typedef {import("./body.js").Body} Body
 */

/** Largest sine of the deflection to which a yielding joint returns; beyond 90 degrees it would not hold. */
const STEEPEST = 0.999;
/** Smallest rest length, as a fraction of that of the scene, to which a spring can be squeezed for good. */
const SHORTEST_REST = 0.01;

/**
 * The force of a spring without damping, kg px/s²; 0 where one of one side is slack.
 *
 * @param {Body} body @param {number} s
 */
function elastic(body, s) {
  const force = body.stiffness[s] * (body.lengths[s] - body.restLengthOf(s));
  return body.sides && body.sides.springs[s] * force < 0 ? 0 : force;
}

/**
 * How far a spring yields at its present length, px, by what has yielded before this step.
 *
 * @param {Body} body @param {number} s
 */
function setBy(body, s) {
  const { limits } = body.data;
  const stiffness = body.stiffness[s];
  if (!limits || body.broken[s] || !(stiffness > 0)) return 0;
  const rest = body.restLengthOf(s);
  const force = elastic(body, s);
  const over = Math.abs(force) - (limits.yieldForce[s] + body.hardened[s]);
  if (!(over > 0)) return 0;
  const least = Math.min(SHORTEST_REST * body.restLength[s] - rest, 0);
  return Math.max((Math.sign(force) * over) / (stiffness + limits.hardening[s]), least);
}

/** How far the rest angle of a joint moves by yielding, radians. @param {Body} body @param {number} j */
function bentBy(body, j) {
  const { limits } = body.data;
  const stiffness = body.jointStiffness[j];
  if (!limits || !(stiffness > 0) || body.isLoose(j)) return 0;
  const { heldSprings, vectors, lengths } = body;
  const [p, q] = [heldSprings[2 * j], heldSprings[2 * j + 1]];
  const [px, py, qx, qy] = [vectors[2 * p], vectors[2 * p + 1], vectors[2 * q], vectors[2 * q + 1]];
  const torque = limits.yieldTorque[j] / (stiffness * lengths[p] * lengths[q]);
  let off = Math.atan2(px * qy - py * qx, px * qx + py * qy) - (body.restAngleOf(j) * Math.PI) / 180;
  if (off > Math.PI) off -= 2 * Math.PI;
  else if (off < -Math.PI) off += 2 * Math.PI;
  if (body.sides && body.sides.joints[j] * off < 0) return 0;
  // Bent beyond the largest torque of a sine law, it has yielded on the way; more than that it never has.
  const isAngle = body.law === "angle";
  const limit = isAngle ? torque : torque < 1 ? Math.asin(torque) : Infinity;
  if (!(Math.abs(off) > limit)) return 0;
  return off - Math.sign(off) * (isAngle ? limit : Math.asin(Math.min(torque, STEEPEST)));
}

/** Let springs and joints yield as they do if a step leads to where a body is. @param {Body} body */
export function yieldHere(body) {
  if (!body.data.limits) return;
  body.measure();
  for (let s = 0; s < body.springs; s++) body.yielding[s] = setBy(body, s);
  for (let j = 0; j < body.joints; j++) body.turnRest(j, bentBy(body, j));
}

/**
 * Keep what has yielded in a step, and let springs break; says whether any did.
 *
 * @param {Body} body
 */
export function settle(body) {
  const { limits } = body.data;
  if (!limits) return false;
  body.measure();
  let broke = false;
  for (let s = 0; s < body.springs; s++) {
    if (body.broken[s]) continue;
    const moved = setBy(body, s);
    body.setLength[s] += moved;
    body.hardened[s] += limits.hardening[s] * Math.abs(moved);
    body.yielding[s] = 0;
    if (Math.abs(elastic(body, s)) > limits.strength[s]) {
      body.broken[s] = 1;
      broke = true;
    }
  }
  for (let j = 0; j < body.joints; j++) {
    body.setAngle[j] += (bentBy(body, j) * 180) / Math.PI;
    if (body.setAngle[j] > 180) body.setAngle[j] -= 360;
    else if (body.setAngle[j] <= -180) body.setAngle[j] += 360;
  }
  if (broke) leak(body);
  body.refresh();
  return broke;
}

/** Let out what was held in by a spring that is broken. @param {Body} body */
export function leak(body) {
  const gone = new Set();
  for (let s = 0; s < body.springs; s++) {
    if (!body.broken[s]) continue;
    const [a, b] = [body.ends[2 * s], body.ends[2 * s + 1]];
    gone.add(`${a} ${b}`).add(`${b} ${a}`);
  }
  body.fillings = body.fillings.filter(({ masses }) =>
    masses.every((mass, i) => !gone.has(`${mass} ${masses[(i + 1) % masses.length]}`)));
}
