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

/** Radius of a dot, and the room for one, px. */
const DOT = 12;
const ROOM = 28;
/** Pixels from a mass to its lines, their length, and from the whole body to the dots. */
const BESIDE = 18;
const LINE = 120;
const BESIDE_ALL = 60;
/** What stands at the foot of the canvas, px. */
const FOOT = 90;
/** Displacement below which a body has stayed where it was, px on the screen. */
const STAYED = 12;
/** Room for a text, px. */
const TEXT = 220;
/** Half the height of a letter, px. */
const HALF = 9;

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
    if (!start.length) this.svg.remove();
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
    if (most.far > STAYED) this.#lines(most, plan, on.step);
    this.#dots(most, plan.radius[most.mass] * on.step, places, at);
  }

  /** How far the mass has gone that went farthest. @param {{mass: number, from: {x: number, y: number}, to: {x: number, y: number}, far: number}} gone @param {Seen["plan"]} plan @param {number} step */
  #lines({ mass, from, to, far }, plan, step) {
    const isUpright = Math.abs(to.y - from.y) >= Math.abs(to.x - from.x);
    const r = plan.radius[mass] * step + BESIDE;
    const by = isUpright ? to.y - from.y : to.x - from.x, length = Math.sign(by) * (far / step / plan.scale);
    const text = isUpright ? movedText(0, length, this.#unit) : movedText(length, 0, this.#unit);
    // Left of it, where there is no room at the right.
    const right = Math.max(from.x, to.x) + r, isLeft = isUpright && right + LINE + TEXT > this.picture.canvas.clientWidth;
    const x = isLeft ? Math.min(from.x, to.x) - r - LINE : right, y = Math.min(from.y, to.y) - r;
    const [before, after, arrow] = isUpright
      ? [`M${x} ${from.y}h${LINE}`, `M${x} ${to.y}h${LINE}`, `M${x + LINE / 2} ${from.y}V${to.y}m-9 ${-12 * Math.sign(by)}l9 ${12 * Math.sign(by)} 9 ${-12 * Math.sign(by)}`]
      : [`M${from.x} ${y}v${-LINE}`, `M${to.x} ${y}v${-LINE}`, `M${from.x} ${y - LINE / 2}H${to.x}m${-12 * Math.sign(by)} -9l${12 * Math.sign(by)} 9 ${-12 * Math.sign(by)} 9`];
    set(makeSvg("path", "softrod-reveal-before", this.svg), { d: before });
    set(makeSvg("path", "softrod-reveal-arrow", this.svg), { d: arrow });
    set(makeSvg("path", "softrod-reveal-after", this.svg), { d: after });
    const label = makeSvg("text", "softrod-reveal-far", this.svg);
    if (isLeft) set(label, { "text-anchor": "end" });
    set(label, isUpright ? { x: isLeft ? x - 10 : x + LINE + 10, y: to.y + HALF } : { x: Math.max(from.x, to.x) + 10, y: y - LINE / 2 + HALF });
    label.textContent = text;
  }

  /**
   * A dot for each prediction, where its mass was put: in rows beside the body, or in columns below it, if it went to the side.
   *
   * @param {{mass: number, from: {x: number, y: number}, to: {x: number, y: number}}} gone @param {number} radius of the mass, px
   * @param {Float64Array} places of all masses, px @param {(place: Place) => {x: number, y: number}} at
   */
  #dots({ mass, from, to }, radius, places, at) {
    const put = this.#bodies.filter((one) => one[mass]).map((one) => at(one[mass]));
    if (!put.length) return;
    const isUpright = Math.abs(to.y - from.y) >= Math.abs(to.x - from.x);
    /** @param {{x: number, y: number}} place */
    const along = ({ x, y }) => (isUpright ? y : x);
    /** @type {Map<number, number>} */
    const bins = new Map();
    const dots = put.map((place) => {
      const bin = Math.round(along(place) / ROOM), count = bins.get(bin) || 0;
      bins.set(bin, count + 1);
      return { bin, count, isRight: Math.abs(along(place) - along(to)) <= Math.max(radius, ROOM / 2) };
    });
    const { clientWidth, clientHeight } = this.picture.canvas;
    const longest = ROOM * Math.max(...bins.values()), [first, last] = [Math.min(...bins.keys()) * ROOM, Math.max(...bins.keys()) * ROOM];
    const edge = Array.from(places).filter((_, i) => i % 2 === Number(!isUpright));
    // Beside all of the body and its lines, as far as there is room.
    const line = isUpright ? to.x + radius + BESIDE + LINE + TEXT : 0;
    const beside = Math.max(line <= clientWidth ? line : 0, ...edge) + BESIDE_ALL;
    const room = isUpright ? clientWidth - Math.max(TEXT, longest) : clientHeight - longest - FOOT;
    const begin = Math.max(Math.min(beside, room), 2 * ROOM);
    for (const { bin, count, isRight } of dots) {
      const [cx, cy] = isUpright ? [begin + ROOM * count, bin * ROOM] : [bin * ROOM, begin + ROOM * count];
      set(makeSvg("circle", isRight ? "softrod-reveal-right" : "softrod-reveal-dot", this.svg), { cx, cy, r: DOT });
    }
    const axis = isUpright ? `M${begin - ROOM} ${first - ROOM}V${last + ROOM}` : `M${first - ROOM} ${begin - ROOM}H${last + ROOM}`;
    set(makeSvg("path", "softrod-reveal-axis", this.svg), { d: axis });
    const title = makeSvg("text", "softrod-reveal-title", this.svg);
    set(title, isUpright ? { x: begin - ROOM, y: first - 2 * ROOM + HALF } : { x: last + 2 * ROOM, y: begin - ROOM + HALF });
    title.textContent = say("class-where-put");
  }
}
