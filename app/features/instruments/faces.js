// @ts-check
/**
 * What instruments look like: SVG above the canvas. Each face has grips, which move a point, and a body, which moves
 * all of it.
 *
 * @typedef {import("./shapes.js").Place} Place
 * @typedef {import("./shapes.js").Kept} Kept
 * @typedef {import("./shapes.js").Kind} Kind
 * @typedef {import("../../stage/sight.js").Sight} Sight
 * @typedef {object} Face
 * @property {SVGGElement} group
 * @property {SVGElement} body
 * @property {SVGGElement[]} grips one for each point
 * @property {SVGGElement[]} buttons what is pressed, not moved
 * @property {(kept: Kept, seen: Sight, places: Place[], size: number) => string} draw at the places of its points,
 *   with text of so many pixels; returns what it reads
 */
import { pageState } from "../../wire/channel.js";
import { protractorReading, rulerReading, strokes, watchReading } from "./shapes.js";
import { SVG } from "../../stage/svg.js";
import { timeNow } from "../../ui/clock.js";

/** Pixels: between a point and its grip, of a grip, and around it where it can be taken. */
const [AWAY, GRIP, REACH] = [24, 8, 20];
/** Pixels: of the strip of a ruler, and of the arc of a protractor at most. */
const [STRIP, ARC] = [26, 64];
/** Degrees below which a number does not fit between the sides of a protractor. */
const NARROW = 50;

/** @type {Record<Kind, string>} */
export const NAMES = { ruler: "Ruler", protractor: "Protractor", stopwatch: "Stopwatch" };
/** Of the points, for screen readers. @type {Record<Kind, string[]>} */
const ENDS = { ruler: ["first end", "second end"], protractor: ["first side", "corner", "second side"], stopwatch: [""] };

/** @param {Element} element @param {Record<string, string | number>} attributes */
export function set(element, attributes) {
  for (const [name, value] of Object.entries(attributes)) {
    const text = typeof value === "number" ? value.toFixed(1) : value;
    if (element.getAttribute(name) !== text) element.setAttribute(name, text);
  }
}

/** A number with a true minus sign. @param {number} value */
export const digits = (value) => value.toFixed(Math.abs(value) < 9.995 ? 2 : 1).replace("-", "−");

/** @template {keyof SVGElementTagNameMap} K @param {Element} parent @param {K} tag @param {string} [names] @returns {SVGElementTagNameMap[K]} */
function add(parent, tag, names) {
  const element = document.createElementNS(SVG, tag);
  if (names) element.setAttribute("class", names);
  parent.append(element);
  return element;
}

/** @param {Element} parent @param {string} names */
function handle(parent, names) {
  const element = add(parent, "g", names);
  element.setAttribute("role", "button");
  element.setAttribute("tabindex", "0");
  return element;
}

/** A grip: where it can be taken, and what is seen of it. @param {Element} parent */
function grip(parent) {
  const element = handle(parent, "softrod-grip");
  set(add(element, "circle", "softrod-grip-reach"), { r: REACH });
  set(add(element, "circle", "softrod-grip-disc"), { r: GRIP });
  return element;
}

/** @param {Place} from @param {Place} to @returns {Place} of length 1 */
function towards(from, to) {
  const [x, y] = [to.x - from.x, to.y - from.y];
  const length = Math.hypot(x, y);
  return length > 1e-6 ? { x: x / length, y: y / length } : { x: 1, y: 0 };
}

/** @param {Place} place @param {Place} way @param {number} far */
const beyond = ({ x, y }, way, far) => ({ x: x + far * way.x, y: y + far * way.y });
/** @param {Place} place */
const text = ({ x, y }) => `${x.toFixed(1)} ${y.toFixed(1)}`;
/** @param {SVGGElement} element @param {Place} to */
const put = (element, to) => set(element, { transform: `translate(${text(to)})` });

/** Lines of text on one side of a place. @param {SVGTextElement[]} lines @param {string[]} words @param {Place} at @param {Place} side @param {number} size */
function write(lines, words, at, side, size) {
  const anchor = Math.abs(side.x) < 0.5 ? "middle" : side.x > 0 ? "start" : "end";
  const down = (side.y * (lines.length - 1) * 1.3 * size) / 2;
  lines.forEach((line, i) => {
    line.style.textAnchor = anchor;
    set(line, { x: at.x, y: at.y + down + (i - (lines.length - 1) / 2) * 1.3 * size });
    if (line.textContent !== words[i]) line.textContent = words[i];
  });
}

/** @param {Kept} kept @param {number} i */
function named(kept, i) {
  const { mass } = kept.points[i];
  const where = mass < 0 ? "Arrows move it, Enter fixes it to a mass" : `At mass ${mass}. Arrows choose another, Enter frees it`;
  return `${NAMES[kept.kind]}, ${ENDS[kept.kind][i]}. ${where}`;
}

/** @param {SVGGElement} group @returns {Face} */
function ruler(group) {
  const body = add(group, "path", "softrod-instrument-body");
  const marks = add(group, "path", "softrod-instrument-marks");
  const words = [add(group, "text"), add(group, "text")];
  const grips = [grip(group), grip(group)];
  return {
    group, body, grips, buttons: [],
    draw(kept, { plan, on }, [a, b], size) {
      const scale = plan.scale * on.step;
      const way = towards(a, b);
      const turned = { x: -way.y, y: way.x };
      const normal = turned.y > 0 || (turned.y === 0 && turned.x > 0) ? turned : { x: way.y, y: -way.x };
      const [c, d] = [beyond(b, normal, STRIP), beyond(a, normal, STRIP)];
      set(body, { d: `M${text(a)}L${text(b)}L${text(c)}L${text(d)}Z` });
      const ticks = strokes(a, b, normal, scale);
      set(marks, { d: `M${text(beyond(a, way, -AWAY))}L${text(beyond(b, way, AWAY))}${ticks}` });
      put(grips[0], beyond(a, way, -AWAY));
      put(grips[1], beyond(b, way, AWAY));
      const { length, dx, dy } = rulerReading(a, b, scale, plan.flip);
      const unit = pageState().unit ?? "";
      const lines = [`${digits(length)} ${unit}`, `Δx ${digits(dx)}  Δy ${digits(dy)}`];
      write(words, lines, beyond({ x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 }, normal, STRIP + size), normal, size);
      grips.forEach((each, i) => set(each, { "aria-label": named(kept, i) }));
      return `${lines[0]}, ${lines[1].replace("  ", ", ")}`;
    },
  };
}

/** @param {SVGGElement} group @returns {Face} */
function protractor(group) {
  const body = add(group, "path", "softrod-instrument-body");
  const marks = add(group, "path", "softrod-instrument-marks");
  const words = [add(group, "text"), add(group, "text", "softrod-instrument-small")];
  const grips = [grip(group), grip(group), grip(group)];
  return {
    group, body, grips, buttons: [],
    draw(kept, _, [a, vertex, b], size) {
      const [one, two] = [towards(vertex, a), towards(vertex, b)];
      const { angle, bend } = protractorReading(a, vertex, b);
      const sense = one.x * two.y - one.y * two.x >= 0 ? 1 : -1;
      const from = Math.atan2(one.y, one.x);
      const turn = (sense * angle * Math.PI) / 180;
      /** @param {number} t @returns {Place} */
      const way = (t) => ({ x: Math.cos(from + t), y: Math.sin(from + t) });
      const middle = way(turn / 2);
      const far = [a, b].map(({ x, y }) => Math.hypot(x - vertex.x, y - vertex.y));
      const radius = Math.min(ARC, Math.max(0.8 * Math.min(...far), 24));
      const [start, end] = [beyond(vertex, one, radius), beyond(vertex, two, radius)];
      const arc = `A${radius.toFixed(1)} ${radius.toFixed(1)} 0 0 ${sense > 0 ? 1 : 0} ${text(end)}`;
      set(body, { d: `M${text(vertex)}L${text(start)}${arc}Z` });
      let ticks = `M${text(beyond(a, one, AWAY))}L${text(vertex)}L${text(beyond(b, two, AWAY))}M${text(start)}${arc}`;
      for (let degrees = 10; degrees < angle; degrees += 10) {
        const at = way((sense * degrees * Math.PI) / 180);
        ticks += `M${text(beyond(vertex, at, radius))}L${text(beyond(vertex, at, radius - (degrees % 30 ? 5 : 9)))}`;
      }
      set(marks, { d: ticks });
      put(grips[0], beyond(a, one, AWAY));
      put(grips[1], beyond(vertex, middle, -AWAY));
      put(grips[2], beyond(b, two, AWAY));
      const lines = [`${angle.toFixed(1)}°`, `bend ${bend.toFixed(1)}°`];
      // Between the sides, or behind the corner where there is no room.
      const [side, away] = angle < NARROW ? [-1, AWAY + 2 * GRIP] : [1, radius + size];
      const outwards = { x: side * middle.x, y: side * middle.y };
      write(words, lines, beyond(vertex, outwards, away), outwards, size);
      grips.forEach((each, i) => set(each, { "aria-label": named(kept, i) }));
      return `${lines[0]}, ${lines[1]}`;
    },
  };
}

/** @param {SVGGElement} group @returns {Face} */
function stopwatch(group) {
  const card = handle(group, "softrod-grip softrod-watch");
  const body = add(card, "rect", "softrod-instrument-body");
  const time = add(card, "text", "softrod-watch-time");
  const laps = add(card, "text", "softrod-instrument-small");
  const buttons = [handle(group, "softrod-grip softrod-watch-button"), handle(group, "softrod-grip softrod-watch-button")];
  const rims = buttons.map((button) => add(button, "rect"));
  const words = buttons.map((button) => add(button, "text"));
  return {
    group, body, grips: [card], buttons,
    draw({ watch }, _, [{ x, y }], size) {
      if (!watch) return "";
      const [width, height] = [11 * size, 6.6 * size];
      put(group, { x: x - width / 2, y: y - height / 2 });
      set(body, { width, height, rx: 0.7 * size });
      const seconds = `${watchReading(watch, timeNow()).toFixed(2)} s`;
      set(time, { x: width / 2, y: 1.6 * size });
      if (time.textContent !== seconds) time.textContent = seconds;
      set(laps, { x: width / 2, y: 3.2 * size });
      const lap = watch.laps.slice(-3).map((each) => each.toFixed(2)).join("  ");
      if (laps.textContent !== lap) laps.textContent = lap;
      const runs = watch.since !== null;
      [runs ? "Stop" : "Start", runs ? "Lap" : "Zero"].forEach((word, i) => {
        const [left, wide] = [0.6 * size + i * 5 * size, 4.8 * size];
        set(rims[i], { x: left, y: 4.1 * size, width: wide, height: 2 * size, rx: 0.5 * size });
        set(words[i], { x: left + wide / 2, y: 5.1 * size });
        if (words[i].textContent !== word) words[i].textContent = word;
        set(buttons[i], { "aria-label": `${word} (${"TL"[i]})` });
      });
      set(card, { "aria-label": `Stopwatch, ${seconds}. Arrows move it` });
      return seconds;
    },
  };
}

const FACES = { ruler, protractor, stopwatch };

/** The face of an instrument, not yet drawn. @param {Element} parent @param {Kind} kind */
export function newFace(parent, kind) {
  const group = add(parent, "g", "softrod-instrument");
  group.setAttribute("role", "group");
  return FACES[kind](group);
}
