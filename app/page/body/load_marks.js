// @ts-check
/** Draws the constant forces on masses over the body. */
import { loadArrows } from "../../drawing/static/arrow_shapes.js";
import { onSight, putUp, SVG } from "./overlay.js";

/** Puts up the marks of a body that has any. */
export function addLoads() {
  const svg = document.createElementNS(SVG, "svg");
  svg.classList.add("softrod-marks", "softrod-loads");
  svg.setAttribute("aria-hidden", "true");
  // A rim in the colour of the paper keeps an arrow legible over the body.
  const paths = [["softrod-arrow-rim"], ["softrod-arrow", "softrod-forces"]].map((names) => {
    const path = document.createElementNS(SVG, "path");
    path.classList.add(...names);
    svg.append(path);
    return path;
  });
  onSight(({ plan, on, places }) => {
    const some = plan.loads.length > 0;
    if (some === (svg.parentNode === null)) some ? putUp(svg) : svg.remove();
    if (!some) return;
    const outline = loadArrows(plan, places, on.step);
    for (const path of paths) path.setAttribute("d", outline);
  });
}
