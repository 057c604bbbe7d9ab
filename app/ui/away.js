// @ts-check
/**
 * While there is no connection: the page says so, its clock stands, what was under way ends, and nothing that is
 * pressed is done, neither now nor late.
 */
import { stopSending } from "../wire/channel.js";
import { lost } from "./kept/keep.js";

const TEXT = "Not connected: your body waits. Reconnecting…";
/** On a wall, which has no body of its own. */
const WALL = "Not connected. Reconnecting…";
/** Where nothing says why the first connection does not come about. */
const BLOCKED =
  "The page is here, but its live connection does not come about: something on the way lets no WebSockets through. Another network may do, such as the hotspot of the computer that softrod runs on.";
/** What would begin something. Moves and releases go on, so that whatever is pressed can be let go. */
const BEGINNINGS = ["pointerdown", "mousedown", "touchstart", "click", "dblclick", "keydown", "paste", "cut", "drop"];
/** Keys that are the browser's: they go from one control to the next, and close a dialog. */
const BROWSERS = new Set(["Tab", "Escape", "Shift", "Control", "Alt", "Meta"]);

let since = Infinity;

/** When the connection was found to be lost, ms of the page's clock; infinite while it is there. */
export const awaySince = () => since;

/** @param {Event} event */
function isBrowsers(event) {
  if (event instanceof KeyboardEvent) return event.ctrlKey || event.metaKey || BROWSERS.has(event.key) || /^F\d/.test(event.key);
  // What a pupil answers is kept until there is a connection.
  return event.target instanceof Element && event.target.closest(".softrod-close, .softrod-seat, .softrod-own-ghost") !== null;
}

/** @param {Event} event */
function swallow(event) {
  if (since === Infinity || isBrowsers(event)) return;
  event.preventDefault();
  event.stopImmediatePropagation();
}

/** Why the server takes no connection from this page: a browser does not tell what a refusal says. */
async function whyRefused() {
  try {
    const answer = await fetch("reach", { headers: { "X-Softrod-Origin": location.origin }, cache: "no-store" });
    return answer.ok ? BLOCKED : await answer.text();
  } catch {
    return TEXT; // it is the server that is gone
  }
}

/** Ends every drag and lets go of every key, as when the window is left. */
const endAll = () => window.dispatchEvent(new Event("blur"));

/**
 * Begins to mind it, before anything else listens to the window.
 *
 * @returns {(line: import("./viser/connection.js").Line) => void} to be told how the connection is
 */
export function mindAbsence() {
  for (const kind of BEGINNINGS) window.addEventListener(kind, swallow, { capture: true, passive: false });
  const banner = document.createElement("div");
  banner.className = "softrod-banner";
  banner.setAttribute("role", "status");
  document.body.append(banner);
  let everThere = false;
  return (line) => {
    const away = line !== "connected";
    everThere ||= !away;
    if (away && since === Infinity) {
      endAll();
      since = performance.now();
    }
    if (line === "closed") {
      lost();
      stopSending();
    }
    if (!away) since = Infinity;
    document.documentElement.toggleAttribute("data-softrod-away", away);
    const wall = document.documentElement.dataset.softrodClass?.split(" ").includes("wall");
    banner.textContent = away ? (wall ? WALL : TEXT) : "";
    if (!everThere) whyRefused().then((text) => everThere || (banner.textContent = text));
  };
}
