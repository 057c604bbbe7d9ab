// @ts-check
/** Draws the arrows of forces, velocities and torques over the body, with what their lengths stand for. */
import { arrow } from "../../stage/arrow_shapes.js";
import * as arrows from "./arrows.js";
import { onMessage, pageState } from "../../wire/channel.js";
import { insertMarksLayer, onMarksRedraw, redrawMarks } from "../../stage/sight.js";
import { SVG } from "../../stage/svg.js";

/** Pixels of the longest arrow: a part of the canvas, within bounds. */
const [PART, LEAST, MOST] = [0.17, 52, 110];
/** Pixels between the end of the sample and the edge, and between two lines of text, in heights of the text. */
const [EDGE, LINE] = [18, 1.9];
/** Milliseconds after which a picture that stays is drawn once more, for a finer scale. */
const AGAIN = 400;

/**
 * @typedef {"forces" | "velocities" | "torques"} Kind
 * @typedef {import("../../stage/sight.js").Sight} Sight
 */
/** @type {Kind[]} */
const KINDS = ["forces", "velocities", "torques"];
/** @type {Record<Kind, string>} */
const NAMES = { forces: "force", velocities: "speed", torques: "torque" };

/** With metres, forces and torques have units with names. @param {Kind} kind @param {string} unit of length */
export function unitOf(kind, unit) {
  if (unit === "m") return { forces: "N", velocities: "m/s", torques: "N m" }[kind];
  return { forces: `kg ${unit}/s²`, velocities: `${unit}/s`, torques: `kg ${unit}²/s²` }[kind];
}

/** A round number as text. @param {number} value */
export const roundText = (value) =>
  value >= 1e5 || value < 1e-3 ? value.toExponential(0).replace("e+", "e") : String(Number(value.toPrecision(2)));

/** @param {Element} element @param {Record<string, string | number>} attributes */
function set(element, attributes) {
  for (const [name, value] of Object.entries(attributes)) {
    if (element.getAttribute(name) !== String(value)) element.setAttribute(name, String(value));
  }
}

/** Puts up the marks, which are empty while no switch is on. */
export function addArrows() {
  const svg = document.createElementNS(SVG, "svg");
  svg.classList.add("softrod-marks", "softrod-arrows");
  svg.setAttribute("aria-hidden", "true");
  /** @template {keyof SVGElementTagNameMap} K @param {K} tag @param {string[]} names @returns {SVGElementTagNameMap[K]} */
  const add = (tag, ...names) => {
    const element = document.createElementNS(SVG, tag);
    element.classList.add(...names);
    svg.append(element);
    return element;
  };
  const series = new arrows.Series();
  const marks = KINDS.map((kind) => ({
    kind,
    // A rim in the colour of the paper keeps an arrow legible over the body.
    rim: add("path", "softrod-arrow-rim"),
    held: add("path", "softrod-arrow", `softrod-${kind}`, "softrod-held"),
    body: add("path", "softrod-arrow", `softrod-${kind}`),
    sample: add("path", "softrod-arrow", `softrod-${kind}`),
    words: add("text", "softrod-arrow-words", `softrod-${kind}`),
    scale: new arrows.Scale(),
  }));
  let again = 0;

  /** @param {Sight} seen */
  const draw = ({ plan, frame, on, places, box }) => {
    const numbers = series.at(frame.time);
    const some = numbers !== null && numbers.generation === plan.generation;
    if (some === (svg.parentNode === null)) some ? insertMarksLayer(svg) : svg.remove();
    if (!some) return;
    const full = Math.min(Math.max(PART * Math.min(box.width, box.height), LEAST), MOST);
    const masses = arrows.massesOf(numbers, plan.radius.length);
    const held = new Set(numbers.held);
    const height = parseFloat(getComputedStyle(svg).fontSize);
    const bar = document.querySelector(".softrod-scale")?.getBoundingClientRect();
    let y = (bar?.bottom ?? box.top) + 0.6 * LINE * height;
    let settling = false;
    marks.forEach(({ kind, rim, held: dashed, body, sample, words, scale }, i) => {
      const values = numbers[kind];
      const has = values.length > 0;
      for (const element of [rim, dashed, body, sample, words]) element.style.display = has ? "" : "none";
      if (!has) {
        scale.full = 0;
        return;
      }
      const width = kind === "torques" ? 1 : 2;
      const unit = scale.update(arrows.largest(values, width), numbers.least[i], performance.now() / 1e3);
      settling ||= scale.settling;
      const end = box.right - EDGE;
      if (kind === "torques") {
        set(body, { d: arrows.torqueArrows(plan, numbers, places, unit, on.step, box) });
        set(dashed, { d: "" });
        const radius = 0.62 * height;
        set(sample, { d: arrows.turnArrow(end - radius, y, radius, -Math.PI / 2, 1.5 * Math.PI) });
        set(words, { x: end - 2 * radius - 8, y });
      } else {
        const how = { open: kind === "velocities" };
        /** @param {boolean} those that are held */
        const all = (those) =>
          arrows.vectorArrows(masses, values, places, full / unit, plan.flip, box, {
            ...how,
            only: (mass) => (kind === "forces" && held.has(mass)) === those,
          });
        set(body, { d: all(false) });
        set(dashed, { d: kind === "forces" ? all(true) : "" });
        set(sample, { d: arrow(end - full, y, full, 0, how.open) });
        set(words, { x: end - full - 8, y });
      }
      set(rim, { d: (body.getAttribute("d") ?? "") + (dashed.getAttribute("d") ?? "") });
      const text = `${NAMES[kind]} ${roundText(unit)} ${unitOf(kind, pageState().unit ?? "")}`;
      if (words.textContent !== text) words.textContent = text;
      y += LINE * height;
    });
    clearTimeout(again);
    if (settling) again = setTimeout(redrawMarks, AGAIN);
  };

  onMessage("arrows", ({ numbers }) => {
    if (numbers.length) series.take(arrows.readArrows(numbers));
    else series.kept = [];
    redrawMarks();
  });
  onMarksRedraw(draw);
}
