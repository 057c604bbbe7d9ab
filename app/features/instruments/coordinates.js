// @ts-check
/** Where a mass is and how fast, in a small label beside it: of the one under the pointer, or chosen. */
import { onPicture } from "../../stage/canvas.js";
import { pageState } from "../../wire/channel.js";
import { chosenMass } from "../../stage/overlay.js";
import { insertMarksLayer, onMarksRedraw, redrawMarks } from "../../stage/sight.js";
import { SVG } from "../../stage/svg.js";
import { massAt } from "../../ui/hands/pointer.js";
import { onTools, tools } from "./tools.js";
import { viserCanvas } from "../../ui/viser/viser.js";

/** Simulated seconds between two pictures beyond which they do not tell a speed. */
const NEAR = 0.1;
/** Pixels between a mass and its label. */
const ASIDE = 10;

/** @typedef {import("../../stage/plan.js").Frame} Frame */

/**
 * The speed of a mass between two pictures, or NaN where they are not of the same motion.
 *
 * @param {Frame | null} before
 * @param {Frame} now
 * @param {number} mass
 */
export function speedOf(before, now, mass) {
  const span = before ? now.time - before.time : 0;
  if (!before || span === 0 || Math.abs(span) > NEAR || before.positions.length !== now.positions.length) return NaN;
  const [x, y] = [2 * mass, 2 * mass + 1].map((i) => now.positions[i] - before.positions[i]);
  return Math.hypot(x, y) / Math.abs(span);
}

/** Begins to read out masses, while the switch is on. */
export function addCoordinates() {
  const svg = document.createElementNS(SVG, "svg");
  svg.classList.add("softrod-marks", "softrod-coordinates");
  svg.setAttribute("aria-hidden", "true");
  const ring = document.createElementNS(SVG, "circle");
  const lines = [0, 1].map(() => document.createElementNS(SVG, "text"));
  svg.append(ring, ...lines);
  let under = -1;
  /** The picture before the one that is shown, of another time. @type {Frame | null} */
  let before = null;
  /** @type {Frame | null} */
  let last = null;
  onPicture((frame) => {
    if (last && last.time !== frame.time) before = last;
    last = frame;
  });
  window.addEventListener(
    "pointermove",
    (event) => {
      if (!tools().coordinates || event.buttons || event.target !== viserCanvas()) return;
      const mass = massAt({ x: event.clientX, y: event.clientY }, event.pointerType);
      if (mass === under) return;
      under = mass;
      redrawMarks();
    },
    { capture: true, passive: true },
  );
  onMarksRedraw(({ plan, frame, on, places, box }) => {
    const mass = [under, chosenMass(), tools().chosen].find((each) => each >= 0 && each < plan.radius.length);
    const has = tools().coordinates && mass !== undefined;
    if (has === (svg.parentNode === null)) has ? insertMarksLayer(svg) : svg.remove();
    if (!has) return;
    const [x, y] = [places[2 * mass], places[2 * mass + 1]];
    const radius = plan.radius[mass] * on.step;
    const height = 1.3 * parseFloat(getComputedStyle(svg).fontSize);
    const unit = pageState().unit ?? "";
    /** @param {number} value */
    const digits = (value) => value.toFixed(Math.abs(value) < 10 ? 2 : 1);
    const speed = speedOf(before, frame, mass);
    const [px, py] = [frame.positions[2 * mass], frame.positions[2 * mass + 1]];
    lines[0].textContent = `mass ${mass}: ${digits(px)}, ${digits(py)} ${unit}`;
    lines[1].textContent = Number.isFinite(speed) ? `${digits(speed)} ${unit}/s` : "";
    for (const [name, value] of [["cx", x], ["cy", y], ["r", radius + 5]]) ring.setAttribute(String(name), String(value));
    const width = Math.max(...lines.map((line) => line.getComputedTextLength()));
    // On the side where there is room for it.
    const left = x + radius + ASIDE + width > box.right ? x - radius - ASIDE - width : x + radius + ASIDE;
    lines.forEach((line, i) => {
      line.setAttribute("x", String(Math.max(left, box.left + 4)));
      line.setAttribute("y", String(y + (i - 0.5) * height));
    });
  });
  onTools(redrawMarks);
}
