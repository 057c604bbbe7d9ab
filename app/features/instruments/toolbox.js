// @ts-check
/**
 * Ruler, protractor, stopwatch and light gate: they are dragged out of a box onto the canvas, moved there by pointer or keys, and
 * thrown back into it. The tab's storage has them; they are not part of the scene.
 *
 * @typedef {import("./shapes.js").Kind} Kind
 * @typedef {import("./shapes.js").Place} Place
 * @typedef {import("../../stage/sight.js").Sight} Sight
 * @typedef {import("./shapes.js").Placed & {face: import("./faces.js").Face}} Instrument
 */
import { Box } from "./box.js";
import { NAMES, newFace } from "./faces.js";
import { Gate } from "./gate.js";
import * as shapes from "./shapes.js";
import { has, onMessage, pageState } from "../../wire/channel.js";
import { COMMANDS } from "../../wire/commands.js";
import { make, overCanvas } from "../../ui/dialog.js";
import { ARROWS } from "../../ui/hands/arrow_keys.js";
import { printed } from "../../ui/hands/key_table.js";
import { isFree } from "../../ui/hands/keys.js";
import { takePointer } from "../../ui/hands/take.js";
import { onFrame, shown } from "../../stage/canvas.js";
import { onMarksRedraw, redrawMarks, sight } from "../../stage/sight.js";
import { makeSvg } from "../../stage/svg.js";
import { kept, store } from "../../ui/kept/storage.js";
import { timeNow } from "../../ui/clock.js";
import { viserCanvas } from "../../ui/viser/viser.js";
import { say } from "../../words/words.js";

const STORED = "softrod-instruments";
/** Pixels by which an arrow key moves a point. */
const STEP = 1;
/** The same with Shift. */
const LARGE_STEP = 10;
/** Milliseconds between two updates of a stopwatch that runs while the body is at rest. */
const TICK = 100;
/** Milliseconds without a movement after which a reading is announced. */
const ANNOUNCE_AFTER = 300;

/** Where its points are when it is placed: pixels from its middle. @type {Record<Kind, [number, number][]>} */
const LAYOUT = { ruler: [[-70, 0], [70, 0]], protractor: [[90, 0], [0, 0], [45, -78]], stopwatch: [[0, 0]], gate: [[0, -60], [0, 60]] };
/** Where it is placed without a pointer: fractions of the canvas's width and height. @type {Record<Kind, [number, number]>} */
const FIRST = { ruler: [0.6, 0.7], protractor: [0.36, 0.5], stopwatch: [0.7, 0.3], gate: [0.5, 0.45] };

/** The instruments of a page. */
class Instruments {
  /** Those on the canvas. @type {Map<Kind, Instrument>} */
  placed = new Map();
  /** Those that a pointer moves. @type {Set<Instrument>} */
  dragged = new Set();
  /** @type {Sight | null} */
  seen = null;
  /** The timer of the next announcement. */
  announcing = 0;

  constructor() {
    this.svg = makeSvg("svg", "softrod-marks softrod-instruments");
    this.svg.removeAttribute("aria-hidden");
    this.svg.setAttribute("role", "group");
    this.svg.setAttribute("aria-label", say("instruments-box"));
    this.live = make("div", "softrod-tell");
    this.live.setAttribute("role", "status");
    this.box = new Box((kind, event, button) => this.take(kind, event, button), (kind) => this.toggle(kind));
    overCanvas().append(this.svg, this.live);
    // The wheel zooms, whatever is under it.
    this.svg.addEventListener("wheel", (event) => {
      event.preventDefault();
      viserCanvas()?.dispatchEvent(new WheelEvent("wheel", event));
    });
  }

  // ------------------------------------------------------------------- on the canvas and in the box
  /** Puts an instrument onto the canvas. @param {Kind} kind @param {shapes.Point[]} points @param {shapes.Watch} [watch] */
  add(kind, points, watch = shapes.newWatch()) {
    const instrument = {
      kind,
      points,
      face: newFace(this.svg, kind),
      ...(kind === "stopwatch" ? { watch } : {}),
      ...(kind === "gate" ? { gate: new Gate() } : {}),
    };
    this.placed.set(kind, instrument);
    this.listen(instrument);
    this.draw(instrument);
    this.box.show(this.placed);
    return instrument;
  }

  /** Puts an instrument onto the canvas, around a place. @param {Kind} kind @param {Place} at */
  addAt(kind, at) {
    if (!this.seen) return null;
    const { on } = this.seen;
    return this.add(kind, LAYOUT[kind].map(([x, y]) => shapes.pointAt({ x: at.x + x, y: at.y + y }, new Float64Array(), on)));
  }

  /** Puts an instrument back into the box. @param {Kind} kind */
  remove(kind) {
    this.placed.get(kind)?.face.group.remove();
    this.placed.delete(kind);
    this.box.show(this.placed);
    this.changed(kind);
  }

  /** Drags an instrument out of the box. @param {Kind} kind @param {PointerEvent} event @param {Element} button */
  take(kind, event, button) {
    const instrument = this.placed.get(kind) ?? this.addAt(kind, { x: event.clientX, y: event.clientY });
    if (instrument) this.drag(instrument, event, button, kind === "stopwatch" ? 0 : -1);
  }

  /** Puts an instrument onto the canvas, or back into the box. @param {Kind} kind */
  toggle(kind) {
    if (this.placed.has(kind)) this.remove(kind);
    else if (this.seen) {
      const { left, right, top } = this.seen.box;
      // Above the bar of time, below which a phone has the panel.
      const bottom = Math.min(this.seen.box.bottom, this.box.element.getBoundingClientRect().bottom);
      const [across, down] = FIRST[kind];
      const instrument = this.addAt(kind, { x: left + across * (right - left), y: top + down * (bottom - top) });
      this.changed(kind);
      // A keyboard user continues with the instrument; after a click the keys are for the body.
      if (instrument && document.activeElement?.matches(":focus-visible")) instrument.face.grips[0].focus();
    }
  }

  /** Stores the instruments, and announces a reading once it stays. @param {Kind} kind of the one that changed */
  changed(kind) {
    store(STORED, JSON.stringify([...this.placed.values()].map(({ kind, points, watch }) => ({ kind, points, watch }))));
    clearTimeout(this.announcing);
    this.announcing = setTimeout(() => {
      const { face } = this.placed.get(kind) ?? {};
      this.live.textContent = face ? (face.group.ariaLabel ?? "") : say("instruments-away", { instrument: say(NAMES[kind]) });
    }, ANNOUNCE_AFTER);
  }

  /** @param {Instrument} instrument */
  draw(instrument) {
    if (!this.seen) return;
    const size = parseFloat(getComputedStyle(this.svg).fontSize);
    const { face, kind, points } = instrument;
    const reading = face.draw(instrument, this.seen, shapes.placesOf(points, this.seen.places, this.seen.on), size);
    const label = say("instruments-reads", { instrument: say(NAMES[kind]), reading });
    if (face.group.ariaLabel !== label) face.group.ariaLabel = label;
  }

  /** @param {Sight} seen */
  look(seen) {
    this.seen = seen;
    this.box.place(seen.box);
    this.placed.forEach((instrument) => this.draw(instrument));
  }

  // ------------------------------------------------------------------- by pointer and keys
  /** @param {Instrument} instrument */
  listen(instrument) {
    const { face, kind } = instrument;
    const whole = kind === "stopwatch" ? 0 : -1;
    const body = /** @type {SVGElement} */ (face.body);
    body.addEventListener("pointerdown", (event) => this.drag(instrument, event, body, whole));
    face.grips.forEach((grip, index) => {
      if (whole < 0) grip.addEventListener("pointerdown", (event) => this.drag(instrument, event, grip, index));
      grip.addEventListener("keydown", (event) => this.press(instrument, index, event));
    });
    face.buttons.forEach((button, index) => {
      button.addEventListener("click", () => this.pressWatch(index));
      button.addEventListener("keydown", (event) => {
        if (event.code !== "Space" && event.key !== "Enter") return;
        event.preventDefault();
        if (!event.repeat) this.pressWatch(index);
      });
    });
  }

  /**
   * Moves an instrument, or one point of it, with the pointer until it is released.
   *
   * @param {Instrument} instrument
   * @param {PointerEvent} start
   * @param {Element} target that gets the pointer's events
   * @param {number} index of the point, or -1 for all
   */
  drag(instrument, start, target, index) {
    if (!this.seen || this.dragged.has(instrument) || start.button > 0) return;
    this.dragged.add(instrument);
    start.preventDefault();
    const from = shapes.placesOf(instrument.points, this.seen.places, this.seen.on);
    takePointer(target, start, { name: say(NAMES[instrument.kind]), at: from[index] });
    const reach = index >= 0 && instrument.kind !== "stopwatch" ? shapes.SNAP : -1;
    /** @param {any} event of the pointer */
    const move = (event) => {
      if (event.pointerId !== start.pointerId || !this.seen) return;
      const { places, on } = this.seen;
      const [dx, dy] = [event.clientX - start.clientX, event.clientY - start.clientY];
      from.forEach(({ x, y }, i) => {
        if (index < 0 || i === index) instrument.points[i] = shapes.pointAt({ x: x + dx, y: y + dy }, places, on, reach);
      });
      this.box.welcome(this.box.isUnder(event));
      this.draw(instrument);
    };
    /** @param {any} event of the pointer */
    const end = (event) => {
      if (event.pointerId !== start.pointerId) return;
      target.removeEventListener("pointermove", move);
      for (const type of ["pointerup", "pointercancel"]) target.removeEventListener(type, end);
      this.dragged.delete(instrument);
      this.box.welcome(false);
      if (this.box.isUnder(event)) this.remove(instrument.kind);
      else this.changed(instrument.kind);
    };
    target.addEventListener("pointermove", move);
    for (const type of ["pointerup", "pointercancel"]) target.addEventListener(type, end);
  }

  /** A key on a grip. @param {Instrument} instrument @param {number} index of its point @param {KeyboardEvent} event */
  press(instrument, index, event) {
    if (!this.seen || event.ctrlKey || event.metaKey || event.altKey) return;
    const { places, on } = this.seen;
    const point = instrument.points[index];
    const arrow = ARROWS[event.key];
    if (event.key === "Delete" || event.key === "Backspace") {
      this.remove(instrument.kind);
      this.box.focus(instrument.kind);
    } else if (arrow && point.mass >= 0) {
      const count = places.length / 2;
      point.mass = (point.mass + (arrow[0] - arrow[1] > 0 ? 1 : count - 1)) % count;
    } else if (arrow) {
      const by = (event.shiftKey ? LARGE_STEP : STEP) / on.step;
      point.x += arrow[0] * by;
      point.y += arrow[1] * by;
    } else if ((event.key === "Enter" || event.code === "Space") && instrument.kind !== "stopwatch") {
      const [at] = shapes.placesOf([{ ...point }], places, on);
      instrument.points[index] = point.mass < 0 ? shapes.pointAt(at, places, on, Infinity) : { ...point, mass: -1 };
    } else return;
    event.preventDefault();
    event.stopPropagation();
    if (!this.placed.has(instrument.kind)) return;
    this.draw(instrument);
    this.changed(instrument.kind);
  }

  /** Presses a button of the stopwatch, if it is there. @param {number} index 0 starts and stops, 1 is for laps and zero */
  pressWatch(index) {
    const instrument = this.placed.get("stopwatch");
    if (!instrument?.watch) return false;
    instrument.watch = (index === 0 ? shapes.startOrStop : shapes.lapOrZero)(instrument.watch, timeNow());
    this.draw(instrument);
    this.changed("stopwatch");
    return true;
  }
}

/** Has the light gate follow the body. @param {Instruments} instruments */
function watchGate(instruments) {
  const gate = () => instruments.placed.get("gate");
  onFrame((frame) => {
    const { plan } = shown();
    const { gate: crossed, points } = gate() ?? {};
    if (crossed && points && plan?.generation === frame.generation) crossed.add(frame, plan, points);
  });
  let { scene } = pageState();
  onMessage("pageState", () => {
    if (pageState().scene !== scene) gate()?.gate?.clear();
    ({ scene } = pageState());
  });
}

/** Adds the box, and the instruments that were on the canvas before the page was loaded. */
export function addInstruments() {
  const instruments = new Instruments();
  window.addEventListener("keydown", (event) => {
    const index = COMMANDS.stopwatch.keys.indexOf(printed(event));
    if (index < 0 || event.repeat || event.shiftKey || !isFree(event)) return;
    if (instruments.pressWatch(index)) event.preventDefault();
  });
  watchGate(instruments);
  onMarksRedraw((seen) => instruments.look(seen));
  setInterval(() => {
    const watch = instruments.placed.get("stopwatch");
    if (watch?.watch?.since != null) instruments.draw(watch);
  }, TICK);
  const show = () => {
    const isOffered = has("tools");
    instruments.box.element.hidden = !isOffered;
    instruments.svg.style.display = isOffered ? "" : "none";
  };
  onMessage("pageState", show);
  show();
  onMessage("putBack", () => [...instruments.placed.keys()].forEach((kind) => instruments.remove(kind)));
  for (const { kind, points, watch } of shapes.restored(kept(STORED))) instruments.add(kind, points, watch);
  instruments.seen = sight();
  redrawMarks();
}
