// @ts-check
/** The picture that is shown and its place on the screen, and the marks that are drawn over it. */
import { onFit } from "./camera.js";
import { onPicture, shown } from "./canvas.js";
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

/** Milliseconds for which the camera may go on moving after the last event. */
const CAMERA_MOVES = 1000;

/** @type {((seen: Sight) => void)[]} */
const listeners = [];
/** True while the page is printed: the canvas then has another size, and nothing is redrawn. */
let printing = false;
/** The canvas at the last redraw of the marks. @type {DOMRect | null} */
let drawnOver = null;

/** Calls back whenever marks over the body have to be redrawn, in the order of these calls. @param {(seen: Sight) => void} draw */
export const onMarksRedraw = (draw) => listeners.push(draw);

/** Adds a layer of marks to the page, under the instruments. @param {SVGSVGElement} svg */
export const insertMarksLayer = (svg) => document.body.insertBefore(svg, document.querySelector(".softrod-instruments"));

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
 * @param {Frame | null} frame the picture
 * @returns {Sight | null}
 */
export function sight(frame = shown().frame) {
  if (printing || matchMedia("print").matches) return null;
  const { pictured: plan } = shown();
  const [on, canvas] = [screen(), viserCanvas()];
  if (!plan || frame?.generation !== plan.generation || !on || !canvas) return null;
  const box = canvas.getBoundingClientRect();
  return { plan, frame, on, places: onScreen(plan, frame.positions, on), box, floor: floorOf(box) };
}

/** Redraws the marks with every picture, every message on the page and every movement of the camera. */
export function keepMarksDrawn() {
  onPicture(redrawMarks);
  onMessage("pageState", redrawMarks);
  onFit(redrawMarks);
  let until = 0;
  let tracking = false;
  const track = () => {
    redrawMarks();
    tracking = performance.now() < until;
    if (tracking) requestAnimationFrame(track);
  };
  /** The camera moves without a picture, too, and goes on a little by itself. @param {Event} event */
  const follow = (event) => {
    if (event instanceof PointerEvent && event.buttons === 0) return;
    until = performance.now() + CAMERA_MOVES;
    if (!tracking) requestAnimationFrame(track);
    tracking = true;
  };
  for (const kind of ["wheel", "pointermove", "pointerup", "keydown", "resize"]) {
    window.addEventListener(kind, follow, { capture: true, passive: true });
  }
}
