import type { PageCommands } from "../wire/wire.js";

/**
 * The door of a feature in the page's script: the default export of the script with the name of its folder. It has a
 * function for each command that the page does itself, and `begin` puts up what it has in the page, once there is one.
 */
export type Feature<N extends keyof PageCommands> = { commands: Record<PageCommands[N], () => void>; begin: () => void };
