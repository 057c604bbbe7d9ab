// @ts-check
/** A small label next to a mass, the one under the pointer or the chosen one: its position and its speed. */
import { onPicture } from "../../stage/canvas.js";
import { pageState } from "../../wire/channel.js";
import { insertMarksLayer, onMarksRedraw, redrawMarks } from "../../stage/sight.js";
import { makeSvg, set } from "../../stage/svg.js";
import { chosenMass } from "../../stage/overlay.js";
import { digits } from "./shapes.js";
import { massAt } from "../../ui/hands/pointer.js";
import { onTools, tools } from "./tools.js";
import { viserCanvas } from "../../ui/viser/viser.js";
import { say } from "../../words/words.js";

/** Simulated seconds between two pictures beyond which they give no speed. */
const MAX_INTERVAL = 0.1;
/** Pixels between a mass and its label. */
const GAP = 10;

/** @typedef {import("../../stage/plan.js").Frame} Frame */

/** The speed of a mass between two pictures; NaN unless they belong to one motion. @param {Frame | null} before @param {Frame} now @param {number} mass */
export function speedOf(before, now, mass) {
  const span = before ? now.time - before.time : 0;
  if (!before || span === 0 || Math.abs(span) > MAX_INTERVAL || before.positions.length !== now.positions.length) return NaN;
  const [x, y] = [2 * mass, 2 * mass + 1].map((i) => now.positions[i] - before.positions[i]);
  return Math.hypot(x, y) / Math.abs(span);
}

/** Adds the label, which is shown while its switch is on. */
export function addCoordinates() {
  const svg = makeSvg("svg", "softrod-marks softrod-coordinates");
  const ring = makeSvg("circle", "", svg);
  const lines = [0, 1].map(() => makeSvg("text", "", svg));
  let under = -1;
  /** The last picture of an earlier time. @type {Frame | null} */
  let before = null;
  /** @type {Frame | null} */
  let last = null;
  onPicture((frame) => {
    if (last && last.time !== frame.time) before = last;
    last = frame;
  });
  window.addEventListener("pointermove", (event) => {
    if (!tools().coordinates || event.buttons || event.target !== viserCanvas()) return;
    const mass = massAt({ x: event.clientX, y: event.clientY }, event.pointerType);
    if (mass === under) return;
    under = mass;
    redrawMarks();
  }, { capture: true, passive: true });
  onMarksRedraw(({ plan, frame, on, places, box }) => {
    const mass = [under, chosenMass(), tools().chosen].find((each) => each >= 0 && each < plan.radius.length);
    const isShown = tools().coordinates && mass !== undefined;
    if (isShown === (svg.parentNode === null)) isShown ? insertMarksLayer(svg) : svg.remove();
    if (!isShown) return;
    const [x, y] = places.subarray(2 * mass, 2 * mass + 2);
    const radius = plan.radius[mass] * on.step;
    const unit = pageState().unit ?? "";
    const speed = speedOf(before, frame, mass);
    const [px, py] = frame.positions.subarray(2 * mass, 2 * mass + 2);
    lines[0].textContent = say("instruments-at", { mass, x: digits(px), y: digits(py), unit });
    lines[1].textContent = Number.isFinite(speed) ? `${digits(speed)} ${unit}/s` : "";
    set(ring, { cx: x, cy: y, r: radius + 5 });
    const width = Math.max(...lines.map((line) => line.getComputedTextLength()));
    const right = x + radius + GAP;
    const left = Math.max(right + width > box.right ? x - radius - GAP - width : right, box.left + 4);
    const height = 1.3 * parseFloat(getComputedStyle(svg).fontSize);
    lines.forEach((line, i) => set(line, { x: left, y: y + (i - 0.5) * height }));
  });
  onTools(redrawMarks);
}
