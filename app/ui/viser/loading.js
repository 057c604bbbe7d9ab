// @ts-check
/**
 * The page that stands from the first bytes on until the body and the panel do; viser's own is not to be seen before
 * that. It also says why the page cannot work, with nothing under it.
 */
import { onPicture } from "../../stage/canvas.js";
import { onMessage, pageState } from "../../wire/channel.js";

/** Pictures of the screen that viser needs to put up the panel of which the page was told. */
const SETTLING = 4;

const NO_CANVAS = "The browser no longer draws this page. Your body is kept:";

const box = () => document.querySelector(".softrod-loading");

/** Says in place of the whole page that it cannot work, and returns what says it. @param {string} text */
export function complain(text) {
  const said = document.createElement("p");
  said.className = "softrod-fault";
  said.setAttribute("role", "alert");
  said.textContent = text;
  const over = box();
  if (over) over.querySelector("h1")?.after(said);
  else document.body.append(said);
  return said;
}

/** Says so once the browser has taken the canvas away from the page: what viser had put on it does not all come back. */
export function mindGraphics() {
  const lost = (/** @type {Event} */ { target }) => {
    if (!(target instanceof HTMLCanvasElement && target.isConnected)) return;
    window.removeEventListener("webglcontextlost", lost, true);
    const again = document.createElement("button");
    again.textContent = "Reload";
    again.addEventListener("click", () => location.reload());
    complain(NO_CANVAS).append(" ", again);
  };
  window.addEventListener("webglcontextlost", lost, true);
}

/** Whether the browser can draw; viser needs WebGL 2. */
export function canDraw() {
  const context = document.createElement("canvas").getContext("webgl2");
  context?.getExtension("WEBGL_lose_context")?.loseContext();
  return context !== null;
}

/** Begins viser's page, whose script waits in the page for its turn. */
export function beginViser() {
  const waiting = document.querySelector("script[data-p]");
  const script = document.createElement("script");
  script.type = "module";
  script.textContent = waiting?.textContent ?? "";
  document.head.append(script);
}

/** Takes the page away once there is something to see. */
export function endLoading() {
  let pictured = false;
  let left = SETTLING;
  const settle = () => (left-- > 0 ? requestAnimationFrame(settle) : box()?.remove());
  const look = () => {
    if (left === SETTLING && pictured && pageState().page) settle();
  };
  onPicture(() => {
    pictured = true;
    look();
  });
  onMessage("pageState", look);
}
