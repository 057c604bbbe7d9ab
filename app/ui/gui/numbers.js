// @ts-check
/**
 * Number boxes: a number is set at Enter, on leaving the box or after a pause, never at every key. Half a number is another
 * number: on its way to 150000 a stiffness would be 15, and springs would break. A number that cannot be is refused with a
 * sentence below, and the old one stays.
 */
import { grouped } from "../numerals.js";
import { make, makeButton } from "../dialog.js";
import { POINT, decimal, say } from "../../words/words.js";
import { visit } from "./control.js";

/** Milliseconds without a key before the number is set. */
const PAUSE = 2000;
/** Characters of an unreadable text that are shown to the user. */
const SHOWN = 40;

/**
 * A sign that may stand before decimals or separate thousands. The one that stands before them in the page's language does,
 * unless the number ends with a nought, which few write.
 */
const AMBIGUOUS = POINT === "," ? /^[+-]?[1-9]\d{0,2}(\.\d{3}|,\d\d0)$/ : /^[+-]?[1-9]\d{0,2}(,\d{3}|\.\d\d0)$/;
const GROUPED = /^\d{1,3}([.,])\d{3}(\1\d{3})*$/;

/**
 * Reads a number, or NaN: with a decimal point or comma, with an exponent, and with spaces, commas or points between groups
 * of three digits. What may be two numbers, as 1,234 or 2.000, is not read.
 *
 * @param {string} text
 */
export function readNumber(text) {
  const plain = text.trim().replace(/\u2212/g, "-").replace(/(\d)[\s'\u2019](?=\d{3}(?!\d))/g, "$1");
  const [, sign = "", digits = "", exponent = ""] = /^([+-]?)([\d.,]*\d[.,]?)(e[+-]?\d+)?$/i.exec(plain) ?? [];
  if (!digits || AMBIGUOUS.test(plain)) return NaN;
  const last = digits.replace(/\d/g, "").slice(-1);
  const [whole = "", fraction = "", ...more] = last ? digits.split(last) : [digits];
  // A mark that occurs more than once separates thousands.
  const before = more.length ? digits : whole;
  if (/[.,]/.test(before) && !GROUPED.test(before)) return NaN;
  const number = Number(`${sign}${before.replace(/[.,]/g, "") || "0"}.${(more.length ? "" : fraction) || "0"}${exponent}`);
  return Number.isFinite(number) ? number : NaN;
}

/** A number without an exponent, for a box. @param {number} number */
export const plainText = (number) => decimal(number.toLocaleString("en-US", { useGrouping: false, maximumSignificantDigits: 15 }));

/**
 * @typedef {object} Range what a box allows; a bound that is null does not exist
 * @property {number | null} low
 * @property {number | null} high
 * @property {string} unit
 */

/**
 * Why a text cannot be set; empty if it can.
 *
 * @param {string} text @param {Range} range
 */
export function whyNot(text, { low, high, unit }) {
  const number = readNumber(text);
  const written = text.trim().slice(0, SHOWN);
  if (AMBIGUOUS.test(written)) {
    return say("ui-number-unclear", { written, one: String(Number(written.replace(",", "."))), other: written.replace(/[,.]/, "") });
  }
  if (Number.isNaN(number)) return say("ui-number-none", { written });
  /** @param {number} bound */
  const said = (bound) => `${grouped(bound)}${unit && unit !== "°" ? " " : ""}${unit}`;
  if (low !== null && number < low) return say("ui-number-least", { least: said(low) });
  if (high !== null && number > high) return say("ui-number-most", { most: said(high) });
  return "";
}

/** A box for a number, with the sentence that says why one is refused. */
export class NumberBox {
  /**
   * @param {object} does
   * @param {() => Range} does.range
   * @param {() => number} does.step of the arrow keys
   * @param {(value: number) => void} does.set called with each number that the user sets
   */
  constructor({ range, step, set }) {
    this.range = range;
    this.step = step;
    this.set = set;
    /** The number that rules. */
    this.value = 0;
    /** True while something is typed that is not set yet. */
    this.isDraft = false;
    /** @type {ReturnType<typeof setTimeout> | undefined} */
    this.timer = undefined;
    this.input = make("input", "softrod-number");
    this.input.type = "text";
    this.input.inputMode = "decimal";
    this.input.autocomplete = "off";
    this.input.spellcheck = false;
    this.input.setAttribute("role", "spinbutton");
    // The keypad of some phones has no minus.
    this.sign = makeButton("\u00b1", () => this.turn(), "softrod-sign");
    this.sign.ariaLabel = say("ui-number-sign");
    this.sign.tabIndex = -1;
    this.sign.hidden = true;
    this.sign.addEventListener("pointerdown", (event) => event.preventDefault()); // the box keeps the focus and its keypad
    this.why = make("p", "softrod-why");
    this.why.setAttribute("role", "alert");
    this.why.hidden = true;
    this.input.addEventListener("focus", visit);
    // Whoever comes to a box writes another number over the one that is there.
    let came = false;
    this.input.addEventListener("focus", () => (came = true));
    this.input.addEventListener("click", () => {
      if (came && this.input.selectionStart === this.input.selectionEnd) this.input.select();
      came = false;
    });
    this.input.addEventListener("input", () => this.type());
    this.input.addEventListener("blur", () => this.settle());
    this.input.addEventListener("keydown", (event) => this.press(event));
  }

  /** Shows a number that rules, unless another is being typed. @param {number} value */
  show(value) {
    const isNew = value !== this.value;
    const { low } = this.range();
    this.sign.hidden = low !== null && low >= 0;
    this.value = value;
    this.input.ariaValueNow = String(value);
    if (this.isDraft) return;
    const text = plainText(value);
    if (this.input.value !== text) this.input.value = text;
    if (isNew) this.refuse("");
  }

  /** @param {string} why */
  refuse(why) {
    this.why.hidden = why === "";
    if (this.why.textContent !== why) this.why.textContent = why;
    this.input.ariaInvalid = why ? "true" : null;
  }

  type() {
    this.isDraft = true;
    this.input.classList.add("softrod-draft");
    this.refuse("");
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.setWhileTyping(), PAUSE);
  }

  /** Changes the sign of what stands in the box. */
  turn() {
    const text = this.input.value.trim();
    this.input.value = /^[-\u2212]/.test(text) ? text.slice(1) : `-${text.replace(/^\+/, "")}`;
    this.type();
  }

  /** Shows the number that rules. */
  drop() {
    this.isDraft = false;
    clearTimeout(this.timer);
    this.input.classList.remove("softrod-draft");
    this.input.value = plainText(this.value);
  }

  /** Sets what was typed, or says why it cannot be. */
  settle() {
    if (!this.isDraft) return;
    const text = this.input.value;
    if (!text.trim()) {
      this.drop();
      return;
    }
    const why = whyNot(text, this.range());
    if (!why) this.value = readNumber(text);
    this.drop();
    this.refuse(why);
    if (!why) this.set(this.value);
  }

  /** Sets the number if it may be complete, but leaves the text as it is, so that the user can go on. */
  setWhileTyping() {
    const text = this.input.value;
    if (!/\d$/.test(text) || whyNot(text, this.range())) return;
    this.value = readNumber(text);
    this.set(this.value);
  }

  /** @param {KeyboardEvent} event */
  press(event) {
    const { key, isComposing } = event;
    if (isComposing) return;
    if (key === "Escape" && this.isDraft) {
      event.stopPropagation();
      this.drop();
    } else if (key === "Enter") {
      this.settle();
      this.input.select();
    } else if (key === "ArrowUp" || key === "ArrowDown") {
      event.preventDefault();
      this.settle();
      const { low, high } = this.range();
      const step = this.step() * (key === "ArrowUp" ? 1 : -1);
      const next = Number((this.value + step).toPrecision(12));
      const value = Math.min(Math.max(next, low ?? -Infinity), high ?? Infinity);
      if (value === this.value) return;
      this.show(value);
      this.set(value);
    }
  }
}
