// @ts-check
/** The angle of a joint as it is seen on the screen. Arithmetic only. */
import { wrapped } from "./draw.js";

/**
 * The direction of a joint's first spring and the angle to its second one on the screen, degrees anticlockwise; and the
 * mass that they share.
 *
 * @param {import("./plan.js").Plan} plan
 * @param {import("./plan.js").Frame} frame
 * @param {number} joint
 */
export function jointAngles(plan, frame, joint) {
  const { springs, joints } = plan;
  /** @param {number} spring @param {number} sense */
  const direction = (spring, sense) => {
    const [a, b] = [2 * springs[2 * spring], 2 * springs[2 * spring + 1]];
    const { positions } = frame;
    const [dx, dy] = [positions[b] - positions[a], (positions[b + 1] - positions[a + 1]) * plan.flip];
    return (Math.atan2(dy * sense, dx * sense) * 180) / Math.PI;
  };
  const sense = joints[4 * joint + 3];
  // Spring a goes on through the mass where it meets b; where b is reversed, so is what a is compared with.
  const from = direction(joints[4 * joint], sense);
  const turn = wrapped(direction(joints[4 * joint + 1], sense) - from);
  return { from, turn, mass: joints[4 * joint + 2] };
}

/** An angle as text; zero has no sign. @param {number} angle degrees */
export const degrees = (angle) => `${(Number(angle.toFixed(1)) + 0).toFixed(1)}°`;
