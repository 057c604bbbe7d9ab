// @ts-check
/** What the server sends to the script beside the body, as JSON of some kind, and what the script asks it for. */
import { send } from "./channel.js";

const NODE = "/softrod/mail/";
/** @type {Map<string, (letter: any) => void>} */
const readers = new Map();

/** Calls back with every letter of a kind; "pictures-3" is of the kind "pictures", too. @param {string} kind @param {(letter: any) => void} reader */
export const onMail = (kind, reader) => readers.set(kind, reader);

/** Whether a node carries letters. @param {string} name */
export const isMail = (name) => name.startsWith(NODE);

/** Opens a letter. @param {string} name of its node @param {Uint8Array | undefined} data JSON */
export function open(name, data) {
  if (data) readers.get(name.slice(NODE.length).replace(/-\d+$/, ""))?.(JSON.parse(new TextDecoder().decode(data)));
}

/** Asks the server for something. @param {{do: string, [field: string]: unknown}} what */
export const ask = (what) => send("ask", JSON.stringify(what));
