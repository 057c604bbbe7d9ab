// @ts-check
/**
 * Draws a body into a canvas by the same modules as the page: for files without a server.
 *
 * @typedef {import("../../stage/plan.js").Plan} Plan
 * @typedef {import("../../stage/plan.js").Frame} Frame
 * @typedef {import("../../stage/plan.js").Damage} Damage
 * @typedef {import("../../stage/draw.js").Instances} Instances
 * @typedef {import("../../stage/environment.js").Screen} Screen
 * @typedef {object} Stage how a file shows its body
 * @property {number} size of the scene's frame, px: the larger of its sides
 * @property {number[]} box left, right, low and high of what is shown, in the page's world
 * @property {string} springs the mesh that springs are drawn with
 * @property {Record<string, number[][]>} meshes outlines: x and y of each corner
 * @typedef {{plan: Plan, frame: Frame, damage: Damage}} Shown
 */
import { loadArrows } from "../../stage/arrow_shapes.js";
import { NODES, toWorld } from "../../stage/draw.js";
// ifdef HAS_DRIVEN
import { drivenArrows } from "../../stage/driven_arrows.js";
// endif
import { moving, standing, streaks } from "../../stage/environment.js";
import { ARROW, LAYERS, MARGIN } from "../../stage/looks.js";
import { isStill } from "../../ui/access.js";
// ifdef HAS_DRIVEN
import { RESTS } from "../../stage/looks.js";
// endif

/** Size, in units of the world, below which an instance is left out; those that have vanished are half as large. */
const UNSEEN = 2e-6;

/**
 * Fills copies of a mesh; consecutive ones of one colour are one area, without seams.
 *
 * @param {CanvasRenderingContext2D} to
 * @param {number[][]} lines
 * @param {Instances} parts
 * @param {Screen} on
 */
function stamp(to, lines, parts, on) {
  const { batched_positions: p, batched_wxyzs: q, batched_scales: s, batched_colors: c } = parts;
  let last = "";
  for (let i = 0; i < s.length / 3; i++) {
    if (!c || !(s[3 * i] > UNSEEN)) continue;
    const color = `rgb(${c[3 * i]} ${c[3 * i + 1]} ${c[3 * i + 2]})`;
    if (color !== last) {
      if (last) to.fill();
      to.beginPath();
      to.fillStyle = last = color;
    }
    const [w, z] = [q[4 * i], q[4 * i + 3]];
    const [cosine, sine] = [w * w - z * z, 2 * w * z];
    for (const line of lines) {
      for (let k = 0; k < line.length; k += 2) {
        const [along, across] = [line[k] * s[3 * i], line[k + 1] * s[3 * i + 1]];
        const x = on.x + on.step * (p[3 * i] + along * cosine - across * sine);
        const y = on.y - on.step * (p[3 * i + 1] + along * sine + across * cosine);
        if (k) to.lineTo(x, y);
        else to.moveTo(x, y);
      }
      to.closePath();
    }
  }
  if (last) to.fill();
}

/**
 * Where the page's world is in a canvas, in pixels of the page from its upper left corner.
 *
 * @param {Stage} stage @param {HTMLCanvasElement} canvas @returns {Screen}
 */
export function screenOf({ box: [left, right, low, high] }, canvas) {
  const { width, height } = canvas.getBoundingClientRect();
  const step = Math.min(width / (right - left), height / (high - low)) / MARGIN;
  return { x: width / 2 - (step * (left + right)) / 2, y: height / 2 + (step * (low + high)) / 2, step };
}

/**
 * Draw a body.
 *
 * @param {Stage} stage @param {HTMLCanvasElement} canvas @param {Shown} shown
 */
export function paint(stage, canvas, { plan, frame, damage }) {
  const to = canvas.getContext("2d");
  if (!to) throw new Error("there is no canvas");
  const { width, height } = canvas.getBoundingClientRect();
  const fine = devicePixelRatio;
  const [across, down] = [Math.round(width * fine), Math.round(height * fine)];
  if (canvas.width !== across || canvas.height !== down) [canvas.width, canvas.height] = [across, down];
  const on = screenOf(stage, canvas);
  const world = toWorld(plan, frame.positions);
  const places = world.map((value, i) => (i % 2 ? on.y - on.step * value : on.x + on.step * value));
  const box = { left: 0, right: width, top: 0, bottom: height };
  const wind = plan.wind.length ? streaks(plan, frame.time, on, box) : "";
  /** @type {Record<string, string>} */
  const paths = { ...standing({ plan, on, box }, stage.size), ...moving({ plan, places }, damage.broken), wind };
  const styles = getComputedStyle(document.documentElement);
  /** @param {string} name */
  const color = (name) => styles.getPropertyValue(`--softrod-${name}`);
  to.setTransform(fine, 0, 0, fine, 0, 0);
  to.clearRect(0, 0, width, height);
  for (const [name, { color: ink, opacity, width: wide, round }] of Object.entries(LAYERS)) {
    const path = new Path2D(paths[name]);
    Object.assign(to, { strokeStyle: color(ink), fillStyle: color(ink), globalAlpha: opacity });
    Object.assign(to, { lineWidth: wide ?? plan.contact * plan.scale * on.step, lineCap: round ? "round" : "butt" });
    if (wide === 0) to.fill(path);
    else to.stroke(path);
  }
  to.globalAlpha = 1;
  const still = isStill();
  const body = { plan, frame, world, damage, still };
  for (const { mesh, draw, has } of Object.values(NODES)) {
    if (has?.(body) ?? true) stamp(to, stage.meshes[mesh || stage.springs], draw(body), on);
  }
  if (plan.loads.length) {
    const arrows = new Path2D(loadArrows(plan, places, on.step));
    Object.assign(to, { strokeStyle: color("force"), fillStyle: color("force"), lineWidth: ARROW, lineJoin: "round" });
    to.stroke(arrows);
    to.fill(arrows);
  }
  // ifdef HAS_DRIVEN
  if (plan.motors.length || plan.pushes.length) {
    const { works, rests } = drivenArrows(plan, frame, places, on.step);
    Object.assign(to, { strokeStyle: color("force"), lineWidth: ARROW, lineCap: "round", lineJoin: "round" });
    to.stroke(new Path2D(works));
    to.globalAlpha = RESTS;
    to.stroke(new Path2D(rests));
    to.globalAlpha = 1;
  }
  // endif
}
