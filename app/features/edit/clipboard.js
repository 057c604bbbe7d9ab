// @ts-check
/**
 * Copying parts of a body and pasting them, in another tab, too: by the clipboard where the browser allows it, and by the
 * storage that the tabs of one server share.
 */
import { onMessage, send } from "../../wire/channel.js";
import { editing } from "./editing.js";
import { sendParts } from "../../ui/kept/links.js";
import { sight } from "../../stage/sight.js";
import { worldAt } from "../../stage/screen.js";

const STORED = "softrod-clipboard";
/** The beginning of a copied text. */
const PREFIX = '{"type":"softrod-fragment"';

/** What was copied last in this tab, in case storage is forbidden. */
let copied = "";

/** Copies the selection. */
export const copySelection = () => send({ do: "act", what: "copy" });

/** What was copied last, in any tab. */
function stored() {
  try {
    return localStorage.getItem(STORED) ?? copied;
  } catch {
    return copied;
  }
}

/** Pastes at the pointer, or in the middle of the canvas. @param {string} [text] from the clipboard, if it is known */
export function pasteHere(text) {
  const fragment = typeof text === "string" && text.trimStart().startsWith(PREFIX) ? text.trim() : stored();
  const seen = sight();
  if (!fragment || !seen) return;
  const { box, on } = seen;
  const at = editing.hover ?? { x: (box.left + box.right) / 2, y: (box.top + box.bottom) / 2 };
  const bytes = new TextEncoder().encode(fragment);
  let letters = "";
  for (const byte of bytes) letters += String.fromCharCode(byte);
  const { x, y } = worldAt(at, on);
  sendParts("paste", `${x.toFixed(6)},${y.toFixed(6)},${btoa(letters)}`);
}

/** Begins to listen. */
export function listenToClipboard() {
  onMessage("copied", ({ text }) => {
    copied = text;
    try {
      localStorage.setItem(STORED, text);
    } catch {
      // Forbidden or full: this tab has it in `copied`.
    }
    // Only pages served by TLS or from this machine have a clipboard.
    navigator.clipboard?.writeText(text).catch(() => {});
  });
}
