// @ts-check
/**
 * What a pupil works with: sliders, plots of what is measured, and the arrow pad.
 *
 * @typedef {import("../../wire/wire.js").Bench} Work
 * @typedef {import("../../wire/wire.js").Dial} Dial
 */
import { makeChart } from "../../export/live/static/chart.js";
import { settingRow } from "../../export/live/static/sliders.js";
import { swings } from "../../export/live/static/swings.js";
import { make } from "../../ui/dialog.js";
import { onMessage, send } from "../../wire/channel.js";
import { unpack } from "../../wire/unpack.js";

/** Seconds of what is plotted that are kept. */
const SPAN = 60;

/** The values of the plots' quantities over the last minute. */
class Record {
  /** @type {number[]} */
  times = [];
  /** @type {Map<string, number[]>} */
  values = new Map();

  /** @param {number} time @param {[name: string, value: number][]} values */
  take(time, values) {
    const all = [this.times, ...this.values.values()];
    while (this.times.length && this.times[this.times.length - 1] >= time) all.forEach((one) => one.pop());
    this.times.push(time);
    for (const [name, value] of values) {
      const known = this.values.get(name);
      if (known) known.push(value);
      else this.values.set(name, [value]);
    }
    const old = this.times.findIndex((at) => at >= time - SPAN);
    if (old > SPAN) [this.times, ...this.values.values()].forEach((one) => one.splice(0, old));
  }

  /** Period and amplitude of a quantity; null where it does not swing. @param {string} name */
  swings(name) {
    const values = this.values.get(name) || [];
    return values.every(Number.isFinite) ? swings(this.times, values) : null;
  }
}

export class Bench {
  /** @type {Work} */
  #work = { tell: "bench", opening: -1, dials: [], curves: [] };
  #record = new Record();
  /** @type {ReturnType<typeof makeChart>[]} */
  #charts = [];
  /** @type {Map<string, ReturnType<typeof settingRow>>} */
  #rows = new Map();
  #asked = false;

  /**
   * @param {HTMLElement} element
   * @param {(dial: Dial, value: number | string) => boolean} change sets a number of a body in the page; true if there is one
   */
  constructor(element, change) {
    this.element = element;
    this.sliders = make("div", "softrod-dials");
    this.plots = make("div", "softrod-charts");
    element.append(this.sliders, this.plots);
    this.change = change;
    onMessage("bench", (work) => this.#build(work));
    onMessage("readings", ({ numbers }) => {
      const { opening, time, values } = unpack("readings", numbers);
      if (opening === this.#work.opening) this.take(time, Array.from(values));
    });
  }

  /** The sliders and lists, with their present values. */
  get dials() {
    return this.#work.dials;
  }

  /** The names of the plots' quantities, in the order of their values. */
  get names() {
    return this.#work.curves.flatMap(({ names, over }) => (over ? [...names, over] : names));
  }

  /** @param {Work} work */
  #build(work) {
    const before = this.#work;
    this.#work = work;
    const keys = (/** @type {Work} */ { dials }) => dials.map(({ key, label, low, high }) => `${key} ${label} ${low} ${high}`).join();
    if (keys(work) !== keys(before)) {
      this.#rows.clear();
      for (const dial of work.dials) {
        const setting = { ...dial, sets: [...dial.sets], options: dial.options.length ? dial.options : undefined };
        this.#rows.set(dial.key, settingRow(setting, (value) => {
          if (this.change(dial, value)) return;
          if (typeof value === "number") send({ do: "setNumber", key: dial.key, value });
          else send({ do: "setWord", key: dial.key, value });
        }));
      }
      this.sliders.replaceChildren(...this.#rows.values());
    }
    for (const { key, value } of work.dials) {
      const row = this.#rows.get(key);
      // Not under a finger: what it sets comes back later.
      if (row && !row.matches(":active")) row.show(value);
    }
    const drawn = JSON.stringify(work.curves) !== JSON.stringify(before.curves);
    if (drawn || work.opening !== before.opening) this.#record = new Record();
    if (!drawn) return;
    this.#charts = work.curves.map(({ labels, units, over_label, over_unit, turned }) => makeChart({ names: labels, words: labels, units, over: over_label, overWords: over_label, overUnit: over_unit, turned }));
    this.plots.replaceChildren(...this.#charts.map(({ element }) => element));
  }

  /** Takes what the plots show now. @param {number} time @param {number[]} values in the order of `names` */
  take(time, values) {
    const labels = this.#work.curves.flatMap((curve) => (curve.over ? [...curve.labels, curve.over_label] : curve.labels));
    this.#record.take(time, labels.map((label, i) => [label, values[i]]));
    if (!this.#asked) requestAnimationFrame(() => this.#draw());
    this.#asked = true;
  }

  #draw() {
    this.#asked = false;
    for (const chart of this.#charts) chart.draw(this.#record);
  }
}
