// @ts-check
/**
 * The camera follows the body, or in a race both: it moves by as much as their middle does, so that the user can pan and
 * zoom meanwhile. The tab remembers the switch.
 */
import { onFit, shift } from "./camera.js";
import { onPicture, shown } from "./canvas.js";
import { toWorld } from "./draw.js";
import { kept, store } from "../ui/kept/storage.js";
import { worldAt } from "./screen.js";
import { screen } from "../ui/viser/screen.js";
import { canvasBox } from "../ui/viser/viser.js";

const NAME = "softrod-chase";
/** Time constant of its movement, s, so that a trot does not shake it. */
const EASE = 0.2;
/** Seconds without a picture after which the body counts as at rest. */
const STOOD = 0.1;

/** Largest distance of the body from the middle, in the size of the canvas, to show the other one too. */
const MAX_OFFSET = 0.3;

let on = false;
/** The place that it follows, in the page's world; null until the next picture. @type {{x: number, y: number} | null} */
let followed = null;
let last = 0;

/** True if the camera follows the body. */
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

/** The place that is followed, in the page's world: in a race one between both, but never far from the body. */
function middle() {
  const { frame, pictured: plan } = shown();
  const [seen, box] = [screen(), canvasBox()];
  if (!frame || !plan || !seen || !box) return null;
  const own = middleOf(plan, frame.positions);
  const { x, y } = frame.second ? middleOf(plan, frame.second.positions) : own;
  /** @param {number} way @param {number} size */
  const part = (way, size) => Math.max(-MAX_OFFSET * size, Math.min(MAX_OFFSET * size, (way * seen.step) / 2)) / seen.step;
  return { x: own.x + part(x - own.x, box.width), y: own.y + part(y - own.y, box.height) };
}

/** Begins to follow; a body that is out of view is moved to the middle. */
function anchor() {
  followed = null;
  const { frame, pictured: plan } = shown();
  const [seen, box] = [screen(), canvasBox()];
  if (!on || !seen || !frame || !plan || !box) return;
  const at = middleOf(plan, frame.positions);
  const [x, y] = [seen.x + at.x * seen.step, seen.y - at.y * seen.step];
  if (x > box.left && x < box.right && y > box.top && y < box.bottom) return;
  followed = worldAt({ x: box.left + box.width / 2, y: box.top + box.height / 2 }, seen);
}

/** Switches following on or off. */
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
  followed ??= at;
  const part = 1 - Math.exp(-passed / EASE);
  const [dx, dy] = [(at.x - followed.x) * part, (at.y - followed.y) * part];
  if (dx || dy) shift(dx, dy);
  followed = { x: followed.x + dx, y: followed.y + dy };
}

/** Begins to follow the body if the tab remembers that. */
export function addChase() {
  on = kept(NAME) === "1";
  onPicture(chase);
  onFit(anchor);
}
