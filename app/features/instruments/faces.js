// @ts-check
/**
 * How instruments look: SVG over the canvas. A face has grips, which move one point each, and a body, which moves all
 * points. `draw` returns what the instrument reads.
 *
 * @typedef {Ruler | Protractor | Stopwatch | LightGate} Face
 * @typedef {import("./shapes.js").Place} Place
 * @typedef {import("./shapes.js").Placed} Placed
 * @typedef {import("./shapes.js").Kind} Kind
 * @typedef {import("../../stage/sight.js").Sight} Sight
 */
import { pageState } from "../../wire/channel.js";
import { digits, protractorReading, rulerReading, ticks, watchReading } from "./shapes.js";
import { makeSvg, set } from "../../stage/svg.js";
import { timeNow } from "../../ui/clock.js";
import { decimal, joined, say } from "../../words/words.js";

/** Pixels between a point and its grip. */
const AWAY = 24;
/** Radius of a grip, and of the disc around it where it can be grabbed, pixels. */
const GRIP = 8;
const REACH = 20;
/** Width of a ruler, pixels. */
const WIDTH = 26;
/** Half the width of a light gate's beam, pixels. */
const BEAM = 6;
/** Crossings that a light gate lists, and the width of the list in sizes of its letters. */
const CROSSINGS = 4;
const LIST = 15;
/** Largest radius of a protractor's arc, pixels. */
const MAX_ARC = 64;
/** Degrees below which the reading does not fit between the sides of a protractor. */
const NARROW = 50;

/** What they are called. @satisfies {Record<Kind, keyof import("../../words/keys.js").Words>} */
export const NAMES = /** @type {const} */ ({
  ruler: "instruments-ruler",
  protractor: "instruments-protractor",
  stopwatch: "instruments-stopwatch",
  gate: "instruments-gate",
});
/** The buttons of a stopwatch, while it stands and while it runs. */
const BUTTONS = /** @type {const} */ ({
  stands: ["instruments-start", "instruments-zero"],
  runs: ["instruments-stop", "instruments-lap"],
});

/** @param {Element} parent @param {string} names */
function makeHandle(parent, names) {
  const element = makeSvg("g", names, parent);
  set(element, { role: "button", tabindex: 0 });
  return element;
}

/** A grip: the disc that is seen, in a larger one that can be grabbed. @param {Element} parent */
function makeGrip(parent) {
  const element = makeHandle(parent, "softrod-grip");
  set(makeSvg("circle", "softrod-grip-reach", element), { r: REACH });
  set(makeSvg("circle", "softrod-grip-disc", element), { r: GRIP });
  return element;
}

/** The direction from one place to another, of length 1. @param {Place} from @param {Place} to @returns {Place} */
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
/** @param {SVGTextElement} element @param {string} words */
const write = (element, words) => {
  if (element.textContent !== words) element.textContent = words;
};

class BaseFace {
  /** @type {SVGGElement[]} one for each point */
  grips = [];
  /** @type {SVGGElement[]} what is pressed, not moved */
  buttons = [];

  /** @param {Element} parent */
  constructor(parent) {
    this.group = makeSvg("g", "softrod-instrument", parent);
    this.group.setAttribute("role", "group");
    /** @type {SVGElement} */
    this.body = this.group;
  }
}

/** What a ruler and a protractor have in common: ticks, two lines of text and grips beyond their points. */
class LineFace extends BaseFace {
  /** @param {Element} parent @param {string[]} points as a screen reader names them @param {string} second class of the second line */
  constructor(parent, points, second) {
    super(parent);
    this.points = points;
    this.body = makeSvg("path", "softrod-instrument-body", this.group);
    this.marks = makeSvg("path", "softrod-instrument-marks", this.group);
    this.words = [makeSvg("text", "", this.group), makeSvg("text", second, this.group)];
    this.grips = points.map(() => makeGrip(this.group));
  }

  /** Places the grips, which also say how they are moved. @param {Placed} placed @param {Place[]} at */
  putGrips({ kind, points }, at) {
    this.grips.forEach((grip, i) => {
      put(grip, at[i]);
      const { mass } = points[i];
      const named = { instrument: say(NAMES[kind]), point: this.points[i] };
      grip.ariaLabel = mass < 0 ? say("instruments-point", named) : say("instruments-point.fixed", { ...named, mass });
    });
  }

  /** Writes the lines on one side of a place. @param {string[]} lines @param {Place} at @param {Place} side @param {number} size */
  writeLines(lines, at, side, size) {
    const anchor = Math.abs(side.x) < 0.5 ? "middle" : side.x > 0 ? "start" : "end";
    this.words.forEach((line, i) => {
      line.style.textAnchor = anchor;
      set(line, { x: at.x, y: at.y + 0.65 * size * side.y + (i - 0.5 * (lines.length - 1)) * 1.3 * size });
      write(line, lines[i]);
    });
  }
}

class Ruler extends LineFace {
  /** @param {Element} parent */
  constructor(parent) {
    super(parent, [say("instruments-first-end"), say("instruments-second-end")], "");
  }

  /** @param {Placed} placed @param {Sight} seen @param {Place[]} places @param {number} size */
  draw(placed, { plan, on }, [a, b], size) {
    const scale = plan.scale * on.step;
    const way = towards(a, b);
    const turned = { x: -way.y, y: way.x };
    const normal = turned.y > 0 || (turned.y === 0 && turned.x > 0) ? turned : { x: way.y, y: -way.x };
    const ends = [beyond(a, way, -AWAY), beyond(b, way, AWAY)];
    set(this.body, { d: `M${text(a)}L${text(b)}L${text(beyond(b, normal, WIDTH))}L${text(beyond(a, normal, WIDTH))}Z` });
    set(this.marks, { d: `M${text(ends[0])}L${text(ends[1])}${ticks(a, b, normal, scale)}` });
    this.putGrips(placed, ends);
    const { length, dx, dy } = rulerReading(a, b, scale, plan.flip);
    const lines = [`${digits(length)} ${pageState().unit ?? ""}`, `Δx ${digits(dx)}  Δy ${digits(dy)}`];
    this.writeLines(lines, beyond({ x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 }, normal, WIDTH + size), normal, size);
    return joined([lines[0], ...lines[1].split("  ")]);
  }
}

class Protractor extends LineFace {
  /** @param {Element} parent */
  constructor(parent) {
    super(parent, [say("instruments-first-side"), say("instruments-corner"), say("instruments-second-side")], "softrod-instrument-small");
  }

  /** @param {Placed} placed @param {Sight} _ @param {Place[]} places @param {number} size */
  draw(placed, _, [a, vertex, b], size) {
    const [one, two] = [towards(vertex, a), towards(vertex, b)];
    const { angle, bend } = protractorReading(a, vertex, b);
    const sense = one.x * two.y - one.y * two.x >= 0 ? 1 : -1;
    const from = Math.atan2(one.y, one.x);
    /** @param {number} degrees from the first side @returns {Place} */
    const way = (degrees) => {
      const t = from + (sense * degrees * Math.PI) / 180;
      return { x: Math.cos(t), y: Math.sin(t) };
    };
    const shorter = Math.min(...[a, b].map(({ x, y }) => Math.hypot(x - vertex.x, y - vertex.y)));
    const radius = Math.min(MAX_ARC, Math.max(0.8 * shorter, 24));
    const start = beyond(vertex, one, radius);
    const arc = `A${radius.toFixed(1)} ${radius.toFixed(1)} 0 0 ${sense > 0 ? 1 : 0} ${text(beyond(vertex, two, radius))}`;
    set(this.body, { d: `M${text(vertex)}L${text(start)}${arc}Z` });
    const ends = [beyond(a, one, AWAY), beyond(vertex, way(angle / 2), -AWAY), beyond(b, two, AWAY)];
    let marks = `M${text(ends[0])}L${text(vertex)}L${text(ends[2])}M${text(start)}${arc}`;
    for (let degrees = 10; degrees < angle; degrees += 10) {
      const at = way(degrees);
      marks += `M${text(beyond(vertex, at, radius))}L${text(beyond(vertex, at, radius - (degrees % 30 ? 5 : 9)))}`;
    }
    set(this.marks, { d: marks });
    this.putGrips(placed, ends);
    const lines = [decimal(`${angle.toFixed(1)}°`), say("instruments-bend", { angle: decimal(`${bend.toFixed(1)}°`) })];
    // Between the sides, or behind the corner where there is no room.
    const [outwards, far] = angle < NARROW ? [way(angle / 2 + 180), AWAY + 2 * GRIP] : [way(angle / 2), radius + size];
    this.writeLines(lines, beyond(vertex, outwards, far), outwards, size);
    return joined(lines);
  }
}

class Stopwatch extends BaseFace {
  /** @param {Element} parent */
  constructor(parent) {
    super(parent);
    const card = makeHandle(this.group, "softrod-grip softrod-watch");
    this.grips = [card];
    this.body = makeSvg("rect", "softrod-instrument-body", card);
    this.time = makeSvg("text", "softrod-watch-time", card);
    this.laps = makeSvg("text", "softrod-instrument-small", card);
    this.buttons = [0, 1].map(() => makeHandle(this.group, "softrod-grip softrod-watch-button"));
    this.rims = this.buttons.map((button) => makeSvg("rect", "", button));
    this.words = this.buttons.map((button) => makeSvg("text", "", button));
  }

  /** @param {Placed} placed @param {Sight} _ @param {Place[]} places @param {number} size */
  draw({ watch }, _, [{ x, y }], size) {
    if (!watch) return "";
    const [width, height] = [11 * size, 6.6 * size];
    put(this.group, { x: x - width / 2, y: y - height / 2 });
    set(this.body, { width, height, rx: 0.7 * size });
    const seconds = decimal(`${watchReading(watch, timeNow()).toFixed(2)} s`);
    set(this.time, { x: width / 2, y: 1.6 * size });
    write(this.time, seconds);
    set(this.laps, { x: width / 2, y: 3.2 * size });
    write(this.laps, watch.laps.slice(-3).map((lap) => decimal(lap.toFixed(2))).join("  "));
    const words = BUTTONS[watch.since === null ? "stands" : "runs"].map((key) => say(key));
    words.forEach((word, i) => {
      const [left, wide] = [(0.6 + 5 * i) * size, 4.8 * size];
      set(this.rims[i], { x: left, y: 4.1 * size, width: wide, height: 2 * size, rx: 0.5 * size });
      set(this.words[i], { x: left + wide / 2, y: 5.1 * size });
      write(this.words[i], word);
      this.buttons[i].ariaLabel = say("instruments-key", { button: word, key: "TL"[i] });
    });
    this.grips[0].ariaLabel = say("instruments-watch", { time: seconds });
    return seconds;
  }
}

class LightGate extends LineFace {
  /** @param {Element} parent */
  constructor(parent) {
    super(parent, [say("instruments-first-end"), say("instruments-second-end")], "softrod-instrument-small");
    this.words.push(...Array.from({ length: CROSSINGS - 2 }, () => makeSvg("text", "softrod-instrument-small", this.group)));
  }

  /** @param {Placed} placed @param {Sight} seen @param {Place[]} places @param {number} size */
  draw(placed, { frame, box }, [a, b], size) {
    const way = towards(a, b);
    const turned = { x: -way.y, y: way.x };
    const right = turned.x > 0 || (turned.x === 0 && turned.y > 0) ? turned : { x: way.y, y: -way.x };
    const middle = { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 };
    // Where there is room for the list.
    const normal = middle.x + LIST * size > box.right && middle.x - LIST * size > box.left ? { x: -right.x, y: -right.y } : right;
    const [one, other] = [-BEAM, BEAM].map((far) => [a, b].map((end) => text(beyond(end, normal, far))));
    set(this.body, { d: `M${one[0]}L${one[1]}L${other[1]}L${other[0]}Z` });
    const ends = [beyond(a, way, -AWAY), beyond(b, way, AWAY)];
    set(this.marks, { d: `M${text(ends[0])}L${text(ends[1])}` });
    this.putGrips(placed, ends);
    // Later frames may have arrived already than the one that is shown.
    const crossed = (placed.gate?.crossings ?? []).filter(({ time }) => time <= frame.time).slice(-CROSSINGS).reverse();
    const several = new Set(crossed.map(({ mass }) => mass)).size > 1;
    const told = crossed.map(({ mass, time, since }) => {
      const interval = since === null ? "" : `  Δt ${decimal(since.toFixed(3))} s`;
      return `${decimal(time.toFixed(3))} s${interval}${several ? `  ${say("instruments-crossed", { mass })}` : ""}`;
    });
    const lines = told.length ? told : [say("instruments-nothing")];
    this.writeLines([...lines, ...Array(CROSSINGS - lines.length).fill("")], beyond(middle, normal, size), normal, size);
    return lines[0].replaceAll("  ", ", ");
  }
}

const FACES = { ruler: Ruler, protractor: Protractor, stopwatch: Stopwatch, gate: LightGate };

/** The face of an instrument. @param {Element} parent @param {Kind} kind @returns {Face} */
export const newFace = (parent, kind) => new FACES[kind](parent);
