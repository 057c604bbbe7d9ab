// @ts-check
/**
 * The head-up display: what the server writes, in an element that the panel cannot take away. It is behind the body, which
 * it never covers.
 */
import { viser } from "./viser.js";

const SOURCE = '<div id="softrod-hud"';
/** @type {HTMLElement | null} */
let hud = null;

/** Puts the display behind viser's canvas, as soon as there is one. @param {HTMLElement} element */
function putBehind(element) {
  const canvas = viser()?.canvas;
  if (canvas?.parentElement) canvas.parentElement.prepend(element);
  else requestAnimationFrame(() => putBehind(element));
}

/** Shows what a message has for the display, if it is for it. @param {unknown} content */
export function showHud(content) {
  if (typeof content !== "string" || !content.startsWith(SOURCE)) return;
  if (!hud?.isConnected) {
    hud = document.createElement("div");
    hud.className = "softrod-hud";
    putBehind(hud);
  }
  const template = document.createElement("template");
  template.innerHTML = content;
  hud.replaceChildren(...(template.content.firstElementChild?.childNodes ?? []));
}
