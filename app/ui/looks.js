// @ts-check
/** How the page looks: projector mode, and where buttons have room for words and for their lists. */
import { kept, store } from "./kept/storage.js";
import { markCanvas, panelAt } from "./viser/widgets.js";

const NAME = "softrod-projector";
/** Pixels of a window for which the panel has its usual size; in larger ones it grows with them. */
const [WIDTH, HEIGHT] = [800, 540];
/** How many times larger it is at most. */
const LARGEST = 4;
/** Milliseconds between two looks at how wide the panel is. */
const LOOK_EVERY = 100;

const root = () => document.documentElement;

/** Pixels of the canvas from which on buttons at its edge have words beside their icons. */
const FOR_WORDS = 640;

/** Whether there is room for words. @param {DOMRect} canvas */
export const hasWords = (canvas) => canvas.width >= FOR_WORDS * larger();

/** Pixels between a list and the edge of the window. */
const EDGE = 8;

/** Where there is no room for a list above its button, it comes down over that. @param {HTMLElement} list */
export function keepInView(list) {
  list.style.translate = "";
  list.style.translate = `0 ${Math.max(0, EDGE - list.getBoundingClientRect().top)}px`;
}

/** Whether projector mode is on. */
export const isProjector = () => root().classList.contains(NAME);

/** Turns projector mode, which has everything larger and bolder for the last row of a class, on or off. The tab remembers. */
export function toggleProjector() {
  store(NAME, root().classList.toggle(NAME) ? "1" : "");
  enlarge();
  keepRoom();
}

/** How many times larger the panel and the tools are. */
export const larger = () =>
  root().classList.contains(NAME) ? Math.min(Math.max(1, Math.min(innerWidth / WIDTH, innerHeight / HEIGHT)), LARGEST) : 1;

const enlarge = () => root().style.setProperty("--softrod-larger", larger().toFixed(3));

/** viser leaves room for the panel beside the canvas by the width that this would have without being larger. */
function keepRoom() {
  if (!root().classList.contains(NAME)) return;
  markCanvas();
  for (const side of ["left", "right"]) {
    const width = panelAt(side)?.getBoundingClientRect().width ?? 0;
    root().style.setProperty(`--softrod-room-${side}`, `${width}px`);
  }
}

/** Keeps the sizes of projector mode, and turns it on if it was on before the page was loaded. */
export function restoreLooks() {
  root().classList.toggle(NAME, kept(NAME) === "1");
  enlarge();
  window.addEventListener("resize", enlarge);
  setInterval(keepRoom, LOOK_EVERY);
}
