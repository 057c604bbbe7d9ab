// @ts-check
/** What the cards of a class are made of; whatever takes the focus has a name by which it keeps it when its card is remade. */
import { make, makeButton } from "../../ui/dialog.js";
import { makeSvg } from "../../stage/svg.js";
import { say } from "../../words/words.js";

/** @typedef {import("../../words/keys.js").Words} Words */

/** Icons as strokes in 24 by 24, since not every font has such letters. */
const ICONS = {
  hand: "M7 12V6M10.5 11V3.5M14 11V4.5M17.5 12V7.5V16a6 6 0 0 1-6 6c-3.5 0-5-2.5-8-7.5L5.5 13 7 15",
  done: "M5 13l4.5 4.5L19 7",
  more: "M5 12h.01M12 12h.01M19 12h.01",
  star: "M12 3l2.8 5.9 6.2.8-4.6 4.4 1.2 6.4L12 17.4 6.4 20.5l1.2-6.4L3 9.7l6.2-.8z",
};

/** An icon, which screen readers skip. @param {keyof typeof ICONS} name */
export function icon(name) {
  const svg = makeSvg("svg", "softrod-class-icon");
  svg.setAttribute("viewBox", "0 0 24 24");
  makeSvg("path", "", svg).setAttribute("d", ICONS[name]);
  return svg;
}

/**
 * An element with what is in it.
 *
 * @template {keyof HTMLElementTagNameMap} K
 * @param {K} kind @param {string} name of its class, or empty @param {(Node | string)[]} content
 * @returns {HTMLElementTagNameMap[K]}
 */
export function box(kind, name, ...content) {
  const element = make(kind, name);
  element.append(...content);
  return element;
}

/**
 * A text with elements in its places.
 *
 * @template {keyof Words} K
 * @param {K} key @param {Record<Words[K], Node | string | number>} values
 * @returns {(Node | string)[]}
 */
export function sayWith(key, values) {
  /** @type {Node[]} */
  const nodes = [];
  const marked = Object.entries(values).map(([name, value]) => [name, value instanceof Node ? `\0${nodes.push(value) - 1}\0` : value]);
  const said = say(key, .../** @type {any} */ ([Object.fromEntries(marked)]));
  return said.split("\0").map((part, i) => (i % 2 ? nodes[Number(part)] : part));
}

/**
 * A button.
 *
 * @param {string} text
 * @param {() => unknown} press
 * @param {{focus?: string, name?: string, pressed?: boolean, label?: string, icon?: keyof typeof ICONS}} [options] the name for the focus,
 *   if that is not the text; its class; whether it is on, for a switch; what a screen reader says instead of the text
 */
export function button(text, press, { focus = text, name = "softrod-small", pressed, label, icon: shape } = {}) {
  const made = makeButton(text, press, name);
  made.dataset.focus = focus;
  if (pressed !== undefined) made.ariaPressed = String(pressed);
  if (label) made.ariaLabel = label;
  if (shape) made.prepend(icon(shape));
  return made;
}

/**
 * A line in which something is typed, with a button.
 *
 * @param {string} label before the line; empty for one that has its own
 * @param {Partial<HTMLInputElement>} properties of the input
 * @param {[text: string, name?: string]} button text and class of the button
 * @param {(text: string) => void} take gets what was typed
 * @param {string} [focus]
 */
export function typedLine(label, properties, button, take, focus = "") {
  const input = make("input", "");
  Object.assign(input, { autocomplete: "off", ...properties });
  return typed(input, label, button, take, focus);
}

/**
 * As `typedLine`, with room for a sentence; Enter sends it.
 *
 * @param {string} label @param {Partial<HTMLTextAreaElement>} properties @param {[text: string, name?: string]} button
 * @param {(text: string) => void} take @param {string} focus
 */
export function typedText(label, properties, button, take, focus) {
  const area = make("textarea", "");
  Object.assign(area, { rows: 2, dir: "auto", ...properties });
  area.addEventListener("keydown", (event) => {
    if (event.key !== "Enter" || event.isComposing) return;
    event.preventDefault();
    form.querySelector("button")?.click();
  });
  const form = typed(area, label, button, take, focus);
  return form;
}

/**
 * A form of something that is typed.
 *
 * @param {HTMLInputElement | HTMLTextAreaElement} input @param {string} label @param {[text: string, name?: string]} button
 * @param {(text: string) => void} take @param {string} focus
 */
function typed(input, label, [text, name = "softrod-small"], take, focus) {
  if (focus) input.dataset.focus = focus;
  const form = box("form", "", label ? box("label", "", `${label} `, input) : input, make("button", name, text));
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    take(input.value.trim());
  });
  return form;
}

/** A picture of the QR code of an address. @param {string} src @param {string} address @param {string} [name] */
export const qrCode = (src, address, name = "") => Object.assign(make("img", name), { src, alt: say("class-qr-code", { address }) });

/** An address as one types it. @param {string} address */
export const typedAddress = (address) => address.replace(/^http:\/\/|\/$/g, "");

/** What is folded out. @type {Set<string>} */
const open = new Set();

/** A part that is folded until it is wanted. @param {string} title @param {HTMLElement[]} content @param {string} [name] by which it is known again */
export function fold(title, content, name = title) {
  const summary = make("summary", "", title);
  summary.dataset.focus = name;
  const details = box("details", "", summary, ...content);
  details.open = open.has(name);
  details.addEventListener("toggle", () => (details.open ? open.add(name) : open.delete(name)));
  return details;
}

/** The choices of a question, how many have chosen each, and which is right where that is known (else -1). @param {string[]} choices @param {number[]} bars @param {number} right */
export function voteBars(choices, bars, right) {
  const most = Math.max(1, ...bars);
  return box("ol", "softrod-bars", ...choices.map((choice, i) => {
    const item = box("li", "", make("bdi", "", choice));
    if (bars.length) {
      const bar = make("i", "");
      bar.style.setProperty("--softrod-part", String(bars[i] / most));
      item.append(box("span", "softrod-track", bar), make("b", "", String(bars[i])));
    }
    if (i === right) item.dataset.right = "";
    return item;
  }));
}
