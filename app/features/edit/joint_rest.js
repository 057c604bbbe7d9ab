// @ts-check
/** Between the rest angle of a joint and the direction in which its second spring rests on the screen; degrees. */
import { shown } from "../../stage/canvas.js";
import { jointAngles } from "../../stage/measures.js";

/** The direction of the first spring of a joint, from which angles count, and which way they turn. @param {number} joint */
function origin(joint) {
  const { pictured: plan, frame } = shown();
  return plan && frame ? { from: jointAngles(plan, frame, joint).from, flip: plan.flip } : { from: 0, flip: 1 };
}

/** The rest angle that has the second spring in a direction. @param {number} joint @param {number} direction */
export function restAt(joint, direction) {
  const { from, flip } = origin(joint);
  const angle = (((direction - from) % 360) + 540) % 360 - 180;
  return Number((angle * flip).toFixed(4));
}

/** The direction in which the second spring rests at a rest angle. @param {number} joint @param {number} angle */
export function directionAt(joint, angle) {
  const { from, flip } = origin(joint);
  return from + angle * flip;
}

/** The direction in which a joint's second spring rests now. @param {number} joint */
export function restDirection(joint) {
  const { pictured: plan, frame, damage } = shown();
  const angle = (plan?.restAngle[joint] ?? 0) + (frame?.angleShift ?? 0) + (damage.setAngle[joint] ?? 0);
  return directionAt(joint, angle);
}
