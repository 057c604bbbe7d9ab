// @ts-check
/**
 * The reveal, over the body as it stands after its run: where it was, how far it has gone, and a dot for each prediction. They
 * come one after the other; class.css has the times.
 */
import { makeSvg, set } from "../../stage/svg.js";
import { tipsOf } from "../../features/classroom/prediction.js";

/** @typedef {import("../../features/classroom/prediction.js").Place} Place */
/** @typedef {import("./picture.js").Seen} Seen */

/** Radius of a dot, and the room for one, px. */
const DOT = 12;
const ROOM = 28;
/** Pixels from the body to its lines, their length, and to the column of dots. */
const BESIDE = 18;
const LINE = 120;
const COLUMN = 330;
/** Displacement below which a body has stayed where it was, px on the screen. */
const STAYED = 12;
/** Half the height of a letter, px. */
const HALF = 9;

export class Reveal {
  svg = makeSvg("svg", "softrod-marks softrod-reveal");
  /** @type {Place[]} */
  #start = [];
  /** @type {Place[][]} */
  #bodies = [];
  #unit = "px";

  /** @param {import("./picture.js").Picture} picture */
  constructor(picture) {
    this.picture = picture;
    picture.onRedraw((seen) => this.#draw(seen));
  }

  /** Shows it, or takes it away (no start). @param {Place[]} start where the masses were @param {Place[][]} bodies predictions @param {string} unit of lengths */
  show(start, bodies, unit) {
    this.#start = start;
    this.#bodies = bodies;
    this.#unit = unit;
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
    const gone = tipsOf(plan).map((mass) => {
      const from = at(start[mass]), to = { x: places[2 * mass], y: places[2 * mass + 1] };
      return { mass, from, to, far: Math.hypot(to.x - from.x, to.y - from.y) };
    });
    const most = gone.reduce((best, one) => (one.far > best.far ? one : best), gone[0]);
    if (!most) return;
    if (most.far > STAYED) this.#lines(most, plan, on.step);
    this.#dots(most, plan.radius[most.mass] * on.step, at);
  }

  /** How far the mass has gone that went farthest. @param {{mass: number, from: {x: number, y: number}, to: {x: number, y: number}, far: number}} gone @param {Seen["plan"]} plan @param {number} step */
  #lines({ mass, from, to, far }, plan, step) {
    const isUpright = Math.abs(to.y - from.y) >= Math.abs(to.x - from.x);
    const r = plan.radius[mass] * step + BESIDE;
    const length = Number((far / step / plan.scale).toPrecision(3));
    const [by, words] = isUpright ? [to.y - from.y, ["lower", "higher"]] : [to.x - from.x, ["to the right", "to the left"]];
    const text = `${length} ${this.#unit} ${words[by > 0 ? 0 : 1]}`;
    const x = Math.max(from.x, to.x) + r, y = Math.min(from.y, to.y) - r;
    const [before, after, arrow] = isUpright
      ? [`M${x} ${from.y}h${LINE}`, `M${x} ${to.y}h${LINE}`, `M${x + LINE / 2} ${from.y}V${to.y}m-9 ${-12 * Math.sign(by)}l9 ${12 * Math.sign(by)} 9 ${-12 * Math.sign(by)}`]
      : [`M${from.x} ${y}v${-LINE}`, `M${to.x} ${y}v${-LINE}`, `M${from.x} ${y - LINE / 2}H${to.x}m${-12 * Math.sign(by)} -9l${12 * Math.sign(by)} 9 ${-12 * Math.sign(by)} 9`];
    set(makeSvg("path", "softrod-reveal-before", this.svg), { d: before });
    set(makeSvg("path", "softrod-reveal-arrow", this.svg), { d: arrow });
    set(makeSvg("path", "softrod-reveal-after", this.svg), { d: after });
    const label = makeSvg("text", "softrod-reveal-far", this.svg);
    set(label, isUpright ? { x: x + LINE + 10, y: to.y + HALF } : { x: Math.max(from.x, to.x) + 10, y: y - LINE / 2 + HALF });
    label.textContent = text;
  }

  /**
   * A dot for each prediction, in columns beside the body: as high as its mass was put.
   *
   * @param {{mass: number, to: {x: number, y: number}, from: {x: number, y: number}}} gone @param {number} radius of the mass, px
   * @param {(place: Place) => {x: number, y: number}} at
   */
  #dots({ mass, from, to }, radius, at) {
    const put = this.#bodies.filter((places) => places[mass]).map((places) => at(places[mass]));
    if (!put.length) return;
    const left = Math.max(from.x, to.x) + radius + COLUMN;
    /** @type {Map<number, number>} */
    const bins = new Map();
    for (const { y } of put.sort((one, two) => one.y - two.y)) {
      const bin = Math.round(y / ROOM), count = bins.get(bin) || 0;
      bins.set(bin, count + 1);
      const isRight = Math.abs(y - to.y) <= Math.max(radius, ROOM / 2);
      set(makeSvg("circle", isRight ? "softrod-reveal-right" : "softrod-reveal-dot", this.svg), { cx: left + ROOM * count, cy: bin * ROOM, r: DOT });
    }
    const top = Math.min(...bins.keys()) * ROOM - 2 * ROOM;
    set(makeSvg("path", "softrod-reveal-axis", this.svg), { d: `M${left - ROOM} ${top + ROOM}V${(Math.max(...bins.keys()) + 1) * ROOM}` });
    const title = makeSvg("text", "softrod-reveal-title", this.svg);
    set(title, { x: left - ROOM, y: top + HALF });
    title.textContent = "where you put it";
  }
}
