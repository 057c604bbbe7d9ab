// @ts-check
/** What is measured on the canvas: the state of the switches of the Measure tab (panel.py). */
import { onMessage } from "../../wire/channel.js";

/** @typedef {import("../../wire/wire.js").Tools} Tools */

/** @type {Tools} */
let state = { tell: "tools", traced: [], seconds: 5, chosen: -1, coordinates: false, strobe: 0 };
/** @type {(() => void)[]} */
const listeners = [];

/** The present state. */
export const tools = () => state;

/** Calls back whenever a switch changes. @param {() => void} listener */
export const onTools = (listener) => listeners.push(listener);

/** Begins to receive it. */
export const hearTools = () =>
  onMessage("tools", (now) => {
    state = now;
    for (const call of listeners) call();
  });
