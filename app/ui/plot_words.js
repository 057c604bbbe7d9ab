// @ts-check
/**
 * Plots for whoever does not see them: what a curve is like, in a sentence, and a table of its numbers that is made when it
 * is opened.
 *
 * @typedef {object} Curve
 * @property {string} label what it is, with its unit
 * @property {ArrayLike<number | null>} values
 * @typedef {object} Along what the curves are over
 * @property {string} label
 * @property {ArrayLike<number | null>} values
 * @property {boolean} isTime
 */
import { make } from "./dialog.js";
import { decimal, say } from "../words/words.js";

/** Digits of a number that is said. */
const DIGITS = 4;
/** Rows of a table, at most. */
const ROWS = 21;
/** Part of the largest size of a value by which values differ that are told apart. */
const LEVEL = 1e-6;

/** A number as it is said. @param {number} value */
export const told = (value) => decimal(String(Number(value.toPrecision(DIGITS))).replace("-", "−"));

/** Whether there is a value. @param {number | null | undefined} value @returns {value is number} */
const isSome = (value) => value !== null && value !== undefined && Number.isFinite(value);

/**
 * A curve in a sentence: its value now, and the lowest and the highest one.
 *
 * @param {Curve} curve @param {Along} along
 */
export function sentenceOf({ label, values }, along) {
  let [low, high, last] = [-1, -1, -1];
  for (let i = 0; i < values.length; i += 1) {
    const value = values[i];
    if (!isSome(value)) continue;
    if (low < 0 || value < Number(values[low])) low = i;
    if (high < 0 || value > Number(values[high])) high = i;
    last = i;
  }
  if (last < 0) return say("ui-plot-none", { label });
  const [least, most] = [Number(values[low]), Number(values[high])];
  const now = told(Number(values[last]));
  if (most - least <= LEVEL * Math.max(Math.abs(least), Math.abs(most))) return say("ui-plot-level", { label, now });
  /** @param {number} i */
  const at = (i) => told(Number(along.values[i]));
  const said = { label, now, low: told(least), high: told(most), across: along.label, lowAt: at(low), highAt: at(high) };
  return say(along.isTime ? "ui-plot-said" : "ui-plot-over", said);
}

/** Indices that are spread evenly, the last one among them. @param {number} count */
function spread(count) {
  const rows = Math.min(count, ROWS);
  return Array.from({ length: rows }, (_, i) => (rows < 2 ? count - 1 : Math.round((i * (count - 1)) / (rows - 1))));
}

/** @param {() => {along: Along, curves: Curve[]}} read what is in view */
function table(read) {
  const { along, curves } = read();
  const made = make("table", "");
  const head = make("tr", "");
  for (const { label } of [along, ...curves]) {
    const cell = make("th", "", label);
    cell.scope = "col";
    head.append(cell);
  }
  made.append(make("caption", "", say("ui-plot-numbers.caption", { count: Math.min(along.values.length, ROWS) })), head);
  for (const i of spread(along.values.length)) {
    const row = make("tr", "");
    for (const { values } of [along, ...curves]) {
      const value = values[i];
      row.append(make("td", "", isSome(value) ? told(value) : ""));
    }
    made.append(row);
  }
  return made;
}

/**
 * A line that opens a table of the numbers that are in view at that moment: one that changed while it is read would be no use.
 *
 * @param {() => {along: Along, curves: Curve[]}} read
 */
export function numbersOf(read) {
  const details = make("details", "softrod-plot-numbers");
  details.append(make("summary", "", say("ui-plot-numbers")));
  details.addEventListener("toggle", () => {
    details.querySelector("table")?.remove();
    if (details.open) details.append(table(read));
  });
  return details;
}
