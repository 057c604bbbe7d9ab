// @ts-check
/**
 * Where things are on the screen, for an edit: what is under the pointer, corners, the rest angles of joints, the grid.
 * Directions are in degrees, anticlockwise from the right.
 *
 * @typedef {import("../../stage/sight.js").Sight} Sight
 * @typedef {{x: number, y: number}} Place pixels
 * @typedef {{masses: number[], springs: number[], joints: number[]}} Parts
 */
import { gridStep } from "../../stage/environment.js";
import { shown } from "../../stage/canvas.js";
import { pageState } from "../../wire/channel.js";
import { wrapped } from "../../stage/draw.js";
import { editing } from "./editing.js";
import { sight } from "../../stage/sight.js";
import { jointAngles } from "../../stage/measures.js";
import { massAt } from "../../ui/hands/pointer.js";
import { wireNumber, worldAt } from "../../stage/screen.js";

/** Pixels within which a spring is under a pointer. */
const REACH = { mouse: 9, pen: 12, touch: 18 };
/** Pixels within which the knob of a joint is under a pointer. */
const KNOB = { mouse: 12, pen: 14, touch: 24 };
/** Pixels from a mass within which its corners are shown and hit, and at which the knob of a joint is. */
export const CORNER = 58;
/** Radius of a joint's wedge, in radii of its mass. */
export const WEDGE = 2.6;
/** Pixels of that radius for the pointer, at least: beyond those from which a finger takes the mass. */
const MIN_WEDGE = { mouse: 24, pen: 30, touch: 56 };

/** @param {Record<string, number>} reach @param {string} kind of pointer */
const within = (reach, kind) => reach[kind] ?? reach.mouse;

// ------------------------------------------------------------------------- geometry
/** @param {Place} one @param {Place} two */
export const distance = (one, two) => Math.hypot(one.x - two.x, one.y - two.y);

/** @param {Place} from @param {Place} to */
export const directionOf = (from, to) => (Math.atan2(from.y - to.y, to.x - from.x) * 180) / Math.PI;

/** The place at some distance in a direction. @param {Place} from @param {number} direction @param {number} far @returns {Place} */
export function off({ x, y }, direction, far) {
  const t = (direction * Math.PI) / 180;
  return { x: x + far * Math.cos(t), y: y - far * Math.sin(t) };
}

/** The anticlockwise turn from one direction to another, in [0, 360). @param {number} from @param {number} to */
export const turnTo = (from, to) => (((to - from) % 360) + 360) % 360;

/** The nearest multiple of a step. @param {number} value @param {number} step */
export const rounded = (value, step) => Math.round(value / step) * step;

/** The distance of a place from a line. @param {Place} at @param {Place} a one end @param {Place} b the other */
function distanceToLine({ x, y }, a, b) {
  const [dx, dy] = [b.x - a.x, b.y - a.y];
  const square = dx * dx + dy * dy;
  const part = square > 0 ? Math.min(1, Math.max(0, ((x - a.x) * dx + (y - a.y) * dy) / square)) : 0;
  return Math.hypot(x - a.x - part * dx, y - a.y - part * dy);
}

/** On which side of the line from a to b a place is, by its sign. @param {Place} a @param {Place} b @param {Place} at */
const side = (a, b, { x, y }) => (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);

/** A stroke with few corners: those that change it least are left out. @param {Place[]} stroke @param {number} most corners */
export function thinned(stroke, most) {
  const left = [...stroke];
  while (left.length > most) {
    let [at, least] = [1, Infinity];
    for (let i = 1; i < left.length - 1; i++) {
      const far = distanceToLine(left[i], left[i - 1], left[i + 1]);
      if (far < least) [at, least] = [i, far];
    }
    left.splice(at, 1);
  }
  return left;
}

// ------------------------------------------------------------------------- the body
/** @param {Pick<Sight, "places">} seen @param {number} mass @returns {Place} */
export const placeOf = ({ places }, mass) => ({ x: places[2 * mass], y: places[2 * mass + 1] });

/** The masses at the ends of a spring. @param {Sight} seen @param {number} spring */
export const endsOf = ({ plan: { springs } }, spring) => [springs[2 * spring], springs[2 * spring + 1]];

/** The springs that are not broken, with the masses at their ends. @param {Sight} seen */
export function springsOf(seen) {
  const { broken } = shown().damage;
  const all = Array.from({ length: seen.plan.springs.length / 2 }, (_, spring) => ({ spring, ends: endsOf(seen, spring) }));
  return all.filter(({ spring }) => !broken.has(spring));
}

/** The two springs of a joint, as they leave its mass. @param {Sight} seen @param {number} joint */
export function armsOf(seen, joint) {
  const [a, b, tip] = seen.plan.joints.subarray(4 * joint, 4 * joint + 3);
  const [one, two] = [a, b].map((spring) => {
    const [from, to] = endsOf(seen, spring);
    return directionOf(placeOf(seen, tip), placeOf(seen, from === tip ? to : from));
  });
  return { tip, one, two };
}

/** The joint of two springs, or -1. @param {Sight} seen @param {number} a @param {number} b */
function jointOf({ plan: { joints } }, a, b) {
  for (let j = 0; 4 * j < joints.length; j++) {
    const [c, d] = joints.subarray(4 * j, 4 * j + 2);
    if ((c === a && d === b) || (c === b && d === a)) return j;
  }
  return -1;
}

/**
 * The corners of a mass: neighbouring springs around it, and the joint that they have, or -1.
 *
 * @param {Sight} seen @param {number} mass
 * @returns {{a: number, b: number, from: number, turn: number, joint: number}[]} springs, direction of the first, anticlockwise turn to the second
 */
export function cornersOf(seen, mass) {
  const spokes = springsOf(seen).filter(({ ends }) => ends.includes(mass)).map(({ spring, ends: [a, b] }) => {
    return { spring, direction: directionOf(placeOf(seen, mass), placeOf(seen, a === mass ? b : a)) };
  });
  if (spokes.length < 2) return [];
  spokes.sort((one, two) => one.direction - two.direction);
  return spokes.map(({ spring: a, direction: from }, i) => {
    const { spring: b, direction: to } = spokes[(i + 1) % spokes.length];
    return { a, b, from, turn: turnTo(from, to), joint: jointOf(seen, a, b) };
  });
}

/** The springs that a stroke crosses. @param {Sight} seen @param {Place[]} stroke */
export const crossed = (seen, stroke) =>
  springsOf(seen).filter(({ ends }) => {
    const [a, b] = ends.map((mass) => placeOf(seen, mass));
    return stroke.slice(1).some((d, k) => side(a, b, stroke[k]) < 0 !== side(a, b, d) < 0 && side(stroke[k], d, a) * side(stroke[k], d, b) < 0);
  }).map(({ spring }) => spring);

// ------------------------------------------------------------------------- under the pointer
/** The nearest spring within reach, or -1. @param {Sight} seen @param {Place} at @param {string} kind of pointer */
export function springAt(seen, at, kind) {
  let [found, least] = [-1, within(REACH, kind)];
  for (const { spring, ends: [a, b] } of springsOf(seen)) {
    const far = distanceToLine(at, placeOf(seen, a), placeOf(seen, b));
    if (far < least) [found, least] = [spring, far];
  }
  return found;
}

/** The joint with the narrowest wedge that contains a place, or -1. @param {Sight} seen @param {Place} at @param {string} kind of pointer */
export function jointAt(seen, at, kind) {
  const { joints, radius } = seen.plan;
  let [found, least] = [-1, Infinity];
  for (let j = 0; 4 * j < joints.length; j++) {
    const mass = joints[4 * j + 2];
    const tip = placeOf(seen, mass);
    if (distance(tip, at) > Math.max(WEDGE * radius[mass] * seen.on.step, within(MIN_WEDGE, kind))) continue;
    const { one, two } = armsOf(seen, j);
    const turn = wrapped(two - one);
    const part = wrapped(directionOf(tip, at) - one) * (turn < 0 ? -1 : 1);
    if (Math.abs(turn) < least && part >= 0 && part <= Math.abs(turn)) [found, least] = [j, Math.abs(turn)];
  }
  return found;
}

/** What is under a place: a mass before a joint before a spring, but a spring that a finger meets before a joint beside it. @param {Place} at @param {string} kind of pointer @returns {Parts} */
export function partAt(at, kind) {
  const nothing = { masses: [], springs: [], joints: [] };
  const seen = sight();
  if (!seen) return nothing;
  const mass = massAt(at, kind);
  if (mass >= 0) return { ...nothing, masses: [mass] };
  const met = jointAt(seen, at, "mouse") < 0 ? springAt(seen, at, "mouse") : -1;
  const joint = met < 0 ? jointAt(seen, at, kind) : -1;
  if (joint >= 0) return { ...nothing, joints: [joint] };
  const spring = met < 0 ? springAt(seen, at, kind) : met;
  return spring >= 0 ? { ...nothing, springs: [spring] } : nothing;
}

/** @param {Parts} parts */
export const isNothing = ({ masses, springs, joints }) => masses.length + springs.length + joints.length === 0;
/** @param {Parts} parts */
export const isSelected = (parts) =>
  /** @type {const} */ (["masses", "springs", "joints"]).some((kind) => parts[kind].length > 0 && editing.selected[kind].includes(parts[kind][0]));

// ------------------------------------------------------------------------- rest angles of joints
/** The joint whose knob can be turned: the only selected part. */
export function turnable() {
  const { masses, springs, joints } = editing.selected;
  const alone = editing.tool === "joint" && joints.length === 1 && masses.length + springs.length === 0;
  return alone && 4 * joints[0] < (shown().pictured?.joints.length ?? 0) ? joints[0] : -1;
}

/** The direction from which the angles of a joint count, and their sense. @param {number} joint */
function origin(joint) {
  const { pictured: plan, frame } = shown();
  return plan && frame ? { from: jointAngles(plan, frame, joint).from, flip: plan.flip } : { from: 0, flip: 1 };
}

/** The rest angle of a joint whose second spring rests in a direction. @param {number} joint @param {number} direction */
export function restAt(joint, direction) {
  const { from, flip } = origin(joint);
  return Number((wrapped(direction - from) * flip).toFixed(4));
}

/** The direction in which the second spring of a joint rests at a rest angle. @param {number} joint @param {number} angle */
export function directionAt(joint, angle) {
  const { from, flip } = origin(joint);
  return from + angle * flip;
}

/** The direction in which the second spring of a joint rests now, or would after the drag. @param {number} joint */
export function restDirection(joint) {
  if (editing.drag?.kind === "turn") return editing.drag.angle;
  const { pictured: plan, frame, damage } = shown();
  return directionAt(joint, (plan?.restAngle[joint] ?? 0) + (frame?.angleShift ?? 0) + (damage.setAngle[joint] ?? 0));
}

/** The mass of a joint, and its knob. @param {Sight} seen @param {number} joint */
export function knobOf(seen, joint) {
  const tip = placeOf(seen, seen.plan.joints[4 * joint + 2]);
  return { tip, direction: restDirection(joint), knob: off(tip, restDirection(joint), CORNER) };
}

/** The joint whose knob is at a place, or -1. @param {Place} at @param {string} kind of pointer */
export function knobAt(at, kind) {
  const [seen, joint] = [sight(), turnable()];
  return seen && joint >= 0 && distance(knobOf(seen, joint).knob, at) <= within(KNOB, kind) ? joint : -1;
}

// ------------------------------------------------------------------------- the grid and the world
/** The step of the visible grid, px of the scene. */
export function step() {
  const { plan, on } = sight() ?? {};
  if (!plan || !on) return 1;
  return gridStep(Math.max(pageState().width ?? 0, pageState().height ?? 0) / plan.scale, plan.scale * on.step);
}

/** The nearest crossing of the grid's lines. @param {Place} at @param {boolean} isFree off the grid */
export function snapped(at, isFree) {
  const seen = sight();
  if (!seen || isFree) return at;
  const { plan, on } = seen;
  const [scale, every] = [plan.scale * on.step, step()];
  const x = rounded((at.x - on.x) / scale + plan.x, every);
  const y = rounded(((on.y - at.y) / scale) * plan.flip + plan.y, every);
  return { x: on.x + (x - plan.x) * scale, y: on.y - (y - plan.y) * scale * plan.flip };
}

/** A place in the page's world, as messages have it. @param {Place} at @returns {[number, number]} */
export function world(at) {
  const seen = sight();
  const point = seen ? worldAt(at, seen.on) : { x: 0, y: 0 };
  return [wireNumber(point.x), wireNumber(point.y)];
}
