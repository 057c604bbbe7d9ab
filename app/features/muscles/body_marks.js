// @ts-check
/** Marks on the body the springs and joints of the muscles that are pointed at in the strip. */
import { insertMarksLayer, onMarksRedraw, sight } from "../../stage/sight.js";
import { makeSvg, set } from "../../stage/svg.js";

/** @typedef {import("./marks.js").Mark} Mark */

/** Pixels around the mass of a joint. */
const RING = 9;

export function addMuscleMarks() {
  const svg = makeSvg("svg", "softrod-marks softrod-muscle-marks");
  const path = makeSvg("path", "", svg);
  /** @type {Mark[]} */
  let marked = [];
  /** @param {import("../../stage/sight.js").Sight} seen */
  const draw = ({ plan, places, on }) => {
    if (!marked.length && !svg.parentNode) return;
    let d = "";
    for (const { joint, part } of marked) {
      if (joint && 4 * part < plan.joints.length) {
        const tip = plan.joints[4 * part + 2];
        const r = (plan.radius[tip] * on.step + RING).toFixed(1);
        d += `M${(places[2 * tip] - Number(r)).toFixed(1)} ${places[2 * tip + 1].toFixed(1)}a${r} ${r} 0 1 0 ${2 * Number(r)} 0a${r} ${r} 0 1 0 ${-2 * Number(r)} 0`;
      } else if (!joint && 2 * part < plan.springs.length) {
        const [a, b] = [2 * plan.springs[2 * part], 2 * plan.springs[2 * part + 1]];
        d += `M${places[a].toFixed(1)} ${places[a + 1].toFixed(1)}L${places[b].toFixed(1)} ${places[b + 1].toFixed(1)}`;
      }
    }
    set(path, { d });
    if (marked.length && !svg.parentNode) insertMarksLayer(svg);
    else if (!marked.length) svg.remove();
  };
  onMarksRedraw(draw);
  return {
    /** @param {Mark[]} marks */
    show: (marks) => {
      marked = marks;
      const seen = sight();
      if (seen) draw(seen);
    },
  };
}
