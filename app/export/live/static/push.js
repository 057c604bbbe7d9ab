// @ts-check
/** The push of what is entered, a wall or the neighbourhood of a spring; see `sim/forces/push.py`. */

/** Damping of a softened push, in parts of the depth that is left in a step. */
const CALMING = 0.5;

/**
 * The push and the friction of what is entered.
 *
 * @param {number} stiffness @param {number} damping @param {number} hysteresis @param {number} friction @param {number} slipSpeed
 * @param {number} h length of the step by which they are softened, s
 * @param {number} mobility the acceleration by a push of one @param {number} mobilityAlong that by friction
 * @param {number} depth px, positive @param {number} speed outwards, px/s @param {number} along the surface, px/s
 * @returns {[push: number, friction: number]}
 */
export function pushAndFriction(
  stiffness, damping, hysteresis, friction, slipSpeed, h, mobility, mobilityAlong, depth, speed, along,
) {
  const elastic = stiffness * depth * depth;
  const power = (h * mobility * (damping * elastic + 4 * h * stiffness * depth)) ** 4;
  const slow = (slipSpeed ** 4 + (h * mobility * hysteresis * elastic) ** 4) ** 0.25;
  const lost = damping * speed + hysteresis * Math.tanh(speed / slow);
  const gain = 1 - lost - (CALMING * h * speed * (power / depth)) / (1 + power);
  const push = Math.max(elastic * gain, 0) / (1 + power) ** 0.25;
  const slip = (slipSpeed ** 4 + (h * mobilityAlong * friction * push) ** 4) ** 0.25;
  return [push, friction * push * Math.tanh(along / slip)];
}
