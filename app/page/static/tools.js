// @ts-check
/** What is measured on the canvas, as the switches of the Measure tab (tools_panel.py) have it. */

const STATE = '<div id="softrod-tools"';

/**
 * @typedef {object} Tools
 * @property {number[]} traced masses whose path is drawn
 * @property {number} seconds of a path
 * @property {number} chosen the mass that was clicked last, or -1
 * @property {boolean} coordinates whether a mass is read out beside it
 */

/** @type {Tools} */
let state = { traced: [], seconds: 5, chosen: -1, coordinates: false };
/** @type {(() => void)[]} */
const listeners = [];

/** The switches now. */
export const tools = () => state;

/** Calls back whenever one was turned. @param {() => void} listener */
export const onTools = (listener) => listeners.push(listener);

/** Takes what a message has for an element of HTML, if it is of the switches. @param {unknown} content */
export function hearTools(content) {
  if (typeof content !== "string" || !content.startsWith(STATE)) return;
  const template = document.createElement("template");
  template.innerHTML = content;
  const element = template.content.firstElementChild;
  if (!(element instanceof HTMLElement)) return;
  const { traced = "", seconds, chosen, coordinates } = element.dataset;
  state = {
    traced: traced.split(" ").filter(Boolean).map(Number),
    seconds: Number(seconds),
    chosen: Number(chosen),
    coordinates: coordinates === "1",
  };
  for (const call of listeners) call();
}
