// @ts-check
/**
 * What is under the pointer: a mass, a joint, a spring, or a corner that has no joint yet. Arithmetic only.
 *
 * @typedef {import("../../stage/plan.js").Plan} Plan
 * @typedef {{x: number, y: number}} Place pixels
 * @typedef {{masses: number[], springs: number[], joints: number[]}} Parts
 */
import { wrapped } from "../../stage/draw.js";

/** A wedge reaches so many times as far as its mass. */
const WEDGE = 2.6;
/** Pixels that a wedge reaches at least, for the pointer. */
const MIN_WEDGE = 24;

/** The direction from one mass to another on the screen, degrees anticlockwise from the right. @param {ArrayLike<number>} places @param {number} from @param {number} to */
const directionOf = (places, from, to) =>
  (Math.atan2(places[2 * from + 1] - places[2 * to + 1], places[2 * to] - places[2 * from]) * 180) / Math.PI;

/** How far anticlockwise it is from one direction to another, degrees in [0, 360). @param {number} from @param {number} to */
export const turnTo = (from, to) => (((to - from) % 360) + 360) % 360;

/**
 * How far a place is from a line between two others, pixels.
 *
 * @param {Place} at @param {number} ax @param {number} ay @param {number} bx @param {number} by
 */
export function distanceTo({ x, y }, ax, ay, bx, by) {
  const [dx, dy] = [bx - ax, by - ay];
  const square = dx * dx + dy * dy;
  const part = square > 0 ? Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / square)) : 0;
  return Math.hypot(x - ax - part * dx, y - ay - part * dy);
}

/**
 * The nearest spring within reach, or -1.
 *
 * @param {Plan} plan
 * @param {ArrayLike<number>} places of the masses
 * @param {Place} at
 * @param {number} reach pixels
 * @param {Set<number>} broken springs that are gone
 */
export function springAt(plan, places, at, reach, broken) {
  const { springs } = plan;
  let [found, least] = [-1, reach];
  for (let s = 0; 2 * s < springs.length; s++) {
    if (broken.has(s)) continue;
    const [a, b] = [2 * springs[2 * s], 2 * springs[2 * s + 1]];
    const distance = distanceTo(at, places[a], places[a + 1], places[b], places[b + 1]);
    if (distance < least) [found, least] = [s, distance];
  }
  return found;
}

/**
 * The two springs of a joint as they leave its mass: directions, degrees.
 *
 * @param {Plan} plan @param {ArrayLike<number>} places @param {number} joint
 */
export function armsOf({ springs, joints }, places, joint) {
  const tip = joints[4 * joint + 2];
  const [one, two] = [joints[4 * joint], joints[4 * joint + 1]].map((s) => {
    const [a, b] = [springs[2 * s], springs[2 * s + 1]];
    return directionOf(places, tip, a === tip ? b : a);
  });
  return { tip, one, two };
}

/** Whether a direction lies in the smaller of the two angles between two others. @param {number} direction @param {number} one @param {number} two */
function isBetween(direction, one, two) {
  const turn = wrapped(two - one);
  const part = wrapped(direction - one);
  return turn >= 0 ? part >= 0 && part <= turn : part <= 0 && part >= turn;
}

/**
 * The joint whose wedge is at a place, or -1; of several the narrowest.
 *
 * @param {Plan} plan @param {ArrayLike<number>} places @param {Place} at
 * @param {number} step pixels of a unit of the world
 */
export function jointAt(plan, places, at, step) {
  const { joints, radius } = plan;
  let [found, least] = [-1, Infinity];
  for (let j = 0; 4 * j < joints.length; j++) {
    const tip = joints[4 * j + 2];
    const [dx, dy] = [at.x - places[2 * tip], places[2 * tip + 1] - at.y];
    const distance = Math.hypot(dx, dy);
    if (distance > Math.max(WEDGE * radius[tip] * step, MIN_WEDGE)) continue;
    const { one, two } = armsOf(plan, places, j);
    const width = Math.abs(wrapped(two - one));
    if (width < least && isBetween((Math.atan2(dy, dx) * 180) / Math.PI, one, two)) [found, least] = [j, width];
  }
  return found;
}

/**
 * The corners of a mass: neighbouring springs around it, with the joint that holds them, or -1.
 *
 * @param {Plan} plan @param {ArrayLike<number>} places @param {number} mass @param {Set<number>} broken
 * @returns {{a: number, b: number, from: number, turn: number, joint: number}[]} springs, direction of the first, degrees anticlockwise to the second
 */
export function cornersOf(plan, places, mass, broken) {
  const { springs, joints } = plan;
  /** @type {{spring: number, direction: number}[]} */
  const spokes = [];
  for (let s = 0; 2 * s < springs.length; s++) {
    const [a, b] = [springs[2 * s], springs[2 * s + 1]];
    if ((a !== mass && b !== mass) || broken.has(s)) continue;
    spokes.push({ spring: s, direction: directionOf(places, mass, a === mass ? b : a) });
  }
  if (spokes.length < 2) return [];
  spokes.sort((one, two) => one.direction - two.direction);
  /** @param {number} a @param {number} b */
  const joint = (a, b) => {
    for (let j = 0; 4 * j < joints.length; j++) {
      const [c, d] = [joints[4 * j], joints[4 * j + 1]];
      if ((c === a && d === b) || (c === b && d === a)) return j;
    }
    return -1;
  };
  return spokes.map(({ spring: a, direction: from }, i) => {
    const { spring: b, direction: to } = spokes[(i + 1) % spokes.length];
    return { a, b, from, turn: turnTo(from, to), joint: joint(a, b) };
  });
}

/**
 * Which springs a stroke crosses.
 *
 * @param {Plan} plan @param {ArrayLike<number>} places @param {Place[]} stroke @param {Set<number>} broken
 */
export function crossed({ springs }, places, stroke, broken) {
  /** @param {number} ax @param {number} ay @param {number} bx @param {number} by @param {number} x @param {number} y */
  const side = (ax, ay, bx, by, x, y) => (bx - ax) * (y - ay) - (by - ay) * (x - ax);
  const hit = [];
  for (let s = 0; 2 * s < springs.length; s++) {
    if (broken.has(s)) continue;
    const [a, b] = [2 * springs[2 * s], 2 * springs[2 * s + 1]];
    const [ax, ay, bx, by] = [places[a], places[a + 1], places[b], places[b + 1]];
    for (let k = 1; k < stroke.length; k++) {
      const [c, d] = [stroke[k - 1], stroke[k]];
      if (
        side(ax, ay, bx, by, c.x, c.y) < 0 !== side(ax, ay, bx, by, d.x, d.y) < 0 &&
        side(c.x, c.y, d.x, d.y, ax, ay) * side(c.x, c.y, d.x, d.y, bx, by) < 0
      ) {
        hit.push(s);
        break;
      }
    }
  }
  return hit;
}

/**
 * A stroke with few corners: those are left out that change it least.
 *
 * @param {Place[]} stroke @param {number} most corners
 */
export function thinned(stroke, most) {
  const left = [...stroke];
  while (left.length > most) {
    let [at, least] = [1, Infinity];
    for (let i = 1; i < left.length - 1; i++) {
      const [a, b] = [left[i - 1], left[i + 1]];
      const off = distanceTo(left[i], a.x, a.y, b.x, b.y);
      if (off < least) [at, least] = [i, off];
    }
    left.splice(at, 1);
  }
  return left;
}

/** The nearest multiple of a step. @param {number} value @param {number} step */
export const rounded = (value, step) => Math.round(value / step) * step;
