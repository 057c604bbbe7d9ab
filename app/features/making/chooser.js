// @ts-check
/** A quantity is chosen as in the Measure tab: a part of the body, and one of its quantities. */
import { box, makeSelect, refusal, setOptions } from "./fields.js";
import { say } from "../../words/words.js";

/** @typedef {import("../../wire/wire.js").LessonOffers} LessonOffers */
/** @typedef {import("../../wire/wire.js").ReadingDraft} Reading */

/** A part of the body and what is measured of it; all else is a formula. */
const NAME = /^([a-z]+\d*)\.([a-z_]*)$/;

/** Two lists for a quantity, of which the first has formulas, too, and one for its value or its period. */
export class Chooser {
  /** @param {string} label @param {string} name of the field @param {() => void} changed */
  constructor(label, name, changed) {
    this.part = makeSelect(say("making-part", { label }));
    this.what = makeSelect(say("making-part.quantity", { label }));
    this.of = makeSelect(say("making-part.of", { label }));
    setOptions(this.of, [["value", say("making-value")], ["period", say("making-period")]], "value");
    this.element = box("softrod-making-part", box("softrod-making-row", this.part, this.what, this.of), refusal(name));
    this.part.addEventListener("change", () => {
      this.show(this.reading);
      changed();
    });
    for (const list of [this.what, this.of]) list.addEventListener("change", changed);
    /** @type {LessonOffers | null} */
    this.offers = null;
  }

  /** @returns {Reading} */
  get reading() {
    const part = this.part.value;
    return { quantity: /^[a-z]+\d*$/.test(part) ? `${part}.${this.what.value}` : part, of: this.of.value === "period" ? "period" : "value" };
  }

  /** Shows a reading, or a first choice. @param {Reading | null} reading */
  show(reading) {
    if (!this.offers) return;
    const { parts, quantities } = this.offers;
    const names = Object.keys(parts);
    const first = names.find((one) => one.startsWith("mass")) ?? names[0] ?? "";
    const [, part, what] = NAME.exec(reading?.quantity ?? `${first}.`) ?? ["", reading?.quantity ?? "", ""];
    setOptions(this.part, Object.entries(part in parts || !part ? parts : { [part]: part, ...parts }), part);
    const called = quantities[part.replace(/\d+$/, "")] ?? {};
    const whats = Object.keys(called);
    const usual = part.startsWith("mass") ? "y" : (whats[0] ?? "");
    setOptions(this.what, Object.entries(called), whats.includes(what) ? what : usual);
    this.what.hidden = whats.length === 0;
    if (reading) this.of.value = reading.of;
  }

  /** Shows what can be chosen now. */
  refresh() {
    this.show(this.part.value ? this.reading : null);
  }
}
