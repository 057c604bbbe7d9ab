// @ts-check
/** Outlines of arrows on the screen. Arithmetic only, without a page. */

import { ARC_BEYOND, ARC_HEAD, ARC_OPEN, HEAD, SIDE, WORKS } from "./looks.js";
import { effortOf } from "./swing.js";

/** Pixels below which an arrow is not drawn. */
const SHORTEST = 3;

/** @param {number} value */
const text = (value) => value.toFixed(1);

/** The length of the head of an arrow of that length, px. @param {number} length */
export const headOf = (length) => Math.min(HEAD, length);

/**
 * The outline of a head.
 *
 * @param {number} x of its tip @param {number} y
 * @param {number} angle direction on the screen, radians
 * @param {number} length
 * @param {boolean} open of two strokes
 */
export function head(x, y, angle, length, open) {
  const [u, v] = [Math.cos(angle), Math.sin(angle)];
  const side = (length * SIDE) / HEAD;
  const [bx, by] = [x - length * u, y - length * v];
  const [left, right] = [`${text(bx - side * v)} ${text(by + side * u)}`, `${text(bx + side * v)} ${text(by - side * u)}`];
  const tip = `${text(x)} ${text(y)}`;
  return open ? `M${left}L${tip}L${right}` : `M${left}L${tip}L${right}Z`;
}

/**
 * The outline of an arrow; empty if it is too short to be seen.
 *
 * @param {number} x of its beginning, pixels @param {number} y
 * @param {number} dx @param {number} dy
 * @param {boolean} open its head is of two strokes
 */
export function arrow(x, y, dx, dy, open = false) {
  const length = Math.hypot(dx, dy);
  if (!(length >= SHORTEST)) return "";
  const size = headOf(0.6 * length);
  const part = open ? 1 : (length - size) / length;
  const shaft = `M${text(x)} ${text(y)}L${text(x + part * dx)} ${text(y + part * dy)}`;
  return shaft + head(x + dx, y + dy, Math.atan2(dy, dx), size, open);
}

/**
 * The arrows of the constant forces on masses.
 *
 * @param {import("./plan.js").Plan} plan
 * @param {Float64Array | Float32Array} places of all masses on the screen
 * @param {number} step pixels of a unit of the world
 */
export function loadArrows({ loads }, places, step) {
  let path = "";
  for (let i = 0; i < loads.length; i += 3) {
    const [mass, x, y] = loads.subarray(i, i + 3);
    path += arrow(places[2 * mass], places[2 * mass + 1], x * step, -y * step);
  }
  return path;
}


/**
 * What motors and keys do: an arc about the mass of each motor's joint that turns with its second spring, with a head that
 * says which way it turns; and an arrow for each force that keys work.
 *
 * @param {import("./plan.js").Plan} plan
 * @param {import("./plan.js").Frame} frame
 * @param {Float64Array | Float32Array} places of all masses on the screen
 * @param {number} step pixels of a unit of the world
 * @returns {{works: string, rests: string}} outlines of strokes: of what works now, and of what rests
 */
export function drivenArrows(plan, frame, places, step) {
  const { motors, pushes, joints, springs, radius, flip } = plan;
  const paths = { works: "", rests: "" };
  /** @param {number} keys @param {(way: number) => string} outline */
  const add = (keys, outline) => {
    const effort = effortOf(frame, keys);
    paths[Math.abs(effort) > WORKS ? "works" : "rests"] += outline(effort < -WORKS ? -1 : 1);
  };
  for (let i = 0; i < motors.length; i += 3) {
    const [joint, turn, keys] = motors.subarray(i, i + 3);
    const [, spring, mass, sense] = joints.subarray(4 * joint, 4 * joint + 4);
    const far = springs[2 * spring + (sense > 0 ? 1 : 0)];
    const [x, y] = [places[2 * mass], places[2 * mass + 1]];
    const along = Math.atan2(places[2 * far + 1] - y, places[2 * far] - x);
    add(keys, (way) => arc(x, y, radius[mass] * step + ARC_BEYOND, along, -flip * turn * way));
  }
  for (let i = 0; i < pushes.length; i += 4) {
    const [mass, x, y, keys] = pushes.subarray(i, i + 4);
    add(keys, (way) => arrow(places[2 * mass], places[2 * mass + 1], way * x * step, -way * y * step, true));
  }
  return paths;
}

/**
 * The outline of an arc with a head.
 *
 * @param {number} x of its middle @param {number} y @param {number} r
 * @param {number} along angle on the screen at which it is open, radians
 * @param {number} way 1 clockwise, -1 anticlockwise
 */
function arc(x, y, r, along, way) {
  const [from, to] = [along + (way * ARC_OPEN) / 2, along + way * (2 * Math.PI - ARC_OPEN / 2)];
  const at = (/** @type {number} */ angle) => [x + r * Math.cos(angle), y + r * Math.sin(angle)];
  const [[ax, ay], [bx, by]] = [at(from), at(to)];
  const curve = `M${text(ax)} ${text(ay)}A${text(r)} ${text(r)} 0 1 ${way > 0 ? 1 : 0} ${text(bx)} ${text(by)}`;
  // A head on a circle looks straight where it points to the middle of its own length.
  return curve + head(bx, by, to + way * (Math.PI / 2 - ARC_HEAD / r / 2), ARC_HEAD, true);
}
