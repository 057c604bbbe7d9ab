// @ts-check
/**
 * Outlines on the screen of what surrounds and fills a body: arithmetic only, without a page.
 *
 * @typedef {import("./plan.js").Plan} Plan
 * @typedef {object} Screen pixels of the window = origin + step * world
 * @property {number} x
 * @property {number} y
 * @property {number} step pixels of a unit of the world; y of the screen grows downwards
 * @typedef {{left: number, right: number, top: number, bottom: number}} Box pixels of the window
 * @typedef {{x: number, y: number}} Point pixels of the window
 */

import { roundDown } from "./axes.js";
import {
  CREST, DENSE, GRAIN, GRAINS, HATCH, PARTS, POINT, RIPPLE, RIPPLES, STREAK, STREAKS, STROKE,
} from "./looks.js";

/** Numbers of each wave of gusts. */
const WAVE = 5;

/** The corners of a box, clockwise. @param {Box} box @returns {Point[]} */
const cornersOf = ({ left, right, top, bottom }) =>
  [{ x: left, y: top }, { x: right, y: top }, { x: right, y: bottom }, { x: left, y: bottom }];

/** The place of a mass among those of all. @param {Float64Array} places @param {number} mass */
const placeOf = (places, mass) => ({ x: places[2 * mass], y: places[2 * mass + 1] });

/** A point of a path. @param {Point} point */
const text = ({ x, y }) => `${x.toFixed(1)} ${y.toFixed(1)}`;

/**
 * The visible part of a wall, or of a rail.
 *
 * @param {Plan} plan
 * @param {Float32Array} rows of walls, or of rails
 * @param {number} index of the wall
 * @param {Screen} on
 * @param {Box} view
 * @returns {{at: Point, normal: Point, corners: Point[], surface: Point[]}} its point and normal, the
 *   corners of the part in view, and the ends of the surface in view: two, or none
 */
export function wallInView(plan, rows, index, on, view) {
  const [px, py, nx, ny] = rows.subarray(4 * index, 4 * index + 4);
  const at = onScreen(plan, on, px, py);
  const normal = { x: nx, y: -ny * plan.flip };
  const box = cornersOf(view);
  const depths = box.map(({ x, y }) => (at.x - x) * normal.x + (at.y - y) * normal.y);
  /** @type {Point[]} */
  const corners = [];
  /** @type {Point[]} */
  const surface = [];
  box.forEach((corner, i) => {
    const [depth, next, after] = [depths[i], depths[(i + 1) % 4], box[(i + 1) % 4]];
    if (depth >= 0) corners.push(corner);
    if (depth >= 0 === next >= 0) return;
    const part = depth / (depth - next);
    const crossing = { x: corner.x + part * (after.x - corner.x), y: corner.y + part * (after.y - corner.y) };
    corners.push(crossing);
    surface.push(crossing);
  });
  return { at, normal, corners, surface };
}

/**
 * The part of a wall's surface that no other wall covers.
 *
 * @param {{surface: Point[]}} wall
 * @param {{at: Point, normal: Point}[]} others
 * @returns {Point[]} two ends, or none
 */
export function uncovered({ surface }, others) {
  let ends = surface;
  for (const { at, normal } of others) {
    if (ends.length < 2) return [];
    const [one, two] = ends;
    const [a, b] = ends.map(({ x, y }) => (x - at.x) * normal.x + (y - at.y) * normal.y);
    if (a < 0 && b < 0) return [];
    if (a < 0 !== b < 0) {
      const crossing = { x: one.x + (a / (a - b)) * (two.x - one.x), y: one.y + (a / (a - b)) * (two.y - one.y) };
      ends = a < 0 ? [crossing, two] : [one, crossing];
    }
  }
  return ends;
}

/** Between two of the grid's thick lines, px. @param {number} size of the scene's frame, px: the larger of its sides */
const majorStep = (size) => roundDown(size / 5);

/**
 * Distance of the visible lines of the grid, px.
 *
 * @param {number} size of the scene's frame, px: the larger of its sides
 * @param {number} scale pixels of a px
 */
export function gridStep(size, scale) {
  const major = majorStep(size);
  return (major / 5) * scale < DENSE ? major : major / 5;
}

/**
 * The grid over the whole view.
 *
 * @param {Plan} plan
 * @param {number} size of the scene's frame, px: the larger of its sides
 * @param {Screen} on
 * @param {Box} view
 * @returns {{grid: string, major: string}} thin lines, and every fifth, at round numbers
 */
export function gridLines(plan, size, on, view) {
  const scale = plan.scale * on.step;
  const major = majorStep(size);
  const lines = { grid: "", major: "" };
  /** @param {number} start pixels of the window, where px are 0 @param {number} from @param {number} to @param {(at: string) => string} line */
  const rule = (start, from, to, line) => {
    const every = gridStep(size, scale) * scale;
    for (let k = Math.ceil((from - start) / every); start + k * every <= to; k++) {
      lines[every < major * scale * 0.9 && k % 5 ? "grid" : "major"] += line((start + k * every).toFixed(1));
    }
  };
  if (major * scale < DENSE) return lines;
  rule(on.x - plan.x * scale, view.left, view.right, (x) => `M${x} ${view.top}V${view.bottom}`);
  rule(on.y + plan.y * scale * plan.flip, view.top, view.bottom, (y) => `M${view.left} ${y}H${view.right}`);
  return lines;
}

/** A closed outline; empty without corners. @param {Point[]} corners */
export const outline = (corners) => corners.length ? `M${corners.map(text).join("L")}Z` : "";

/**
 * The strokes along a wall's surface, which are fixed in the scene; on a belt, heads of arrows that point where it runs.
 *
 * @param {{at: Point, normal: Point, surface: Point[]}} wall
 * @param {number} scale pixels of a px
 * @param {number} [belt] its speed
 */
export function hatching({ at, normal, surface }, scale, belt = 0) {
  if (surface.length < 2) return "";
  const along = { x: -normal.y, y: normal.x };
  const [one, two] = surface.map(({ x, y }) => (x - at.x) * along.x + (y - at.y) * along.y);
  const gap = 2 ** Math.round(Math.log2(HATCH / scale)) * scale;
  let strokes = "";
  for (let k = Math.ceil(Math.min(one, two) / gap); k * gap <= Math.max(one, two); k++) {
    const from = { x: at.x + k * gap * along.x, y: at.y + k * gap * along.y };
    /** A place so many strokes into the wall and along it. @param {number} depth @param {number} way */
    const place = (depth, way) => ({ x: from.x - STROKE * (depth * normal.x + way * along.x), y: from.y - STROKE * (depth * normal.y + way * along.y) });
    const back = 0.5 * Math.sign(belt);
    strokes += (belt ? [place(0.5, back), place(1, 0), place(1.5, back)] : [from, place(1, 1)]).map((point, i) => `${i ? "L" : "M"}${text(point)}`).join("");
  }
  return strokes;
}

/** @param {number} a @param {number} b */
const pair = (a, b) => `${Math.min(a, b)} ${Math.max(a, b)}`;

/**
 * Pairs of masses between which all springs are broken, as `leaking` in sim/model/system.py has them.
 *
 * @param {ArrayLike<number>} springs both masses of each
 * @param {Set<number>} broken
 */
function gapsOf(springs, broken) {
  /** @param {number} s */
  const ends = (s) => pair(springs[2 * s], springs[2 * s + 1]);
  const gaps = new Set(Array.from(broken, ends));
  for (let s = 0; gaps.size && s < springs.length / 2; s++) if (!broken.has(s)) gaps.delete(ends(s));
  return gaps;
}

/**
 * The outlines of loops that are filled with gas, or with liquid, and not leaking.
 *
 * @param {Plan} plan
 * @param {Float64Array} places of the masses in pixels of the window, x and y of each
 * @param {boolean} gas
 * @param {Set<number>} broken
 */
export function loops({ fillings, springs }, places, gas, broken) {
  let outlines = "";
  const gaps = gapsOf(springs, broken);
  for (let i = 0; i < fillings.length; i += 2 + fillings[i + 1]) {
    if ((fillings[i] === 1) !== gas) continue;
    const loop = Array.from(fillings.subarray(i + 2, i + 2 + fillings[i + 1]));
    if (gaps.size && loop.some((mass, k) => gaps.has(pair(mass, loop[(k + 1) % loop.length])))) continue;
    outlines += outline(loop.map((mass) => placeOf(places, mass)));
  }
  return outlines;
}

/**
 * What changes only with the camera: the grid, a medium, the ground, and the walls.
 *
 * @param {{plan: Plan, on: Screen, box: Box}} seen
 * @param {number} size of the scene's frame, px: the larger of its sides
 */
export function standing({ plan, on, box }, size) {
  const found = { wall: "", hatch: "", surface: "", rail: "", ...gridLines(plan, size, on, box), ...resisting(plan, on, box) };
  const walls = Array.from({ length: plan.walls.length / 4 }, (_, i) => wallInView(plan, plan.walls, i, on, box));
  walls.forEach((wall, i) => {
    found.wall += outline(wall.corners);
    const surface = uncovered(wall, walls.filter((other) => other !== wall));
    found.hatch += hatching({ ...wall, surface }, plan.scale * on.step, plan.belts[i]);
    found.surface += outline(surface);
  });
  for (let i = 0; i < plan.rails.length / 4; i++) found.rail += outline(wallInView(plan, plan.rails, i, on, box).surface);
  return found;
}

/**
 * A medium as water on a map, over the whole view, and the ground as sand. Their marks are fixed in the scene, to show how
 * a body moves; if wind moves the medium, its streaks show that instead.
 *
 * @param {Plan} plan
 * @param {Screen} on
 * @param {Box} view
 */
export function resisting(plan, on, view) {
  const found = { medium: "", ripple: "", ground: "", grain: "" };
  const all = outline(cornersOf(view));
  if (plan.medium) found.medium = all;
  if (plan.medium && !(meanWind(plan) > 0)) {
    for (const { x, y } of scattered(plan, on, view, RIPPLES)) {
      const points = Array.from({ length: 2 * PARTS + 1 }, (_, k) => {
        const part = k / (2 * PARTS);
        return text({ x: x + (part - 0.5) * RIPPLE, y: y - CREST * Math.sin(4 * Math.PI * part) });
      });
      found.ripple += `M${points.join("L")}`;
    }
  }
  if (plan.ground) {
    found.ground = all;
    for (const { i, j, x, y } of scattered(plan, on, view, GRAINS)) {
      const [turn, long] = [Math.PI * chance(i, j, 2), GRAIN * (0.2 + 0.8 * chance(i, j, 3))];
      const end = { x: x + long * Math.cos(turn), y: y + long * Math.sin(turn) };
      found.grain += `M${text({ x, y })}L${text(end)}`;
    }
  }
  return found;
}

/** The speed of the mean wind, px/s. @param {Plan} plan */
const meanWind = ({ wind }) => wind.length ? Math.hypot(wind[0], wind[1]) : 0;

/**
 * What moves with the body: its skin and its fillings.
 *
 * @param {{plan: Plan, places: Float64Array}} seen
 * @param {Set<number>} broken
 */
export const moving = ({ plan, places }, broken) => ({
  skin: plan.contact ? skin(plan, places, broken) : "",
  gas: loops(plan, places, true, broken),
  liquid: loops(plan, places, false, broken),
});

/**
 * Lines along unbroken springs; as wide as contact reaches, they touch where it begins.
 *
 * @param {Plan} plan
 * @param {Float64Array} places of the masses in pixels of the window, x and y of each
 * @param {Set<number>} broken
 */
export function skin({ springs }, places, broken) {
  let lines = "";
  for (let i = 0; i < springs.length / 2; i++) {
    if (broken.has(i)) continue;
    lines += `M${text(placeOf(places, springs[2 * i]))}L${text(placeOf(places, springs[2 * i + 1]))}`;
  }
  return lines;
}

/**
 * The velocity of the air, px/s, at a place that moves with the mean wind, where gusts do not change.
 *
 * @param {Float32Array} wind
 * @param {number} x of the place at time zero, px @param {number} y
 */
export function airAt(wind, x, y) {
  let [u, v] = wind;
  for (let k = 2; k + WAVE <= wind.length; k += WAVE) {
    const sine = Math.sin(wind[k] * x + wind[k + 1] * y + wind[k + 4]);
    u += wind[k + 2] * sine;
    v += wind[k + 3] * sine;
  }
  return { u, v };
}

/** A pseudorandom number from 0 to 1, always the same for a cell. @param {number} i @param {number} j @param {number} k */
function chance(i, j, k) {
  const value = Math.sin(127.1 * i + 311.7 * j + 74.7 * k) * 43758.5453;
  return value - Math.floor(value);
}

/**
 * Pseudorandom places over the whole view, one in each cell of a lattice.
 *
 * @param {Plan} plan
 * @param {Screen} on
 * @param {Box} view
 * @param {number} apart mean distance, pixels
 * @param {Point} drift of the lattice, px
 * @returns {({i: number, j: number, at: Point} & Point)[]} the cell, its place before the drift, px, and after it, pixels
 *   of the window
 */
function scattered(plan, on, view, apart, drift = { x: 0, y: 0 }) {
  const scale = plan.scale * on.step;
  const cell = 2 ** Math.round(Math.log2(apart / scale));
  // The view in the scene, from low to high.
  const [left, right] = [view.left, view.right].map((x) => plan.x + (x - on.x) / scale);
  const ends = [view.top, view.bottom].map((y) => plan.y + ((on.y - y) / scale) * plan.flip);
  const first = { i: Math.floor((left - drift.x) / cell), j: Math.floor((Math.min(...ends) - drift.y) / cell) };
  const last = { i: Math.ceil((right - drift.x) / cell), j: Math.ceil((Math.max(...ends) - drift.y) / cell) };
  const places = [];
  for (let i = first.i; i <= last.i; i++) {
    for (let j = first.j; j <= last.j; j++) {
      const at = { x: (i + chance(i, j, 0)) * cell, y: (j + chance(i, j, 1)) * cell };
      places.push({ i, j, at, ...onScreen(plan, on, at.x + drift.x, at.y + drift.y) });
    }
  }
  return places;
}

/** A place of the scene in pixels of the window. @param {Plan} plan @param {Screen} on @param {number} x @param {number} y */
function onScreen(plan, on, x, y) {
  const scale = plan.scale * on.step;
  return { x: on.x + (x - plan.x) * scale, y: on.y - (y - plan.y) * scale * plan.flip };
}

/**
 * Streaks of air, one in each cell of a lattice that drifts with the mean wind: each is a piece of a streamline with a
 * point at its end.
 *
 * @param {Plan} plan
 * @param {number} time s
 * @param {Screen} on
 * @param {Box} view
 */
export function streaks(plan, time, on, view) {
  const { wind } = plan;
  const speed = meanWind(plan);
  if (!(speed > 0)) return "";
  const drift = { x: wind[0] * time, y: wind[1] * time };
  const lasting = STREAK / (speed * plan.scale * on.step * PARTS);
  let lines = "";
  for (const { x, y, at } of scattered(plan, on, view, STREAKS, drift)) {
    const points = [{ x, y }];
    for (let part = 0; part < PARTS; part++) {
      const { u, v } = airAt(wind, at.x, at.y);
      at.x -= u * lasting;
      at.y -= v * lasting;
      points.push(onScreen(plan, on, at.x + drift.x, at.y + drift.y));
    }
    lines += `M${points.map(text).join("L")}${point(points[0], points[1])}`;
  }
  return lines;
}

/** The point of an arrow. @param {Point} tip @param {Point} from */
function point(tip, from) {
  const length = Math.hypot(tip.x - from.x, tip.y - from.y);
  if (!(length > 0)) return "";
  const [dx, dy] = [((from.x - tip.x) / length) * POINT, ((from.y - tip.y) / length) * POINT];
  const [one, two] = [1, -1].map((side) => ({ x: tip.x + dx - side * dy * 0.7, y: tip.y + dy + side * dx * 0.7 }));
  return `M${text(one)}L${text(tip)}L${text(two)}`;
}
