// @ts-check
/** Controls with a value: sliders, numbers, switches, lists, texts, buttons; and what is only shown. */
import { make, makeButton, untranslated } from "../dialog.js";
import { say } from "../../words/words.js";
import { Control, newId, setText, visit } from "./control.js";
import { NumberBox } from "./numbers.js";

/** @typedef {import("./control.js").Declared} Declared */

/** An option that is the name of a part, a quantity or a formula, which is also typed. */
const NAME = /^\S*[\d._^]\S*$/;

/** A control under a label, which also has the hint. */
class Field extends Control {
  /** @param {Declared} declared @param {string} name of its class @param {"label" | "span"} [kind] of its label */
  constructor(declared, name, kind = "label") {
    super(declared, `softrod-field ${name}`);
    this.label = make(kind, "softrod-label");
    this.label.id = newId();
  }

  /** Names an element by the label. @param {HTMLElement} element */
  labels(element) {
    element.setAttribute("aria-labelledby", this.label.id);
    return element;
  }

  /** @param {boolean} valued */
  show(valued) {
    super.show(valued);
    const { label = "", hint, disabled } = this.props;
    setText(this.label, label);
    this.label.hidden = label === "";
    this.element.title = hint ?? "";
    for (const input of this.element.querySelectorAll("input, select, textarea, button")) {
      /** @type {HTMLInputElement} */ (input).disabled = disabled === true;
    }
  }
}

/** A field with a number box in the line of its label. */
class NumberField extends Field {
  /** @param {Declared} declared @param {string} [name] */
  constructor(declared, name = "softrod-number-field") {
    super(declared, name);
    this.box = new NumberBox({ range: () => this.range, step: () => this.props.step || 1, set: (value) => this.enter(value) });
    this.label.setAttribute("for", (this.box.input.id = newId()));
    this.unit = untranslated(make("span", "softrod-unit"));
    this.line = make("div", "softrod-field-line");
    this.line.append(this.label, this.box.sign, this.box.input, this.unit);
    this.element.append(this.line, this.box.why);
  }

  /** What the box allows. */
  get range() {
    const { low = null, high = null, unit = "" } = this.look;
    return { low, high, unit };
  }

  /** Sets a number that was typed. @param {number} value */
  enter(value) {
    this.set(value);
    this.show(true);
  }

  /** @param {boolean} valued */
  show(valued) {
    super.show(valued);
    setText(this.unit, this.look.unit ?? "");
    if (valued) this.box.show(this.value);
  }
}

/** Pixels by which a finger moves to the side that slides, and does not scroll. */
const SLIDES = 6;
/** Half the width of a thumb, px. */
const THUMB = 8;

/** A slider below its label and its number box. It covers the useful range; the box takes all that is allowed. */
class Slider extends NumberField {
  /** @param {Declared} declared */
  constructor(declared) {
    super(declared, "softrod-slider");
    this.track = make("input", "");
    this.track.type = "range";
    this.labels(this.track);
    this.ends = make("div", "softrod-ends");
    this.ends.append(make("span", ""), make("span", ""));
    this.ends.ariaHidden = "true";
    this.line.after(this.track, this.ends);
    /** Whether a move waits for the next picture. */
    this.asked = false;
    /** Where a finger came down, which may scroll or slide; null else. @type {{x: number, y: number, value: number} | null} */
    this.finger = null;
    this.track.addEventListener("pointerdown", (event) => this.press(event));
    this.track.addEventListener("pointermove", ({ clientX, clientY }) => {
      const { finger } = this;
      if (finger && Math.abs(clientX - finger.x) > Math.max(SLIDES, Math.abs(clientY - finger.y))) this.finger = null;
    });
    this.track.addEventListener("pointerup", ({ clientX }) => this.finger && this.tap(clientX));
    this.track.addEventListener("pointercancel", () => (this.finger = null));
    this.track.addEventListener("focus", visit);
    this.track.addEventListener("input", () => this.slide());
    this.track.addEventListener("dblclick", () => this.look.own != null && this.enter(this.look.own));
  }

  focus() {
    this.track.focus();
  }

  /** True if equal steps of the slider are equal factors. */
  get isLogarithmic() {
    return this.look.logarithmic === true;
  }

  /** Where the slider stands for a value. @param {number} value */
  place(value) {
    const { min, max } = this.props;
    const inside = Math.min(Math.max(value, min), max);
    return this.isLogarithmic ? Math.log10(Math.max(inside, 1e-12)) : inside;
  }

  /** @param {PointerEvent} event */
  press({ pointerType, clientX, clientY }) {
    visit();
    if (pointerType === "touch") this.finger = { x: clientX, y: clientY, value: this.value };
  }

  /** Goes to where a finger was lifted. @param {number} x */
  tap(x) {
    this.finger = null;
    const { left, width } = this.track.getBoundingClientRect();
    const [low, high] = [Number(this.track.min), Number(this.track.max)];
    this.track.value = String(low + (high - low) * Math.min(Math.max((x - left - THUMB) / (width - 2 * THUMB), 0), 1));
    this.slide();
  }

  slide() {
    if (this.finger) {
      this.track.value = String(this.place(this.finger.value));
      return;
    }
    const place = Number(this.track.value);
    // No hand moves it more finely than three digits.
    this.value = this.isLogarithmic ? Number((10 ** place).toPrecision(3)) : Number(place.toPrecision(12));
    this.box.show(this.value);
    this.fill();
    if (!this.asked) requestAnimationFrame(() => this.send());
    this.asked = true;
  }

  send() {
    this.asked = false;
    this.set(this.value);
  }

  /** Draws the track up to the thumb. */
  fill() {
    const [low, high] = [Number(this.track.min), Number(this.track.max)];
    /** @param {number} place */
    const part = (place) => (high > low ? (place - low) / (high - low) : 0);
    const from = low < 0 && high > 0 && !this.isLogarithmic ? part(0) : 0;
    const at = part(Number(this.track.value));
    this.track.style.setProperty("--from", String(Math.min(from, at)));
    this.track.style.setProperty("--to", String(Math.max(from, at)));
    this.track.ariaValueText = `${this.box.input.value} ${this.look.unit ?? ""}`.trim();
  }

  /** @param {boolean} valued */
  show(valued) {
    super.show(valued);
    const { min, max, step, _marks: marks } = this.props;
    const [low, high] = [this.place(min), this.place(max)].map(String);
    if (this.track.min !== low) this.track.min = low;
    if (this.track.max !== high) this.track.max = high;
    this.track.step = this.isLogarithmic ? "0.01" : String(step);
    const [first, last] = this.ends.children;
    setText(/** @type {HTMLElement} */ (first), marks?.[0]?.label ?? String(min));
    setText(/** @type {HTMLElement} */ (last), marks?.[marks.length - 1]?.label ?? String(max));
    if (!valued || this.asked) return;
    this.track.value = String(this.place(this.value));
    this.fill();
  }
}

/** A switch at the end of its line. */
class Switch extends Field {
  /** @param {Declared} declared */
  constructor(declared) {
    super(declared, "softrod-switch");
    this.input = make("input", "");
    this.input.type = "checkbox";
    this.input.setAttribute("role", "switch");
    this.label.setAttribute("for", (this.input.id = newId()));
    this.element.append(this.label, this.input);
    this.input.addEventListener("change", () => this.set(this.input.checked));
  }

  /** @param {boolean} valued */
  show(valued) {
    super.show(valued);
    if (valued) this.input.checked = this.value === true;
  }
}

/** A list to choose from. */
class List extends Field {
  /** @param {Declared} declared */
  constructor(declared) {
    super(declared, "softrod-list");
    this.select = make("select", "");
    this.label.setAttribute("for", (this.select.id = newId()));
    this.element.append(this.label, this.select);
    this.select.addEventListener("change", () => {
      this.set(this.select.value);
      // Keys act on the body again, unless the user goes by keys.
      if (!this.select.matches(":focus-visible")) this.select.blur();
    });
  }

  /** @param {boolean} valued */
  show(valued) {
    super.show(valued);
    /** @type {string[]} */
    const options = this.props.options ?? [];
    if (options.length !== this.select.length || options.some((option, i) => this.select.options[i].value !== option)) {
      const made = options.map((text) => new Option(text, text));
      made.filter(({ value }) => NAME.test(value)).forEach(untranslated);
      this.select.replaceChildren(...made);
      valued = true;
    }
    if (valued) this.select.value = this.value;
  }
}

/** A line or several of text. */
class TextField extends Field {
  /** @param {Declared} declared */
  constructor(declared) {
    super(declared, "softrod-text-field");
    this.input = declared.props.multiline ? make("textarea", "") : make("input", "");
    this.label.setAttribute("for", (this.input.id = newId()));
    this.element.append(this.label, this.input);
    this.input.addEventListener("input", () => this.set(this.input.value));
  }

  /** @param {boolean} valued */
  show(valued) {
    super.show(valued);
    if (valued && this.input.value !== this.value) this.input.value = this.value;
  }
}

/** The classes of buttons by viser's colours. @type {Record<string, string>} */
const BUTTONS = { gray: "softrod-button", red: "softrod-button softrod-danger" };

/** A button. */
class Button extends Control {
  /** @param {Declared} declared */
  constructor(declared) {
    super(declared, "softrod-press");
    this.button = makeButton("", () => this.set(true), BUTTONS[declared.props.color] ?? "softrod-button softrod-first");
    this.icon = make("span", "softrod-icon");
    this.text = make("span", "softrod-press-text");
    this.word = make("span", "");
    this.note = make("small", "");
    this.text.append(this.word, " ", this.note);
    this.button.append(this.icon, this.text);
    this.element.append(this.button);
  }

  /** @param {boolean} valued */
  show(valued) {
    super.show(valued);
    const { label, hint, disabled, _icon_html: icon } = this.props;
    const { place = "", note = "", picture = "" } = this.look;
    setText(this.word, label);
    setText(this.note, note);
    this.showPicture(picture, icon);
    this.button.title = hint ?? (place === "beside" ? label : "");
    this.button.disabled = disabled === true;
  }

  /** Shows a picture, or else an icon. @param {string} name @param {string | null} [icon] */
  showPicture(name, icon) {
    this.icon.toggleAttribute("data-picture", name !== "");
    if (name) {
      this.icon.replaceChildren();
      this.icon.style.setProperty("--softrod-light", pictureOf(name));
      this.icon.style.setProperty("--softrod-dark", pictureOf(`${name}-dark`));
    } else if (icon && !this.icon.firstChild) this.icon.innerHTML = icon;
  }
}

/** Where a small picture of a preset is, as styles say it. @param {string} name */
const pictureOf = (name) => `url("${new URL(`../../features/gallery/thumbnails/${name}.webp`, import.meta.url).href}")`;

/** Buttons in one row. */
class ButtonRow extends Field {
  /** @param {Declared} declared */
  constructor(declared) {
    super(declared, "softrod-button-row", "span");
    this.row = make("div", "softrod-segments");
    if (declared.props.label) this.labels(this.row).setAttribute("role", "group");
    this.element.append(this.label, this.row);
  }

  /** @param {boolean} valued */
  show(valued) {
    const options = /** @type {string[]} */ (this.props.options ?? []);
    if (options.join("\n") !== [...this.row.children].map(({ textContent }) => textContent).join("\n")) {
      this.row.replaceChildren(...options.map((option) => makeButton(option, () => this.set(option))));
    }
    super.show(valued);
  }
}

/** HTML of the server. */
class Html extends Control {
  /** @param {Declared} declared */
  constructor(declared) {
    super(declared, "softrod-html");
    this.content = "";
  }

  get name() {
    return "";
  }

  /** @param {boolean} valued */
  show(valued) {
    const { content = "" } = this.props;
    const wasShown = content === this.content && !this.element.hidden;
    if (content !== this.content) this.element.innerHTML = this.content = content;
    super.show(valued);
    this.element.hidden ||= content === "";
    // Why something was refused stands below its field, where the panel may end.
    if (!wasShown && !this.element.hidden) this.element.querySelector(".softrod-refused")?.scrollIntoView({ block: "nearest" });
  }
}

/** A line between controls. */
class Divider extends Control {
  /** @param {Declared} declared */
  constructor(declared) {
    super(declared, "softrod-divider");
    this.element.append(make("hr", ""));
  }
}

/** How far something is that takes a while. */
class Progress extends Control {
  /** @param {Declared} declared */
  constructor(declared) {
    super(declared, "softrod-progress");
    this.bar = make("progress", "");
    this.bar.max = 100;
    this.bar.ariaLabel = say("ui-progress");
    this.element.append(this.bar);
  }

  /** @param {boolean} valued */
  show(valued) {
    super.show(valued);
    if (valued) this.bar.value = this.value;
  }
}

/** Controls by the messages that declare them. @type {Record<string, new (declared: Declared) => Control>} */
export const FIELDS = {
  GuiSliderMessage: Slider,
  GuiNumberMessage: NumberField,
  GuiCheckboxMessage: Switch,
  GuiDropdownMessage: List,
  GuiTextMessage: TextField,
  GuiButtonMessage: Button,
  GuiButtonGroupMessage: ButtonRow,
  GuiHtmlMessage: Html,
  GuiDividerMessage: Divider,
  GuiProgressBarMessage: Progress,
};
