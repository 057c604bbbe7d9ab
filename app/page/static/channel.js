// @ts-check
/**
 * What the page says to the server, through one hidden text element, and what the server tells the page,
 * through the attributes of the element #softrod-state.
 */
import { viser } from "./viser.js";

let sequence = 0;

/** What the server told. @returns {DOMStringMap} */
export const told = () => document.getElementById("softrod-state")?.dataset ?? {};

/** @type {(() => void)[]} */
const listeners = [];
let heard = "";

/** Calls back whenever the server told something new. @param {() => void} listener */
export function onTold(listener) {
  listeners.push(listener);
  if (listeners.length > 1) return;
  const look = () => {
    const now = JSON.stringify(told());
    if (now === heard) return;
    heard = now;
    for (const call of listeners) call();
  };
  // The element is viser's, which replaces it as a whole.
  const root = document.getElementById("root") ?? document.body;
  new MutationObserver(look).observe(root, { childList: true, subtree: true });
}

/**
 * Sends a message, if there is a connection.
 *
 * @param {string} kind
 * @param {string} payload
 */
export function send(kind, payload) {
  const uuid = told().channel;
  if (!uuid) return;
  // The number makes every message differ from the one before, which viser would otherwise drop.
  const value = `${++sequence}|${kind}|${payload}`;
  viser()?.sendMessage({ type: "GuiUpdateMessage", uuid, updates: { value } });
}
