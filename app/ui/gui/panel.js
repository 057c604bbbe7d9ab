// @ts-check
/**
 * The panel: beside the canvas, or a sheet over its lower part on a phone, with three heights that a finger sets.
 */
import { kept, store } from "../kept/storage.js";
import { make, makeButton } from "../dialog.js";

/** Windows in which the panel is a sheet. */
const SHEET = matchMedia("(max-width: 576px)");
/** Key under which the browser's tab stores that the panel is folded. */
const FOLDED = "softrod-folded";
/** Pixels of a drag that moves the sheet to the next height. */
const THROW = 40;

/** @typedef {"closed" | "half" | "full"} Height */
/** @type {Height[]} */
const HEIGHTS = ["closed", "half", "full"];

/** @param {string} property @param {string} value */
const setRoot = (property, value) => document.documentElement.style.setProperty(property, value);

class Panel {
  constructor() {
    this.element = make("aside", "softrod-panel");
    this.element.ariaLabel = "Controls";
    this.element.hidden = true;
    this.controls = make("div", "softrod-controls softrod-root");
    this.handle = makeButton("", () => this.go(this.height === "closed" ? "half" : "closed"), "softrod-handle");
    this.fold = makeButton("", () => this.setFolded(!this.isFolded), "softrod-fold");
    this.element.append(this.handle, this.controls);
    /** @type {Height} */
    this.height = "half";
    this.isFolded = kept(FOLDED) === "1";
  }

  begin() {
    document.body.append(this.element, this.fold);
    SHEET.addEventListener("change", () => this.show());
    // A tab that is pressed is wanted in sight.
    this.controls.addEventListener("click", ({ target }) => {
      if (target instanceof Element && target.closest("[role=tab]") && this.height === "closed") this.go("half");
    });
    this.listenToFinger();
    this.show();
  }

  /** True if there is nothing in it. */
  get isEmpty() {
    return this.controls.childElementCount === 0;
  }

  /** Shows or hides the panel after controls have come or gone. */
  changed() {
    if (this.element.hidden === this.isEmpty) return;
    this.element.hidden = this.isEmpty;
    this.show();
  }

  /** Opens it, for a tab or a control that was asked for. */
  unfold() {
    if (this.isFolded) this.setFolded(false);
    if (this.height === "closed") this.go("half");
  }

  /** @param {boolean} on */
  setFolded(on) {
    this.isFolded = on;
    store(FOLDED, on ? "1" : "");
    this.show();
  }

  /** Moves the sheet. @param {Height} height */
  go(height) {
    this.height = height;
    this.show();
  }

  show() {
    const { dataset } = document.documentElement;
    const isSheet = SHEET.matches;
    if (this.isEmpty) delete dataset.softrodPanel;
    else dataset.softrodPanel = isSheet ? this.height : this.isFolded ? "folded" : "open";
    this.handle.ariaLabel = this.height === "closed" ? "Show the controls" : "Hide the controls";
    this.handle.ariaExpanded = String(this.height !== "closed");
    this.fold.hidden = isSheet || this.isEmpty;
    this.fold.ariaLabel = this.isFolded ? "Show the panel" : "Hide the panel";
    this.fold.title = this.fold.ariaLabel;
    this.fold.ariaExpanded = String(!this.isFolded);
    this.fold.textContent = this.isFolded ? "«" : "»";
  }

  /** Lets a finger drag the sheet by its handle; it goes on to the height at which it was thrown. */
  listenToFinger() {
    let from = 0;
    let moved = 0;
    const { handle } = this;
    handle.addEventListener("pointerdown", (event) => {
      handle.setPointerCapture(event.pointerId);
      [from, moved] = [event.clientY, 0];
    });
    handle.addEventListener("pointermove", (event) => {
      if (!handle.hasPointerCapture(event.pointerId)) return;
      moved = from - event.clientY;
      setRoot("--softrod-pull", `${moved}px`);
      this.element.toggleAttribute("data-pulled", true);
    });
    const end = () => {
      this.element.removeAttribute("data-pulled");
      setRoot("--softrod-pull", "0px");
      const at = HEIGHTS.indexOf(this.height);
      const steps = Math.abs(moved) < THROW ? 0 : Math.sign(moved) * (Math.abs(moved) > 0.4 * innerHeight ? 2 : 1);
      if (steps) this.go(HEIGHTS[Math.min(Math.max(at + steps, 0), HEIGHTS.length - 1)]);
    };
    handle.addEventListener("pointerup", end);
    handle.addEventListener("pointercancel", end);
    // A drag is no press.
    handle.addEventListener("click", (event) => Math.abs(moved) >= THROW && event.stopImmediatePropagation(), true);
  }
}

export const panel = new Panel();
