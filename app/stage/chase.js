// @ts-check
/**
 * The switch by which the camera goes with the body, or in a race with both: it moves as much as their middle does, so
 * that one can pan and zoom meanwhile. The tab remembers.
 */
import { onFit, shift } from "./camera.js";
import { onPicture, shown } from "./canvas.js";
import { toWorld } from "./draw.js";
import { kept, store } from "../ui/kept/storage.js";
import { screen, worldAt } from "./screen.js";
import { canvasBox } from "../ui/viser/viser.js";

const NAME = "softrod-chase";
/** Seconds in which it makes up for most of a step, so that a trot does not shake it. */
const EASE = 0.2;
/** Seconds between two pictures beyond which the body stood. */
const STOOD = 0.1;

/** Part of the canvas by which the body is out of its middle at most, for the sake of the other one. */
const BESIDE = 0.3;

let on = false;
/** Where it has gone with, in the page's world; null until the next picture says. @type {{x: number, y: number} | null} */
let gone = null;
let last = 0;

/** Whether the camera goes with the body. */
export const isChasing = () => on;

/** The middle of a body in the page's world. @param {import("./plan.js").Plan} plan @param {Float32Array} positions */
function middleOf(plan, positions) {
  const world = toWorld(plan, positions);
  let [x, y] = [0, 0];
  for (let i = 0; i < world.length; i += 2) {
    x += (2 * world[i]) / world.length;
    y += (2 * world[i + 1]) / world.length;
  }
  return { x, y };
}

/** What is to be kept in view, in the page's world: in a race a place between both, but never far from the body. */
function middle() {
  const { frame, pictured: plan } = shown();
  const [seen, box] = [screen(), canvasBox()];
  if (!frame || !plan || !seen || !box) return null;
  const own = middleOf(plan, frame.positions);
  const { x, y } = frame.second ? middleOf(plan, frame.second.positions) : own;
  /** @param {number} way @param {number} size */
  const part = (way, size) => Math.max(-BESIDE * size, Math.min(BESIDE * size, (way * seen.step) / 2)) / seen.step;
  return { x: own.x + part(x - own.x, box.width), y: own.y + part(y - own.y, box.height) };
}

/** Where it is to go on from: a body that is out of view comes into its middle. */
function anchor() {
  gone = null;
  const { frame, pictured: plan } = shown();
  const [seen, box] = [screen(), canvasBox()];
  if (!on || !seen || !frame || !plan || !box) return;
  const at = middleOf(plan, frame.positions);
  const [x, y] = [seen.x + at.x * seen.step, seen.y - at.y * seen.step];
  if (x > box.left && x < box.right && y > box.top && y < box.bottom) return;
  gone = worldAt({ x: box.left + box.width / 2, y: box.top + box.height / 2 }, seen);
}

/** Turns it on or off. */
export function toggleChase() {
  on = !on;
  store(NAME, on ? "1" : "");
  anchor();
  chase();
}

function chase() {
  if (!on) return;
  const [now, at] = [performance.now() / 1e3, middle()];
  const passed = Math.min(now - last, STOOD);
  last = now;
  if (!at) return;
  gone ??= at;
  const part = 1 - Math.exp(-passed / EASE);
  const [dx, dy] = [(at.x - gone.x) * part, (at.y - gone.y) * part];
  if (dx || dy) shift(dx, dy);
  gone = { x: gone.x + dx, y: gone.y + dy };
}

/** Begins to go with the body, if the tab remembers that. */
export function addChase() {
  on = kept(NAME) === "1";
  onPicture(chase);
  onFit(anchor);
}
