// @ts-check
/**
 * Plots of quantities over time, as SVG. A vertical line follows the pointer, and the values there stand below; a drag
 * across the plot shows that part alone, and a double click all of it.
 */
import { makeSvg } from "../../stage/svg.js";
import { send } from "../../wire/channel.js";
import { make } from "../dialog.js";
import { takePointer } from "../hands/take.js";
import { numbersOf, sentenceOf } from "../plot_words.js";
import { decimal, say } from "../../words/words.js";
import { Control, newId } from "./control.js";

const TOP = 8;
const BOTTOM = 40;
const BESIDE = 24;
/** Pixels of a digit of the marks. */
const DIGIT = 7.5;
/** Marks of an axis, about. */
const TICKS = 5;
/** Pixels of a drag that shows a part. */
const LEAST_DRAG = 6;
/** Seconds of a part that keys show, at least. */
const LEAST_PART = 0.05;
/** Digits that distinguish the marks of the narrowest axis, see app/session/plots.py. */
const DIGITS = 7;
/** Part of a range that stays free at either end. */
const MARGIN = 0.05;

/**
 * Round numbers in a range, with equal steps of 1, 2 or 5 times a power of ten.
 *
 * @param {number} low @param {number} high
 */
export function ticks(low, high) {
  const rough = (high - low) / TICKS;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((factor) => factor * power).find((size) => size >= rough) ?? 10 * power;
  const made = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; i += 1) made.push(i * step + 0); // no -0
  return made;
}

/** A mark's text. @param {number} value */
export const markText = (value) => decimal(String(Number(value.toPrecision(DIGITS))).replace("-", "−"));

/** A little more than the range of numbers; some range where there is none. @param {Iterable<number>} values */
export function rangeOf(values) {
  let [low, high] = [Infinity, -Infinity];
  for (const value of values) {
    if (!Number.isFinite(value)) continue;
    low = Math.min(low, value);
    high = Math.max(high, value);
  }
  if (low > high) return [0, 1];
  const size = Math.max(Math.abs(low), Math.abs(high));
  // Values that hardly differ are told apart by no marks.
  const more = high - low > 1e-6 * size ? MARGIN * (high - low) : MARGIN * size || 1;
  return [low - more, high + more];
}

/** @typedef {{label: string, stroke: string, width?: number, alpha?: number, scale: string, class?: string}} Series */

/** What draws in each drawing. @type {WeakMap<Element, Plot>} */
const drawings = new WeakMap();

/**
 * A copy of the drawing of a plot, with another width and height, px; of one that the server draws as it is.
 *
 * @param {Element} svg @param {number} width @param {number} height
 */
export function copyAt(svg, width, height) {
  const plot = drawings.get(svg);
  plot?.draw(width, height);
  const copy = svg.cloneNode(true);
  plot?.draw();
  return copy;
}

/** A plot over time, as uPlot's properties describe it: data, series, scales and axes. */
export class Plot extends Control {
  /** @param {import("./control.js").Declared} declared */
  constructor(declared) {
    super(declared, "softrod-plot");
    this.svg = makeSvg("svg", "softrod-chart");
    this.svg.removeAttribute("aria-hidden");
    this.svg.tabIndex = 0;
    this.svg.ariaDescription = say("ui-plot-keys");
    this.values = make("div", "softrod-plot-values");
    this.values.id = newId();
    this.element.append(this.svg, this.values, numbersOf(() => this.told));
    /** The part of the time that is shown; null for all. @type {[number, number] | null} */
    this.zoom = null;
    /** The time of all values before a part was shown: the server sends those of a part alone. @type {[number, number]} */
    this.whole = [Infinity, -Infinity];
    /** Where a drag began, px. @type {number | null} */
    this.from = null;
    /** Where the pointer is, px; null outside. @type {number | null} */
    this.at = null;
    /** The time that is heard, s; null for none. @type {number | null} */
    this.heard = null;
    this.inside = { left: 0, right: 1, low: 0, high: 1 };
    /** The ranges of the vertical axes, from the bottom to the top. @type {number[][]} */
    this.ranges = [];
    this.width = 0;
    this.height = 0;
    this.svg.addEventListener("pointermove", (event) => this.point(this.placeOf(event)));
    this.svg.addEventListener("pointerleave", () => this.point(null));
    this.svg.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      takePointer(this.svg, event, { name: say("taps-part") });
      this.from = this.placeOf(event);
    });
    this.svg.addEventListener("pointerup", (event) => this.release(this.placeOf(event)));
    this.svg.addEventListener("pointercancel", () => (this.from = null));
    this.svg.addEventListener("dblclick", () => this.showPart(null));
    this.svg.addEventListener("keydown", (event) => this.press(event));
    drawings.set(this.svg, this);
    new ResizeObserver(() => this.draw()).observe(this.svg);
  }

  get name() {
    return "";
  }

  /** The times of the values. @returns {ArrayLike<number>} */
  get times() {
    return this.props.data?.[0] ?? [];
  }

  /** The lines, with their values. @returns {[Series, ArrayLike<number>][]} */
  get lines() {
    /** @type {Series[]} */
    const series = this.props.series ?? [];
    return series.slice(1).map((line, i) => [line, this.props.data?.[i + 1] ?? []]);
  }

  /** What is in view, in numbers: lines up to the moment that is shown, without fits. */
  get told() {
    const { times } = this;
    const [low, high] = this.zoom ?? [-Infinity, Infinity];
    const shown = Array.from(times).flatMap((time, i) => (time >= low && time <= high ? [i] : []));
    const kinds = this.lines.map(([line]) => line.class);
    const lines = this.lines.filter(([line]) => !kinds.includes("softrod-until") || line.class === "softrod-until");
    return {
      along: { label: this.props.axes?.[0]?.label ?? say("ui-plot-time"), values: shown.map((i) => times[i]), isTime: true },
      curves: lines.map(([{ label }, values]) => ({ label, values: shown.map((i) => values[i] ?? null) })),
    };
  }

  /** @param {boolean} valued @param {[number, number] | null} [zoom] */
  show(valued, zoom = this.zoom) {
    this.zoom = zoom;
    super.show(valued);
    this.draw();
  }

  /** Shows a part of the time, of which the server sends more, and analyses it. @param {[number, number] | null} part */
  showPart(part) {
    const { times } = this;
    if (!this.zoom && times.length) this.whole = [times[0], times[times.length - 1]];
    this.show(true, part);
    send({ do: "inView", plot: this.id, part });
  }

  /** Arrows across move the part that is shown, up and down make it half or twice as long, Home shows all. @param {KeyboardEvent} event */
  press(event) {
    const { times, zoom } = this;
    if (event.ctrlKey || event.altKey || event.metaKey || times.length < 2) return;
    const now = [times[0], times[times.length - 1]];
    const [first, last] = zoom ? [Math.min(now[0], this.whole[0]), Math.max(now[1], this.whole[1])] : now;
    const [low, high] = zoom ?? now;
    const [across, factor] = { ArrowLeft: [-0.25, 1], ArrowRight: [0.25, 1], ArrowUp: [0, 0.5], ArrowDown: [0, 2] }[event.key] ?? [0, 0];
    if (!factor && event.key !== "Home") return;
    event.preventDefault();
    const length = Math.max(factor * (high - low), LEAST_PART);
    const from = Math.min(Math.max((low + high - length) / 2 + across * (high - low), first), last - length);
    this.showPart(factor && length < last - first ? [from, from + length] : null);
  }

  /** The range of a scale, from the bottom to the top. @param {string} scale @param {number} low @param {number} high */
  range(scale, low, high) {
    const times = this.times;
    const inSight = [];
    for (const [line, values] of this.lines) {
      if (line.scale !== scale) continue;
      for (let i = 0; i < values.length; i += 1) if (times[i] >= low && times[i] <= high) inSight.push(values[i]);
    }
    const [from, to] = rangeOf(inSight);
    return this.props.scales?.[scale]?.dir === -1 ? [to, from] : [from, to];
  }

  draw(width = this.svg.clientWidth, height = this.svg.clientHeight) {
    [this.width, this.height] = [width, height];
    const { times } = this;
    if (!(width > 0 && height > BOTTOM + TOP) || !times.length) return;
    const [low, high] = this.zoom ?? [times[0], times[times.length - 1]];
    const axes = /** @type {{scale: string, label: string, side?: number}[]} */ (this.props.axes ?? []);
    const upwards = axes.slice(1).map((axis) => ({ ...axis, range: this.range(axis.scale, low, high) }));
    this.ranges = upwards.map(({ range }) => range);
    /** @param {{range: number[]}} axis */
    const marksOf = ({ range: [a, b] }) => ticks(Math.min(a, b), Math.max(a, b));
    /** @param {{range: number[]} | undefined} axis */
    const room = (axis) => (axis ? BESIDE + DIGIT * Math.max(0, ...marksOf(axis).map((mark) => markText(mark).length)) : 12);
    const [left, right] = [room(upwards[0]), width - room(upwards[1])];
    const bottom = height - BOTTOM;
    this.inside = { left, right, low, high };
    /** @param {number} time */
    const across = (time) => left + ((right - left) * (time - low)) / (high - low);
    /** @param {number[]} range @param {number} value */
    const up = ([from, to], value) => bottom - ((bottom - TOP) * (value - from)) / (to - from);

    this.svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
    const grid = [];
    /** @type {Element[]} */
    const parts = [];
    /** @param {string} text @param {number} x @param {number} y @param {string} anchor @param {string} [name] of its class @param {string} [turn] */
    const write = (text, x, y, anchor, name = "", turn = "") => {
      const made = makeSvg("text", name);
      made.textContent = text;
      if (turn) made.setAttribute("transform", turn);
      else {
        made.setAttribute("x", String(x));
        made.setAttribute("y", String(y));
      }
      made.setAttribute("text-anchor", anchor);
      made.setAttribute("aria-hidden", "true"); // the label says more
      parts.push(made);
    };
    for (const mark of ticks(low, high)) {
      grid.push(`M${across(mark)} ${TOP}V${bottom}`);
      write(markText(mark), across(mark), bottom + 16, "middle");
    }
    write(axes[0]?.label ?? "", (left + right) / 2, height - 6, "middle", "softrod-axis");
    upwards.forEach((axis, i) => {
      for (const mark of marksOf(axis)) {
        const y = up(axis.range, mark);
        if (i === 0) grid.push(`M${left} ${y}H${right}`);
        write(markText(mark), i ? right + 5 : left - 5, y + 4, i ? "start" : "end");
      }
      const x = i ? width - 4 : 12;
      write(axis.label, x, 0, "middle", "softrod-axis", `translate(${x} ${(TOP + bottom) / 2}) rotate(-90)`);
    });
    const back = makeSvg("path", "softrod-chart-grid");
    back.setAttribute("d", grid.join(""));
    const curves = this.lines.map(([line, values]) => {
      const range = upwards.find(({ scale }) => scale === line.scale)?.range ?? [0, 1];
      const made = makeSvg("path", "softrod-chart-line");
      made.setAttribute("d", pathOf(times, values, low, high, across, (value) => up(range, value)));
      made.style.stroke = line.stroke;
      made.style.strokeWidth = `${line.width ?? 2}px`;
      made.style.strokeOpacity = String(line.alpha ?? 1);
      return made;
    });
    this.mark = makeSvg("path", "softrod-chart-mark");
    this.cursor = makeSvg("path", "softrod-heard");
    this.svg.replaceChildren(back, ...parts, ...curves, this.mark, this.cursor);
    const { along, curves: told } = this.told;
    const label = told.map((curve) => sentenceOf(curve, along)).join(" ");
    this.svg.setAttribute("aria-label", label);
    // Without a value there is no picture to be named.
    if (label) this.svg.setAttribute("role", "img");
    else this.svg.removeAttribute("role");
    this.read();
    this.hear(this.heard);
  }

  /** Shows where the plot is heard. @param {number | null} time s; null where it is not */
  hear(time) {
    const { left, right, low, high } = this.inside;
    this.heard = time;
    const x = time === null ? NaN : left + ((right - left) * (time - low)) / (high - low);
    this.cursor?.setAttribute("d", x >= left - 1 && x <= right + 1 ? `M${x.toFixed(1)} ${TOP}V${this.height - BOTTOM}` : "");
  }

  /** Where an event is, px from the left as they are drawn: on a projector these are larger than the window's. @param {PointerEvent} event */
  placeOf({ clientX }) {
    const { left, width } = this.svg.getBoundingClientRect();
    return ((clientX - left) * this.width) / width;
  }

  /** @param {number | null} x px */
  point(x) {
    this.at = x;
    this.read();
  }

  /** The values at the pointer, or the last ones. */
  read() {
    const { left, right, low, high } = this.inside;
    const { at, from, times } = this;
    const inside = at !== null && at >= left && at <= right;
    const time = inside ? low + ((high - low) * (at - left)) / (right - left) : null;
    const bottom = this.height - BOTTOM;
    this.mark?.setAttribute("d", inside ? `M${at} ${TOP}V${bottom}${from === null ? "" : `M${from} ${TOP}V${bottom}`}` : "");
    const i = time === null ? -1 : nearest(times, time);
    // A line that ends at the moment that is shown goes on as a pale one.
    const told = new Map();
    for (const [{ label }, values] of this.lines) if (i >= 0 && Number.isFinite(values[i])) told.set(label, values[i]);
    const said = [...told].map(([label, value]) => `${label}: ${markText(Number(value.toPrecision(4)))}`);
    this.values.textContent = time === null || !said.length ? "" : [`${decimal(times[i].toFixed(2))} s`, ...said].join(" · ");
  }

  /** @param {number} x px */
  release(x) {
    const { from } = this;
    this.from = null;
    if (from === null || Math.abs(x - from) < LEAST_DRAG) return;
    const { left, right, low, high } = this.inside;
    const [a, b] = [from, x].map((place) => low + ((high - low) * (Math.min(Math.max(place, left), right) - left)) / (right - left));
    this.showPart([Math.min(a, b), Math.max(a, b)]);
  }
}

/** The place in growing numbers that is next to one. @param {ArrayLike<number>} times @param {number} time */
function nearest(times, time) {
  let best = 0;
  for (let i = 1; i < times.length; i += 1) if (Math.abs(times[i] - time) < Math.abs(times[best] - time)) best = i;
  return best;
}

/**
 * A line through the values of a part of the time, with gaps where there is none.
 *
 * @param {ArrayLike<number>} times @param {ArrayLike<number>} values @param {number} low @param {number} high
 * @param {(time: number) => number} across @param {(value: number) => number} up
 */
function pathOf(times, values, low, high, across, up) {
  let path = "";
  let pen = "M";
  for (let i = 0; i < values.length; i += 1) {
    const [value, inSight] = [values[i], times[i] >= low && times[i] <= high];
    if (!inSight || value === null || !Number.isFinite(value)) {
      pen = "M";
      continue;
    }
    path += `${pen}${across(times[i]).toFixed(1)} ${up(value).toFixed(1)}`;
    pen = "L";
  }
  return path;
}
