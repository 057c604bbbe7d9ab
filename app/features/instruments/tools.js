// @ts-check
/** What is measured on the canvas, as the switches of the Measure tab (panel.py) have it. */
import { onMessage } from "../../wire/channel.js";

/** @typedef {import("../../wire/wire.js").Tools} Tools */

/** @type {Tools} */
let state = { tell: "tools", traced: [], seconds: 5, chosen: -1, coordinates: false };
/** @type {(() => void)[]} */
const listeners = [];

/** The switches now. */
export const tools = () => state;

/** Calls back whenever one was turned. @param {() => void} listener */
export const onTools = (listener) => listeners.push(listener);

/** Begins to hear of them. */
export const hearTools = () =>
  onMessage("tools", (told) => {
    state = told;
    for (const call of listeners) call();
  });
