// @ts-check
/**
 * A prediction: a pale copy of the body that a pupil drags to where the body will be. Where one mass is dragged, the
 * others follow as a chain of springs without weight would: each spring is brought back towards its length, again and
 * again (Jakobsen 2001, Advanced Character Physics).
 */
import { insertMarksLayer, onMarksRedraw, redrawMarks } from "../../stage/sight.js";
import { SVG } from "../../stage/svg.js";
import { screen, worldAt, wireNumber } from "../../stage/screen.js";

/** @typedef {import("../../stage/sight.js").Sight} Sight */
/** @typedef {[number, number]} Place in the page's world */

/** How often every spring is brought towards its length for one movement of the pointer. */
const ROUNDS = 30;
/** How far an arrow key moves a mass, px of the screen; with Shift, ten times less. */
const KEY_STEP = 20;
/** Radius of what takes a finger, px. */
const REACH = 22;
/** Bodies of more masses than this have a grip at every so many only. */
const MAX_GRIPS = 40;

/**
 * Moves one mass of a body, and lets the others follow.
 *
 * @param {Place[]} places of the masses; changed
 * @param {number} mass
 * @param {Place} to
 * @param {[number, number, number][]} springs the masses that each joins, and its length
 * @param {Set<number>} held masses that stay
 */
export function drag(places, mass, to, springs, held) {
  places[mass] = to;
  for (let round = 0; round < ROUNDS; round++) {
    for (const [a, b, length] of springs) {
      const [mayA, mayB] = [a !== mass && !held.has(a), b !== mass && !held.has(b)];
      if (!mayA && !mayB) continue;
      const [dx, dy] = [places[b][0] - places[a][0], places[b][1] - places[a][1]];
      const distance = Math.hypot(dx, dy) || 1e-9;
      const share = (distance - length) / distance / (mayA && mayB ? 2 : 1);
      if (mayA) places[a] = [places[a][0] + share * dx, places[a][1] + share * dy];
      if (mayB) places[b] = [places[b][0] - share * dx, places[b][1] - share * dy];
    }
  }
}

/** The springs of a body as it is now, in the page's world. @param {Sight} seen @returns {[number, number, number][]} */
function springsOf({ plan, frame }) {
  const { positions } = frame;
  return Array.from({ length: plan.springs.length / 2 }, (_, i) => {
    const [a, b] = [plan.springs[2 * i], plan.springs[2 * i + 1]];
    const length = Math.hypot(positions[2 * b] - positions[2 * a], positions[2 * b + 1] - positions[2 * a + 1]);
    return [a, b, length * plan.scale];
  });
}

/** The places of a body's masses in the page's world. @param {Sight} seen @returns {Place[]} */
const placesOf = ({ plan, frame }) =>
  Array.from(plan.radius, (_, i) => [
    (frame.positions[2 * i] - plan.x) * plan.scale,
    (frame.positions[2 * i + 1] - plan.y) * plan.scale * plan.flip,
  ]);

/** @param {Place[]} places @param {number[] | Uint32Array | Float32Array} springs @param {import("../../stage/screen.js").Screen} on */
export const outline = (places, springs, on) => {
  /** @param {number} i */
  const at = (i) => `${(on.x + places[i][0] * on.step).toFixed(1)} ${(on.y - places[i][1] * on.step).toFixed(1)}`;
  let path = "";
  for (let i = 0; i < springs.length; i += 2) {
    if (places[springs[i]] && places[springs[i + 1]]) path += `M${at(springs[i])}L${at(springs[i + 1])}`;
  }
  return path;
};

/** The ghost that is dragged. */
export class OwnGhost {
  /** @param {() => void} changed called when it was moved */
  constructor(changed) {
    this.changed = changed;
    /** @type {Place[]} */
    this.places = [];
    this.moved = false;
    this.on = false;
    this.svg = document.createElementNS(SVG, "svg");
    this.svg.classList.add("softrod-marks", "softrod-own-ghost");
    this.path = document.createElementNS(SVG, "path");
    this.svg.append(this.path);
    /** @type {SVGCircleElement[]} */
    this.grips = [];
    /** @type {[number, number, number][]} */
    this.springs = [];
    /** @type {Set<number>} */
    this.held = new Set();
    onMarksRedraw((seen) => this.draw(seen));
  }

  /** Begins a prediction where the body is, or ends it. @param {boolean} on */
  show(on) {
    if (on === this.on) return;
    this.on = on;
    this.places = [];
    this.moved = false;
    if (on) insertMarksLayer(this.svg);
    else this.svg.remove();
    redrawMarks();
  }

  /** Where it is, for a message. */
  points() {
    return this.places.map(([x, y]) => /** @type {Place} */ ([wireNumber(x), wireNumber(y)]));
  }

  /** @param {Sight} seen */
  draw(seen) {
    if (!this.on) return;
    if (this.places.length !== seen.plan.radius.length) {
      this.places = placesOf(seen);
      this.springs = springsOf(seen);
      this.held = new Set([...seen.plan.pinned, ...(seen.plan.driven >= 0 ? [seen.plan.driven] : [])]);
      this.makeGrips();
    }
    this.path.setAttribute("d", outline(this.places, seen.plan.springs, seen.on));
    for (const grip of this.grips) {
      const [x, y] = this.places[Number(grip.dataset.mass)];
      grip.setAttribute("cx", (seen.on.x + x * seen.on.step).toFixed(1));
      grip.setAttribute("cy", (seen.on.y - y * seen.on.step).toFixed(1));
    }
  }

  makeGrips() {
    for (const grip of this.grips) grip.remove();
    const free = this.places.map((_, i) => i).filter((i) => !this.held.has(i));
    const every = Math.ceil(free.length / MAX_GRIPS);
    const masses = free.filter((_, i) => (free.length - 1 - i) % every === 0);
    this.grips = masses.map((mass) => this.makeGrip(mass, masses.length));
    // The last one, at the free end of a rope, is on top.
    this.svg.append(...this.grips);
  }

  /** @param {number} mass @param {number} of how many there are */
  makeGrip(mass, of) {
    const grip = document.createElementNS(SVG, "circle");
    grip.classList.add("softrod-own-grip");
    grip.dataset.mass = String(mass);
    grip.setAttribute("r", String(of > 12 ? REACH / 2 : REACH));
    grip.setAttribute("tabindex", "0");
    grip.setAttribute("role", "button");
    grip.setAttribute("aria-label", `Mass ${mass} of your prediction: move it with the arrow keys`);
    /** @param {PointerEvent} event */
    const follow = (event) => {
      const on = screen();
      if (!on || !grip.hasPointerCapture(event.pointerId)) return;
      const { x, y } = worldAt({ x: event.clientX, y: event.clientY }, on);
      this.move(mass, [x, y]);
    };
    grip.addEventListener("pointerdown", (event) => {
      event.preventDefault();
      event.stopPropagation();
      grip.focus();
      grip.setPointerCapture(event.pointerId);
    });
    grip.addEventListener("pointermove", follow);
    grip.addEventListener("keydown", (event) => {
      const on = screen();
      const to = { ArrowUp: [0, 1], ArrowDown: [0, -1], ArrowLeft: [-1, 0], ArrowRight: [1, 0] }[event.key];
      if (!to || !on) return;
      event.preventDefault();
      event.stopPropagation();
      const step = KEY_STEP / on.step / (event.shiftKey ? 10 : 1);
      this.move(mass, [this.places[mass][0] + to[0] * step, this.places[mass][1] + to[1] * step]);
    });
    return grip;
  }

  /** @param {number} mass @param {Place} to */
  move(mass, to) {
    drag(this.places, mass, to, this.springs, this.held);
    this.moved = true;
    redrawMarks();
    this.changed();
  }
}

/** Draws the predictions of a class, pale, as they are told. */
export class Ghosts {
  constructor() {
    /** @type {Place[][]} */
    this.bodies = [];
    this.svg = document.createElementNS(SVG, "svg");
    this.svg.classList.add("softrod-marks", "softrod-ghosts");
    this.svg.setAttribute("aria-hidden", "true");
    onMarksRedraw((seen) => this.draw(seen));
  }

  /** @param {Place[][]} bodies */
  show(bodies) {
    this.bodies = bodies;
    if (bodies.length && !this.svg.parentNode) insertMarksLayer(this.svg);
    if (!bodies.length) this.svg.remove();
    redrawMarks();
  }

  /** @param {Sight} seen */
  draw(seen) {
    if (!this.bodies.length) return;
    this.svg.replaceChildren(
      ...this.bodies.map((places) => {
        const path = document.createElementNS(SVG, "path");
        path.setAttribute("d", outline(places, seen.plan.springs, seen.on));
        return path;
      }),
    );
  }
}
