// @ts-check
/** Projector mode, and room for words and lists of the buttons over the canvas. */
import { kept, store } from "./kept/storage.js";

const NAME = "softrod-projector";
/** Width of a window, px, in which everything has its usual size; in projector mode it grows with larger windows. */
const WIDTH = 800;
/** Height of such a window, px. */
const HEIGHT = 540;
/** Largest factor of projector mode. */
const MAX_FACTOR = 4;

const root = () => document.documentElement;

/** Width of the canvas, px, at which the buttons at its edge get words beside their icons. */
const WIDTH_FOR_WORDS = 640;

/** True if there is room for these words. @param {DOMRect} canvas */
export const hasWords = (canvas) => canvas.width >= WIDTH_FOR_WORDS * larger();

/** Pixels between a list and the edge of the window. */
const EDGE = 8;

/** Moves a list down if it would reach beyond the window: beside its button, or over it where there is no room. @param {HTMLElement} list */
export function keepInView(list) {
  list.style.translate = "";
  const { top, left, right, width } = list.getBoundingClientRect();
  const down = Math.max(0, EDGE - top);
  const beside = (list.nextElementSibling?.getBoundingClientRect().width ?? 0) + EDGE;
  const aside = down && width + beside + 2 * EDGE < window.innerWidth ? beside : 0;
  list.style.translate = `${left + right > window.innerWidth ? -aside : aside}px ${down}px`;
}

/** True in projector mode. */
export const isProjector = () => root().classList.contains(NAME);

/** Switches projector mode, in which everything is larger and bolder for the last row of a class; the tab remembers. */
export function toggleProjector() {
  store(NAME, root().classList.toggle(NAME) ? "1" : "");
  enlarge();
}

/** The factor by which the panel and the tools are enlarged. */
export const larger = () =>
  root().classList.contains(NAME) ? Math.min(Math.max(1, Math.min(innerWidth / WIDTH, innerHeight / HEIGHT)), MAX_FACTOR) : 1;

const enlarge = () => root().style.setProperty("--softrod-larger", larger().toFixed(3));

/** Turns projector mode on if it was on before the page was reloaded, and keeps its sizes up to date. */
export function restoreLooks() {
  root().classList.toggle(NAME, kept(NAME) === "1");
  enlarge();
  window.addEventListener("resize", enlarge);
}
