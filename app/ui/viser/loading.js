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

/** Says that the page has not arrived whole, and offers to load it again. */
export const offerReload = () => sayWithReload(say("ui-not-loaded"));

/** Shows why the page cannot work, and a button that loads it again. @param {string} why */
function sayWithReload(why) {
  showFault(why).append(" ", makeButton(say("ui-no-canvas.reload"), () => location.reload(), ""));
}

/** Offers to reload once the browser has discarded the canvas, since viser does not restore all of it. */
export function watchGraphics() {
  const lost = (/** @type {Event} */ { target }) => {
    if (!(target instanceof HTMLCanvasElement && target.isConnected)) return;
    window.removeEventListener("webglcontextlost", lost, true);
    sayWithReload(say("ui-no-canvas"));
  };
  window.addEventListener("webglcontextlost", lost, true);
}

/** True if the browser has WebGL 2, which viser needs. */
export function canDraw() {
  const context = document.createElement("canvas").getContext("webgl2");
  context?.getExtension("WEBGL_lose_context")?.loseContext();
  return context !== null;
}

/**
 * Gives the script that is viser's page, ready to be run. It is a file of its own, so that browsers keep it when the
 * language changes.
 */
export async function viserScript() {
  const answer = await fetch(new URL("viser.txt", import.meta.url));
  if (!answer.ok) throw new Error(answer.statusText);
  const waiting = new DOMParser().parseFromString(await answer.text(), "text/html").querySelector("script");
  const script = Object.assign(document.createElement("script"), { type: "module", textContent: waiting?.textContent ?? "" });
  Object.assign(script.dataset, waiting?.dataset); // which it reads from its element
  return script;
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
