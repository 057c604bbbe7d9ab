// @ts-check
/** Larger letters, for a projector or as the browser has them, and room for words and lists of the buttons over the canvas. */
import { isSheet } from "./gui/panel.js";
import { kept, store } from "./kept/storage.js";

const NAME = "softrod-projector";
/** Width of a window, px, in which everything has its usual size; in projector mode it grows with larger windows. */
const WIDTH = 800;
/** Height of such a window, px. */
const HEIGHT = 540;
/** Largest factor of projector mode. */
const MAX_FACTOR = 4;
/** Pixels of letters for which a browser's user has asked for larger ones; without that they have 16. */
const LARGE_LETTERS = 20;
/** Size of a window, px, in which letters of twice the usual size still leave room for the body. */
const ROOM_FOR_DOUBLE = { width: 1280, height: 800 };

const root = () => document.documentElement;

/** Width of the canvas, px, at which the buttons at its edge get words beside their icons. */
const WIDTH_FOR_WORDS = 640;

/** True if there is room for these words. @param {DOMRect} canvas */
export const hasWords = (canvas) => canvas.width >= WIDTH_FOR_WORDS * larger();

/** Pixels between a list and the edge of the window. */
const EDGE = 8;

/** Moves a list down or up if it would reach beyond the window: beside its button, or over it where there is no room. @param {HTMLElement} list */
export function keepInView(list) {
  list.style.translate = "";
  const { top, bottom, left, right, width } = list.getBoundingClientRect();
  const down = Math.max(EDGE - top, 0) - Math.max(bottom + EDGE - window.innerHeight, 0);
  const beside = (list.nextElementSibling?.getBoundingClientRect().width ?? 0) + EDGE;
  const aside = down && width + beside + 2 * EDGE < window.innerWidth ? beside : 0;
  list.style.translate = `${left + right > window.innerWidth ? -aside : aside}px ${down}px`;
}

/** True in projector mode. */
export const isProjector = () => root().classList.contains(NAME);

/** Whether everything is larger at first, as for a user who has asked the browser for large letters. */
const isWished = () => letters >= LARGE_LETTERS && !isSheet();

/** Switches projector mode, in which everything is larger and bolder for the last row of a class; the tab remembers. */
export function toggleProjector() {
  isAsked = root().classList.toggle(NAME);
  store(NAME, isAsked ? "1" : "0");
  enlarge();
}

/** Pixels of a phone's width that its sheet needs. */
const NARROWEST = 260;

/** Pixels of letters as the browser's user wishes them. */
let letters = 16;
/** Whether projector mode was asked for in the page; else it is on only as far as letters are to be larger. */
let isAsked = false;

/** Measures them: viser's page sets a size of its own. */
function measureLetters() {
  const probe = document.createElement("div");
  probe.style.cssText = "position: absolute; visibility: hidden; font-size: medium";
  document.body.append(probe);
  letters = parseFloat(getComputedStyle(probe).fontSize) || 16;
  probe.remove();
}

/** The factor by which the panel and the tools are enlarged. */
export function larger() {
  const room = innerWidth / NARROWEST;
  if (isSheet()) return Math.max(1, Math.min(isAsked ? room : letters / 16, room));
  if (!isProjector()) return 1;
  const usual = Math.min(innerWidth / WIDTH, innerHeight / HEIGHT);
  const wished = Math.min(letters / 16, (2 * innerWidth) / ROOM_FOR_DOUBLE.width, (2 * innerHeight) / ROOM_FOR_DOUBLE.height);
  return Math.min(Math.max(1, isAsked ? usual : 1, wished), MAX_FACTOR);
}

const enlarge = () => root().style.setProperty("--softrod-larger", larger().toFixed(3));

/** Turns projector mode on if it was on before the page was reloaded or large letters are wished, and keeps its sizes up to date. */
export function restoreLooks() {
  measureLetters();
  isAsked = kept(NAME) === "1";
  root().classList.toggle(NAME, { 0: false, 1: true }[kept(NAME) ?? ""] ?? isWished());
  enlarge();
  window.addEventListener("resize", enlarge);
}
