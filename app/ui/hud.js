// @ts-check
/**
 * The head-up display: what the server writes, in an element that the panel cannot take away. It is behind the body, which
 * it never covers.
 */
import { onMessage } from "../wire/channel.js";
import { viserCanvas } from "./viser/viser.js";

/** @type {HTMLElement | null} */
let hud = null;

/** Puts the display behind viser's canvas, as soon as there is one. @param {HTMLElement} element */
function putBehind(element) {
  const canvas = viserCanvas();
  if (canvas?.parentElement) canvas.parentElement.prepend(element);
  else requestAnimationFrame(() => putBehind(element));
}

/** Begins to show it. */
export const showHud = () =>
  onMessage("hud", ({ html }) => {
    if (!hud?.isConnected) {
      hud = document.createElement("div");
      hud.className = "softrod-hud";
      putBehind(hud);
    }
    hud.innerHTML = html;
  });
