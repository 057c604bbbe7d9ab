// @ts-check
/**
 * A lost connection: the page says so, its clock stops, what is under way ends, and no press has any effect, neither
 * now nor later.
 */
import { stopSending } from "../wire/channel.js";
import { reasonOfRefusal } from "../wire/reach.js";
import { make, overCanvas } from "./dialog.js";
import { lost } from "./kept/keep.js";
import { say } from "../words/words.js";

/** Events that begin something. Moves and releases are let through, so that whatever is pressed can be released. */
const BEGINNINGS = ["pointerdown", "mousedown", "touchstart", "click", "dblclick", "keydown", "paste", "cut", "drop"];
/** Keys of the browser, which move the focus or close a dialog. */
const BROWSER_KEYS = new Set(["Tab", "Escape", "Shift", "Control", "Alt", "Meta"]);

let lostAt = Infinity;

/** When the connection was lost, ms of the page's clock; infinite while there is one. */
export const awaySince = () => lostAt;

/** @param {Event} event */
function isAllowed(event) {
  if (event instanceof KeyboardEvent) return event.ctrlKey || event.metaKey || BROWSER_KEYS.has(event.key) || /^F\d/.test(event.key);
  return event.target instanceof Element && event.target.closest(".softrod-close") !== null;
}

/** @param {Event} event */
function swallow(event) {
  if (lostAt === Infinity || isAllowed(event)) return;
  event.preventDefault();
  event.stopImmediatePropagation();
}

/** Ends every drag and releases every key, as when the window loses the focus. */
const endAll = () => window.dispatchEvent(new Event("blur"));

/**
 * Begins to swallow events while there is no connection; call it before anything else listens to the window.
 *
 * @returns {(line: import("./viser/connection.js").Line) => void} call it when the state of the connection changes
 */
export function watchConnectionLoss() {
  for (const kind of BEGINNINGS) window.addEventListener(kind, swallow, { capture: true, passive: false });
  const banner = make("div", "softrod-banner");
  banner.setAttribute("role", "status");
  overCanvas().append(banner);
  let wasConnected = false;
  return (line) => {
    const away = line !== "connected";
    wasConnected ||= !away;
    if (away && lostAt === Infinity) {
      endAll();
      lostAt = performance.now();
    }
    if (line === "closed") {
      lost();
      stopSending();
    }
    if (!away) lostAt = Infinity;
    document.documentElement.toggleAttribute("data-softrod-away", away);
    banner.textContent = away ? say("ui-away") : "";
    if (!wasConnected) reasonOfRefusal(say("ui-blocked"), say("ui-away")).then((text) => wasConnected || (banner.textContent = text));
  };
}
