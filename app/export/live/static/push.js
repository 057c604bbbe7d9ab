// @ts-check
/**
 * The push of what is entered, a wall or the neighbourhood of a spring; see `sim/forces/touch/push.py`.
 *
 * @typedef {[damping: number, hysteresis: number, calm: number]} Lost what is lost in a bounce: s/px, 1, px^(-1/2)/s
 * @typedef {[stiffness: number, damping: number]} Tangential of a tangential spring, kg/s² and kg/s
 */

/** Damping of a softened push, in parts of the depth that is left in a step. */
const CALMING = 0.5;

/**
 * The push and the friction of what is entered.
 *
 * @param {number} stiffness @param {Lost} lost @param {number} friction @param {number} slipSpeed @param {Tangential} tangential
 * @param {number} h length of the step by which they are softened, s
 * @param {number} mobility the acceleration by a push of one @param {number} mobilityAlong that by friction
 * @param {number} depth px, positive @param {number} speed outwards, px/s @param {number} along the surface, px/s
 * @param {number} stretch of the tangential spring, px
 * @returns {[push: number, friction: number]}
 */
export function pushAndFriction(
  stiffness, [damping, hysteresis, calm], friction, slipSpeed, tangential, h, mobility, mobilityAlong, depth, speed,
  along, stretch,
) {
  const elastic = stiffness * depth * depth;
  const power = (h * mobility * (damping * elastic + 4 * h * stiffness * depth)) ** 4;
  const slow = ((calm * depth * Math.sqrt(depth)) ** 4 + (h * mobility * hysteresis * elastic) ** 4) ** 0.25;
  const lost = damping * speed + (hysteresis ? hysteresis * Math.tanh(speed / (slow + 1e-300)) : 0);
  const gain = 1 - lost - (CALMING * h * speed * (power / depth)) / (1 + power);
  const push = Math.max(elastic * gain, 0) / (1 + power) ** 0.25;
  const most = friction * push;
  if (!tangential[0]) {
    const slip = (slipSpeed ** 4 + (h * mobilityAlong * most) ** 4) ** 0.25;
    return [push, most * Math.tanh(along / slip)];
  }
  const [held, resisting] = softened(tangential, h, mobilityAlong);
  return [push, clamp(clamp(held * stretch, most) + resisting * along, most)];
}

/**
 * A tangential spring for a step of h seconds.
 *
 * @param {Tangential} tangential @param {number} h @param {number} mobilityAlong
 * @returns {Tangential}
 */
export function softened([stiffness, damping], h, mobilityAlong) {
  const [x, y] = [h * h * mobilityAlong * stiffness, 2 * h * mobilityAlong * damping];
  return [stiffness / (1 + x ** 4) ** 0.25, damping / (1 + y ** 4) ** 0.25];
}

/** A number that is at most as large as another one, with its sign. @param {number} value @param {number} most */
export function clamp(value, most) {
  return Math.min(Math.max(value, -most), most);
}
