// @ts-check
/** The places that a table says masses were at: all of them pale, and those of the time that is shown. */
import { onTold } from "../../wire/channel.js";
import { onSight, redrawMarks, SVG } from "../body/overlay.js";

/** Numbers of a place: time, x, y. */
const EACH = 3;
/** Radii of the places, px, and of those of now. */
const [SMALL, LARGE] = [2, 4];

/**
 * The places nearest to a time, not farther from it than places are from each other: several masses may have one each.
 *
 * @param {ArrayLike<number>} numbers
 * @param {number} time
 * @returns {number[]} where their numbers begin
 */
export function placesAt(numbers, time) {
  const times = Array.from({ length: numbers.length / EACH }, (_, i) => numbers[EACH * i]);
  const sorted = [...new Set(times)].sort((a, b) => a - b);
  const nearest = sorted.reduce((best, t) => (Math.abs(t - time) < Math.abs(best - time) ? t : best), Infinity);
  const apart = sorted.length > 1 ? (sorted[sorted.length - 1] - sorted[0]) / (sorted.length - 1) : Infinity;
  if (!(Math.abs(nearest - time) <= apart)) return [];
  return times.flatMap((t, i) => (t === nearest ? [EACH * i] : []));
}

/** Begins to draw them. */
export function addMeasured() {
  const svg = document.createElementNS(SVG, "svg");
  svg.classList.add("softrod-marks", "softrod-measured");
  svg.setAttribute("aria-hidden", "true");
  const [all, now] = ["softrod-measured-all", "softrod-measured-now"].map((name) => {
    const path = document.createElementNS(SVG, "path");
    path.classList.add(name);
    svg.append(path);
    return path;
  });
  /** @type {Float32Array} */
  let numbers = new Float32Array();
  /** @param {import("../body/overlay.js").Sight} seen */
  const draw = ({ plan, frame, on }) => {
    if (!numbers.length) return;
    const scale = plan.scale * on.step;
    /** @param {number} i @param {number} radius */
    const dot = (i, radius) => {
      const x = on.x + (numbers[i + 1] - plan.x) * scale;
      const y = on.y - (numbers[i + 2] - plan.y) * scale * plan.flip;
      return `M${(x - radius).toFixed(1)} ${y.toFixed(1)}a${radius} ${radius} 0 1 0 ${2 * radius} 0a${radius} ${radius} 0 1 0 ${-2 * radius} 0`;
    };
    let path = "";
    for (let i = 0; i < numbers.length; i += EACH) path += dot(i, SMALL);
    all.setAttribute("d", path);
    now.setAttribute("d", placesAt(numbers, frame.time).map((i) => dot(i, LARGE)).join(""));
  };
  onTold("measured", (told) => {
    numbers = told.numbers;
    if (numbers.length && !svg.parentNode) document.querySelector(".softrod-overlay")?.before(svg);
    if (!numbers.length) svg.remove();
    redrawMarks();
  });
  onSight(draw);
}
