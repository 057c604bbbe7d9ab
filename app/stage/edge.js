// @ts-check
/** A button at the edge of the view, an arrow towards a body that has left it; it shows the whole scene. */
import { fit } from "./camera.js";
import { iconHtml, makeButton, overCanvas } from "../ui/dialog.js";
import { withKey } from "../ui/hands/key_table.js";
import { startsRight } from "./sides.js";
import { say } from "../words/words.js";

/** Pixels between the arrow's middle and the edge. */
const INSET = 34;

/** @typedef {import("./environment.js").Box} Box */

/**
 * Place and direction of the arrow, clockwise from the right in degrees; null while a mass is in view.
 *
 * @param {ArrayLike<number>} places of the masses, px of the window, x and y of each
 * @param {Box} view
 */
export function edgeArrow(places, view) {
  let least = Infinity;
  let nearest = { x: 0, y: 0, turn: 0 };
  for (let i = 0; i < places.length; i += 2) {
    const [x, y] = [places[i], places[i + 1]];
    const at = { x: between(x, view.left, view.right), y: between(y, view.top, view.bottom) };
    const distance = Math.hypot(x - at.x, y - at.y);
    if (distance === 0) return null;
    if (distance < least) {
      least = distance;
      nearest = { ...at, turn: (Math.atan2(y - at.y, x - at.x) * 180) / Math.PI };
    }
  }
  if (least === Infinity) return null;
  return {
    x: between(nearest.x, view.left + INSET, view.right - INSET),
    y: between(nearest.y, view.top + INSET, view.bottom - INSET),
    turn: nearest.turn,
  };
}

/** @param {number} value @param {number} low @param {number} high */
const between = (value, low, high) => Math.max(low, Math.min(high, value));

/** What else is over the canvas, and the side of it where there is room. */
const OBSTACLES = /** @type {const} */ ([
  [".softrod-edit.softrod-edit-row:not(.softrod-edit-closed)", "below"],
  [".softrod-hud", "below"],
  [".softrod-box[data-open]", "beside"],
  [".softrod-edit:not(.softrod-edit-row)", "beside"],
  [".softrod-box-lid", "above"],
  [".softrod-edit-closed", "above"],
  [".softrod-menu-lid", "above"],
  [".softrod-edit-bar", "above"],
]);

/** Moves a place to where nothing covers the arrow. @param {{x: number, y: number}} place */
function uncovered({ x, y }) {
  for (const [name, side] of OBSTACLES) {
    const { left, right, top, bottom } = document.querySelector(name)?.getBoundingClientRect() ?? new DOMRect();
    if (left === right) continue; // not in the page
    if (x + INSET < left || x - INSET > right || y + INSET < top || y - INSET > bottom) continue;
    if (side === "above") y = top - INSET;
    else if (side === "below") y = bottom + INSET;
    else x = startsRight ? left - INSET : right + INSET;
  }
  return { x, y };
}

/** Adds the arrow to the page, hidden; what is returned draws it. */
export function addEdgeArrow() {
  const button = makeButton("", () => {
    fit(true);
    button.blur();
  }, "softrod-edge");
  button.hidden = true;
  button.ariaLabel = say("stage-away");
  button.title = withKey(say("command-fit"), "fit");
  button.innerHTML = iconHtml("M5 10v4h8v5l7-7-7-7v5z");
  overCanvas().append(button);
  /** @param {import("./sight.js").Sight} seen */
  return ({ places, box: { left, right, top }, floor: bottom }) => {
    const arrow = edgeArrow(places, { left, right, top, bottom });
    button.hidden = arrow === null;
    if (!arrow) return;
    const { x, y } = uncovered(arrow);
    button.style.left = `${x}px`;
    button.style.top = `${y}px`;
    button.style.setProperty("--softrod-turn", `${arrow.turn}deg`);
  };
}
