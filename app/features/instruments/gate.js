// @ts-check
/**
 * A light gate: when masses cross the segment between two points, from the positions that the page receives anyway.
 * Arithmetic only, without a page.
 *
 * @typedef {import("../../stage/plan.js").Frame} Frame
 * @typedef {import("../../stage/plan.js").Plan} Plan
 * @typedef {import("./shapes.js").Point} Point
 * @typedef {{mass: number, time: number, since: number | null}} Crossing a mass, the simulated time at which it crossed, s,
 *   and the time since the same mass crossed before, if it did
 */

/** Crossings that are kept. */
const MOST = 50;
/** Simulated seconds between two frames beyond which the way between them is unknown. */
const GAP = 0.3;
/** Part of the gate's length by which a mass moves at least: a body at rest trembles by rounding errors. */
const LEAST = 1e-6;

/**
 * Where the ends of a gate are in a frame, px of the scene: x and y of each.
 *
 * @param {Point[]} points in the world; one on a mass moves with it
 * @param {Pick<Plan, "x" | "y" | "scale" | "flip">} plan
 * @param {ArrayLike<number>} positions
 */
export const endsOf = (points, { x, y, scale, flip }, positions) =>
  points.flatMap((point) =>
    point.mass >= 0 && 2 * point.mass + 1 < positions.length
      ? [positions[2 * point.mass], positions[2 * point.mass + 1]]
      : [x + point.x / scale, y + point.y / (scale * flip)],
  );

/** How far a place is beside a segment, and what part of the segment it is along. @param {number[]} ends @param {number} px @param {number} py */
function beside([ax, ay, bx, by], px, py) {
  const [x, y, dx, dy] = [bx - ax, by - ay, px - ax, py - ay];
  const square = x * x + y * y;
  return { away: (x * dy - y * dx) / Math.sqrt(square), part: (x * dx + y * dy) / square };
}

/**
 * The part of the time from the second to the third of three frames after which a distance is zero, from the parabola
 * through its values; from the straight line without the first.
 *
 * @param {number} before the distance at the first frame; NaN if there is none
 * @param {number} from @param {number} to of different signs
 * @param {number} ratio time from the first to the second frame over that from the second to the third
 */
export function whenZero(before, from, to, ratio) {
  let part = from / (from - to);
  if (!Number.isFinite(before)) return part;
  // The distance is from + slope * part + bend * part ** 2.
  const slope = (to - from - (before - from) / ratio ** 2) / (1 + 1 / ratio);
  const bend = to - from - slope;
  for (let i = 0; i < 4; i += 1) {
    const rate = slope + 2 * bend * part;
    if (rate) part -= (from + slope * part + bend * part ** 2) / rate;
  }
  return part >= 0 && part <= 1 ? part : from / (from - to);
}

/** The crossings of a gate. */
export class Gate {
  /** The last of them, in order of time. @type {Crossing[]} */
  crossings = [];
  /** The frames before, the newest last. @type {Frame[]} */
  #frames = [];

  /** Forgets what crossed it. */
  clear() {
    this.crossings = [];
    this.#frames = [];
  }

  /**
   * Takes the next frame.
   *
   * @param {Frame} frame
   * @param {Pick<Plan, "x" | "y" | "scale" | "flip">} plan
   * @param {Point[]} points of the gate
   */
  add(frame, plan, points) {
    const [before] = this.#frames.slice(-1);
    if (before && before.positions.length !== frame.positions.length) this.clear();
    else if (before && frame.time < before.time) {
      // Time went back: what came later is void.
      this.crossings = this.crossings.filter(({ time }) => time <= frame.time);
      this.#frames = [];
    } else if (before && frame.time === before.time) this.#frames.pop();
    const [earlier, last] = this.#frames.length > 1 ? this.#frames : [null, this.#frames[0]];
    if (last && frame.time - last.time <= GAP) this.#cross(earlier, last, frame, plan, points);
    this.#frames = last ? [last, frame] : [frame];
  }

  /**
   * @param {Frame | null} earlier @param {Frame} last @param {Frame} frame
   * @param {Pick<Plan, "x" | "y" | "scale" | "flip">} plan @param {Point[]} points
   */
  #cross(earlier, last, frame, plan, points) {
    const [ends, before] = [endsOf(points, plan, frame.positions), endsOf(points, plan, last.positions)];
    const long = Math.hypot(ends[2] - ends[0], ends[3] - ends[1]);
    if (!(long > 0) || !(Math.hypot(before[2] - before[0], before[3] - before[1]) > 0)) return;
    const span = frame.time - last.time;
    const ratio = earlier && last.time - earlier.time <= GAP ? (last.time - earlier.time) / span : NaN;
    const found = [];
    for (let mass = 0; 2 * mass < frame.positions.length; mass += 1) {
      const [x, y] = [2 * mass, 2 * mass + 1];
      const from = beside(before, last.positions[x], last.positions[y]);
      const to = beside(ends, frame.positions[x], frame.positions[y]);
      if (from.away < 0 === to.away < 0 || !(Math.abs(to.away - from.away) > LEAST * long)) continue;
      if (points.some((point) => point.mass === mass)) continue;
      const first = ratio > 0 && earlier ? beside(endsOf(points, plan, earlier.positions), earlier.positions[x], earlier.positions[y]).away : NaN;
      const share = whenZero(first, from.away, to.away, ratio);
      const along = from.part + share * (to.part - from.part);
      if (along >= 0 && along <= 1) found.push({ mass, time: last.time + share * span });
    }
    for (const { mass, time } of found.sort((a, b) => a.time - b.time)) {
      const [same] = this.crossings.filter((crossing) => crossing.mass === mass).slice(-1);
      this.crossings.push({ mass, time, since: same ? time - same.time : null });
    }
    this.crossings.splice(0, this.crossings.length - MOST);
  }
}
