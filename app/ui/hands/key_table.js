// @ts-check
/**
 * The page's keys, by what is printed on them: letters stand in other places on Dvorak and AZERTY keyboards, and a key is
 * looked for by its letter.
 *
 * @typedef {import("../../wire/wire.js").CommandName} CommandName
 */
import { COMMANDS } from "../../wire/commands.js";
import { say } from "../../words/words.js";

/** What the places of keys have on them on an American keyboard. @type {Record<string, string>} */
const PLACES = { Space: " ", Comma: ",", Period: "." };

/**
 * What is printed on a key, in lower case. Where that is no Latin letter (a Cyrillic or Greek one, or a key of an input
 * method), what an American keyboard has in its place.
 *
 * @param {{key: string, code: string}} event of a keyboard
 */
export function printed({ key, code }) {
  if (/^[ -~]$/.test(key)) return key.toLowerCase();
  if (key.length > 1 && !["Dead", "Process", "Unidentified"].includes(key)) return key;
  return PLACES[code] ?? (/^(?:Key([A-Z])|Digit(\d))$/.test(code) ? code.slice(-1).toLowerCase() : key);
}

const rows = /** @type {[CommandName, import("../../wire/commands.js").Row][]} */ (Object.entries(COMMANDS));

/**
 * The command that a key gives, with Ctrl or without; with Shift it may be another one.
 *
 * @param {{key: string, code: string, ctrlKey?: boolean, metaKey?: boolean, shiftKey?: boolean}} event of a keyboard
 * @param {string} [where] see `Row` in commands.py
 */
export function commandOf(event, where = "") {
  const key = `${event.ctrlKey || event.metaKey ? "ctrl " : ""}${event.shiftKey ? "shift " : ""}${printed(event)}`;
  /** @param {string} wanted */
  const find = (wanted) => rows.find(([, row]) => (row.where ?? "") === where && row.keys.includes(wanted))?.[0];
  return find(key) ?? find(key.replace("shift ", ""));
}

/** Keys that have names. @type {Record<string, import("../../words/keys.js").Plain>} */
const NAMED = {
  Ctrl: "key-ctrl",
  Shift: "key-shift",
  Space: "key-space",
  Esc: "key-esc",
  Delete: "key-delete",
  Backspace: "key-backspace",
  Tab: "key-tab",
};

/** The first key of a command as the page's language calls it; empty without one. @param {CommandName} command */
export const keyOf = (command) =>
  (COMMANDS[command].shown ?? "")
    .split(" ")
    .map((key) => (key in NAMED ? say(NAMED[key]) : key))
    .join(" ");

/** A sentence or a name with the key that does it, for tooltips. @param {string} text @param {CommandName} command */
export const withKey = (text, command) => (keyOf(command) ? say("key-too", { text, key: keyOf(command) }) : text);
