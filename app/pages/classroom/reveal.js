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
/** Pixels from a mass to its lines, their length, and from the body to the columns of dots. */
const BESIDE = 18;
const LINE = 120;
const COLUMNS = 60;
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
   * @param {{mass: number, to: {x: number, y: number}}} gone @param {number} radius of the mass, px
   * @param {Float64Array} places of all masses, px @param {(place: Place) => {x: number, y: number}} at
   */
  #dots({ mass, to }, radius, places, at) {
    const put = this.#bodies.filter((places) => places[mass]).map((places) => at(places[mass]));
    if (!put.length) return;
    /** @type {Map<number, number>} */
    const bins = new Map();
    const rows = put.map(({ y }) => {
      const bin = Math.round(y / ROOM), count = bins.get(bin) || 0;
      bins.set(bin, count + 1);
      return { bin, count, isRight: Math.abs(y - to.y) <= Math.max(radius, ROOM / 2) };
    });
    // Right of all of the body and its lines, as far as there is room.
    const body = Math.max(to.x + LINE + TEXT, ...Array.from(places).filter((_, i) => i % 2 === 0));
    const width = Math.max(TEXT, ROOM * Math.max(...bins.values()));
    const left = Math.max(Math.min(body + COLUMNS, this.picture.canvas.clientWidth - width - ROOM), 2 * ROOM);
    for (const { bin, count, isRight } of rows) {
      set(makeSvg("circle", isRight ? "softrod-reveal-right" : "softrod-reveal-dot", this.svg), { cx: left + ROOM * count, cy: bin * ROOM, r: DOT });
    }
    const top = Math.min(...bins.keys()) * ROOM - 2 * ROOM;
    set(makeSvg("path", "softrod-reveal-axis", this.svg), { d: `M${left - ROOM} ${top + ROOM}V${(Math.max(...bins.keys()) + 1) * ROOM}` });
    const title = makeSvg("text", "softrod-reveal-title", this.svg);
    set(title, { x: left - ROOM, y: top + HALF });
    title.textContent = "where you put it";
  }
}
