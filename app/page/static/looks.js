// @ts-check
/** Projector mode: everything over the body larger and bolder, for the last row of a class. */

const NAME = "softrod-projector";

/** Turns it on, or off; the tab remembers. */
export function project() {
  const on = document.documentElement.classList.toggle(NAME);
  try {
    sessionStorage.setItem(NAME, on ? "1" : "");
  } catch {
    // Without storage it lasts until the page is loaded again.
  }
}

/** As it was left. */
export function restoreLooks() {
  document.documentElement.classList.toggle(NAME, sessionStorage.getItem(NAME) === "1");
}
