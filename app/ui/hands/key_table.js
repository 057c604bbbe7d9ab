// @ts-check
/**
 * Commands by keys. Keys are found by the letters printed on them, whose places differ between keyboards.
 *
 * @typedef {import("../../wire/wire.js").CommandName} CommandName
 */
import { COMMANDS } from "../../wire/commands.js";

/** Directions of the arrow keys, y upwards. @type {Record<string, [number, number]>} */
export const ARROWS = { ArrowUp: [0, 1], ArrowDown: [0, -1], ArrowLeft: [-1, 0], ArrowRight: [1, 0] };

/** Characters of an American keyboard, by the codes of keys. @type {Record<string, string>} */
const PLACES = { Space: " ", Comma: ",", Period: "." };

/**
 * The character printed on a key, in lower case; if that is no Latin letter (but Cyrillic, Greek, or a key of an input
 * method), that of an American keyboard.
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
 * The command of a key with its modifiers; a key without a command of its own for Shift has the same one with it.
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

/** Appends the key of a command to a text, for tooltips. @param {string} text @param {CommandName} command */
export const withKey = (text, command) => (COMMANDS[command].shown ? `${text} (${COMMANDS[command].shown})` : text);
