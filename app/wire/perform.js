// @ts-check
/** Executes commands of the table, in the page or by the server. */
import { has, onMessage, send } from "./channel.js";
import { COMMANDS } from "./commands.js";

/** @typedef {import("./wire.js").CommandName} CommandName */

/** Commands of the page. @type {Map<string, () => void>} */
const own = new Map();

/** Adds commands that the page executes itself. @param {Record<string, () => void>} commands */
export function provide(commands) {
  for (const [name, act] of Object.entries(commands)) own.set(name, act);
}

/** True if the page has the control that a command needs. @param {CommandName} command */
export const isOffered = (command) => has(COMMANDS[command].needs ?? "") || !COMMANDS[command].needs;

/** @param {CommandName} command */
export function perform(command) {
  if (!isOffered(command)) return;
  const act = own.get(command);
  if (act) act();
  else send({ do: "perform", command });
}

/** Begins to execute commands of the page that are chosen in the panel or in the palette. */
export const listenToCommands = () => onMessage("run", ({ command }) => perform(command));
