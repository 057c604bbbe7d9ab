// @ts-check
/** A quantity is chosen as in the Measure tab: a part of the body, and what of it. */
import { make } from "../../ui/dialog.js";
import { makeSelect, refusal, setOptions } from "./fields.js";

/** @typedef {import("../../wire/wire.js").LessonOffers} LessonOffers */
/** @typedef {{quantity: string, of: "value" | "period"}} Reading */

/** @param {string} name */
const partOf = (name) => name.slice(0, name.indexOf("."));
/** @param {string} part */
const kindOf = (part) => part.replace(/\d+$/, "");

/** Two lists by which a quantity is chosen, as in the Measure tab, and one for its value or its period. */
export class Chooser {
  /** @param {string} label @param {string} name of the field @param {() => void} changed */
  constructor(label, name, changed) {
    this.part = makeSelect(`${label}: part`);
    this.what = makeSelect(`${label}: quantity`);
    this.of = makeSelect(`${label}: of it`);
    setOptions(this.of, [["value", "value"], ["period", "period"]], "value");
    this.element = make("div", "softrod-making-row");
    this.element.append(this.part, this.what, this.of);
    this.refused = refusal(name);
    this.part.addEventListener("change", () => {
      this.show({ ...this.reading, quantity: `${this.part.value}.${this.what.value}` });
      changed();
    });
    for (const list of [this.what, this.of]) list.addEventListener("change", changed);
    /** @type {LessonOffers | null} */
    this.offers = null;
  }

  /** @returns {Reading} */
  get reading() {
    return { quantity: `${this.part.value}.${this.what.value}`, of: this.of.value === "period" ? "period" : "value" };
  }

  /** @param {Reading | null} reading the one that is chosen, or none yet */
  show(reading) {
    if (!this.offers) return;
    const { parts, quantities } = this.offers;
    const chosen = reading?.quantity ? partOf(reading.quantity) : (parts.find((part) => part.startsWith("mass")) ?? parts[0] ?? "");
    const known = parts.includes(chosen) || !chosen ? parts : [chosen, ...parts];
    setOptions(this.part, known.map((part) => [part, part]), chosen);
    const units = quantities[kindOf(chosen)] ?? {};
    const whats = Object.keys(units);
    const before = reading?.quantity.slice(chosen.length + 1) ?? "";
    const usual = chosen.startsWith("mass") ? "y" : (whats[0] ?? "");
    setOptions(this.what, whats.map((what) => [what, `${what.replaceAll("_", " ")}${units[what] && ` (${units[what]})`}`]), whats.includes(before) ? before : usual);
    if (reading) this.of.value = reading.of;
  }
}
