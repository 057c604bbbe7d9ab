// @ts-check
/** Outlines of straight arrows on the screen. Arithmetic only, without a page. */

import { HEAD, SIDE } from "./looks.js";

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
