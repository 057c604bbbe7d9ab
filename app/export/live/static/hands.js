// @ts-check
/**
 * Hands on the body of a live file: by mouse, pen and several fingers, and by keys alone while the canvas has the focus.
 *
 * @typedef {Pick<import("./body.js").Body, "masses"> & {positions: ArrayLike<number> & {[i: number]: number},
 *   velocities: {[i: number]: number}, reachable?: (mass: number, x: number, y: number) => number[]}} Moved
 * @typedef {import("./steps.js").Hand} Hand
 * @typedef {import("../../../stage/plan.js").Plan} Plan
 * @typedef {import("../../../stage/environment.js").Screen} Screen
 */
import { KeyHand } from "../../../ui/hands/key_hand.js";
import { placeText } from "../../../stage/measures.js";
import { takePointer } from "../../../ui/hands/take.js";
import { say } from "../../../words/words.js";
import { nearest, onScreen, REACH, worldAt } from "../../../stage/screen.js";
import { element } from "../../static/parts.js";

/** The hand of the keys among those of pointers. */
const KEYS = -1;
/** Pixels between the rim of the mass that the keys have chosen and the ring around it. */
const GAP = 6;

export class Hands {
  /** Where each hand leads its mass, by pointer. @type {Map<number, Hand>} */
  #led = new Map();
  /** Whether the ringed mass follows the pointer. */
  follows = false;
  /** Where the pointer is, px. @type {{x: number, y: number} | null} */
  #pointer = null;
  /** The mass that the keys have chosen, or -1. */
  #chosen = -1;
  #keys;

  /** @param {HTMLCanvasElement} canvas @param {{body: Moved, plan: Plan, place: Screen, unit: string}} shown what is shown now */
  constructor(canvas, shown) {
    this.canvas = canvas;
    this.shown = shown;
    canvas.addEventListener("pointerleave", () => (this.#pointer = null));
    canvas.addEventListener("pointerdown", (event) => this.#press(event));
    canvas.addEventListener("pointermove", (event) => this.#move(event));
    for (const kind of /** @type {const} */ (["pointerup", "pointercancel", "lostpointercapture"])) {
      canvas.addEventListener(kind, ({ pointerId }) => {
        this.#led.delete(pointerId);
        canvas.classList.toggle("holds", this.#led.size > 0);
      });
    }
    // Two fingers of which one holds a mass do not zoom; its pointer is pressed before its touch starts.
    canvas.addEventListener("touchstart", (event) => this.#led.size && event.preventDefault(), { passive: false });
    this.#keys = this.#keyHand();
    canvas.addEventListener("focus", () => canvas.matches(":focus-visible") && this.#keys.focus(shown.plan.driven));
    canvas.addEventListener("blur", () => this.#keys.blur());
    canvas.addEventListener("keydown", (event) => this.#keys.press(event));
  }

  #keyHand() {
    const says = element("says", HTMLElement);
    return new KeyHand({
      count: () => this.shown.body.masses,
      chosen: () => this.#chosen,
      choose: (mass) => (this.#chosen = mass),
      grab: (mass) => {
        this.#grab(KEYS, mass);
        return true;
      },
      move: (x, y) => {
        const { scale, flip } = this.shown.plan;
        const hand = this.#led.get(KEYS);
        if (hand) Object.assign(hand, { x: hand.x + x / scale, y: hand.y + (y / scale) * flip });
      },
      drop: () => this.#led.delete(KEYS),
      where: (mass) => {
        const { positions } = this.shown.body;
        const { x, y } = this.#led.get(KEYS) ?? { x: positions[2 * mass], y: positions[2 * mass + 1] };
        return placeText(x, y, this.shown.unit);
      },
      hint: () => "ui-mass.first",
      say: (text) => (says.textContent = text),
    });
  }

  /** @param {number} hand @param {number} mass */
  #grab(hand, mass) {
    const { positions } = this.shown.body;
    this.#led.set(hand, { mass, x: positions[2 * mass], y: positions[2 * mass + 1] });
  }

  /** Where the masses are in the canvas. */
  #places() {
    const { body, plan, place } = this.shown;
    return onScreen(plan, body.positions, place);
  }

  /** The mass under a pointer, or -1. @param {PointerEvent} event */
  #massAt({ offsetX: x, offsetY: y, pointerType }) {
    const { plan, place } = this.shown;
    const radii = plan.radius.map((radius) => radius * place.step);
    return nearest(this.#places(), radii, { x, y }, REACH[/** @type {"mouse"} */ (pointerType)] ?? REACH.mouse);
  }

  /** Where a pointer is, px. @param {PointerEvent} event */
  #spot({ offsetX, offsetY }) {
    const { plan: { scale, x, y, flip }, place } = this.shown;
    const at = worldAt({ x: offsetX, y: offsetY }, place);
    return { x: x + at.x / scale, y: y + (at.y / scale) * flip };
  }

  /** @param {PointerEvent} event */
  #press(event) {
    if (event.button !== 0) return;
    this.#pointer = this.#spot(event);
    const mass = this.#massAt(event);
    if (mass < 0) return;
    event.preventDefault();
    const { left, top } = this.canvas.getBoundingClientRect(), places = this.#places();
    const at = { x: left + places[2 * mass], y: top + places[2 * mass + 1] };
    takePointer(this.canvas, event, { name: say("edit-mass", { number: String(mass) }), at });
    for (const [hand, { mass: other }] of this.#led) if (other === mass) this.#led.delete(hand);
    this.#grab(event.pointerId, mass);
    this.canvas.classList.add("holds");
  }

  /** @param {PointerEvent} event */
  #move(event) {
    const hand = this.#led.get(event.pointerId);
    this.#pointer = this.#spot(event);
    if (hand) Object.assign(hand, this.#pointer);
    else if (event.pointerType === "mouse") this.canvas.classList.toggle("near", this.#massAt(event) >= 0);
  }

  /** The mass that the keys have chosen, or -1. */
  get chosen() {
    return this.#chosen;
  }

  /** What each hand holds, by pointer; the keys have one, too. */
  get held() {
    return this.#led;
  }

  /** The hands, each with its mass and where that is to be. @returns {Hand[]} */
  get all() {
    const mass = this.shown.plan.driven;
    const follows = this.follows && this.#pointer && mass >= 0 && !this.#led.size;
    return follows ? [{ mass, .../** @type {{x: number, y: number}} */ (this.#pointer) }] : [...this.#led.values()];
  }

  letGo() {
    this.#keys.letGo();
    this.#led.clear();
  }

  /** Put the masses where hands have them, while the clock stands. */
  moveAtOnce() {
    const { positions, velocities } = this.shown.body;
    for (let { mass, x, y } of this.all) {
      // ifdef HAS_RAILS
      if (this.shown.body.reachable) [x, y] = this.shown.body.reachable(mass, x, y);
      // endif
      positions[2 * mass] = x;
      positions[2 * mass + 1] = y;
      velocities[2 * mass] = velocities[2 * mass + 1] = 0;
    }
  }

  /** Mark the mass that the keys have chosen. */
  mark() {
    const to = this.canvas.getContext("2d");
    const mass = this.#chosen;
    if (mass < 0 || !to || document.activeElement !== this.canvas) return;
    const { plan, place } = this.shown;
    const places = this.#places();
    to.beginPath();
    to.arc(places[2 * mass], places[2 * mass + 1], plan.radius[mass] * place.step + GAP, 0, 2 * Math.PI);
    to.lineWidth = this.#led.has(KEYS) ? 4 : 2;
    to.strokeStyle = getComputedStyle(document.documentElement).getPropertyValue("--softrod-brand");
    to.stroke();
  }
}
