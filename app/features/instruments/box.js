// @ts-check
/** The box of instruments: a button, and a list from which instruments are dragged. */
import { NAMES } from "./faces.js";
import { make, makeButton, overCanvas } from "../../ui/dialog.js";
import { hasWords, keepInView } from "../../ui/looks.js";
import { floorOf } from "../../stage/dock.js";
import { sidesOf } from "../../stage/sides.js";
import { say } from "../../words/words.js";

/** @typedef {import("./shapes.js").Kind} Kind */

/** Pixels after which a press on an instrument in the box drags it out. */
const DRAG = 6;
/** Outlines of 24 by 24, as strokes. @type {Record<Kind, string>} */
const ICONS = {
  ruler: "M3 15 15 3l6 6L9 21zM7 11l2 2M10 8l3 3M13 5l2 2",
  protractor: "M3 18a9 9 0 0 1 18 0zM12 18l5-7M12 18H8",
  stopwatch: "M12 21a8 8 0 1 0 0-16 8 8 0 0 0 0 16zM12 13l3-3M10 2h4",
  gate: "M3 5h4v14H3zM17 5h4v14h-4zM9 12h1M12 12h1M15 12h1",
};
const BOX_ICON = "M3 9h18v11H3zM9 9V5h6v4M3 14h18M12 12v4";

/** @param {string} path @param {string} word */
const labelled = (path, word) => `<svg viewBox="0 0 24 24" aria-hidden="true"><path d="${path}"/></svg><span>${word}</span>`;

export class Box {
  /**
   * @param {(kind: Kind, event: PointerEvent, button: Element) => void} take an instrument is dragged out
   * @param {(kind: Kind) => void} press its button is pressed
   */
  constructor(take, press) {
    this.element = make("div", "softrod-box");
    this.content = make("div", "softrod-box-tools softrod-floats");
    this.content.id = "softrod-box-tools";
    this.content.setAttribute("role", "group");
    this.lid = makeButton("", () => this.open(this.content.hidden === true), "softrod-box-lid softrod-floats");
    this.lid.innerHTML = labelled(BOX_ICON, say("instruments-box"));
    this.lid.title = say("instruments-box.hint");
    this.lid.setAttribute("aria-controls", this.content.id);
    this.content.ariaLabel = this.lid.ariaLabel = say("instruments-box");
    this.element.append(this.content, this.lid);
    this.element.addEventListener("keydown", (event) => {
      if (event.key !== "Escape" || this.content.hidden) return;
      event.stopPropagation();
      this.open(false);
      this.lid.focus();
    });
    /** @type {Map<Kind, HTMLButtonElement>} */
    this.buttons = new Map();
    for (const kind of /** @type {Kind[]} */ (Object.keys(ICONS))) this.buttons.set(kind, this.makeTool(kind, take, press));
    this.content.append(...this.buttons.values());
    this.open(false);
    overCanvas().append(this.element);
  }

  /** @param {Kind} kind @param {(kind: Kind, event: PointerEvent, button: Element) => void} take @param {(kind: Kind) => void} press */
  makeTool(kind, take, press) {
    /** The press that may become a drag. @type {PointerEvent | null} */
    let start = null;
    let dragged = false;
    const button = makeButton("", () => {
      if (!dragged) press(kind);
      dragged = false;
      // Return keyboard focus to the body, unless the user navigates by keyboard.
      if (!button.matches(":focus-visible")) button.blur();
    }, "");
    button.ariaPressed = "false";
    button.title = say("instruments-box.drag");
    button.innerHTML = labelled(ICONS[kind], say(NAMES[kind]));
    button.addEventListener("pointerdown", (event) => {
      [start, dragged] = [event.button === 0 ? event : null, false];
      button.setPointerCapture(event.pointerId);
    });
    button.addEventListener("pointermove", (event) => {
      if (start?.pointerId !== event.pointerId || Math.hypot(event.clientX - start.clientX, event.clientY - start.clientY) < DRAG) return;
      [start, dragged] = [null, true];
      take(kind, event, button);
    });
    for (const type of /** @type {const} */ (["pointerup", "pointercancel"])) button.addEventListener(type, () => (start = null));
    return button;
  }

  /** @param {boolean} open */
  open(open) {
    this.content.hidden = !open;
    this.element.toggleAttribute("data-open", open);
    this.lid.ariaExpanded = String(open);
    if (open) keepInView(this.content);
  }

  /** Shows which instruments are on the canvas. @param {Map<Kind, unknown>} placed */
  show(placed) {
    this.buttons.forEach((button, kind) => (button.ariaPressed = String(placed.has(kind))));
  }

  /** @param {Kind} kind */
  focus(kind) {
    (this.content.hidden ? this.lid : this.buttons.get(kind))?.focus();
  }

  /** Whether a pointer is over it. @param {{clientX: number, clientY: number}} event */
  isUnder({ clientX, clientY }) {
    const { left, right, top, bottom } = this.element.getBoundingClientRect();
    return clientX >= left && clientX <= right && clientY >= top && clientY <= bottom;
  }

  /** Shows that what is dragged would go back into it. @param {boolean} on */
  welcome(on) {
    this.element.classList.toggle("softrod-box-welcome", on);
  }

  /** Stands where lines start on the canvas, over the bar of time. @param {DOMRect} canvas */
  place(canvas) {
    this.element.classList.toggle("softrod-words", hasWords(canvas));
    this.element.style.insetInlineStart = `${sidesOf(canvas).start + 14}px`;
    this.element.style.bottom = `${window.innerHeight - floorOf(canvas) + 10}px`;
    if (!this.content.hidden) keepInView(this.content);
  }
}
