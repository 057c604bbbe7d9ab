// @ts-check
/**
 * The controls of the panel. Python declares them by viser's API; this folder takes viser's messages on them out of the
 * queue, draws them with the browser's own elements, and answers as viser's page would. What those messages lack comes
 * beside them, as `controlLook`.
 */
import { answer, send } from "../../wire/channel.js";
import { make } from "../dialog.js";
import { grouped } from "../numerals.js";
import { say } from "../../words/words.js";

/**
 * @typedef {object} Declared a message that declares a control
 * @property {string} type
 * @property {string} uuid
 * @property {string} container_uuid
 * @property {any} [value]
 * @property {Record<string, any>} props
 *
 * @typedef {import("../../wire/wire.js").ControlLook} Look
 */

/** A tab, a folder, a dialog or the panel itself, with its controls in their order. */
export class Place {
  /** @param {HTMLElement} element */
  constructor(element) {
    this.element = element;
    /** @type {Control[]} */
    this.members = [];
  }

  /** Puts a control where its order says, after others with the same order. @param {Control} control */
  put(control) {
    this.drop(control);
    const at = this.members.findIndex((other) => other.order > control.order);
    const next = at < 0 ? null : this.members[at];
    this.members.splice(at < 0 ? this.members.length : at, 0, control);
    this.element.insertBefore(control.element, next?.element ?? null);
  }

  /** @param {Control} control */
  drop(control) {
    this.members = this.members.filter((other) => other !== control);
  }
}

/** A control. A subclass makes its element, and shows what has changed. */
export class Control {
  /** @param {Declared} declared @param {string} name of its class */
  constructor({ uuid, value, props }, name) {
    this.id = uuid;
    this.value = value;
    this.props = props;
    /** What viser's messages lack. @type {Partial<Look>} */
    this.look = {};
    /** @type {HTMLElement} */
    this.element = make("div", `softrod-control ${name}`);
  }

  get order() {
    return Number(this.props.order ?? 0);
  }

  /** The places inside of it, by their ids. @type {Map<string, Place>} */
  get places() {
    return new Map();
  }

  /** The name under which it is found; empty if it has none. */
  get name() {
    return String(this.props.label ?? "");
  }

  /** Its value in words; empty without one that a word says. */
  get saying() {
    const { value, look } = this;
    if (typeof value === "boolean") return say(value ? "ui-on" : "ui-on.off");
    if (typeof value === "number") return `${grouped(value)}${look.unit && look.unit !== "°" ? " " : ""}${look.unit ?? ""}`;
    return typeof value === "string" && this.props.options ? value : "";
  }

  /** Takes a message's changes. @param {Record<string, any>} updates */
  take({ value, ...props }) {
    Object.assign(this.props, props);
    if (value !== undefined) this.value = value;
    this.show(value !== undefined);
  }

  /** @param {Look} look */
  describe(look) {
    this.look = look;
    this.element.dataset.place = look.place ?? "";
    this.show(true);
  }

  /** Shows the present properties, and the value if it has changed. @param {boolean} _valued */
  show(_valued) {
    this.element.hidden = this.props.visible === false;
  }

  /** Sets the value as the user has, and tells the server. @param {any} value */
  set(value) {
    this.value = value;
    answer({ type: "GuiUpdateMessage", uuid: this.id, updates: { value } });
  }

  /** Moves the focus to the first thing in it that takes it. */
  focus() {
    const inside = /** @type {NodeListOf<HTMLElement>} */ (this.element.querySelectorAll("input, select, textarea, button"));
    [...inside].find((each) => each.tabIndex >= 0 && each.checkVisibility())?.focus();
  }
}

/** Begins another step of undo. */
export const visit = () => send({ do: "visit" });

/** The texts of elements; those in the page may have been translated. @type {WeakMap<HTMLElement, string>} */
const texts = new WeakMap();

/** Sets a text if it differs from the one before. @param {HTMLElement} element @param {string} text */
export function setText(element, text) {
  if (texts.get(element) === text) return;
  texts.set(element, text);
  element.textContent = text;
}

let count = 0;
/** A name that no other element has. */
export const newId = () => `softrod-${(count += 1)}`;
