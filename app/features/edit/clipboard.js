// @ts-check
/**
 * Copying parts of a body and pasting them, also into another tab: by the clipboard where the browser lets a page have
 * it, and by the storage that the tabs of one server share.
 */
import { onMessage, send } from "../../wire/channel.js";
import { editing } from "./editing.js";
import { sendParts } from "../../ui/kept/links.js";
import { sight } from "../../stage/sight.js";
import { worldAt } from "../../stage/screen.js";

const STORED = "softrod-clipboard";
const BEGINS = '{"type":"softrod-fragment"';

/** What was copied last in this tab, where storage is forbidden. */
let copied = "";

/** Has what is selected copied. */
export const toClipboard = () => send({ do: "act", what: "copy" });

/** What was copied last, in whichever tab. */
function stored() {
  try {
    return localStorage.getItem(STORED) ?? copied;
  } catch {
    return copied;
  }
}

/** Puts it in at the pointer, or in the middle of the canvas. @param {string} [text] what is pasted, if it is known */
export function pasteHere(text) {
  const fragment = typeof text === "string" && text.trimStart().startsWith(BEGINS) ? text.trim() : stored();
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
      // Forbidden or full: this tab still has it.
    }
    // Only a page of this machine or by TLS has a clipboard.
    navigator.clipboard?.writeText(text).catch(() => {});
  });
}
