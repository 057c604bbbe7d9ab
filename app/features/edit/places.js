// @ts-check
/** Where things are for an edit: what is under the pointer, the nearest crossing of the grid, directions and distances. */
import { gridStep } from "../../stage/environment.js";
import { shown } from "../../stage/canvas.js";
import { pageState } from "../../wire/channel.js";
import { editing } from "./editing.js";
import { sight } from "../../stage/sight.js";
import { jointAt, rounded, springAt } from "./pick.js";
import { massAt } from "../../ui/hands/pointer.js";
import { wireNumber, worldAt } from "../../stage/screen.js";

/**
 * @typedef {import("./pick.js").Place} Place
 * @typedef {import("./pick.js").Parts} Parts
 */

/** Pixels from a spring within which it is meant. */
export const REACH = { mouse: 9, pen: 12, touch: 18 };
/** Pixels from a mass within which its corners are shown and hit, and the knob of a joint stands. */
export const CORNER = 58;

/** @param {Record<string, number>} reach @param {string} kind */
export const within = (reach, kind) => reach[kind] ?? reach.mouse;

/**
 * What is under a place: a mass before a joint before a spring.
 *
 * @param {Place} at @param {string} kind of pointer
 * @returns {Parts}
 */
export function partAt(at, kind) {
  const nothing = { masses: [], springs: [], joints: [] };
  const seen = sight();
  if (!seen) return nothing;
  const mass = massAt(at, kind);
  if (mass >= 0) return { ...nothing, masses: [mass] };
  const joint = jointAt(seen.plan, seen.places, at, seen.on.step);
  if (joint >= 0) return { ...nothing, joints: [joint] };
  const spring = springAt(seen.plan, seen.places, at, within(REACH, kind), shown().damage.broken);
  return spring >= 0 ? { ...nothing, springs: [spring] } : nothing;
}

/** @param {Parts} parts */
export const isNothing = ({ masses, springs, joints }) => masses.length + springs.length + joints.length === 0;
/** @param {Parts} parts */
export const isSelected = (parts) =>
  /** @type {const} */ (["masses", "springs", "joints"]).some((kind) => parts[kind].length > 0 && editing.selected[kind].includes(parts[kind][0]));

/** The step of the grid that is seen, px of the scene. */
export function step() {
  const seen = sight();
  const { plan, on } = seen ?? {};
  if (!plan || !on) return 1;
  return gridStep(Math.max(pageState().width ?? 0, pageState().height ?? 0) / plan.scale, plan.scale * on.step);
}

/**
 * The nearest crossing of the grid's lines.
 *
 * @param {Place} at @param {boolean} free off the grid
 */
export function snapped(at, free) {
  const seen = sight();
  if (!seen || free) return at;
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

/** The direction of a place from a mass, degrees anticlockwise. @param {number} mass @param {Place} at */
export function directionTo(mass, at) {
  const places = sight()?.places ?? new Float64Array(2 * mass + 2);
  return (Math.atan2(places[2 * mass + 1] - at.y, at.x - places[2 * mass]) * 180) / Math.PI;
}

/** @param {number} mass @param {Place} at */
export function distanceTo(mass, at) {
  const places = sight()?.places;
  return places ? Math.hypot(places[2 * mass] - at.x, places[2 * mass + 1] - at.y) : Infinity;
}

/** The joint whose knob can be turned: the one that is selected alone. */
export function turnable() {
  const { masses, springs, joints } = editing.selected;
  const alone = editing.tool === "joint" && joints.length === 1 && masses.length + springs.length === 0;
  return alone && 4 * joints[0] < (shown().pictured?.joints.length ?? 0) ? joints[0] : -1;
}
