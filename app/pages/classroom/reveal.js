// @ts-check
/**
 * The reveal, over the body as it stands after its run: where it was, how far it has gone, and a dot for each prediction. They
 * come one after the other; class.css has the times.
 */
import { makeSvg, set } from "../../stage/svg.js";
import { movedText, tipsOf } from "../../features/classroom/prediction.js";
import { say } from "../../words/words.js";

/** @typedef {import("../../features/classroom/prediction.js").Place} Place */
/** @typedef {import("./picture.js").Seen} Seen */

/** Part of the canvas beside the body that has the dots and the texts. */
const STRIP = 0.32;
/** Room for a dot, px, at most and at least: it is smaller where many are in a row. */
const ROOM = 28;
const LEAST_ROOM = 8;
/** Radius of a dot, as a part of its room. */
const DOT = 0.43;
/** Pixels from a mass to its lines, and from the axis to the arrow. */
const BESIDE = 8;
const ARROW = 18;
/** The head of the arrow, px. */
const HEAD = [9, 12];
/** Displacement below which a body has stayed where it was, px on the screen. */
const STAYED = 12;
/** What stands at the upper edge of the canvas, the scale bar, px; and the distance of texts from an edge. */
const TOP = 60;
const EDGE = 14;

/** @typedef {{x: number, y: number}} Point on the canvas, px */

/**
 * The column of each dot, so that no two dots touch, and their size, so small that all columns fit.
 *
 * @param {number[]} along where each is along the axis, px @param {number} room for the columns, px
 */
export function columns(along, room) {
  const order = along.map((_, i) => i).sort((one, other) => along[one] - along[other]);
  for (let size = ROOM; ; size -= 1) {
    /** The last place in each column. @type {number[]} */
    const last = [];
    /** @type {number[]} */
    const column = [];
    for (const i of order) {
      const free = last.findIndex((at) => along[i] - at >= size);
      column[i] = free < 0 ? last.length : free;
      last[column[i]] = along[i];
    }
    if (size <= LEAST_ROOM || size * last.length <= room) return { size, column };
  }
}

export class Reveal {
  svg = makeSvg("svg", "softrod-marks softrod-reveal");
  /** @type {Place[]} */
  #start = [];
  /** @type {Place[][]} */
  #bodies = [];
  #unit = "px";
  /** The masses that were asked for; none for all. @type {number[]} */
  #asked = [];

  /** @param {import("./picture.js").Picture} picture */
  constructor(picture) {
    this.picture = picture;
    picture.onRedraw((seen) => this.#draw(seen));
  }

  /** Shows it, or takes it away (no start). @param {Place[]} start where the masses were @param {Place[][]} bodies predictions @param {string} unit of lengths @param {number[]} asked the masses that were asked for */
  show(start, bodies, unit, asked) {
    this.#start = start;
    this.#bodies = bodies;
    this.#unit = unit;
    this.#asked = asked;
    if (start.length && !this.svg.parentNode) this.picture.insert(this.svg);
    if (!start.length) {
      this.svg.remove();
      this.picture.reserve("", 0);
    }
    this.picture.redraw();
  }

  /** @param {Seen} seen */
  #draw(seen) {
    const { plan, on, places } = seen;
    const start = this.#start;
    this.svg.textContent = "";
    if (start.length !== plan.radius.length) return;
    /** @param {Place} place */
    const at = ([x, y]) => ({ x: on.x + x * on.step, y: on.y - y * on.step });
    const gone = tipsOf(plan, this.#asked).map((mass) => {
      const from = at(start[mass]), to = { x: places[2 * mass], y: places[2 * mass + 1] };
      return { mass, from, to, far: Math.hypot(to.x - from.x, to.y - from.y) };
    });
    const most = gone.reduce((best, one) => (one.far > best.far ? one : best), gone[0]);
    if (!most) return;
    const { mass, from, to, far } = most;
    const isUpright = Math.abs(to.y - from.y) >= Math.abs(to.x - from.x);
    this.picture.reserve(isUpright ? "right" : "top", STRIP);
    const { clientWidth, clientHeight } = this.picture.canvas;
    const axis = isUpright ? clientWidth * (1 - STRIP) : clientHeight * STRIP;
    const letters = parseFloat(getComputedStyle(this.svg).fontSize);
    const put = this.#bodies.filter((one) => one[mass]).map((one) => at(one[mass]));
    const room = isUpright ? clientWidth - axis - ROOM : axis - TOP - 3 * letters;
    const along = put.map(({ x, y }) => (isUpright ? y : x)), { size, column } = columns(along, room);
    if (far > STAYED) this.#lines(from, to, plan.radius[mass] * on.step + BESIDE, isUpright, axis);
    const near = Math.max(plan.radius[mass] * on.step, ROOM / 2), goal = isUpright ? to.y : to.x;
    put.forEach((_, i) => {
      const isRight = Math.abs(along[i] - goal) <= near;
      const away = (isUpright ? 1 : -1) * (0.5 * ROOM + size * column[i] + 0.5 * size);
      const [cx, cy] = isUpright ? [axis + away, along[i]] : [along[i], axis + away];
      set(makeSvg("circle", isRight ? "softrod-reveal-right" : "softrod-reveal-dot", this.svg), { cx, cy, r: DOT * size });
    });
    const ends = [...along, isUpright ? from.y : from.x, goal];
    const [first, last] = [Math.min(...ends) - size, Math.max(...ends) + size];
    set(makeSvg("path", "softrod-reveal-axis", this.svg), { d: isUpright ? `M${axis} ${first}V${last}` : `M${first} ${axis}H${last}` });
    const length = Math.sign(goal - (isUpright ? from.y : from.x)) * (far / on.step / plan.scale);
    const told = isUpright ? movedText(0, length, this.#unit) : movedText(length, 0, this.#unit);
    /** @param {number} y */
    const inside = (y) => Math.min(Math.max(y, TOP + letters), clientHeight - EDGE);
    // Beside the dots, where the body went to; the title at the other end.
    const before = inside(first - 0.5 * letters), after = inside(last + letters);
    const [title, result] = length < 0 ? [after, before] : [before, after];
    if (put.length) this.#text("softrod-reveal-title", say("class-where-put"), isUpright ? axis + EDGE : EDGE, isUpright ? title : TOP);
    if (far > STAYED) this.#text("softrod-reveal-far", told, isUpright ? axis + EDGE : to.x, isUpright ? result : TOP + 1.5 * letters, !isUpright);
  }

  /** How far a mass has gone. @param {Point} from @param {Point} to @param {number} r from its middle to the lines, px @param {boolean} isUpright @param {number} axis where the lines end, px */
  #lines(from, to, r, isUpright, axis) {
    const by = Math.sign(isUpright ? to.y - from.y : to.x - from.x), [wide, long] = HEAD, at = isUpright ? axis - ARROW : axis + ARROW;
    const [before, after, arrow] = isUpright
      ? [`M${from.x + r} ${from.y}H${axis}`, `M${to.x + r} ${to.y}H${axis}`, `M${at} ${from.y}V${to.y}m${-wide} ${-long * by}l${wide} ${long * by} ${wide} ${-long * by}`]
      : [`M${from.x} ${from.y - r}V${axis}`, `M${to.x} ${to.y - r}V${axis}`, `M${from.x} ${at}H${to.x}m${-long * by} ${-wide}l${long * by} ${wide} ${-long * by} ${wide}`];
    set(makeSvg("path", "softrod-reveal-before", this.svg), { d: before });
    set(makeSvg("path", "softrod-reveal-after", this.svg), { d: after });
    set(makeSvg("path", "softrod-reveal-arrow", this.svg), { d: arrow });
  }

  /** A text that stays on the canvas. @param {string} name of its class @param {string} text @param {number} x @param {number} y @param {boolean} [isCentred] */
  #text(name, text, x, y, isCentred) {
    const label = makeSvg("text", name, this.svg);
    label.textContent = text;
    const wide = label.getComputedTextLength(), most = this.picture.canvas.clientWidth - EDGE - wide;
    set(label, { x: Math.max(EDGE, Math.min(isCentred ? x - wide / 2 : x, most)), y });
  }
}
