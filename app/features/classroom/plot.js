// @ts-check
/** The class's plot: what each seat found over what it set, a point a seat. */
import { axisMarks } from "../../stage/axes.js";
import { makeSvg, set } from "../../stage/svg.js";
import { decimal, joined, say } from "../../words/words.js";

/** @typedef {import("../../wire/wire.js").Found} Found */
/** @typedef {import("../../wire/wire.js").Law} Law */
/** @typedef {import("../../wire/wire.js").Axes} Axes */

/** Size of the plot, in its own units, and what of it is left of, below and above the axes. */
const SIZE = { width: 400, height: 270 };
/** Its letters where nobody asks for larger ones, and what is left of, below, above and right of the axes, in their size. */
const LETTERS = 14;
const MARGIN = { left: 4.3, below: 3.5, above: 2.1, right: 1.8 };
/** Ratio of the largest to the smallest number from which an axis is logarithmic. */
const WIDE_RANGE = 5;
/** Pieces of the curve of a law. */
const PIECES = 40;
/** How near to 1 an exponent is left out. */
const PLAIN = 0.005;
/** Span of an axis at least, as a part of its largest number: what differs by less is the same to a class. */
const MIN_SPAN = 0.05;
/** Ratio of the smallest to the largest number below which a linear axis begins at zero. */
const FROM_ZERO = 0.6;
/** Marks of a linear axis with letters of the usual size. */
const MAX_MARKS = 5;

/**
 * Where numbers lie on an axis, from 0 to 1, and round numbers on it.
 *
 * @param {number[]} numbers
 * @param {boolean} logarithmic
 * @param {number} [count] of the marks of a linear one, at most
 */
export function axis(numbers, logarithmic, count = MAX_MARKS) {
  let [least, most] = [Math.min(...numbers), Math.max(...numbers)];
  if (!logarithmic && least > 0 && least < FROM_ZERO * most) least = 0;
  if (!logarithmic && most < 0 && most > FROM_ZERO * least) most = 0;
  const scale = logarithmic ? Math.log10 : (/** @type {number} */ number) => number;
  const [low, high] = [scale(least), scale(most)];
  const span = logarithmic ? 0.3 : MIN_SPAN * Math.max(Math.abs(low), Math.abs(high)) || 1;
  const margin = Math.max(0.06 * (high - low), (span - (high - low)) / 2);
  /** @param {number} number */
  const part = (number) => (scale(number) - low + margin) / (high - low + 2 * margin);
  const [from, to] = [low - margin, high + margin];
  const isNarrow = high - low < Math.log10(WIDE_RANGE);
  const marks = !logarithmic ? axisMarks(from, to, count) : isNarrow ? axisMarks(10 ** from, 10 ** to, count) : powers(10 ** from, 10 ** to);
  return { part, marks };
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

/** A number as it stands at an axis. @param {number} number */
const short = (number) => decimal((number !== 0 && (Math.abs(number) >= 1e5 || Math.abs(number) < 1e-3) ? number.toExponential() : String(number)).replace("-", "−"));

/** Raised digits, signs and points. @type {Record<string, string>} */
const RAISED = { "-": "⁻", ".": "·", 0: "⁰", 1: "¹", 2: "²", 3: "³", 4: "⁴", 5: "⁵", 6: "⁶", 7: "⁷", 8: "⁸", 9: "⁹" };

/** A power law in words. @param {Law} law @param {Axes} axes */
export const power = ({ factor, exponent }, { what, over }) => {
  const raised = Math.abs(exponent - 1) < PLAIN ? "" : exponent.toFixed(2).replace(/./g, (sign) => RAISED[sign]);
  return `${what} = ${decimal(String(Number(factor.toPrecision(3))))} × ${over}${raised}`.replace(/-/g, "−");
};

/**
 * The plot. An axis is logarithmic where its numbers span a wide range.
 *
 * @param {Found[]} found
 * @param {Axes} axes
 * @param {{law?: Law | null, own?: Found | null, letters?: number}} [options] the law of the points; the one that is the reader's own; the size of letters, in the plot's units
 */
export function plot(found, axes, { law = null, own = null, letters = LETTERS } = {}) {
  const { what, unit, over, over_unit, turned } = axes;
  const svg = makeSvg("svg", "softrod-class-plot");
  svg.removeAttribute("aria-hidden");
  const values = { what, over, count: found.length };
  const label = law ? say("class-plot.law", { ...values, law: power(law, axes) }) : say("class-plot", values);
  set(svg, { viewBox: `0 0 ${SIZE.width} ${SIZE.height}`, role: "img", "aria-label": label, "font-size": letters });
  /** @param {number[]} numbers */
  const axisOf = (numbers) => {
    const least = Math.min(...numbers);
    return axis(numbers, least > 0 && Math.max(...numbers) > WIDE_RANGE * least, Math.round((MAX_MARKS * LETTERS) / letters));
  };
  const settings = found.map(({ setting }) => setting);
  const x = axisOf(settings), y = axisOf(found.map((one) => one.found));
  /** @param {keyof SVGElementTagNameMap} kind @param {Record<string, number | string>} attributes @param {string} [text] */
  const add = (kind, { class: name = "", ...attributes }, text = "") => {
    const element = makeSvg(kind, String(name), svg);
    set(element, attributes);
    element.textContent = text;
  };
  const [left, above] = [MARGIN.left * letters, MARGIN.above * letters];
  const right = SIZE.width - MARGIN.right * letters, low = SIZE.height - MARGIN.below * letters;
  /** @param {number} number */
  const across = (number) => left + x.part(number) * (right - left);
  /** @param {number} number */
  const up = (number) => (turned ? above + y.part(number) * (low - above) : low - y.part(number) * (low - above));
  for (const mark of x.marks) {
    add("path", { class: "softrod-plot-grid", d: `M${across(mark)} ${above}V${low}` });
    add("text", { x: across(mark), y: low + 1.35 * letters, "text-anchor": "middle" }, short(mark));
  }
  for (const mark of y.marks) {
    add("path", { class: "softrod-plot-grid", d: `M${left} ${up(mark)}H${right}` });
    add("text", { x: left - 6, y: up(mark) + 0.35 * letters, "text-anchor": "end" }, short(mark));
  }
  add("path", { d: `M${left} ${above}V${low}H${right}` });
  if (law) {
    const [least, most] = [Math.min(...settings), Math.max(...settings)];
    const along = Array.from({ length: PIECES + 1 }, (_, i) => least * (most / least) ** (i / PIECES));
    add("path", { class: "softrod-plot-law", d: `M${along.map((at) => `${across(at)} ${up(law.factor * at ** law.exponent)}`).join("L")}` });
  }
  for (const { setting, found: value } of found) add("circle", { cx: across(setting), cy: up(value), r: 6 });
  if (own) {
    add("circle", { class: "softrod-plot-own", cx: across(own.setting), cy: up(own.found), r: 10 });
    const side = x.part(own.setting) > 0.5 ? "end" : "start";
    add("text", { class: "softrod-plot-you", x: across(own.setting) + (side === "end" ? -14 : 14), y: up(own.found) - 10, "text-anchor": side }, say("class-plot-you", { value: short(Number(own.found.toPrecision(4))) }));
  }
  add("text", { x: right, y: SIZE.height - 0.5 * letters, "text-anchor": "end", class: "softrod-axis" }, joined([over, over_unit]));
  add("text", { x: 4, y: 1.2 * letters, class: "softrod-axis" }, joined([what, unit]));
  return svg;
}
