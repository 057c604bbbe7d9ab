// @ts-check
/** The paths of some masses during the last seconds, from the positions that the page receives anyway. */
import { onMessage, pageState } from "../../wire/channel.js";
import { onFrame, shown } from "../../stage/canvas.js";
import { onMarksRedraw, redrawMarks } from "../../stage/sight.js";
import { makeSvg, set } from "../../stage/svg.js";
import { onTools, tools } from "./tools.js";
import { timeNow } from "../../ui/clock.js";

/** Approximate number of points of a path, at most. */
const MAX_POINTS = 1200;
/** Simulated seconds between two frames beyond which the path between them is unknown. */
const GAP = 0.3;
/** Parts of a path; the older, the paler. */
export const BANDS = 6;
/** Milliseconds between two redraws of the paths while the body is at rest and sends no frames. */
const FADE_EVERY = 200;
const COLORS = 4;

/** @typedef {{t: number, x: number, y: number, cut: boolean}} Step a time, s, a position, px, and whether the path is broken before it */

/** The path of a mass. */
export class Trail {
  constructor() {
    /** @type {Step[]} */
    this.steps = [];
  }

  /**
   * @param {number} t simulated time, s
   * @param {number} x
   * @param {number} y
   * @param {number} seconds of the path to keep
   */
  add(t, x, y, seconds) {
    const { steps } = this;
    // Time went back: what came later is void.
    while (steps.length && steps[steps.length - 1].t >= t) steps.pop();
    const before = steps[steps.length - 1];
    const cut = !before || t - before.t > GAP;
    const earlier = steps[steps.length - 2];
    // Closer than the path's resolution: the new point replaces the last one.
    if (!cut && !before.cut && earlier && t - earlier.t < (2 * seconds) / MAX_POINTS) steps.pop();
    steps.push({ t, x, y, cut });
    let old = 0;
    while (old < steps.length && steps[old].t < t - seconds) old++;
    if (old > 64 || old === steps.length) steps.splice(0, old);
  }

  /**
   * Lines on the screen, from the oldest point within `seconds` to the position that is shown now.
   *
   * @param {number} now simulated time, s
   * @param {number} seconds
   * @param {{t: number, x: number, y: number}} shown what is on the screen: later frames may have arrived already
   * @param {(step: {x: number, y: number}) => string} place formats a position for a path
   * @returns {string[]} BANDS paths
   */
  bands(now, seconds, shown, place) {
    const paths = Array.from({ length: BANDS }, () => "");
    let [last, open] = ["", -1];
    const past = this.steps.filter(({ t }) => t < shown.t);
    const cut = this.steps[past.length]?.cut ?? false;
    for (const step of [...past, { ...shown, cut }]) {
      const age = Math.max((now - step.t) / seconds, 0);
      const at = place(step);
      if (age > 1) open = -1;
      else {
        const band = Math.min(BANDS - 1, Math.floor((1 - age) * BANDS));
        const joins = !step.cut && last !== "";
        if (joins) paths[band] += band === open ? `L${at}` : `M${last}L${at}`;
        open = joins ? band : -1;
      }
      last = at;
    }
    return paths;
  }
}

/** The path of one mass, as it is drawn. */
class Trace {
  /** @param {SVGSVGElement} svg */
  constructor(svg) {
    this.trail = new Trail();
    const color = Array.from({ length: COLORS }, (_, i) => i).find((i) => !svg.querySelector(`.softrod-trace-${i}`)) ?? 0;
    this.group = makeSvg("g", `softrod-trace softrod-trace-${color}`, svg);
    this.paths = Array.from({ length: BANDS }, (_, i) => {
      const path = makeSvg("path", "", this.group);
      path.style.strokeOpacity = String((i + 1) / BANDS);
      return path;
    });
  }

  /** @param {number} mass @param {import("../../stage/sight.js").Sight} seen */
  draw(mass, { plan, frame, on }) {
    const scale = plan.scale * on.step;
    const [x, y] = frame.positions.subarray(2 * mass, 2 * mass + 2);
    /** @param {{x: number, y: number}} step */
    const place = ({ x, y }) =>
      `${(on.x + (x - plan.x) * scale).toFixed(1)} ${(on.y - (y - plan.y) * scale * plan.flip).toFixed(1)}`;
    this.trail.bands(timeNow(), tools().seconds, { t: frame.time, x, y }, place).forEach((d, i) => set(this.paths[i], { d }));
  }
}

/** Records and draws the paths of the masses that are traced. */
export function addTraces() {
  const svg = makeSvg("svg", "softrod-marks softrod-traces");
  /** @type {Map<number, Trace>} */
  const traces = new Map();
  /** @param {number} mass */
  const remove = (mass) => {
    traces.get(mass)?.group.remove();
    traces.delete(mass);
  };
  /** @param {import("../../stage/plan.js").Frame | null} frame */
  const record = (frame) => {
    if (!frame) return;
    for (const [mass, { trail }] of traces) {
      if (2 * mass >= frame.positions.length) continue;
      trail.add(frame.time, frame.positions[2 * mass], frame.positions[2 * mass + 1], tools().seconds);
    }
  };
  onTools(() => {
    const { traced } = tools();
    for (const mass of [...traces.keys()]) if (!traced.includes(mass)) remove(mass);
    for (const mass of traced) if (!traces.has(mass)) traces.set(mass, new Trace(svg));
    if (traces.size && !svg.parentNode) document.querySelector(".softrod-overlay")?.before(svg);
    if (!traces.size) svg.remove();
    record(shown().frame);
    redrawMarks();
  });
  let { scene } = pageState();
  onMessage("pageState", () => {
    if (pageState().scene !== scene) [...traces.keys()].forEach(remove);
    ({ scene } = pageState());
  });
  onFrame(record);
  onMarksRedraw((seen) => traces.forEach((trace, mass) => trace.draw(mass, seen)));
  setInterval(() => traces.size && pageState().rest && redrawMarks(), FADE_EVERY);
}
