// @ts-check
/**
 * The panel: beside the canvas, or a sheet over its lower part on a phone, with three heights that a finger sets.
 */
import { has, onMessage, pageState } from "../../wire/channel.js";
import { perform } from "../../wire/perform.js";
import { access } from "../access.js";
import { kept, store } from "../kept/storage.js";
import { foldStrips } from "../strip.js";
import { iconHtml, make, makeButton, overCanvas } from "../dialog.js";
import { withKey } from "../hands/key_table.js";
import { say } from "../../words/words.js";
import { openFinder } from "./finder.js";

const FIND = "M11 4a7 7 0 1 1 0 14a7 7 0 0 1 0-14zM16 16l4.5 4.5";
const HELP = "M12 3a9 9 0 1 1 0 18a9 9 0 0 1 0-18zM9.6 9.2a2.5 2.5 0 1 1 3.4 2.4q-1 .5-1 1.7v.4M12 16.6v.1";
const FOLD = "M9 6l6 6l-6 6";
const UNFOLD = "M15 6l-6 6l6 6";
const MORE = "M6 9l6 6l6-6";

/** Windows in which the panel is a sheet. */
const SHEET = matchMedia("(max-width: 576px)");
/** Windows, as at four times the usual size, that have room for the body or for its sliders. */
const TINY = matchMedia("(max-width: 480px) and (max-height: 400px)");
/** Windows in which the panel would take half of the canvas: it is a button there, which opens it over the body. */
const SMALL = matchMedia("(min-width: 577px) and (max-width: 720px) and (max-height: 480px)");
/** Key under which the browser's tab stores whether its user has folded the panel. */
const FOLDED = "softrod-folded";
/** Pixels of a drag that moves the sheet to the next height. */
const THROW = 40;

/** True if the panel is a sheet over the lower part of the window. */
export const isSheet = () => SHEET.matches;

/** @typedef {"closed" | "half" | "full"} Height */
/** @type {Height[]} */
const HEIGHTS = ["closed", "half", "full"];

/** A button that is only an icon. @param {string} icon @param {string} name @param {() => void} press */
function iconButton(icon, name, press) {
  const button = makeButton("", press, "softrod-icon-button");
  button.innerHTML = iconHtml(icon);
  button.ariaLabel = button.title = name;
  return button;
}

/** @param {string} property @param {string} value */
const setRoot = (property, value) => document.documentElement.style.setProperty(property, value);

class Panel {
  constructor() {
    this.element = make("aside", "softrod-panel");
    this.element.ariaLabel = say("ui-panel");
    this.element.hidden = true;
    this.controls = make("div", "softrod-controls softrod-root");
    this.handle = makeButton("", () => this.go(this.next), "softrod-handle");
    this.help = iconButton(HELP, say("command-help"), () => perform("help"));
    this.fold = iconButton(FOLD, say("ui-panel.hide"), () => this.setFolded(true));
    this.unfolds = iconButton(UNFOLD, say("ui-panel.show"), () => this.setFolded(false));
    this.unfolds.classList.add("softrod-unfold", "softrod-floats");
    this.unfolds.append(make("span", "", say("ui-panel")));
    const head = make("div", "softrod-panel-head");
    const brand = make("span", "softrod-brand", "softrod");
    brand.translate = false;
    head.append(brand, iconButton(FIND, withKey(say("command-palette"), "palette"), openFinder), this.help, this.fold);
    this.element.append(this.handle, head, this.controls);
    // A phone has these over the canvas instead, where they take nothing from the sliders.
    this.scene = makeButton("", () => perform("gallery"), "softrod-scene softrod-floats");
    this.scene.title = say("command-gallery");
    this.find = iconButton(FIND, say("command-palette"), openFinder);
    this.find.classList.add("softrod-floats");
    this.over = make("div", "softrod-over");
    this.over.append(this.scene, this.find);
    /** The height at which the user has put the sheet; null before that. @type {Height | null} */
    this.put = null;
    this.inLesson = false;
    /** Whether the user has folded it; null before that was chosen. @type {boolean | null} */
    this.chosen = { 0: false, 1: true }[kept(FOLDED) ?? ""] ?? null;
  }

  begin() {
    overCanvas().append(this.over);
    document.body.append(this.element);
    overCanvas().append(this.unfolds);
    onMessage("pageState", ({ lesson }) => {
      // A lesson begins with its question.
      if (lesson && !this.inLesson && this.put === "closed") this.put = null;
      this.inLesson = Boolean(lesson);
      this.help.hidden = !has("help");
      this.showOver();
      this.show();
    });
    for (const size of [SHEET, SMALL, TINY]) size.addEventListener("change", () => (this.showOver(), this.show()));
    // A tab that is pressed is wanted in sight.
    this.controls.addEventListener("click", ({ target }) => {
      if (target instanceof Element && target.closest("[role=tab]") && this.height === "closed") this.go("half");
    });
    this.listenToFinger();
    this.show();
  }

  /** A lesson needs its panel wherever it is. */
  get isFolded() {
    return this.chosen ?? (SMALL.matches && !pageState().lesson);
  }

  /** The height of the sheet. @returns {Height} */
  get height() {
    return this.put ?? (TINY.matches && !this.inLesson ? "closed" : "half");
  }

  /** True if there is nothing in it. */
  get isEmpty() {
    return this.controls.childElementCount === 0;
  }

  /** Shows or hides the panel after controls have come or gone. */
  changed() {
    if (this.element.hidden === this.isEmpty) return;
    this.element.hidden = this.isEmpty;
    this.showOver();
    this.show();
  }

  /** The height to which a press on the handle takes the sheet; by taps it comes to all of them. @returns {Height} */
  get next() {
    if (this.height === "closed") return "half";
    return this.height === "half" && access().taps ? "full" : "closed";
  }

  /** Opens it, for a tab or a control that was asked for. */
  unfold() {
    if (SHEET.matches) foldStrips();
    if (this.isFolded) this.choose(false);
    if (this.height === "closed") this.go("half");
  }

  /** @param {boolean} folded */
  choose(folded) {
    this.chosen = folded;
    store(FOLDED, folded ? "1" : "0");
    this.show();
  }

  /** Folds it or brings it back, with the focus. @param {boolean} on */
  setFolded(on) {
    this.choose(on);
    (on ? this.unfolds : this.fold).focus();
  }

  /** Moves the sheet. @param {Height} height */
  go(height) {
    this.put = height;
    this.show();
  }

  show() {
    const { dataset } = document.documentElement;
    const isSheet = SHEET.matches;
    if (this.isEmpty) delete dataset.softrodPanel;
    else dataset.softrodPanel = isSheet ? this.height : this.isFolded ? "folded" : "open";
    this.handle.ariaLabel = say(this.next === "closed" ? "ui-panel.down" : "ui-panel.up");
    this.handle.ariaExpanded = String(this.height !== "closed");
    this.unfolds.hidden = isSheet || this.isEmpty || !this.isFolded;
  }

  /** Shows what a phone has over the canvas. */
  showOver() {
    const { title = "" } = pageState();
    this.scene.hidden = !has("chooser") || !title;
    if (this.scene.dataset.name !== title) {
      this.scene.dataset.name = title;
      this.scene.replaceChildren(make("span", "", title));
      this.scene.insertAdjacentHTML("beforeend", iconHtml(MORE));
      this.scene.ariaLabel = say("ui-scene", { title });
    }
    this.find.hidden = this.isEmpty;
    document.documentElement.toggleAttribute("data-softrod-over", SHEET.matches && !(this.scene.hidden && this.find.hidden));
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
