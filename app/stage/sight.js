// @ts-check
/** The picture that is shown and its place on the screen, and the marks that are drawn over it. */
import { overCanvas } from "../ui/dialog.js";
import { onFit } from "./camera.js";
import { onRender, shown } from "./canvas.js";
import { floorOf } from "./dock.js";
import { callAll, onMessage } from "../wire/channel.js";
import { onScreen } from "./screen.js";
import { screen } from "../ui/viser/screen.js";
import { viserCanvas } from "../ui/viser/viser.js";

/**
 * @typedef {import("./plan.js").Plan} Plan
 * @typedef {import("./plan.js").Frame} Frame
 * @typedef {object} Sight a picture, and where it is on the screen
 * @property {Plan} plan
 * @property {Frame} frame
 * @property {import("./screen.js").Screen} on
 * @property {Float64Array} places of the masses, x and y of each
 * @property {DOMRect} box of the canvas
 * @property {number} floor lower end of the visible part of the canvas: its own edge, or the bar of time
 */

/** @type {((seen: Sight) => void)[]} */
const listeners = [];
/** True while the page is printed: the canvas then has another size, and nothing is redrawn. */
let printing = false;
/** The canvas at the last redraw of the marks. @type {DOMRect | null} */
let drawnOver = null;

/** Calls back whenever marks over the body have to be redrawn, in the order of these calls. @param {(seen: Sight) => void} draw */
export const onMarksRedraw = (draw) => listeners.push(draw);

/** Adds a layer of marks to the page, under the instruments. @param {SVGSVGElement} svg */
export const insertMarksLayer = (svg) => overCanvas().insertBefore(svg, document.querySelector(".softrod-instruments"));

/** Redraws all marks. */
export function redrawMarks() {
  const seen = sight();
  if (!seen) return;
  drawnOver = seen.box;
  callAll(listeners, seen);
}

/** Scales the marks with the canvas while the page is printed, or ends that. @param {boolean} on */
export function frameMarks(on) {
  printing = on;
  for (const svg of document.querySelectorAll(".softrod-overlay, .softrod-marks")) {
    if (on && drawnOver) {
      const { left, top, width, height } = drawnOver;
      svg.setAttribute("viewBox", `${left} ${top} ${width} ${height}`);
    } else svg.removeAttribute("viewBox");
  }
  if (!on) redrawMarks();
}

/**
 * What is on the screen now; null while the page is printed.
 *
 * @returns {Sight | null}
 */
export function sight() {
  if (printing || matchMedia("print").matches) return null;
  const { pictured: plan, rendered, frame: latest } = shown();
  const frame = rendered?.generation === plan?.generation ? rendered : latest;
  const [on, canvas] = [screen(), viserCanvas()];
  if (!plan || frame?.generation !== plan.generation || !on || !canvas) return null;
  const box = canvas.getBoundingClientRect();
  return { plan, frame, on, places: onScreen(plan, frame.positions, on), box, floor: floorOf(box) };
}

/** Redraws the marks with every picture, every message on the page and every movement of the camera. */
export function keepMarksDrawn() {
  /** @type {{frame: Frame | null, place: string}} */
  let drawn = { frame: null, place: "" };
  // viser draws for a while after each picture, too.
  onRender(() => {
    const { x, y, step } = screen() ?? {};
    const { left, top, width, height } = viserCanvas()?.getBoundingClientRect() ?? {};
    const [frame, place] = [shown().rendered ?? shown().frame, [x, y, step, left, top, width, height].join(" ")];
    if (frame === drawn.frame && place === drawn.place) return;
    drawn = { frame, place };
    redrawMarks();
  });
  onMessage("pageState", redrawMarks);
  onFit(redrawMarks);
}
