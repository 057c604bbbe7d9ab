// @ts-check
/**
 * The head-up display: HTML from the server behind the body, in an element that outlives the panel.
 */
import { redrawMarks } from "../stage/sight.js";
import { onMessage } from "../wire/channel.js";
import { make } from "./dialog.js";
import { viserCanvas } from "./viser/viser.js";

/** @type {HTMLElement | null} */
let hud = null;

/** Inserts the display behind viser's canvas, once there is one. @param {HTMLElement} element */
function putBehind(element) {
  const canvas = viserCanvas();
  if (canvas?.parentElement) canvas.parentElement.prepend(element);
  else requestAnimationFrame(() => putBehind(element));
}

/** Begins to show the display. */
export const showHud = () =>
  onMessage("hud", ({ html }) => {
    if (!hud?.isConnected) {
      hud = make("div", "softrod-hud");
      putBehind(hud);
      // The scale bar keeps out of its way.
      new ResizeObserver(redrawMarks).observe(hud);
    }
    hud.innerHTML = html;
  });
