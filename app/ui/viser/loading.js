// @ts-check
/**
 * The loading screen, which covers viser's page until the body and the panel are there. It also says why the page cannot
 * work.
 */
import { onPicture } from "../../stage/canvas.js";
import { make, makeButton } from "../dialog.js";
import { onMessage, pageState } from "../../wire/channel.js";
import { say } from "../../words/words.js";

/** Animation frames that viser needs to show the panel after its messages have arrived. */
const SETTLING = 4;

const box = () => document.querySelector(".softrod-loading");

/** Shows why the page cannot work, in place of the whole page, and returns the element. @param {string} text */
export function showFault(text) {
  const said = make("p", "softrod-fault", text);
  said.setAttribute("role", "alert");
  const over = box();
  if (over) over.querySelector("h1")?.after(said);
  else document.body.append(said);
  return said;
}

/** Offers to reload once the browser has discarded the canvas, since viser does not restore all of it. */
export function watchGraphics() {
  const lost = (/** @type {Event} */ { target }) => {
    if (!(target instanceof HTMLCanvasElement && target.isConnected)) return;
    window.removeEventListener("webglcontextlost", lost, true);
    showFault(say("ui-no-canvas")).append(" ", makeButton(say("ui-no-canvas.reload"), () => location.reload(), ""));
  };
  window.addEventListener("webglcontextlost", lost, true);
}

/** True if the browser has WebGL 2, which viser needs. */
export function canDraw() {
  const context = document.createElement("canvas").getContext("webgl2");
  context?.getExtension("WEBGL_lose_context")?.loseContext();
  return context !== null;
}

/** Begins viser's page, whose script is in the page but not run yet. */
export function beginViser() {
  const waiting = document.querySelector("script[data-p]");
  const script = document.createElement("script");
  script.type = "module";
  script.textContent = waiting?.textContent ?? "";
  document.head.append(script);
}

/** Removes the loading screen once there is something to see. */
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
