// @ts-check
/**
 * What the page says to the server, through one hidden text element, and what the server tells the page, in
 * the attributes of the element #softrod-state. That is read from the message which brings it: the element
 * itself is in the panel, which viser takes out of the page while it is folded.
 */
import { viser } from "./viser.js";

const STATE = '<div id="softrod-state"';
let sequence = 0;
/** @type {DOMStringMap} */
let heard = {};
/** @type {(() => void)[]} */
const listeners = [];

/** What the server told last. */
export const told = () => heard;

/** Calls back whenever the server told something new. @param {() => void} listener */
export const onTold = (listener) => listeners.push(listener);

/** Takes what a message has for an element of HTML, if it is for the script. @param {unknown} content */
export function hear(content) {
  if (typeof content !== "string" || !content.startsWith(STATE)) return;
  const template = document.createElement("template");
  template.innerHTML = content;
  const element = template.content.firstElementChild;
  if (element instanceof HTMLElement) heard = { ...element.dataset };
  for (const call of listeners) call();
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
