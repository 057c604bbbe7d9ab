// @ts-check
/** How the page looks: projector mode, and where buttons have room for words. */
import { kept, store } from "./storage.js";

const NAME = "softrod-projector";

/** Pixels of the canvas from which on buttons at its edge have words beside their icons. */
const FOR_WORDS = 640;

/** Whether there is room for words. @param {DOMRect} canvas */
export const hasWords = (canvas) => canvas.width >= FOR_WORDS;

/** Whether projector mode is on. */
export const isProjector = () => document.documentElement.classList.contains(NAME);

/** Turns projector mode, which has everything larger and bolder for the last row of a class, on or off. The tab remembers. */
export function toggleProjector() {
  store(NAME, document.documentElement.classList.toggle(NAME) ? "1" : "");
}

/** Turns it on if it was on before the page was loaded. */
export function restoreLooks() {
  document.documentElement.classList.toggle(NAME, kept(NAME) === "1");
}
