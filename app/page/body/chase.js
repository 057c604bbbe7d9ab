// @ts-check
/**
 * The switch by which the camera goes with the body, or in a race with both: it moves as much as their middle does, so
 * that one can pan and zoom meanwhile. The tab remembers.
 */
import { onFit, shift } from "./camera.js";
import { onPicture, shown } from "./canvas.js";
import { toWorld } from "../../drawing/static/draw.js";
import { kept, store } from "../files/storage.js";
import { screen, worldAt } from "./screen.js";
import { viser } from "../viser/viser.js";

const NAME = "softrod-chase";
/** Seconds in which it makes up for most of a step, so that a trot does not shake it. */
const EASE = 0.2;
/** Seconds between two pictures beyond which the body stood. */
const STOOD = 0.1;

let on = false;
/** Where it has gone with, in the page's world; null until the next picture says. @type {{x: number, y: number} | null} */
let gone = null;
let last = 0;

/** Whether the camera goes with the body. */
export const isChasing = () => on;

/** The middle of what is to be kept in view, in the page's world. */
function middle() {
  const { frame, pictured: plan } = shown();
  if (!frame || !plan) return null;
  let [x, y] = [0, 0];
  const bodies = frame.rival ? [frame, frame.rival] : [frame];
  for (const { positions } of bodies) {
    const world = toWorld(plan, positions);
    for (let i = 0; i < world.length; i += 2) {
      x += world[i] / (world.length / 2) / bodies.length;
      y += world[i + 1] / (world.length / 2) / bodies.length;
    }
  }
  return { x, y };
}

/** Turns it on or off; a body that has left the view comes back into its middle. */
export function toggleChase() {
  on = !on;
  store(NAME, on ? "1" : "");
  gone = null;
  const [seen, at, box] = [screen(), middle(), viser()?.canvas?.getBoundingClientRect()];
  if (!on || !seen || !at || !box) return;
  const [x, y] = [seen.x + at.x * seen.step, seen.y - at.y * seen.step];
  if (x > box.left && x < box.right && y > box.top && y < box.bottom) return;
  gone = worldAt({ x: box.left + box.width / 2, y: box.top + box.height / 2 }, seen);
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
  onFit(() => (gone = null));
}
