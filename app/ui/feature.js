// @ts-check
/**
 * The door of a feature in the page's script: the default export of the script with the name of its folder.
 *
 * @typedef {import("../wire/wire.js").PageCommands} PageCommands
 */

/**
 * @template {keyof PageCommands} N the feature's name; it has a function for each command that the page does itself
 * @typedef {object} Feature
 * @property {Record<PageCommands[N], () => void>} commands
 * @property {() => void} begin puts up what it has in the page, once there is a page
 */

export {};
