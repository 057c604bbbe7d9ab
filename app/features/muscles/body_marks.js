// @ts-check
/** Marks on the body: the springs and joints of the muscles that are pointed at in the strip. */
import { insertMarksLayer, onMarksRedraw, sight } from "../../stage/sight.js";
import { makeSvg, set } from "../../stage/svg.js";

/** @typedef {import("./marks.js").Mark} Mark */

/** Pixels around the mass of a joint. */
const RING = 9;

export class MuscleMarks {
  svg = makeSvg("svg", "softrod-marks softrod-muscle-marks");
  path = makeSvg("path", "", this.svg);
  /** @type {Mark[]} */
  marked = [];

  constructor() {
    onMarksRedraw((seen) => this.draw(seen));
  }

  /** @param {Mark[]} marks */
  show(marks) {
    this.marked = marks;
    const seen = sight();
    if (seen) this.draw(seen);
  }

  /** @param {import("../../stage/sight.js").Sight} seen */
  draw({ plan, places, on }) {
    if (!this.marked.length) {
      this.svg.remove();
      return;
    }
    /** @param {number} mass @param {number} [left] px */
    const at = (mass, left = 0) => `${(places[2 * mass] - left).toFixed(1)} ${places[2 * mass + 1].toFixed(1)}`;
    const paths = this.marked.map(({ joint, part }) => {
      if (joint && 4 * part < plan.joints.length) {
        const tip = plan.joints[4 * part + 2];
        const r = Number((plan.radius[tip] * on.step + RING).toFixed(1));
        return `M${at(tip, r)}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0`;
      }
      return !joint && 2 * part < plan.springs.length ? `M${at(plan.springs[2 * part])}L${at(plan.springs[2 * part + 1])}` : "";
    });
    set(this.path, { d: paths.join("") });
    if (!this.svg.parentNode) insertMarksLayer(this.svg);
  }
}
