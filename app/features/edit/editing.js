// @ts-check
/**
 * What the page knows of an edit that is under way: the tool, what is selected, and what the pointer does. Those who
 * draw it or show it are called whenever it changes.
 *
 * @typedef {import("./pick.js").Place} Place
 * @typedef {import("./pick.js").Parts} Parts
 * @typedef {"hand" | "build" | "joint" | "select" | "cut"} Tool
 * @typedef {{kind: "line", from: number, start: Place, at: Place, to: number}} Line from a mass or a place to another
 * @typedef {{kind: "marquee", start: Place, at: Place, add: boolean}} Marquee
 * @typedef {{kind: "move", start: Place, dx: number, dy: number, moved: boolean}} Move pixels
 * @typedef {{kind: "stroke", points: Place[]}} Stroke
 * @typedef {{kind: "turn", joint: number, angle: number}} Turn degrees
 * @typedef {Line | Marquee | Move | Stroke | Turn} Drag
 */
import { has } from "../../wire/channel.js";

export const editing = {
  /** Whether the tools are out. */
  on: false,
  /** @type {Tool} */
  tool: "build",
  /** What is selected. @type {Parts} */
  selected: { masses: [], springs: [], joints: [] },
  /** What undo takes back, and what redo does again; empty if there is nothing. */
  undo: "",
  redo: "",
  /** The factor of stiffness with which the body could keep a shape that was refused; 0 for none. */
  stiffen: 0,
  /** Where the pointer is over the canvas, or null. @type {Place | null} */
  hover: null,
  /** What the pointer is doing. @type {Drag | null} */
  drag: null,
  /** The mass from which the next spring leads, or -1. */
  chain: -1,
  /** Whether it is to be the mass that is built last, as soon as the server has said which. */
  chaining: false,
  /** The mass whose corners are shown, or -1. */
  corner: -1,
  /** The spring from which a joint is to lead, or -1. */
  arm: -1,
};

/** @type {readonly string[]} */
const TOOLS = ["hand", "build", "joint", "select", "cut"];
/** Whether a command is a tool. @param {string | undefined} command @returns {command is Tool} */
export const isTool = (command) => command !== undefined && TOOLS.includes(command);

/** @type {(() => void)[]} */
const listeners = [];
/** Calls back whenever something of it changed. @param {() => void} listener */
export const onEditing = (listener) => listeners.push(listener);

/** Changes some of it. @param {Partial<typeof editing>} changes */
export function change(changes) {
  Object.assign(editing, changes);
  for (const listener of listeners) listener();
}

/** Whether this page has the tools. */
export const isEditable = () => has("edit");

/** How much is selected. */
export const countSelected = () =>
  editing.selected.masses.length + editing.selected.springs.length + editing.selected.joints.length;

/** Nothing is under way. */
const NOTHING = { drag: null, chain: -1, chaining: false, corner: -1, arm: -1 };
/** Gives up what is under way. @returns {boolean} whether there was something, beside corners that show */
export function giveUp() {
  const { drag, chain, chaining, corner, arm } = editing;
  const some = drag !== null || chain >= 0 || chaining || arm >= 0;
  if (some || corner >= 0) change(NOTHING);
  return some;
}

/** Another tool, which begins with nothing under way. @param {Tool} tool */
export const setTool = (tool) => change({ tool, ...NOTHING });

/** Takes the tools out, or puts them away. @param {boolean} on */
export const setEditing = (on) => change({ on: on && isEditable(), ...NOTHING });
