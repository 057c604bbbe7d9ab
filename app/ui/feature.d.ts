import type { PageCommands } from "../wire/wire.js";

/**
 * The interface of a feature in the page: the default export of the script with the name of its folder. It has a function for
 * each command that the page executes itself, and `begin` adds its elements to the page, once viser's page is there.
 */
export type Feature<N extends keyof PageCommands> = { commands: Record<PageCommands[N], () => void>; begin: () => void };
