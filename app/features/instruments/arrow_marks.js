// @ts-check
/** Draws the arrows of forces, velocities and torques over the body, with a sample arrow that shows their scale. */
import { arrow } from "../../stage/arrow_shapes.js";
import * as arrows from "./arrows.js";
import { onMessage, pageState } from "../../wire/channel.js";
import { unpack } from "../../wire/unpack.js";
import { insertMarksLayer, onMarksRedraw, redrawMarks } from "../../stage/sight.js";
import { sidesOf, startsRight } from "../../stage/sides.js";
import { makeSvg, set } from "../../stage/svg.js";
import { decimal, say } from "../../words/words.js";

/** Length of the longest arrow, as a fraction of the canvas's shorter side. */
const LENGTH = 0.17;
/** Bounds of that length, pixels. */
const MIN_LENGTH = 52;
const MAX_LENGTH = 110;
/** Pixels between the end of a sample arrow and the edge of the canvas. */
const MARGIN = 18;
/** Pixels between it and its words. */
const GAP = 8;
/** Distance between two samples, in heights of the text. */
const LINE = 1.9;
/** Milliseconds after which a still picture is redrawn, so that its scale can become finer. */
const REDRAW_AFTER = 400;

/**
 * @typedef {"forces" | "velocities" | "torques"} Kind
 * @typedef {import("../../stage/sight.js").Sight} Sight
 */
/** @satisfies {Record<Kind, keyof import("../../words/keys.js").Words>} */
const NAMES = /** @type {const} */ ({ forces: "instruments-force", velocities: "instruments-speed", torques: "instruments-torque" });
const KINDS = /** @type {Kind[]} */ (Object.keys(NAMES));

/** The unit of a kind of arrow; with metres, forces and torques have named units. @param {Kind} kind @param {string} unit of length */
export function unitOf(kind, unit) {
  if (unit === "m") return { forces: "N", velocities: "m/s", torques: "N m" }[kind];
  return { forces: `kg ${unit}/s²`, velocities: `${unit}/s`, torques: `kg ${unit}²/s²` }[kind];
}

/** A round number as text. @param {number} value */
export const roundText = (value) =>
  decimal(value >= 1e5 || value < 1e-3 ? value.toExponential(0).replace("e+", "e") : String(Number(value.toPrecision(2))));

/** Where a sample of some length begins, at the end of lines. @param {DOMRect} box of the canvas @param {number} length */
const beginOf = (box, length) => (startsRight ? sidesOf(box).end + MARGIN : box.right - MARGIN - length);

/** The arrows of one kind, with their sample. */
class ArrowMarks {
  /** @param {Kind} kind @param {SVGSVGElement} svg */
  constructor(kind, svg) {
    this.kind = kind;
    this.scale = new arrows.Scale();
    // A rim in the background's colour keeps an arrow legible over the body.
    this.rim = makeSvg("path", "softrod-arrow-rim", svg);
    this.held = makeSvg("path", `softrod-arrow softrod-${kind} softrod-held`, svg);
    this.body = makeSvg("path", `softrod-arrow softrod-${kind}`, svg);
    this.sample = makeSvg("path", `softrod-arrow softrod-${kind}`, svg);
    this.words = makeSvg("text", `softrod-arrow-words softrod-${kind}`, svg);
  }

  /**
   * @param {Sight} seen @param {arrows.Numbers} numbers @param {number} y of the sample @param {number} height of text, pixels
   * @returns {boolean} whether there are such arrows
   */
  draw(seen, numbers, y, height) {
    const { kind, scale } = this;
    const values = numbers[kind];
    const has = values.length > 0;
    for (const element of [this.rim, this.held, this.body, this.sample, this.words]) element.style.display = has ? "" : "none";
    if (!has) {
      scale.full = 0;
      return false;
    }
    const unit = scale.update(arrows.largest(values, kind === "torques" ? 1 : 2), numbers.least[KINDS.indexOf(kind)], performance.now() / 1e3);
    const length = kind === "torques" ? this.drawTorques(seen, numbers, unit, y, 0.62 * height) : this.drawVectors(kind, seen, numbers, unit, y);
    const begin = beginOf(seen.box, length);
    set(this.words, { x: startsRight ? begin + length + GAP : begin - GAP, y });
    set(this.rim, { d: (this.body.getAttribute("d") ?? "") + (this.held.getAttribute("d") ?? "") });
    const text = say(NAMES[kind], { value: `${roundText(unit)} ${unitOf(kind, pageState().unit ?? "")}` });
    if (this.words.textContent !== text) this.words.textContent = text;
    return true;
  }

  /** @param {Sight} seen @param {arrows.Numbers} numbers @param {number} unit @param {number} y @param {number} radius of the sample */
  drawTorques({ plan, on, places, box }, numbers, unit, y, radius) {
    set(this.body, { d: arrows.torqueArrows(plan, numbers, places, unit, on.step, box) });
    set(this.sample, { d: arrows.turnArrow(beginOf(box, 2 * radius) + radius, y, radius, -Math.PI / 2, 1.5 * Math.PI) });
    return 2 * radius;
  }

  /** @param {"forces" | "velocities"} kind @param {Sight} seen @param {arrows.Numbers} numbers @param {number} unit @param {number} y */
  drawVectors(kind, { plan, places, box }, numbers, unit, y) {
    const masses = arrows.massesOf(numbers, plan.radius.length);
    const held = new Set(kind === "forces" ? numbers.held : []);
    const full = Math.min(Math.max(LENGTH * Math.min(box.width, box.height), MIN_LENGTH), MAX_LENGTH);
    const open = kind === "velocities";
    /** @param {boolean} isHeld */
    const path = (isHeld) =>
      arrows.vectorArrows(masses, numbers[kind], places, full / unit, plan.flip, box, { open, only: (mass) => held.has(mass) === isHeld });
    set(this.body, { d: path(false) });
    set(this.held, { d: path(true) });
    set(this.sample, { d: arrow(beginOf(box, full), y, full, 0, open) });
    return full;
  }
}

/** Adds the arrows, which are empty while no switch is on. */
export function addArrows() {
  const svg = makeSvg("svg", "softrod-marks softrod-arrows");
  const series = new arrows.Series();
  const marks = KINDS.map((kind) => new ArrowMarks(kind, svg));
  let redraw = 0;
  onMarksRedraw((seen) => {
    const numbers = series.at(seen.frame.time);
    const isShown = numbers !== null && numbers.generation === seen.plan.generation;
    if (isShown === (svg.parentNode === null)) isShown ? insertMarksLayer(svg) : svg.remove();
    if (!isShown) return;
    const height = parseFloat(getComputedStyle(svg).fontSize);
    const bar = document.querySelector(".softrod-scale")?.getBoundingClientRect();
    let y = (bar?.bottom ?? seen.box.top) + 0.6 * LINE * height;
    for (const mark of marks) if (mark.draw(seen, numbers, y, height)) y += LINE * height;
    clearTimeout(redraw);
    if (marks.some(({ scale }) => scale.full > 0 && scale.settling)) redraw = setTimeout(redrawMarks, REDRAW_AFTER);
  });
  onMessage("arrows", ({ numbers }) => {
    if (numbers.length) series.take(unpack("arrows", numbers));
    else series.clear();
    redrawMarks();
  });
}
