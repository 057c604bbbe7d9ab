// @ts-check
/**
 * The body on a class's page, drawn into a canvas by the renderer of live files, and marks over it.
 *
 * @typedef {import("../../stage/plan.js").Plan} Plan
 * @typedef {import("../../stage/plan.js").Frame} Frame
 * @typedef {import("../../stage/plan.js").Damage} Damage
 * @typedef {import("../../stage/environment.js").Screen} Screen
 * @typedef {object} Seen what is on the canvas now
 * @property {Plan} plan
 * @property {Frame} frame
 * @property {Screen} on where the page's world is in the canvas
 * @property {Float64Array} places of the masses in the canvas, px
 */
import { paint, screenOf } from "../../export/static/paint.js";
import { roundUp } from "../../stage/axes.js";
import { Glide } from "../../stage/glide.js";
import { readDamage, readFrame, readPlan, UNHARMED } from "../../stage/plan.js";
import { onScreen, worldAt } from "../../stage/screen.js";
import { callAll, onMessage, pageState } from "../../wire/channel.js";

/** Free space around the body's motion, as a part of its size. */
const ROOM = 0.3;
/** Free space around what else is to be seen, in the page's world: a twentieth of the scene's frame. */
const MARGIN = 0.3;
/** Least length of the scale bar, its distance from the edge, px, and the size of its letters, as a part of the page's. */
const BAR = 60;
const INSET = 18;
const LETTERS = 0.85;
/** The view grows with its body up to so many times its size; then it goes with the body. */
const GROWTH = 2.5;

/** @typedef {[left: number, right: number, low: number, high: number]} Box in the page's world */

/** The smallest box around two. @param {Box} one @param {Box} two @returns {Box} */
const around = (one, two) => [Math.min(one[0], two[0]), Math.max(one[1], two[1]), Math.min(one[2], two[2]), Math.max(one[3], two[3])];

/** @param {Box} box */
const sizeOf = ([left, right, low, high]) => Math.max(right - left, high - low);

/** Where the masses of a body are, in the page's world. @param {Plan} plan @param {ArrayLike<number>} positions @returns {Box} */
function boxOf(plan, positions) {
  /** @type {Box} */
  let box = [Infinity, -Infinity, Infinity, -Infinity];
  for (let i = 0; i < plan.radius.length; i++) {
    const x = (positions[2 * i] - plan.x) * plan.scale, y = (positions[2 * i + 1] - plan.y) * plan.scale * plan.flip;
    const r = plan.radius[i];
    box = around(box, [x - r, x + r, y - r, y + r]);
  }
  return box;
}

export class Picture {
  /** @type {Plan | null} */
  plan = null;
  /** @type {Damage} */
  damage = UNHARMED;
  /** The frame that is shown. @type {Frame | null} */
  frame = null;
  /** Called when marks have to be drawn. @type {((seen: Seen) => void)[]} */
  #listeners = [];
  #glide = new Glide();
  #asked = false;
  /** What is shown of the world. @type {Box} */
  #box = [-3, 3, -3, 3];
  /** Of which opening that is. */
  #scene = NaN;
  #moment = -Infinity;
  /** Frames of another source than the server. @type {Frame | null} */
  #own = null;

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {{meshes: Record<string, number[][]>, coils: Record<string, number>}} shapes outlines of what is drawn, and the
   *   slimness of the springs that each coil suits
   */
  constructor(canvas, shapes) {
    this.canvas = canvas;
    this.shapes = shapes;
    onMessage("plan", ({ numbers }) => {
      this.plan = readPlan(numbers);
      this.damage = UNHARMED;
      this.redraw();
    });
    onMessage("damage", ({ numbers }) => {
      this.damage = readDamage(numbers);
      this.redraw();
    });
    onMessage("frame", ({ numbers, wall }) => {
      const frame = readFrame(numbers);
      this.latest = [...this.latest.slice(-1), frame];
      this.#glide.take(frame, wall, performance.now() / 1e3);
      this.#ask();
    });
    onMessage("pageState", ({ scene, width, height, view }) => {
      if (scene === this.#scene) {
        if (view && view.length && !this.#hasView) this.#look(/** @type {Box} */ (view));
        return;
      }
      this.#scene = scene;
      this.#hasView = false;
      this.#box = this.#first = [-width / 2, width / 2, -height / 2, height / 2];
      if (view && view.length) this.#look(/** @type {Box} */ (view));
      this.redraw();
    });
    new ResizeObserver(() => this.redraw()).observe(canvas);
    // The browser had taken its memory back.
    canvas.addEventListener("contextrestored", () => this.redraw());
  }

  #hasView = false;
  /** What was shown of the world before the body went farther. @type {Box} */
  #first = [-3, 3, -3, 3];
  /** The last two frames from the server, for whoever goes on from there. @type {Frame[]} */
  latest = [];

  /** Shows the body's motion, with some room. @param {Box} view */
  #look(view) {
    const room = ROOM * sizeOf(view);
    this.#hasView = true;
    this.#box = this.#first = [view[0] - room, view[1] + room, view[2] - room, view[3] + room];
    this.redraw();
  }

  /** Calls back whenever marks over the body are drawn. @param {(seen: Seen) => void} draw */
  onRedraw(draw) {
    this.#listeners.push(draw);
  }

  /** Puts a layer of marks over the body. @param {SVGSVGElement} svg */
  insert(svg) {
    this.canvas.after(svg);
  }

  /** Where a pointer is in the page's world. @param {MouseEvent} event */
  at({ clientX, clientY }) {
    const { left, top } = this.canvas.getBoundingClientRect();
    return worldAt({ x: clientX - left, y: clientY - top }, this.place);
  }

  /** Where the page's world is in the canvas. @returns {Screen} */
  get place() {
    return screenOf(this.#stage, this.canvas);
  }

  /** Positions and number of the masses that are shown. */
  get body() {
    return { positions: this.frame ? this.frame.positions : new Float32Array(), velocities: new Float32Array(), masses: this.plan ? this.plan.radius.length : 0 };
  }

  /** A strip of the canvas that is kept free of the body: its side, and its part of the canvas. @type {{side: "" | "right" | "top", part: number}} */
  #strip = { side: "", part: 0 };

  /** Keeps a strip of the canvas free of the body. @param {"" | "right" | "top"} side @param {number} part of the canvas */
  reserve(side, part) {
    if (side === this.#strip.side && part === this.#strip.part) return;
    this.#strip = { side, part };
    this.redraw();
  }

  /** What is shown of the world, with the strip. @returns {Box} */
  get #shown() {
    const [left, right, low, high] = this.#box, { side, part } = this.#strip;
    if (!side) return this.#box;
    const { clientWidth, clientHeight } = this.canvas;
    const [width, height] = side === "right" ? [clientWidth * (1 - part), clientHeight] : [clientWidth, clientHeight * (1 - part)];
    const unit = Math.max((right - left) / width, (high - low) / height);
    const x = (left + right - unit * width) / 2, y = (low + high - unit * height) / 2;
    return [x, x + unit * clientWidth, y, y + unit * clientHeight];
  }

  get #stage() {
    return { size: this.size, box: this.#shown, springs: this.#springs, meshes: this.shapes.meshes };
  }

  /** Size of the scene's frame, px. */
  get size() {
    return this.plan ? 6 / this.plan.scale : 600;
  }

  /** The mesh that suits most of the springs; as `Sketch._spring_shape`. */
  get #springs() {
    const { plan, shapes: { coils } } = this;
    if (!plan || plan.bars || !plan.restLength.length) return "bar";
    const slim = Array.from(plan.restLength, (length, i) => Math.max(length * plan.scale, 1e-9) / plan.thickness[i]).sort((a, b) => a - b);
    const middle = (slim[(slim.length - 1) >> 1] + slim[slim.length >> 1]) / 2;
    const off = (/** @type {string} */ name) => Math.abs(Math.log(coils[name] / middle));
    return Object.keys(coils).reduce((best, name) => (off(name) < off(best) ? name : best));
  }

  /** Shows frames of the page itself, until the server's come again. @param {Frame} frame */
  show(frame) {
    this.#own = frame;
    this.#draw(frame);
  }

  /** Shows the server's frames again. */
  release() {
    this.#own = null;
    this.redraw();
  }

  redraw() {
    this.#moment = -Infinity;
    this.#ask();
  }

  #ask() {
    if (!this.#asked) requestAnimationFrame(() => this.#next());
    this.#asked = true;
  }

  #next() {
    this.#asked = false;
    if (this.#own) {
      this.#draw(this.#own);
      return;
    }
    const fresh = this.#glide.at(performance.now() / 1e3) || (this.#moment === -Infinity ? this.#glide.last : null);
    if (fresh) this.#draw(fresh);
    if (this.#glide.frames.length && this.#glide.busy) this.#ask();
  }

  /** @param {Frame} frame */
  #draw(frame) {
    const { plan } = this;
    if (!plan || frame.generation !== plan.generation) return;
    // It begins anew: what it did before is no reason to be far away.
    if (this.frame && frame.time < this.frame.time) this.#box = this.#first;
    this.frame = frame;
    this.#moment = frame.time;
    this.#follow(boxOf(plan, frame.positions));
    paint(this.#stage, this.canvas, { plan, frame, damage: this.damage.generation === plan.generation ? this.damage : UNHARMED });
    const on = this.place;
    this.#scale(plan, on);
    callAll(this.#listeners, { plan, frame, on, places: onScreen(plan, frame.positions, on) });
  }

  /** A bar of a round length at the top right. @param {Plan} plan @param {Screen} on */
  #scale(plan, on) {
    const to = this.canvas.getContext("2d");
    if (!to) return;
    const pixel = plan.scale * on.step, length = roundUp(BAR / pixel), unit = pageState().unit || "px";
    const end = this.canvas.clientWidth - INSET, begin = end - length * pixel;
    const styles = getComputedStyle(document.documentElement);
    const letters = parseFloat(getComputedStyle(document.body).fontSize) * LETTERS;
    Object.assign(to, { strokeStyle: styles.getPropertyValue("--softrod-text"), fillStyle: styles.getPropertyValue("--softrod-text"), lineWidth: 2 });
    Object.assign(to, { textAlign: "center", textBaseline: "top", font: `${letters}px ${styles.getPropertyValue("--softrod-font")}` });
    to.beginPath();
    to.moveTo(begin, INSET - 5);
    to.lineTo(begin, INSET + 5);
    to.moveTo(begin, INSET);
    to.lineTo(end, INSET);
    to.moveTo(end, INSET - 5);
    to.lineTo(end, INSET + 5);
    to.stroke();
    to.fillText(`${length} ${unit}`, (begin + end) / 2, INSET + 7);
  }

  /** Has places seen, too. @param {[x: number, y: number][]} places of the page's world */
  include(places) {
    for (const [x, y] of places) this.#box = this.#first = around(this.#box, [x - MARGIN, x + MARGIN, y - MARGIN, y + MARGIN]);
  }

  /** Keeps the body in view. @param {Box} body */
  #follow(body) {
    if (!body.every(Number.isFinite)) return;
    const grown = around(this.#box, body);
    if (grown.every((edge, i) => edge === this.#box[i])) return;
    if (sizeOf(grown) <= GROWTH * Math.max(sizeOf(body), 1)) this.#box = grown;
    else {
      const [left, right, low, high] = this.#box;
      const x = Math.max(body[1] - right, 0) + Math.min(body[0] - left, 0);
      const y = Math.max(body[3] - high, 0) + Math.min(body[2] - low, 0);
      this.#box = [left + x, right + x, low + y, high + y];
    }
  }
}
