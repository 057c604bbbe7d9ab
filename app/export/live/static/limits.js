// @ts-check
/**
 * What springs and joints bear: beyond a limit a spring yields or breaks, and a joint yields. `sim/forces/limits.py` has
 * the derivation.
 *
 * @typedef {import("./body.js").Body} Body
 */

/** Largest sine of the deflection to which a yielding joint returns; beyond 90 degrees it would not hold. */
const STEEPEST = 0.999;
/** Smallest rest length, as a fraction of that of the scene, to which a spring can be squeezed for good. */
const SHORTEST_REST = 0.01;

/**
 * Let springs and joints yield and break, after a step; says whether any did.
 *
 * @param {Body} body
 */
export function settle(body) {
  const { limits } = body.data;
  if (!limits) return false;
  body.measure();
  let [changed, broke] = [false, false];
  for (let s = 0; s < body.springs; s++) {
    const stiffness = body.stiffness[s];
    if (body.broken[s]) continue;
    let force = stiffness * (body.lengths[s] - body.restLengthOf(s));
    const over = Math.abs(force) - (limits.yieldForce[s] + body.hardened[s]);
    if (over > 0 && stiffness > 0) {
      const least = Math.min(SHORTEST_REST * body.restLength[s] - body.restLengthOf(s), 0);
      const moved = Math.max((Math.sign(force) * over) / (stiffness + limits.hardening[s]), least);
      body.setLength[s] += moved;
      body.hardened[s] += limits.hardening[s] * Math.abs(moved);
      force -= stiffness * moved;
      changed ||= moved !== 0;
    }
    if (Math.abs(force) > limits.strength[s]) {
      body.broken[s] = 1;
      broke = true;
    }
  }
  if (broke) leak(body);
  for (let j = 0; j < body.joints; j++) changed = bend(body, j, limits.yieldTorque[j]) || changed;
  if (changed || broke) body.refresh();
  return changed || broke;
}

/** Let a joint yield beyond a torque; says whether it did. @param {Body} body @param {number} j @param {number} yieldTorque */
function bend(body, j, yieldTorque) {
  const stiffness = body.jointStiffness[j];
  if (!(stiffness > 0) || body.isLoose(j)) return false;
  const { heldSprings, vectors, lengths, rest } = body;
  const [p, q] = [heldSprings[2 * j], heldSprings[2 * j + 1]];
  const [px, py, qx, qy] = [vectors[2 * p], vectors[2 * p + 1], vectors[2 * q], vectors[2 * q + 1]];
  const limit = yieldTorque / (stiffness * lengths[p] * lengths[q]);
  let off = Math.atan2(px * qy - py * qx, px * qx + py * qy) - rest[j];
  if (off > Math.PI) off -= 2 * Math.PI;
  else if (off < -Math.PI) off += 2 * Math.PI;
  const isAngle = body.law === "angle";
  const size = Math.abs(off);
  // Bent beyond the largest torque of a sine law, it has yielded on the way.
  const torque = isAngle ? size : size > 0.5 * Math.PI ? 1 : Math.sin(size);
  const kept = isAngle ? Math.min(limit, size) : Math.asin(Math.min(limit, STEEPEST));
  const moved = off - Math.sign(off) * kept;
  if (!(torque > limit) || Math.abs(moved) < 1e-12) return false;
  body.setAngle[j] += (moved * 180) / Math.PI;
  if (body.setAngle[j] > 180) body.setAngle[j] -= 360;
  else if (body.setAngle[j] <= -180) body.setAngle[j] += 360;
  return true;
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
