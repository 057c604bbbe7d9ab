// @ts-check
/** The shape of a mode over the body: it swings, its nodes stand still, and its antinodes show how far they go. */
import { posed } from "./shapes.js";
import { insertMarksLayer, sight } from "../../stage/sight.js";
import { makeSvg, set } from "../../stage/svg.js";
import { onScreen } from "../../stage/screen.js";

/** @typedef {import("./shapes.js").Shapes} Shapes */

/** Seconds of a swing of the ghost, whatever its mode's. */
const PERIOD = 1.6;
/** How far it swings, in sizes of the body. */
const AWAY = 0.12;
/** Nodes that are drawn of a mode at most: of a cloth they make lines. */
const MOST = 240;

const isStill = () => matchMedia("(prefers-reduced-motion: reduce)").matches;

/** Puts up the ghost, which is hidden while no mode is shown. */
export function addGhost() {
  const svg = makeSvg("svg", "softrod-marks softrod-mode-ghost");
  const [far, body] = [makeSvg("path", "softrod-mode-far", svg), makeSvg("path", "softrod-mode-shape", svg)];
  const [reach, nodes] = [makeSvg("path", "softrod-mode-reach", svg), makeSvg("path", "softrod-mode-nodes", svg)];
  let mode = -1;
  let amplitude = 0;
  let asked = false;
  /** @type {() => {shapes: Shapes | null, frames?: Float32Array}} */
  let look = () => ({ shapes: null });

  const ask = () => {
    if (!asked && mode >= 0) requestAnimationFrame(draw);
    asked = asked || mode >= 0;
  };
  const draw = () => {
    asked = false;
    const { shapes, frames } = look();
    const seen = sight();
    const shown = mode >= 0 && shapes !== null && mode < shapes.modes.length && seen !== null && 2 * seen.plan.radius.length === shapes.rest.length;
    if (shown === (svg.parentNode === null)) shown ? insertMarksLayer(svg) : svg.remove();
    if (!shown) {
      ask();
      return;
    }
    const { plan, on } = seen;
    const most = amplitude || AWAY * shapes.size;
    /** @param {number} part of the amplitude */
    const at = (part) => onScreen(plan, posed(shapes, mode, part * most, frames), on);
    /** @param {Float64Array} places @param {number} m */
    const point = (places, m) => `${places[2 * m].toFixed(1)} ${places[2 * m + 1].toFixed(1)}`;
    /** @param {Float64Array} places */
    const outline = (places) => {
      let path = "";
      for (let s = 0; s < plan.springs.length; s += 2) {
        path += `M${point(places, plan.springs[s])}L${point(places, plan.springs[s + 1])}`;
      }
      return path;
    };
    const [one, other] = [at(1), at(-1)];
    const still = isStill();
    const swing = Math.sin((2 * Math.PI * performance.now()) / 1e3 / PERIOD);
    set(body, { d: outline(still ? one : at(swing)) });
    set(far, { d: still ? outline(other) : "" });
    const middle = at(0);
    const { nodes: where, antinodes } = shapes.modes[mode];
    let ways = "";
    for (const mass of antinodes) ways += `M${point(one, mass)}L${point(other, mass)}`;
    set(reach, { d: ways });
    let rings = "";
    const step = Math.ceil(where.length / 2 / MOST) || 1;
    for (let i = 0; i < where.length; i += 2 * step) {
      const [a, b] = plan.springs.subarray(2 * where[i], 2 * where[i] + 2);
      const part = where[i + 1];
      const x = middle[2 * a] + part * (middle[2 * b] - middle[2 * a]);
      const y = middle[2 * a + 1] + part * (middle[2 * b + 1] - middle[2 * a + 1]);
      rings += `M${(x - 4.5).toFixed(1)} ${y.toFixed(1)}a4.5 4.5 0 1 0 9 0a4.5 4.5 0 1 0 -9 0`;
    }
    set(nodes, { d: rings });
    ask();
  };
  return {
    /**
     * Shows a mode, or none (-1).
     *
     * @param {number} which
     * @param {number} [px] amplitude; 0 for one that can be seen well
     */
    show(which, px = 0) {
      [mode, amplitude] = [which, px];
      if (which < 0) svg.remove();
      ask();
    },
    /** Where shapes and frames come from. @param {typeof look} from */
    from: (from) => (look = from),
  };
}
