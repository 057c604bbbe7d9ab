// @ts-check
/** The shape of a mode over the body: it swings, its nodes stand still, and lines show how far its antinodes go. */
import { posed } from "./shapes.js";
import { insertMarksLayer, sight } from "../../stage/sight.js";
import { makeSvg, set } from "../../stage/svg.js";
import { onScreen } from "../../stage/screen.js";
import { isStill } from "../../ui/access.js";

/** @typedef {import("./shapes.js").Shapes} Shapes */

/** Seconds of a swing, whatever the mode's own period. */
const PERIOD = 1.6;
/** How far it swings, in sizes of the body. */
const AMPLITUDE = 0.12;
/** Nodes that are drawn of a mode: those of a cloth make lines. */
const MAX_NODES = 240;
/** Radius of the ring around a node, px. */
const RING = 4.5;

/** The marks, which are hidden while no mode is shown. */
export class ShapeMarks {
  svg = makeSvg("svg", "softrod-marks softrod-mode-marks");
  far = makeSvg("path", "softrod-mode-far", this.svg);
  body = makeSvg("path", "softrod-mode-shape", this.svg);
  reach = makeSvg("path", "softrod-mode-reach", this.svg);
  nodes = makeSvg("path", "softrod-mode-nodes", this.svg);
  mode = -1;
  amplitude = 0;
  isAsked = false;

  /** @param {() => {shapes: Shapes | null, frames?: Float32Array}} source of what is drawn */
  constructor(source) {
    this.source = source;
  }

  /**
   * Shows a mode, or none (-1).
   *
   * @param {number} mode
   * @param {number} amplitude px; 0 for one that can be seen well
   */
  show(mode, amplitude) {
    this.mode = mode;
    this.amplitude = amplitude;
    if (mode < 0) this.svg.remove();
    this.ask();
  }

  ask() {
    if (this.isAsked || this.mode < 0) return;
    this.isAsked = true;
    requestAnimationFrame(() => this.draw());
  }

  draw() {
    this.isAsked = false;
    const { shapes, frames } = this.source();
    const seen = sight();
    if (shapes?.modes[this.mode] && seen && 2 * seen.plan.radius.length === shapes.rest.length) {
      if (!this.svg.parentNode) insertMarksLayer(this.svg);
      this.place(shapes, frames, seen);
    } else this.svg.remove();
    this.ask();
  }

  /** @param {Shapes} shapes @param {Float32Array | undefined} frames @param {import("../../stage/sight.js").Sight} seen */
  place(shapes, frames, { plan, on }) {
    const amplitude = this.amplitude || AMPLITUDE * shapes.size;
    /** @param {number} part of the amplitude */
    const at = (part) => onScreen(plan, posed(shapes, this.mode, part * amplitude, frames), on);
    /** @param {Float64Array} places @param {number} mass */
    const point = (places, mass) => `${places[2 * mass].toFixed(1)} ${places[2 * mass + 1].toFixed(1)}`;
    /** @param {Float64Array} places */
    const outline = (places) => {
      let path = "";
      for (let s = 0; s < plan.springs.length; s += 2) {
        path += `M${point(places, plan.springs[s])}L${point(places, plan.springs[s + 1])}`;
      }
      return path;
    };
    const one = at(1), middle = at(0), other = at(-1);
    const swing = Math.sin((2 * Math.PI * performance.now()) / 1e3 / PERIOD);
    set(this.body, { d: outline(isStill() ? one : at(swing)) });
    set(this.far, { d: isStill() ? outline(other) : "" });
    const { nodes, antinodes } = shapes.modes[this.mode];
    set(this.reach, { d: Array.from(antinodes, (mass) => `M${point(one, mass)}L${point(other, mass)}`).join("") });
    let rings = "";
    const step = Math.ceil(nodes.length / 2 / MAX_NODES) || 1;
    for (let i = 0; i < nodes.length; i += 2 * step) {
      const [a, b] = plan.springs.subarray(2 * nodes[i], 2 * nodes[i] + 2);
      const [x, y] = [0, 1].map((axis) => middle[2 * a + axis] + nodes[i + 1] * (middle[2 * b + axis] - middle[2 * a + axis]));
      rings += `M${(x - RING).toFixed(1)} ${y.toFixed(1)}a${RING} ${RING} 0 1 0 ${2 * RING} 0a${RING} ${RING} 0 1 0 ${-2 * RING} 0`;
    }
    set(this.nodes, { d: rings });
  }
}
