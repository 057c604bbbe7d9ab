// @ts-check
/** Does a command of the table, whether it is the server's or the page's own. */
import { has, onMessage, send } from "./channel.js";
import { COMMANDS } from "./commands.js";

/** @typedef {import("./wire.js").CommandName} CommandName */

/** What the page does itself. @type {Map<string, () => void>} */
const own = new Map();

/** Has the page do some commands itself. @param {Record<string, () => void>} commands */
export function provide(commands) {
  for (const [name, act] of Object.entries(commands)) own.set(name, act);
}

/** Whether the page has the control without which a command is left out. @param {CommandName} command */
export const isOffered = (command) => has(COMMANDS[command].needs ?? "") || !COMMANDS[command].needs;

/** @param {CommandName} command */
export function perform(command) {
  if (!isOffered(command)) return;
  const act = own.get(command);
  if (act) act();
  else send({ do: "perform", command });
}

/** Does those commands of the page that were given in the panel or in the palette. */
export const listenToCommands = () => onMessage("run", ({ command }) => perform(command));
