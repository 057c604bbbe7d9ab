// @ts-check
/** Outlines of what motors and keys do. Arithmetic only, without a page. */

import { arrow, head } from "./arrow_shapes.js";
import { ARC_BEYOND, ARC_HEAD, ARC_OPEN, WORKS } from "./looks.js";
import { effortOf } from "./swing.js";

/** @param {number} value */
const text = (value) => value.toFixed(1);

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
