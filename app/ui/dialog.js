// @ts-check
/**
 * Dialogs of the script. The browser traps the focus in them, returns it afterwards, and closes them with Esc.
 */
import { say, tied } from "../words/words.js";

/**
 * Makes an HTML element.
 *
 * @template {keyof HTMLElementTagNameMap} K
 * @param {K} kind
 * @param {string} name its class, or empty
 * @param {string} [text] shown as it is, never as HTML
 * @returns {HTMLElementTagNameMap[K]}
 */
export function make(kind, name, text = "") {
  const element = document.createElement(kind);
  if (name) element.className = name;
  if (text) element.textContent = tied(text);
  return element;
}

/** What no browser is to translate: a name, a code, a number with its unit. @template {HTMLElement} E @param {E} element */
export function untranslated(element) {
  element.translate = false;
  return element;
}

/** An outlined or filled icon of 24 by 24 as HTML, with a word beside it. @param {string} path @param {string} [word] */
export const iconHtml = (path, word) =>
  `<svg viewBox="0 0 24 24" aria-hidden="true"><path d="${path}"/></svg>${word === undefined ? "" : `<span>${word}</span>`}`;

/** @param {string} text @param {() => void} press @param {string} [name] */
export function makeButton(text, press, name = "softrod-button") {
  const button = make("button", name, text);
  button.type = "button";
  button.addEventListener("click", press);
  return button;
}

/**
 * Makes a region that a screen reader reads out, and returns what says something in it: the same words again, too.
 *
 * @param {string} [name] a further class
 * @returns {(text: string) => void}
 */
export function addTeller(name = "") {
  const region = make("div", `softrod-tell ${name}`.trim());
  region.setAttribute("role", "status");
  overCanvas().append(region);
  return (text) => {
    region.textContent = region.textContent === text ? `${text}\u00a0` : text;
  };
}

/** A button that closes what it stands in; its sign is not read. @param {() => void} close @param {string} [name] */
export function makeClose(close, name = say("ui-close")) {
  const button = makeButton("", close, "softrod-close");
  const sign = make("span", "", "×");
  sign.ariaHidden = "true";
  button.append(sign);
  button.ariaLabel = name;
  return button;
}

/** The part of the page with the body, and with all that stands over it: where the page's tools go. @returns {HTMLElement} */
export const overCanvas = () => document.querySelector("main") || document.body;

/**
 * Makes a dialog with a title and a button that closes it.
 *
 * @param {string} title
 * @param {string} name its class
 */
export function makeDialog(title, name) {
  const dialog = make("dialog", `softrod-dialog ${name}`);
  const head = make("div", "softrod-dialog-head");
  const heading = make("h2", "", title);
  heading.id = `${name}-title`;
  dialog.setAttribute("aria-labelledby", heading.id);
  head.append(heading, makeClose(() => dialog.close()));
  const body = make("div", "softrod-dialog-body");
  dialog.append(head, body);
  // A click on the backdrop closes it, unless the press began inside, as when text is selected.
  let outside = false;
  dialog.addEventListener("pointerdown", ({ target }) => (outside = target === dialog));
  dialog.addEventListener("click", ({ target }) => outside && target === dialog && dialog.close());
  document.body.append(dialog);
  return { dialog, head, body };
}
