// @ts-check
/**
 * The sliders and lists of a live file. What comes from the scene is text in them.
 *
 * @typedef {import("./settings.js").Setting} Setting
 */
import { make, untranslated } from "../../../ui/dialog.js";
import { upright } from "../../../words/words.js";
import { said } from "./readings.js";

/** Positions of a slider. */
const PLACES = 1000;
/** Digits of a number that a slider sets. */
const DIGITS = 3;
/** Places about a pointer in which it finds the roundest number: a thumb sets no single place. */
const ROUND = 5;

/** The number at a place of a slider. @param {Setting} setting @param {number} place 0 to PLACES */
function valueAt({ low, high, logarithmic }, place) {
  const part = place / PLACES;
  const value = logarithmic ? low * (high / low) ** part : low + (high - low) * part;
  return Number(value.toPrecision(DIGITS));
}

/** The roundest number near a place of a slider. @param {Setting} setting @param {number} place */
function roundAt(setting, place) {
  const exact = valueAt(setting, place);
  for (let digits = 1; digits < DIGITS; digits++) {
    const value = Number(exact.toPrecision(digits));
    if (Math.abs(placeOf(setting, value) - place) <= ROUND) return value;
  }
  return exact;
}

/** The place of a number on a slider. @param {Setting} setting @param {number} value */
function placeOf({ low, high, logarithmic }, value) {
  const part = logarithmic ? Math.log(Math.max(value, 1e-300) / low) / Math.log(high / low) : (value - low) / (high - low);
  return Math.round(PLACES * Math.min(Math.max(part, 0), 1));
}

/** @typedef {{parts: HTMLElement[], set: (value: number | string) => void}} Control and what shows another value in it */

/** @param {Setting} setting @param {(value: number) => void} change @returns {Control} */
function slider(setting, change) {
  const input = make("input", "");
  const shown = untranslated(make("output", ""));
  shown.ariaLive = "off"; // the slider says it
  const unit = setting.unit && setting.unit !== "°" ? ` ${setting.unit}` : setting.unit;
  let now = Number(setting.value);
  const show = (/** @type {number} */ value) => {
    now = value;
    shown.textContent = upright(said(value) + unit);
    input.setAttribute("aria-valuetext", shown.textContent);
  };
  Object.assign(input, { type: "range", min: "0", max: String(PLACES), value: String(placeOf(setting, now)) });
  show(now);
  let isPointed = false; // keys set every place
  /** The value before a finger came down, which may be about to scroll. @type {number | null} */
  let before = null;
  input.addEventListener("pointerdown", ({ pointerType }) => {
    isPointed = true;
    before = pointerType === "touch" ? now : null;
  });
  input.addEventListener("pointercancel", () => {
    if (before === null || before === now) return;
    set(before);
    change(before);
  });
  input.addEventListener("keydown", () => (isPointed = false));
  input.addEventListener("input", () => {
    const value = (isPointed ? roundAt : valueAt)(setting, Number(input.value));
    show(value);
    change(value);
  });
  const set = (/** @type {number | string} */ value) => {
    input.value = String(placeOf(setting, Number(value)));
    show(Number(value));
  };
  return { parts: [shown, input], set };
}

/** @param {Setting} setting @param {[number | string, string][]} options @param {(value: number | string) => void} change @returns {Control} */
function list({ value: first }, options, change) {
  const choose = make("select", "");
  for (const [value, name] of options) choose.add(new Option(name, "", false, value === first));
  choose.addEventListener("change", () => change(options[choose.selectedIndex][0]));
  return { parts: [choose], set: (value) => (choose.selectedIndex = options.findIndex(([one]) => one === value)) };
}

/**
 * The row of a setting, a slider or a list to choose from; `show` has it show another value.
 *
 * @param {Setting} setting @param {(value: number | string) => void} change
 */
export function settingRow(setting, change) {
  const row = make("div", "row");
  const label = make("label", "", setting.label);
  const { parts, set } = setting.options ? list(setting, setting.options, change) : slider(setting, change);
  label.htmlFor = parts[parts.length - 1].id = `setting-${setting.key}`;
  row.append(label, ...parts);
  return Object.assign(row, { show: set });
}
