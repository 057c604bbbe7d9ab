// @ts-check
/** The paths of some masses during the last seconds, made of the positions that the page shows anyway. */
import { onMessage, pageState } from "../../wire/channel.js";
import { onFrame, shown } from "../../stage/canvas.js";
import { onMarksRedraw, redrawMarks } from "../../stage/sight.js";
import { SVG } from "../../stage/svg.js";
import { onTools, tools } from "./tools.js";
import { timeNow } from "../../ui/clock.js";

/** Points of a path, at most, about. */
const MOST = 1200;
/** Simulated seconds between two pictures beyond which nobody knows the way between them. */
const GAP = 0.3;
/** Parts of a path, each paler than the one after it. */
export const BANDS = 6;
/** Milliseconds between two drawings of the paths while the body is at rest, of which no pictures come. */
const FADE_EVERY = 200;

/** @typedef {{t: number, x: number, y: number, cut: boolean}} Step a place, px, and whether no line leads to it */

/** Where a mass was. */
export class Trail {
  constructor() {
    /** @type {Step[]} */
    this.steps = [];
  }

  /**
   * @param {number} t simulated time, s
   * @param {number} x
   * @param {number} y
   * @param {number} seconds that are kept
   */
  add(t, x, y, seconds) {
    const { steps } = this;
    // Gone back in time: what came after is no longer so.
    while (steps.length && steps[steps.length - 1].t >= t) steps.pop();
    const before = steps[steps.length - 1];
    const cut = !before || t - before.t > GAP;
    const earlier = steps[steps.length - 2];
    // Too near to the one before: the newest place takes its room.
    if (!cut && !before.cut && earlier && t - earlier.t < (2 * seconds) / MOST) steps.pop();
    steps.push({ t, x, y, cut });
    let old = 0;
    while (old < steps.length && steps[old].t < t - seconds) old++;
    if (old > 64 || old === steps.length) steps.splice(0, old);
  }

  /**
   * Lines on the screen, from the oldest place that is not too old to the one that is shown now.
   *
   * @param {number} now simulated time, s
   * @param {number} seconds
   * @param {{t: number, x: number, y: number}} shown where the mass is shown: frames may have come that are not, yet
   * @param {(step: {x: number, y: number}) => string} place as a path has it
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

/** Begins to keep and to draw the paths of the masses that are traced. */
export function addTraces() {
  const svg = document.createElementNS(SVG, "svg");
  svg.classList.add("softrod-marks", "softrod-traces");
  svg.setAttribute("aria-hidden", "true");
  /** @type {Map<number, {trail: Trail, paths: SVGPathElement[]}>} */
  const traces = new Map();
  /** @param {number} mass */
  const begin = (mass) => {
    const group = document.createElementNS(SVG, "g");
    // Neighbours in the list of colours, not in the body, are told apart.
    group.classList.add("softrod-trace", `softrod-trace-${[0, 1, 2, 3].find((i) => !svg.querySelector(`.softrod-trace-${i}`)) ?? 0}`);
    const paths = Array.from({ length: BANDS }, (_, i) => {
      const path = document.createElementNS(SVG, "path");
      path.style.strokeOpacity = String((i + 1) / BANDS);
      group.append(path);
      return path;
    });
    svg.append(group);
    traces.set(mass, { trail: new Trail(), paths });
  };
  /** @param {number} mass */
  const end = (mass) => {
    traces.get(mass)?.paths[0].parentElement?.remove();
    traces.delete(mass);
  };
  /** @param {import("../../stage/plan.js").Frame | null} frame */
  const take = (frame) => {
    if (!frame) return;
    for (const [mass, { trail }] of traces) {
      if (2 * mass < frame.positions.length) {
        trail.add(frame.time, frame.positions[2 * mass], frame.positions[2 * mass + 1], tools().seconds);
      }
    }
  };
  const follow = () => {
    const { traced } = tools();
    for (const mass of [...traces.keys()]) if (!traced.includes(mass)) end(mass);
    for (const mass of traced) if (!traces.has(mass)) begin(mass);
    if (traces.size && !svg.parentNode) document.querySelector(".softrod-overlay")?.before(svg);
    if (!traces.size) svg.remove();
    take(shown().frame);
    redrawMarks();
  };
  /** @param {import("../../stage/sight.js").Sight} seen */
  const draw = ({ plan, frame, on }) => {
    const { seconds } = tools();
    const scale = plan.scale * on.step;
    /** @param {{x: number, y: number}} step */
    const place = ({ x, y }) =>
      `${(on.x + (x - plan.x) * scale).toFixed(1)} ${(on.y - (y - plan.y) * scale * plan.flip).toFixed(1)}`;
    for (const [mass, { trail, paths }] of traces) {
      const [x, y] = frame.positions.subarray(2 * mass, 2 * mass + 2);
      trail.bands(timeNow(), seconds, { t: frame.time, x, y }, place).forEach((path, i) => {
        if (paths[i].getAttribute("d") !== path) paths[i].setAttribute("d", path);
      });
    }
  };
  let body = pageState().scene;
  onMessage("pageState", () => {
    const now = pageState().scene;
    if (now !== body) for (const mass of [...traces.keys()]) end(mass);
    body = now;
  });
  onTools(follow);
  onFrame(take);
  onMarksRedraw(draw);
  setInterval(() => traces.size && pageState().rest && redrawMarks(), FADE_EVERY);
}
