// @ts-check
/**
 * Ruler, protractor and stopwatch: where they are, what they read, and what is kept of them. Arithmetic only, without
 * a page.
 *
 * Their points are in the page's world, so that they stay where they are under zoom and pan, and in another scene are
 * still in view. A point on a mass goes where that goes.
 *
 * @typedef {{x: number, y: number}} Place pixels of the window
 * @typedef {{x: number, y: number, mass: number}} Point in the world, and the mass that it is on, or -1
 * @typedef {import("../../stage/screen.js").Screen} Screen
 */
import { roundUp } from "../../stage/measures.js";
import { nearest, worldAt } from "../../stage/screen.js";

/** @typedef {"ruler" | "protractor" | "stopwatch"} Kind */
/** Points of each kind. @type {Record<Kind, number>} */
export const POINTS = { ruler: 2, protractor: 3, stopwatch: 1 };
/** Pixels within which a point goes onto a mass. */
export const SNAP = 12;
/** Pixels between the strokes of a ruler, at least, and strokes of it, at most. */
const [STROKE, STROKES] = [6, 600];
/** Laps that are kept. */
const LAPS = 4;

/**
 * Where points are on the screen. A point on a mass is moved to where the mass is; in a body without such a mass it
 * stays.
 *
 * @param {Point[]} points
 * @param {Float64Array} places of the masses, x and y of each
 * @param {Screen} on
 * @returns {Place[]}
 */
export function placesOf(points, places, on) {
  return points.map((point) => {
    if (point.mass >= 0 && 2 * point.mass < places.length) {
      Object.assign(point, worldAt({ x: places[2 * point.mass], y: places[2 * point.mass + 1] }, on));
    }
    return { x: on.x + on.step * point.x, y: on.y - on.step * point.y };
  });
}

/**
 * The point at a place on the screen: on the nearest mass, if one is near enough.
 *
 * @param {Place} at
 * @param {Float64Array} places of the masses, x and y of each
 * @param {Screen} on
 * @param {number} [reach] pixels
 * @returns {Point}
 */
export function pointAt(at, places, on, reach = SNAP) {
  const mass = nearest(places, new Float64Array(places.length / 2), at, reach);
  const place = mass < 0 ? at : { x: places[2 * mass], y: places[2 * mass + 1] };
  return { ...worldAt(place, on), mass };
}

/**
 * What a ruler reads, px of the scene.
 *
 * @param {Place} a
 * @param {Place} b
 * @param {number} scale pixels of a px
 * @param {number} flip -1 where y grows downwards
 */
export function rulerReading(a, b, scale, flip) {
  const [dx, dy] = [(b.x - a.x) / scale, (-(b.y - a.y) * flip) / scale];
  return { length: Math.hypot(dx, dy), dx, dy };
}

/**
 * What a protractor reads: the angle at the middle point between the other two, degrees in 0..180, and the turn from
 * going on straight, as a joint's angle is.
 *
 * @param {Place} a
 * @param {Place} vertex
 * @param {Place} b
 */
export function protractorReading(a, vertex, b) {
  const [ax, ay, bx, by] = [a.x - vertex.x, a.y - vertex.y, b.x - vertex.x, b.y - vertex.y];
  const angle = (Math.abs(Math.atan2(ax * by - ay * bx, ax * bx + ay * by)) * 180) / Math.PI;
  return { angle, bend: 180 - angle };
}

/**
 * Strokes of a ruler at round lengths, as a path.
 *
 * @param {Place} a
 * @param {Place} b
 * @param {Place} normal of length 1, to the side where they are
 * @param {number} scale pixels of a px
 */
export function strokes(a, b, normal, scale) {
  const length = Math.hypot(b.x - a.x, b.y - a.y);
  const every = roundUp(Math.max(STROKE, length / STROKES) / scale) * scale;
  let path = "";
  for (let k = 0; k * every <= length + 1e-6; k++) {
    const part = length ? (k * every) / length : 0;
    const [x, y] = [a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)];
    const size = k % 10 === 0 ? 13 : k % 5 === 0 ? 9 : 5;
    path += `M${x.toFixed(1)} ${y.toFixed(1)}l${(size * normal.x).toFixed(1)} ${(size * normal.y).toFixed(1)}`;
  }
  return path;
}

/**
 * A stopwatch of simulated time.
 *
 * @typedef {object} Watch
 * @property {number | null} since simulated time at which it was started last; null while it is stopped
 * @property {number} before seconds that it had run before
 * @property {number[]} laps seconds of each lap's end, the last ones
 */

/** @returns {Watch} */
export const newWatch = () => ({ since: null, before: 0, laps: [] });

/** Seconds that it shows; time that was gone back on does not count. @param {Watch} watch @param {number} now */
export const watchReading = ({ since, before }, now) => before + (since === null ? 0 : Math.max(now - since, 0));

/** @param {Watch} watch @param {number} now @returns {Watch} */
export const startOrStop = (watch, now) =>
  watch.since === null ? { ...watch, since: now } : { ...watch, since: null, before: watchReading(watch, now) };

/** While it runs a lap, else all back to zero. @param {Watch} watch @param {number} now @returns {Watch} */
export const lapOrZero = (watch, now) =>
  watch.since === null ? newWatch() : { ...watch, laps: [...watch.laps, watchReading(watch, now)].slice(-LAPS) };

/** @typedef {{kind: Kind, points: Point[], watch?: Watch}} Kept what is kept of an instrument */

/** What was kept, unless by another version of the page. @param {string | null} text JSON @returns {Kept[]} */
export function restored(text) {
  try {
    const found = /** @type {Kept[]} */ (JSON.parse(text ?? "[]"));
    return found.filter(({ kind, points }) => points.length === POINTS[kind]);
  } catch {
    return [];
  }
}
