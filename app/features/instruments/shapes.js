// @ts-check
/**
 * Ruler, protractor, stopwatch and light gate: where they are, what they read, and how they are stored. Arithmetic only, without a
 * page.
 *
 * Their points are in the page's world, so that they stay in place under zoom and pan and are in view in another scene,
 * too. A point on a mass moves with it.
 *
 * @typedef {"ruler" | "protractor" | "stopwatch" | "gate"} Kind
 * @typedef {{x: number, y: number}} Place pixels of the window
 * @typedef {{x: number, y: number, mass: number}} Point in the world, and the mass that it is on, or -1
 * @typedef {{since: number | null, before: number, laps: number[]}} Watch a stopwatch of simulated time: when it was
 *   started last, or null while it is stopped; seconds counted before that; seconds at the end of each of the last laps
 * @typedef {{kind: Kind, points: Point[], watch?: Watch, gate?: import("./gate.js").Gate}} Placed an instrument
 *   on the canvas; all but what crossed its gate is stored
 * @typedef {import("../../stage/screen.js").Screen} Screen
 */
import { decimal } from "../../words/words.js";
import { roundUp } from "../../stage/axes.js";
import { nearest, worldAt } from "../../stage/screen.js";

/** Number of points. @type {Record<Kind, number>} */
const POINTS = { ruler: 2, protractor: 3, stopwatch: 1, gate: 2 };
/** Pixels within which a point snaps to a mass. */
export const SNAP = 12;
/** Pixels between the ticks of a ruler, at least. */
const TICK = 6;
const MAX_TICKS = 600;
const MAX_LAPS = 4;

/** A reading, with a typographic minus sign. @param {number} value */
export const digits = (value) => decimal(value.toFixed(Math.abs(value) < 9.995 ? 2 : 1)).replace("-", "−");

/**
 * Where points are on the screen. A point on a mass is moved to that mass; in a body without such a mass it stays.
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
 * The point at a place on the screen; on the nearest mass, if one is within reach.
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
 * The reading of a ruler, px of the scene.
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
 * The reading of a protractor: the angle at the middle point between the other two, degrees in 0..180, and the bend from
 * a straight line, which is what a joint's angle is.
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
 * The ticks of a ruler at round lengths, as a path.
 *
 * @param {Place} a
 * @param {Place} b
 * @param {Place} normal of length 1, towards their side
 * @param {number} scale pixels of a px
 */
export function ticks(a, b, normal, scale) {
  const length = Math.hypot(b.x - a.x, b.y - a.y);
  const every = roundUp(Math.max(TICK, length / MAX_TICKS) / scale) * scale;
  let path = "";
  for (let k = 0; k * every <= length + 1e-6; k++) {
    const part = length ? (k * every) / length : 0;
    const [x, y] = [a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)];
    const size = k % 10 === 0 ? 13 : k % 5 === 0 ? 9 : 5;
    path += `M${x.toFixed(1)} ${y.toFixed(1)}l${(size * normal.x).toFixed(1)} ${(size * normal.y).toFixed(1)}`;
  }
  return path;
}

/** @returns {Watch} */
export const newWatch = () => ({ since: null, before: 0, laps: [] });

/** Seconds that it shows; time that was taken back does not count. @param {Watch} watch @param {number} now */
export const watchReading = ({ since, before }, now) => before + (since === null ? 0 : Math.max(now - since, 0));

/** @param {Watch} watch @param {number} now @returns {Watch} */
export const startOrStop = (watch, now) =>
  watch.since === null ? { ...watch, since: now } : { ...watch, since: null, before: watchReading(watch, now) };

/** Records a lap while it runs; else sets it to zero. @param {Watch} watch @param {number} now @returns {Watch} */
export const lapOrZero = (watch, now) =>
  watch.since === null ? newWatch() : { ...watch, laps: [...watch.laps, watchReading(watch, now)].slice(-MAX_LAPS) };

/** The instruments that were stored; unknown ones, by another version of the page, are dropped. @param {string | null} text JSON @returns {Placed[]} */
export function restored(text) {
  try {
    const found = /** @type {Placed[]} */ (JSON.parse(text ?? "[]"));
    return found.filter(({ kind, points }) => points.length === POINTS[kind]);
  } catch {
    return [];
  }
}
