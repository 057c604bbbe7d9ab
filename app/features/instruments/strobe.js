// @ts-check
/**
 * A stroboscope: the body's places at equal intervals of simulated time stay on the canvas, from the positions that the
 * page receives anyway.
 *
 * @typedef {import("../../stage/plan.js").Frame} Frame
 * @typedef {import("../../stage/plan.js").Plan} Plan
 */
import { onMessage, pageState } from "../../wire/channel.js";
import { onFrame, shown } from "../../stage/canvas.js";
import { between } from "../../stage/plan.js";
import { onMarksRedraw, redrawMarks } from "../../stage/sight.js";
import { makeSvg, set } from "../../stage/svg.js";
import { onTools, tools } from "./tools.js";

/** Images that stay, at most; fewer of a body with many parts, since all of them are drawn. */
const MOST = 100;
const PARTS = 8000;
/** Simulated seconds between two frames beyond which the places between them are unknown. */
const GAP = 0.3;
/** Part of an interval by which a time may be rounded. */
const NEAR = 1e-6;

/** How many images stay of a body. @param {number} parts its masses and springs */
export const mostOf = (parts) => Math.max(Math.min(MOST, Math.floor(PARTS / Math.max(parts, 1))), 4);

/**
 * The moments between two frames that are multiples of an interval, the second frame's own among them.
 *
 * @param {Frame | null} last null before the first frame
 * @param {Frame} frame
 * @param {number} every s
 */
export function flashes(last, frame, every) {
  const isNear = last !== null && frame.time - last.time <= GAP && last.positions.length === frame.positions.length;
  const end = Math.floor(frame.time / every + NEAR);
  const begin = isNear ? Math.floor(last.time / every + NEAR) + 1 : Math.abs(frame.time - end * every) <= NEAR * every ? end : end + 1;
  const found = [];
  for (let k = begin; k <= end; k += 1) {
    const part = isNear ? (k * every - last.time) / (frame.time - last.time) : 1;
    found.push(isNear && part < 1 ? between(last, frame, part) : frame);
  }
  return found;
}

/**
 * A body's springs as lines and its masses as discs, as paths in the world.
 *
 * @param {Pick<Plan, "x" | "y" | "scale" | "flip" | "radius" | "springs">} plan
 * @param {ArrayLike<number>} positions
 * @param {Set<number>} broken springs
 */
export function image({ x, y, scale, flip, radius, springs }, positions, broken) {
  /** @param {number} mass */
  const place = (mass) => [(positions[2 * mass] - x) * scale, (positions[2 * mass + 1] - y) * scale * flip];
  /** @param {number} value */
  const text = (value) => Number(value.toFixed(5));
  let [lines, discs] = ["", ""];
  for (let i = 0; 2 * i < springs.length; i += 1) {
    if (broken.has(i)) continue;
    const [a, b] = [place(springs[2 * i]), place(springs[2 * i + 1])];
    lines += `M${a.map(text).join(" ")}L${b.map(text).join(" ")}`;
  }
  for (let mass = 0; mass < radius.length; mass += 1) {
    const [px, py] = place(mass);
    const r = text(radius[mass]);
    discs += `M${text(px - radius[mass])} ${text(py)}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0`;
  }
  return { lines, discs };
}

/** Records and draws the images while the stroboscope is on. */
export function addStrobe() {
  const svg = makeSvg("svg", "softrod-marks softrod-strobe");
  const group = makeSvg("g", "", svg);
  /** @type {{time: number, element: SVGGElement}[]} */
  let images = [];
  /** @type {Frame | null} */
  let last = null;
  let every = 0;
  const clear = () => {
    images = [];
    last = null;
    group.replaceChildren();
  };
  /** @param {Frame} frame @param {Plan} plan */
  const keep = (frame, plan) => {
    const element = makeSvg("g", "", group);
    const { lines, discs } = image(plan, frame.positions, shown().damage.broken);
    set(makeSvg("path", "softrod-strobe-springs", element), { d: lines });
    set(makeSvg("path", "softrod-strobe-masses", element), { d: discs });
    images.push({ time: frame.time, element });
    const most = mostOf(plan.radius.length + plan.springs.length / 2);
    for (const { element: old } of images.splice(0, images.length - most)) old.remove();
  };
  /** @param {Frame} frame */
  const record = (frame) => {
    const { plan } = shown();
    if (!every || !plan || plan.generation !== frame.generation) return;
    if (last && frame.time < last.time) {
      // Time went back: what came later is void.
      for (const { element } of images.filter(({ time }) => time > frame.time)) element.remove();
      images = images.filter(({ time }) => time <= frame.time);
      last = null;
    }
    const before = images.at(-1)?.time ?? -Infinity;
    for (const flash of flashes(last, frame, every)) if (flash.time > before + NEAR) keep(flash, plan);
    last = frame;
  };
  onTools(() => {
    if (tools().strobe === every) return;
    every = tools().strobe;
    clear();
    if (every && !svg.parentNode) document.querySelector(".softrod-overlay")?.before(svg);
    if (!every) svg.remove();
    redrawMarks();
  });
  let { scene } = pageState();
  onMessage("pageState", () => {
    if (pageState().scene !== scene) clear();
    ({ scene } = pageState());
  });
  onFrame(record);
  onMarksRedraw(({ on, frame }) => {
    if (!every) return;
    set(group, { transform: `translate(${on.x} ${on.y}) scale(${on.step} ${-on.step})` });
    // Later frames may have arrived already than the one that is shown.
    for (const { time, element } of images.slice(-3)) element.style.display = time > frame.time + NEAR ? "none" : "";
  });
}
