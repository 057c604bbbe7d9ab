// @ts-check
/** Draws the constant forces on masses over the body. */
import { loadArrows } from "./arrow_shapes.js";
import { insertMarksLayer, onMarksRedraw } from "./sight.js";
import { makeSvg } from "./svg.js";

/** Adds the marks of a body that has any. */
export function addLoads() {
  const svg = makeSvg("svg", "softrod-marks softrod-loads");
  // A rim in the colour of the paper keeps an arrow legible over the body.
  const paths = ["softrod-arrow-rim", "softrod-arrow softrod-forces"].map((names) => makeSvg("path", names, svg));
  onMarksRedraw(({ plan, on, places }) => {
    const some = plan.loads.length > 0;
    if (some === (svg.parentNode === null)) some ? insertMarksLayer(svg) : svg.remove();
    if (!some) return;
    const outline = loadArrows(plan, places, on.step);
    for (const path of paths) path.setAttribute("d", outline);
  });
}
