// @ts-check
/**
 * A box of instruments: ruler, protractor, stopwatch. They are dragged out of it onto the canvas, moved there by pointer
 * or keys, and thrown back into it. The tab's storage keeps them; they are no part of the scene.
 *
 * @typedef {import("./shapes.js").Kind} Kind
 * @typedef {import("./shapes.js").Kept} Kept
 * @typedef {import("./shapes.js").Place} Place
 * @typedef {import("../../stage/sight.js").Sight} Sight
 * @typedef {Kept & {face: import("./faces.js").Face}} Instrument
 */
import { NAMES, newFace } from "./faces.js";
import * as shapes from "./shapes.js";
import { has, onMessage } from "../../wire/channel.js";
import { COMMANDS } from "../../wire/commands.js";
import { printed } from "../../ui/hands/key_table.js";
import { isFree } from "../../ui/hands/keys.js";
import { hasWords, keepInView } from "../../ui/looks.js";
import { onMarksRedraw, redrawMarks, sight } from "../../stage/sight.js";
import { SVG } from "../../stage/svg.js";
import { kept, store } from "../../ui/kept/storage.js";
import { timeNow } from "../../ui/clock.js";
import { viserCanvas } from "../../ui/viser/viser.js";

const STORED = "softrod-instruments";
/** Pixels after which a press on an instrument in the box drags it out. */
const DRAG = 6;
/** Pixels that an arrow key moves a point, and with Shift. */
const [STEP, FAR] = [1, 10];
/** Milliseconds between two readings of a stopwatch that runs while the body is at rest. */
const TICK = 100;

/** @type {Record<string, [number, number]>} */
const MOVES = { ArrowUp: [0, -1], ArrowDown: [0, 1], ArrowLeft: [-1, 0], ArrowRight: [1, 0] };
/** Where the points are when it is put down, pixels. @type {Record<Kind, [number, number][]>} */
const LAID = { ruler: [[-70, 0], [70, 0]], protractor: [[90, 0], [0, 0], [45, -78]], stopwatch: [[0, 0]] };
/** Where on the canvas each is laid, without a pointer that says it: parts of its width and height. @type {Record<Kind, [number, number]>} */
const FIRST = { ruler: [0.6, 0.7], protractor: [0.36, 0.5], stopwatch: [0.7, 0.3] };
/** Outlines of 24 by 24, as strokes. @type {Record<Kind | "box", string>} */
const ICONS = {
  box: "M3 9h18v11H3zM9 9V5h6v4M3 14h18M12 12v4",
  ruler: "M3 15 15 3l6 6L9 21zM7 11l2 2M10 8l3 3M13 5l2 2",
  protractor: "M3 18a9 9 0 0 1 18 0zM12 18l5-7M12 18H8",
  stopwatch: "M12 21a8 8 0 1 0 0-16 8 8 0 0 0 0 16zM12 13l3-3M10 2h4",
};

/** @param {Kind | "box"} name */
const icon = (name) => `<svg viewBox="0 0 24 24" aria-hidden="true"><path d="${ICONS[name]}"/></svg>`;

/** Puts up the box, and the instruments that were on the canvas before the page was loaded. */
export function addInstruments() {
  const svg = document.createElementNS(SVG, "svg");
  svg.classList.add("softrod-marks", "softrod-instruments");
  const live = document.createElement("div");
  live.className = "softrod-tell";
  live.setAttribute("role", "status");
  /** @type {Map<Kind, Instrument>} */
  const out = new Map();
  const box = addBox();
  document.body.append(svg, live);

  /** @type {Sight | null} */
  let seen = null;
  const keep = () =>
    store(STORED, JSON.stringify([...out.values()].map(({ kind, points, watch }) => ({ kind, points, watch }))));
  let saying = 0;
  /** Says what an instrument reads, once it is not moved any more. @param {Kind} kind */
  const say = (kind) => {
    clearTimeout(saying);
    saying = setTimeout(() => {
      const { face } = out.get(kind) ?? {};
      live.textContent = face ? (face.group.getAttribute("aria-label") ?? "") : `${NAMES[kind]} back in the box`;
    }, 300);
  };

  /** @param {Instrument} instrument */
  const drawOne = (instrument) => {
    if (!seen) return;
    const size = parseFloat(getComputedStyle(svg).fontSize);
    const { face, kind, points } = instrument;
    const reading = face.draw(instrument, seen, shapes.placesOf(points, seen.places, seen.on), size);
    const label = `${NAMES[kind]}: ${reading}`;
    if (face.group.getAttribute("aria-label") !== label) face.group.setAttribute("aria-label", label);
  };
  /** @param {Kind} kind @param {Kept["points"]} points @param {Kept["watch"]} [watch] */
  const lay = (kind, points, watch = shapes.newWatch()) => {
    const instrument = { kind, points, face: newFace(svg, kind), ...(kind === "stopwatch" ? { watch } : {}) };
    out.set(kind, instrument);
    listen(instrument);
    drawOne(instrument);
    box.show(out);
    return instrument;
  };
  /** Back into the box. @param {Kind} kind */
  const putAway = (kind) => {
    out.get(kind)?.face.group.remove();
    out.delete(kind);
    box.show(out);
    keep();
    say(kind);
  };
  /** Onto the canvas, around a place. @param {Kind} kind @param {Place} at */
  const layAt = (kind, at) => {
    if (!seen) return null;
    const { on } = seen;
    return lay(kind, LAID[kind].map(([x, y]) => shapes.pointAt({ x: at.x + x, y: at.y + y }, new Float64Array(), on)));
  };

  /** Those that a pointer moves. @type {Set<Instrument>} */
  const led = new Set();
  /**
   * Moves an instrument, or one point of it, with the pointer until that is let go.
   *
   * @param {Instrument} instrument
   * @param {PointerEvent} event that began it
   * @param {Element} target that gets the pointer's events
   * @param {number} index of the point, or -1 for all
   */
  const drag = (instrument, event, target, index) => {
    if (!seen || led.has(instrument) || event.button > 0) return;
    led.add(instrument);
    event.preventDefault();
    target.setPointerCapture(event.pointerId);
    const begun = shapes.placesOf(instrument.points, seen.places, seen.on);
    /** @param {PointerEvent} now */
    const move = (now) => {
      if (now.pointerId !== event.pointerId || !seen) return;
      const [dx, dy] = [now.clientX - event.clientX, now.clientY - event.clientY];
      begun.forEach(({ x, y }, i) => {
        const reach = i === index && instrument.kind !== "stopwatch" ? shapes.SNAP : -1;
        if (!seen || (index >= 0 && i !== index)) return;
        instrument.points[i] = shapes.pointAt({ x: x + dx, y: y + dy }, seen.places, seen.on, reach);
      });
      box.welcome(box.isOver(now));
      drawOne(instrument);
    };
    /** @param {PointerEvent} now */
    const end = (now) => {
      if (now.pointerId !== event.pointerId) return;
      for (const kind of ["pointermove", "pointerup", "pointercancel"]) target.removeEventListener(kind, listeners[kind]);
      led.delete(instrument);
      box.welcome(false);
      if (box.isOver(now)) putAway(instrument.kind);
      else {
        keep();
        say(instrument.kind);
      }
    };
    /** @type {Record<string, any>} */
    const listeners = { pointermove: move, pointerup: end, pointercancel: end };
    for (const [kind, listener] of Object.entries(listeners)) target.addEventListener(kind, listener);
  };

  /** @param {Instrument} instrument @param {number} index @param {KeyboardEvent} event */
  const pressed = (instrument, index, event) => {
    if (!seen || event.ctrlKey || event.metaKey || event.altKey) return;
    const { places, on } = seen;
    const point = instrument.points[index];
    const way = MOVES[event.key];
    const isWatch = instrument.kind === "stopwatch";
    if (event.key === "Delete" || event.key === "Backspace") {
      putAway(instrument.kind);
      box.focus(instrument.kind);
    } else if (way && point.mass >= 0) {
      const count = places.length / 2;
      point.mass = (point.mass + (way[0] + way[1] > 0 ? 1 : count - 1)) % count;
    } else if (way) {
      const by = event.shiftKey ? FAR : STEP;
      point.x += (way[0] * by) / on.step;
      point.y -= (way[1] * by) / on.step;
    } else if ((event.key === "Enter" || event.code === "Space") && !isWatch) {
      const [at] = shapes.placesOf([{ ...point }], places, on);
      instrument.points[index] = point.mass < 0 ? shapes.pointAt(at, places, on, Infinity) : { ...point, mass: -1 };
    } else return;
    event.preventDefault();
    event.stopPropagation();
    if (!out.has(instrument.kind)) return;
    drawOne(instrument);
    keep();
    say(instrument.kind);
  };

  /** Presses a button of the stopwatch. @param {number} index 0 starts and stops, 1 is for laps and zero */
  const time = (index) => {
    const watch = out.get("stopwatch");
    if (!watch?.watch) return false;
    watch.watch = (index === 0 ? shapes.startOrStop : shapes.lapOrZero)(watch.watch, timeNow());
    drawOne(watch);
    keep();
    say("stopwatch");
    return true;
  };

  /** @param {Instrument} instrument */
  const listen = (instrument) => {
    const { face, kind } = instrument;
    const whole = kind === "stopwatch" ? 0 : -1;
    face.body.addEventListener("pointerdown", (event) => drag(instrument, event, face.body, whole));
    face.grips.forEach((grip, index) => {
      if (whole < 0) grip.addEventListener("pointerdown", (event) => drag(instrument, event, grip, index));
      grip.addEventListener("keydown", (event) => pressed(instrument, index, event));
    });
    face.buttons.forEach((button, index) => {
      button.addEventListener("click", () => time(index));
      button.addEventListener("keydown", (event) => {
        if (event.code !== "Space" && event.key !== "Enter") return;
        event.preventDefault();
        if (!event.repeat) time(index);
      });
    });
  };

  box.onTake((kind, event, button) => {
    const instrument = out.get(kind) ?? layAt(kind, { x: event.clientX, y: event.clientY });
    if (instrument) drag(instrument, event, button, kind === "stopwatch" ? 0 : -1);
  });
  box.onPress((kind) => {
    if (out.has(kind)) putAway(kind);
    else if (seen) {
      const { left, right, top } = seen.box;
      // Above the bar of time, below which a phone has the panel.
      const bottom = Math.min(seen.box.bottom, box.bottom());
      const [part, down] = FIRST[kind];
      const instrument = layAt(kind, { x: left + part * (right - left), y: top + down * (bottom - top) });
      keep();
      say(kind);
      // Who goes by keys goes on with it; after a click the keys are the body's.
      if (instrument && document.activeElement?.matches(":focus-visible")) instrument.face.grips[0].focus();
    }
  });
  window.addEventListener("keydown", (event) => {
    const index = COMMANDS.stopwatch.keys.indexOf(printed(event));
    if (index < 0 || event.repeat || event.shiftKey || !isFree(event)) return;
    if (time(index)) event.preventDefault();
  });
  // The wheel zooms, whatever is under it.
  svg.addEventListener("wheel", (event) => {
    event.preventDefault();
    viserCanvas()?.dispatchEvent(new WheelEvent("wheel", event));
  });
  onMarksRedraw((now) => {
    seen = now;
    box.place(now.box);
    for (const instrument of out.values()) drawOne(instrument);
  });
  setInterval(() => {
    const watch = out.get("stopwatch");
    if (watch?.watch?.since != null) drawOne(watch);
  }, TICK);
  const show = () => {
    const isOffered = has("tools");
    box.offer(isOffered);
    svg.style.display = isOffered ? "" : "none";
  };
  onMessage("pageState", show);
  show();
  for (const { kind, points, watch } of shapes.restored(kept(STORED))) lay(kind, points, watch);
  seen = sight();
  redrawMarks();
}

/** The box: a button, and what is in it. */
function addBox() {
  const element = document.createElement("div");
  element.className = "softrod-box";
  element.innerHTML = `<div class="softrod-box-tools" id="softrod-box-tools" role="group" aria-label="Instruments" hidden></div>
    <button type="button" class="softrod-box-lid" aria-expanded="false" aria-controls="softrod-box-tools"
      aria-label="Instruments" title="Instruments: ruler, protractor, stopwatch">${icon("box")}<span>Instruments</span></button>`;
  document.body.append(element);
  const content = /** @type {HTMLElement} */ (element.firstElementChild);
  const lid = /** @type {HTMLButtonElement} */ (element.lastElementChild);
  /** @type {(kind: Kind, event: PointerEvent, button: Element) => void} */
  let take = () => {};
  /** @type {(kind: Kind) => void} */
  let press = () => {};
  /** @param {boolean} open */
  const open = (open) => {
    content.hidden = !open;
    element.toggleAttribute("data-open", open);
    lid.ariaExpanded = String(open);
    if (open) keepInView(content);
  };
  lid.addEventListener("click", () => open(content.hidden === true));
  element.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || content.hidden) return;
    event.stopPropagation();
    open(false);
    lid.focus();
  });
  /** @type {Map<Kind, HTMLButtonElement>} */
  const buttons = new Map();
  for (const kind of /** @type {Kind[]} */ (["ruler", "protractor", "stopwatch"])) {
    const button = document.createElement("button");
    button.type = "button";
    button.ariaPressed = "false";
    button.title = "Drag it onto the canvas, and back into the box";
    button.innerHTML = `${icon(kind)}<span>${NAMES[kind]}</span>`;
    /** The press that may drag it out. @type {PointerEvent | null} */
    let begun = null;
    let dragged = false;
    button.addEventListener("pointerdown", (event) => {
      [begun, dragged] = [event.button === 0 ? event : null, false];
      button.setPointerCapture(event.pointerId);
    });
    button.addEventListener("pointermove", (event) => {
      if (begun?.pointerId !== event.pointerId || Math.hypot(event.clientX - begun.clientX, event.clientY - begun.clientY) < DRAG) return;
      [begun, dragged] = [null, true];
      take(kind, event, button);
    });
    for (const kind of /** @type {const} */ (["pointerup", "pointercancel"])) button.addEventListener(kind, () => (begun = null));
    button.addEventListener("click", () => {
      if (!dragged) press(kind);
      dragged = false;
      // The keys are the body's again, unless somebody goes by keys.
      if (!button.matches(":focus-visible")) button.blur();
    });
    buttons.set(kind, button);
    content.append(button);
  }
  return {
    /** @param {typeof take} listener */
    onTake: (listener) => (take = listener),
    /** @param {typeof press} listener */
    onPress: (listener) => (press = listener),
    /** Whether the page has it. @param {boolean} on */
    offer: (on) => (element.hidden = !on),
    /** Which instruments are out. @param {Map<Kind, unknown>} out */
    show: (out) => buttons.forEach((button, kind) => (button.ariaPressed = String(out.has(kind)))),
    /** @param {Kind} kind */
    focus: (kind) => (content.hidden ? lid : buttons.get(kind))?.focus(),
    /** @param {{clientX: number, clientY: number}} event */
    isOver({ clientX, clientY }) {
      const { left, right, top, bottom } = element.getBoundingClientRect();
      return clientX >= left && clientX <= right && clientY >= top && clientY <= bottom;
    },
    /** Shows that what is dragged would go back. @param {boolean} on */
    welcome: (on) => element.classList.toggle("softrod-box-welcome", on),
    /** Where it stands, pixels. */
    bottom: () => element.getBoundingClientRect().bottom,
    /** At the left of the canvas, over the bar of time. @param {DOMRect} canvas */
    place(canvas) {
      const dock = document.querySelector(".softrod-dock")?.getBoundingClientRect();
      const bottom = Math.min(canvas.bottom, dock?.top ?? Infinity);
      element.classList.toggle("softrod-words", hasWords(canvas));
      element.style.left = `${canvas.left + 14}px`;
      element.style.bottom = `${window.innerHeight - bottom + 10}px`;
      if (!content.hidden) keepInView(content);
    },
  };
}
