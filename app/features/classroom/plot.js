// @ts-check
/** The class's plot: what each seat found over what it set, a point a seat. */
import { SVG } from "../../stage/svg.js";

/** @typedef {import("../../wire/wire.js").Found} Found */
/** @typedef {import("../../wire/wire.js").Law} Law */

/** Sizes, in the plot's own units. */
const [WIDE, HIGH, LEFT, BELOW, ABOVE] = [400, 270, 62, 52, 30];
/** From this factor between the least and the largest on, an axis goes by powers of ten. */
const WIDE_RANGE = 5;
/** Marks of an axis, at most. */
const MAX_MARKS = 5;

/**
 * Where numbers lie on an axis, from 0 to 1, and round numbers on it.
 *
 * @param {number[]} numbers
 * @param {boolean} logarithmic
 */
export function axis(numbers, logarithmic) {
  const [least, most] = [Math.min(...numbers), Math.max(...numbers)];
  const scale = logarithmic ? Math.log10 : (/** @type {number} */ number) => number;
  const [low, high] = [scale(least), scale(most)];
  const margin = high > low ? 0.06 * (high - low) : logarithmic ? 0.3 : Math.abs(high) || 1;
  /** @param {number} number */
  const part = (number) => (scale(number) - low + margin) / (high - low + 2 * margin);
  const [from, to] = [low - margin, high + margin];
  const marks = logarithmic ? powers(10 ** from, 10 ** to) : steps(from, to);
  return { part, marks };
}

/** Round numbers in a range, evenly. @param {number} low @param {number} high */
function steps(low, high) {
  const least = (high - low) / MAX_MARKS;
  const power = 10 ** Math.floor(Math.log10(least));
  const step = ([1, 2, 5, 10].find((one) => one * power >= least) ?? 10) * power;
  const first = Math.ceil(low / step);
  return Array.from({ length: Math.floor(high / step) - first + 1 }, (_, i) => Number(((first + i) * step).toPrecision(12)));
}

/** Powers of ten in a range; with 2 and 5 between them where that is few. @param {number} low @param {number} high */
function powers(low, high) {
  for (const within of [[1], [1, 3], [1, 2, 5], [1, 1.5, 2, 3, 4, 5, 6, 7, 8, 9]]) {
    const found = [];
    for (let power = Math.floor(Math.log10(low)); power <= Math.log10(high); power++) {
      for (const one of within) {
        const number = Number((one * 10 ** power).toPrecision(12));
        if (number >= low && number <= high) found.push(number);
      }
    }
    if (found.length >= 3 || within.length > 9) return found;
  }
  return [];
}

/** A number as an axis has it. @param {number} number */
const short = (number) => (number !== 0 && (Math.abs(number) >= 1e5 || Math.abs(number) < 1e-3) ? number.toExponential() : String(number)).replace("-", "−");

/** A power law in words. @param {Law} law @param {string} what @param {string} over */
export const power = ({ factor, exponent }, what, over) =>
  `${what} = ${Number(factor.toPrecision(3))} × ${over}^${exponent.toFixed(2)}`.replaceAll("-", "−");

/**
 * Both axes go by powers of ten where the numbers do. With a law both do, so that it is a straight line.
 *
 * @param {Found[]} found
 * @param {string} over
 * @param {string} what
 * @param {Law | null} [law]
 */
export function plot(found, over, what, law = null) {
  const svg = document.createElementNS(SVG, "svg");
  svg.setAttribute("viewBox", `0 0 ${WIDE} ${HIGH}`);
  svg.classList.add("softrod-class-plot");
  svg.setAttribute("role", "img");
  const told = law ? `; ${power(law, what, over)}` : "";
  svg.setAttribute("aria-label", `${what} over ${over}: ${found.length} points${told}`);
  /** @param {number[]} numbers */
  const made = (numbers) => {
    const least = Math.min(...numbers);
    return axis(numbers, least > 0 && (law !== null || Math.max(...numbers) > WIDE_RANGE * least));
  };
  const settings = found.map(({ setting }) => setting);
  const [x, y] = [made(settings), made(found.map((one) => one.found))];
  /** @param {keyof SVGElementTagNameMap} kind @param {Record<string, number | string>} attributes @param {string} [text] */
  const add = (kind, attributes, text = "") => {
    const element = document.createElementNS(SVG, kind);
    for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
    element.textContent = text;
    svg.append(element);
  };
  const [right, low] = [WIDE - 12, HIGH - BELOW];
  /** @param {number} number */
  const across = (number) => LEFT + x.part(number) * (right - LEFT);
  /** @param {number} number */
  const up = (number) => low - y.part(number) * (low - ABOVE);
  for (const mark of x.marks) {
    add("path", { class: "softrod-plot-grid", d: `M${across(mark)} ${ABOVE}V${low}` });
    add("text", { x: across(mark), y: low + 20, "text-anchor": "middle" }, short(mark));
  }
  for (const mark of y.marks) {
    add("path", { class: "softrod-plot-grid", d: `M${LEFT} ${up(mark)}H${right}` });
    add("text", { x: LEFT - 6, y: up(mark) + 5, "text-anchor": "end" }, short(mark));
  }
  add("path", { d: `M${LEFT} ${ABOVE}V${low}H${right}` });
  if (law) {
    const ends = [Math.min(...settings), Math.max(...settings)];
    const [from, to] = ends.map((end) => `${across(end)} ${up(law.factor * end ** law.exponent)}`);
    add("path", { class: "softrod-plot-law", d: `M${from}L${to}` });
  }
  for (const { setting, found: value } of found) add("circle", { cx: across(setting), cy: up(value), r: 6 });
  add("text", { x: (LEFT + right) / 2, y: HIGH - 8, "text-anchor": "middle" }, over);
  add("text", { x: 4, y: 18 }, what);
  return svg;
}
