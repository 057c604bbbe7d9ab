// @ts-check
/** Projector mode: everything over the body larger and bolder, for the last row of a class. */
import { kept, store } from "./storage.js";

const NAME = "softrod-projector";

/** Turns projector mode on or off; the tab remembers. */
export function toggleProjector() {
  store(NAME, document.documentElement.classList.toggle(NAME) ? "1" : "");
}

/** Turns it on if it was on before the page was loaded. */
export function restoreLooks() {
  document.documentElement.classList.toggle(NAME, kept(NAME) === "1");
}
