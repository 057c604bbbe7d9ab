// @ts-check
/**
 * The measured places of a table: all of them small, and those of the present time larger. After a fit, also pale bodies
 * that fit the table about as well.
 */
import { onMessage } from "../../wire/channel.js";
import { onMarksRedraw, redrawMarks } from "../../stage/sight.js";
import { makeSvg } from "../../stage/svg.js";

/** Numbers of a place: time, x, y. */
const EACH = 3;
/** Radius of a place, and of one of the present time, px. */
const SMALL = 2;
const LARGE = 4;

/**
 * The places nearest to a time, if they are no farther from it than the usual distance: one or more, by different masses.
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

/** @typedef {{ numbers: ArrayLike<number>, draws: number, masses: number, rate: number }} Fan */

/**
 * The places of the masses of a fan at a time, interpolated between its frames.
 *
 * @param {Fan} fan
 * @param {number} time
 * @returns {number[]} x and y of each mass of each body; none after its end
 */
export function fanAt({ numbers, draws, masses, rate }, time) {
  const each = 2 * draws * masses, frame = Math.floor(time * rate), part = time * rate - frame;
  const [from, to] = [each * frame, each * (part ? frame + 1 : frame)];
  if (!each || from < 0 || to + each > numbers.length) return [];
  return Array.from({ length: each }, (_, i) => numbers[from + i] + part * (numbers[to + i] - numbers[from + i]));
}

/** Begins to draw them. */
function begin() {
  const svg = makeSvg("svg", "softrod-marks softrod-measured");
  const [lines, all, now] = ["fan", "all", "now"].map((name) => makeSvg("path", `softrod-measured-${name}`, svg));
  /** @type {Float32Array} */
  let numbers = new Float32Array();
  /** @type {Fan} */
  let fan = { numbers, draws: 0, masses: 0, rate: 0 };
  /** @param {import("../../stage/sight.js").Sight} seen */
  const draw = ({ plan, frame, on }) => {
    if (!svg.parentNode) return;
    const scale = plan.scale * on.step;
    /** @param {number} x @param {number} y */
    const at = (x, y) => [on.x + (x - plan.x) * scale, on.y - (y - plan.y) * scale * plan.flip];
    /** @param {number} i @param {number} radius */
    const dot = (i, radius) => {
      const [x, y] = at(numbers[i + 1], numbers[i + 2]);
      return `M${(x - radius).toFixed(1)} ${y.toFixed(1)}a${radius} ${radius} 0 1 0 ${2 * radius} 0a${radius} ${radius} 0 1 0 ${-2 * radius} 0`;
    };
    let path = "";
    for (let i = 0; i < numbers.length; i += EACH) path += dot(i, SMALL);
    all.setAttribute("d", path);
    now.setAttribute("d", placesAt(numbers, frame.time).map((i) => dot(i, LARGE)).join(""));
    const places = fanAt(fan, frame.time);
    let bodies = "";
    for (let first = 0; first < places.length; first += 2 * fan.masses) {
      plan.springs.forEach((mass, end) => {
        const [x, y] = at(places[first + 2 * mass], places[first + 2 * mass + 1]);
        bodies += `${end % 2 ? "L" : "M"}${x.toFixed(1)} ${y.toFixed(1)}`;
      });
    }
    lines.setAttribute("d", bodies);
  };
  const show = () => {
    const any = numbers.length || fan.numbers.length;
    if (any && !svg.parentNode) document.querySelector(".softrod-overlay")?.before(svg);
    if (!any) svg.remove();
    redrawMarks();
  };
  onMessage("measured", (told) => {
    numbers = told.numbers;
    show();
  });
  onMessage("fan", (told) => {
    fan = told;
    show();
  });
  onMarksRedraw(draw);
}

/** @type {import("../../ui/feature.js").Feature<"fit">} */
export default { commands: {}, begin };
