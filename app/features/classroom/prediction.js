// @ts-check
/**
 * Predictions: pale copies of the body, of which a pupil drags one to where the body will be. When one mass is dragged,
 * the others follow as a chain of massless springs would: each spring is brought back towards its length, again and again
 * (Jakobsen 2001, Advanced Character Physics).
 */
import { roundUp } from "../../stage/axes.js";
import { makeSvg, set } from "../../stage/svg.js";
import { wireNumber } from "../../stage/screen.js";
import { ARROWS } from "../../ui/hands/arrow_keys.js";
import { takePointer } from "../../ui/hands/take.js";
import { decimal, say } from "../../words/words.js";

/** @typedef {import("../../stage/plan.js").Plan} Plan */
/** @typedef {import("../../stage/plan.js").Frame} Frame */
/** @typedef {import("../../stage/environment.js").Screen} Screen */
/** @typedef {{plan: Plan, frame: Frame, on: Screen}} Sight what is seen: a body, and where the page's world is on the screen */
/** @typedef {[number, number]} Place in the page's world */
/**
 * @typedef {object} Marks where predictions are drawn
 * @property {(draw: (seen: Sight) => void) => void} onRedraw calls back whenever marks have to be drawn
 * @property {(svg: SVGSVGElement) => void} insert puts a layer over the body
 * @property {() => void} redraw has all marks drawn
 * @property {(event: MouseEvent) => {x: number, y: number} | null} at where a pointer is in the page's world
 */
/** @typedef {[a: number, b: number, length: number]} Spring the masses that it joins, and its length */

/** How often every spring is brought towards its length for one movement of the pointer. */
const ROUNDS = 30;
/** Pixels by which an arrow key moves a mass; a tenth with Shift. */
const KEY_STEP = 20;
/** By how much a button moves a mass at least, in the page's world: 1/150 of the scene's frame. It is a round number of px. */
const STEP = 0.04;
/** Radius of a grip for a finger, px; half of it where there are more grips than `CROWDED`. */
const REACH = 22;
const CROWDED = 12;
/** Bodies with more masses than this have a grip at only every so many. */
const MAX_GRIPS = 40;

/**
 * Moves one mass of a body, and lets the others follow.
 *
 * @param {Place[]} places of the masses; changed
 * @param {number} mass
 * @param {Place} to
 * @param {Spring[]} springs
 * @param {Set<number>} held masses that stay
 */
export function drag(places, mass, to, springs, held) {
  places[mass] = to;
  for (let round = 0; round < ROUNDS; round++) {
    for (const [a, b, length] of springs) {
      const mayA = a !== mass && !held.has(a), mayB = b !== mass && !held.has(b);
      if (!mayA && !mayB) continue;
      const [dx, dy] = [places[b][0] - places[a][0], places[b][1] - places[a][1]];
      const distance = Math.hypot(dx, dy) || 1e-9;
      const share = (distance - length) / distance / (mayA && mayB ? 2 : 1);
      if (mayA) places[a] = [places[a][0] + share * dx, places[a][1] + share * dy];
      if (mayB) places[b] = [places[b][0] - share * dx, places[b][1] - share * dy];
    }
  }
}

/** The places of a body's masses in the page's world. @param {Sight} seen @returns {Place[]} */
const placesOf = ({ plan, frame }) =>
  Array.from(plan.radius, (_, i) => [
    (frame.positions[2 * i] - plan.x) * plan.scale,
    (frame.positions[2 * i + 1] - plan.y) * plan.scale * plan.flip,
  ]);

/** The springs between some places. @param {Sight} seen @param {Place[]} places @returns {Spring[]} */
const springsOf = ({ plan: { springs } }, places) =>
  Array.from({ length: springs.length / 2 }, (_, i) => {
    const [a, b] = [springs[2 * i], springs[2 * i + 1]];
    return [a, b, Math.hypot(places[b][0] - places[a][0], places[b][1] - places[a][1])];
  });

/** The springs of a body as the path of a line. @param {Place[]} places @param {Sight} seen */
function outline(places, { plan: { springs }, on }) {
  /** @param {number} i */
  const at = (i) => `${(on.x + places[i][0] * on.step).toFixed(1)} ${(on.y - places[i][1] * on.step).toFixed(1)}`;
  let path = "";
  for (let i = 0; i < springs.length; i += 2) {
    if (places[springs[i]] && places[springs[i + 1]]) path += `M${at(springs[i])}L${at(springs[i + 1])}`;
  }
  return path;
}

/** The prediction that is dragged. */
export class OwnPrediction {
  svg = makeSvg("svg", "softrod-marks softrod-own-prediction");
  path = makeSvg("path", "", this.svg);
  /** @type {Place[]} */
  places = [];
  /** @type {Spring[]} */
  springs = [];
  /** @type {Set<number>} */
  held = new Set();
  /** @type {SVGCircleElement[]} */
  grips = [];
  isOn = false;
  moved = false;
  /** The mass that was moved last. */
  last = -1;
  /** The masses that are asked for; none for all. @type {number[]} */
  asked = [];

  /** Where its masses were at first. @type {Place[]} */
  start = [];
  /** The unit of the page's world on the screen, px, and a px of the scene in it. */
  step = 1;
  scale = 1;

  /** @param {Marks} marks @param {() => void} changed called when it begins, and when it was moved */
  constructor(marks, changed) {
    this.marks = marks;
    this.changed = changed;
    this.svg.removeAttribute("aria-hidden");
    set(this.svg, { role: "application", "aria-label": say("class-grips") }); // keys go to its grips
    marks.onRedraw((seen) => this.draw(seen));
  }

  /** Begins a prediction where the body is, or ends it. @param {boolean} on @param {number[]} [asked] the masses that are asked for; none for all */
  show(on, asked = []) {
    if (on === this.isOn) return;
    this.isOn = on;
    this.asked = asked;
    // Nothing around the grips takes a finger's drag for a scroll.
    document.documentElement.toggleAttribute("data-softrod-predicting", on);
    this.places = [];
    this.moved = false;
    if (on) this.marks.insert(this.svg);
    else this.svg.remove();
    this.marks.redraw();
  }

  /** The places of its masses, for a message. */
  points() {
    return this.places.map(([x, y]) => /** @type {Place} */ ([wireNumber(x), wireNumber(y)]));
  }

  /** The masses that can be dragged. */
  get free() {
    const free = this.places.map((_, i) => i).filter((i) => !this.held.has(i));
    const asked = free.filter((i) => this.asked.includes(i));
    return asked.length ? asked : free;
  }

  /** Whether there is one of these alone, whose place can be said and stepped. */
  get isSingle() {
    return this.free.length === 1;
  }

  /** How far from its start that mass was put, in words; empty for other bodies, and before. @param {string} unit of lengths */
  said(unit) {
    if (!this.isSingle) return "";
    const [mass] = this.free;
    const dx = (this.places[mass][0] - this.start[mass][0]) / this.scale, dy = (this.places[mass][1] - this.start[mass][1]) / this.scale;
    return dx || dy ? movedText(dx, -dy, unit) : "";
  }

  /** The same of the mass that was moved last, with its number; empty before. @param {string} unit */
  news(unit) {
    if (!this.moved || this.last < 0) return "";
    const [[x, y], [x0, y0]] = [this.places[this.last], this.start[this.last]];
    return say("class-moved-mass", { mass: String(this.last), moved: movedText((x - x0) / this.scale, (y0 - y) / this.scale, unit) });
  }

  /** Moves that mass a little. @param {number} across 1 for right @param {number} up 1 for up */
  stepBy(across, up) {
    const [mass] = this.free;
    const [x, y] = this.places[mass];
    const step = roundUp(STEP / this.scale) * this.scale;
    this.move(mass, [x + across * step, y + up * step]);
  }

  /** @param {Sight} seen */
  draw(seen) {
    if (!this.isOn) return;
    const { plan, on } = seen;
    this.step = on.step;
    this.scale = plan.scale;
    if (this.places.length !== plan.radius.length) {
      this.places = placesOf(seen);
      this.start = this.places.map(([x, y]) => [x, y]);
      this.springs = springsOf(seen, this.places);
      this.held = new Set([...plan.pinned, ...(plan.driven >= 0 ? [plan.driven] : [])]);
      this.makeGrips();
      this.changed();
    }
    set(this.path, { d: outline(this.places, seen) });
    for (const grip of this.grips) {
      const [x, y] = this.places[Number(grip.dataset.mass)];
      set(grip, { cx: (on.x + x * on.step).toFixed(1), cy: (on.y - y * on.step).toFixed(1) });
    }
  }

  makeGrips() {
    for (const grip of this.grips) grip.remove();
    const free = this.free;
    const every = Math.ceil(free.length / MAX_GRIPS);
    // The last one, at the free end of a rope, has a grip, and is on top.
    const masses = free.filter((_, i) => (free.length - 1 - i) % every === 0);
    const radius = masses.length > CROWDED ? REACH / 2 : REACH;
    this.grips = masses.map((mass) => this.makeGrip(mass, radius));
  }

  /** @param {number} mass @param {number} r px */
  makeGrip(mass, r) {
    const grip = makeSvg("circle", "softrod-own-grip", this.svg);
    const label = say("class-grip", { mass: String(mass) });
    set(grip, { "data-mass": mass, r, tabindex: 0, role: "button", "aria-label": label });
    /** @param {Event} event */
    const stop = (event) => {
      event.preventDefault();
      event.stopPropagation();
    };
    let pointer = -1;
    grip.addEventListener("pointerdown", (event) => {
      stop(event);
      grip.focus();
      pointer = event.pointerId;
      takePointer(grip, event, { name: say("edit-mass", { number: String(mass) }), always: true });
    });
    grip.addEventListener("pointermove", (event) => {
      const at = event.pointerId === pointer ? this.marks.at(event) : null;
      if (at) this.move(mass, [at.x, at.y]);
    });
    for (const kind of /** @type {const} */ (["pointerup", "pointercancel", "lostpointercapture"])) {
      grip.addEventListener(kind, ({ pointerId }) => (pointer = pointerId === pointer ? -1 : pointer));
    }
    grip.addEventListener("keydown", (event) => {
      const way = ARROWS[event.key];
      if (!way) return;
      stop(event);
      const step = KEY_STEP / this.step / (event.shiftKey ? 10 : 1);
      const [x, y] = this.places[mass];
      this.move(mass, [x + way[0] * step, y + way[1] * step]);
    });
    return grip;
  }

  /** @param {number} mass @param {Place} to */
  move(mass, to) {
    drag(this.places, mass, to, this.springs, this.held);
    this.moved = true;
    this.last = mass;
    this.marks.redraw();
    this.changed();
  }
}

/** How far something was moved, along the way that is longer. @param {number} right @param {number} down @param {string} unit of both */
export function movedText(right, down, unit) {
  const isUpright = Math.abs(down) >= Math.abs(right), by = isUpright ? down : right;
  const length = `${decimal(String(Number(Math.abs(by).toPrecision(3))))} ${unit}`;
  if (isUpright) return say(by > 0 ? "class-moved.lower" : "class-moved.higher", { length });
  return say(by > 0 ? "class-moved.right" : "class-moved.left", { length });
}

/** Bodies with more free masses than this have a disc at the last one only. */
const FEW = 6;
/** Of more predictions than this, nothing but rings is drawn where masses are asked for. */
const FEW_OUTLINES = 3;
/** Smallest radius of a disc, px: the last row sees it. */
const LEAST_DISC = 7;

/** The free masses of a body that predictions show as discs: those that were asked for. @param {Plan} plan @param {number[]} asked */
export function tipsOf({ radius, pinned, driven }, asked) {
  const held = new Set([...pinned, driven]);
  const free = Array.from(radius.keys()).filter((mass) => !held.has(mass));
  const wanted = free.filter((mass) => asked.includes(mass));
  if (wanted.length && wanted.length <= FEW) return wanted;
  return free.length > FEW ? free.slice(-1) : free;
}

/** Draws the predictions of a class: pale bodies, with a disc at each free mass; of many, as little as lets the body be seen. */
export class Predictions {
  svg = makeSvg("svg", "softrod-marks softrod-predictions");
  /** @type {Place[][]} */
  bodies = [];
  /** @type {number[]} */
  asked = [];

  /** @param {Marks} marks */
  constructor(marks) {
    this.marks = marks;
    marks.onRedraw((seen) => this.draw(seen));
  }

  /** @param {Place[][]} bodies @param {number[]} [asked] the masses that were asked for; none for all */
  show(bodies, asked = []) {
    this.bodies = bodies;
    this.asked = asked;
    this.svg.replaceChildren(...bodies.map(() => makeSvg("path", "")));
    this.svg.classList.toggle("softrod-many", bodies.length > FEW_OUTLINES);
    if (bodies.length && !this.svg.parentNode) this.marks.insert(this.svg);
    if (!bodies.length) this.svg.remove();
    this.marks.redraw();
  }

  /** @param {Sight} seen */
  draw(seen) {
    const { plan, on } = seen;
    const tips = tipsOf(plan, this.asked);
    const isBare = this.bodies.length > FEW_OUTLINES && tips.every((mass) => this.asked.includes(mass));
    this.bodies.forEach((places, i) => {
      const discs = tips.filter((mass) => places[mass]).map((mass) => {
        const [x, y] = places[mass], r = Math.max(plan.radius[mass] * on.step, LEAST_DISC);
        return `M${(on.x + x * on.step - r).toFixed(1)} ${(on.y - y * on.step).toFixed(1)}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0`;
      });
      set(this.svg.children[i], { d: (isBare ? "" : outline(places, seen)) + discs.join("") });
    });
  }
}
