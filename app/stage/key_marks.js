// @ts-check
/** Draws over the body what motors and keys do, and the keys on what they work. */
import { drivenArrows } from "./driven_arrows.js";
import { WORKS } from "./looks.js";
import { insertMarksLayer, onMarksRedraw } from "./sight.js";
import { makeSvg, set } from "./svg.js";
import { countMuscles, effortOf, muscleAt } from "./swing.js";

/** @typedef {import("./sight.js").Sight} Sight */
/** @typedef {{x: number, y: number, keys: number}} Cap the keys on a part, at a place of the window */

/** What is written for Left and Right, and for Up and Down. */
const SIGNS = ["← →", "↑ ↓"];
/** Half the width and height of a cap, and its distance from what the keys work, px. */
const [HALF, HIGH, BESIDE] = [21, 10, 24];
/** Pixels between two caps of the same keys below which the second one is left out. */
const APART = 110;
/** Pixels between two caps one above the other. */
const STACKED = 2 * HIGH + 3;

/** Adds the marks of a body that has any. */
export function addKeyMarks() {
  const svg = makeSvg("svg", "softrod-marks softrod-driven");
  const paths = ["softrod-arrow-rim", "softrod-arrow softrod-rests", "softrod-arrow-rim", "softrod-arrow"].map((names) =>
    makeSvg("path", `${names} softrod-forces`, svg),
  );
  /** @type {SVGGElement[]} */
  const caps = [];
  onMarksRedraw((seen) => {
    const { plan, frame, on, places } = seen;
    const found = capsOf(seen);
    const some = plan.motors.length > 0 || found.length > 0;
    if (some === (svg.parentNode === null)) some ? insertMarksLayer(svg) : svg.remove();
    if (!some) return;
    const { works, rests } = drivenArrows(plan, frame, places, on.step);
    [rests, rests, works, works].forEach((d, i) => set(paths[i], { d }));
    while (caps.length > found.length) caps.pop()?.remove();
    while (caps.length < found.length) caps.push(makeCap(svg));
    found.forEach(({ x, y, keys }, i) => {
      set(caps[i], { transform: `translate(${x.toFixed(1)} ${y.toFixed(1)})` });
      caps[i].classList.toggle("softrod-on", Math.abs(effortOf(frame, keys)) > WORKS);
      const text = /** @type {Element} */ (caps[i].lastChild);
      if (text.textContent !== SIGNS[keys]) text.textContent = SIGNS[keys];
    });
  });
}

/** An empty cap. @param {SVGSVGElement} svg */
function makeCap(svg) {
  const cap = makeSvg("g", "softrod-cap", svg);
  set(makeSvg("rect", "", cap), { x: -HALF, y: -HIGH, width: 2 * HALF, height: 2 * HIGH, rx: 4 });
  makeSvg("text", "", cap);
  return cap;
}

/** Where keys are written: above a motor and a joint, beside a spring, and behind a force. @param {Sight} seen @returns {Cap[]} */
function capsOf({ plan, on, places }) {
  const { motors, pushes, joints, springs, radius, many } = plan;
  /** @type {Cap[]} */
  const caps = [];
  /** @param {number} keys @param {number} x @param {number} y @param {number} dx @param {number} dy towards the cap */
  const add = (keys, x, y, dx, dy) => {
    if (keys < 0) return;
    const cap = { keys, x: x + dx, y: y + dy };
    if (caps.some((other) => other.keys === keys && Math.hypot(other.x - cap.x, other.y - cap.y) <= APART)) return;
    while (caps.some((other) => Math.abs(other.x - cap.x) < 2 * HALF && Math.abs(other.y - cap.y) < STACKED)) cap.y -= STACKED;
    caps.push(cap);
  };
  /** @param {number} keys @param {number} mass @param {number} dx @param {number} dy direction */
  const beside = (keys, mass, dx, dy) => {
    const far = (radius[mass] * on.step + BESIDE) / Math.hypot(dx, dy);
    add(keys, places[2 * mass], places[2 * mass + 1], far * dx, far * dy);
  };
  if (many) return caps;
  for (let i = 0; i < motors.length; i += 3) beside(motors[i + 2], joints[4 * motors[i] + 2], 0, -1);
  for (let i = 0; i < pushes.length; i += 4) beside(pushes[i + 3], pushes[i], -pushes[i + 1], pushes[i + 2]);
  for (let k = 0; k < countMuscles(plan); k++) {
    const { joint, part, keys } = muscleAt(plan, k);
    if (keys < 0) continue;
    if (joint) beside(keys, joints[4 * part + 2], 0, -1);
    else {
      const [a, b] = [2 * springs[2 * part], 2 * springs[2 * part + 1]];
      const [x, y] = [places[b] - places[a], places[b + 1] - places[a + 1]];
      const far = BESIDE / Math.max(Math.hypot(x, y), 1e-9);
      add(keys, (places[a] + places[b]) / 2, (places[a + 1] + places[b + 1]) / 2, -far * y, far * x);
    }
  }
  return caps;
}
