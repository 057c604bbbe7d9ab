// @ts-check
/** The angle of a joint on the screen, and texts of angles and lengths. Arithmetic only. */
import { wrapped } from "./draw.js";
import { decimal, say } from "../words/words.js";

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
export const degrees = (angle) => decimal(`${(Number(angle.toFixed(1)) + 0).toFixed(1)}°`.replace("-", "−"));

/** A place in the scene in words. @param {number} x @param {number} y @param {string} unit */
export function placeText(x, y, unit) {
  const [across, up] = [x, y].map((value) => decimal(String(Number(value.toPrecision(4)) + 0).replace("-", "−")));
  return say("ui-place", { x: across, y: up, unit }).trim();
}

/** A round length as text; parts of a metre in cm. @param {number} size @param {string} unit */
export function lengthText(size, unit) {
  const inCm = unit === "m" && size < 1 && size >= 0.01;
  return `${decimal(String(Number((inCm ? 100 * size : size).toPrecision(1))))} ${inCm ? "cm" : unit}`;
}
