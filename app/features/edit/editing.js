// @ts-check
/**
 * The state of editing: the tool, what is selected, and what the pointer is doing. Listeners are called whenever it
 * changes.
 *
 * @typedef {import("./pick.js").Place} Place
 * @typedef {import("./pick.js").Parts} Parts
 * @typedef {"hand" | "build" | "joint" | "select" | "cut"} Tool
 * @typedef {{kind: "line", from: number, start: Place, at: Place, to: number}} Line between masses, or places where those are -1
 * @typedef {{kind: "marquee", start: Place, at: Place, add: boolean}} Marquee
 * @typedef {{kind: "move", start: Place, dx: number, dy: number, moved: boolean}} Move pixels
 * @typedef {{kind: "stroke", points: Place[]}} Stroke
 * @typedef {{kind: "turn", joint: number, angle: number}} Turn degrees
 * @typedef {Line | Marquee | Move | Stroke | Turn} Drag
 */
import { has } from "../../wire/channel.js";
import { joined, say } from "../../words/words.js";

export const editing = {
  /** Whether the tools are shown. */
  on: false,
  /** @type {Tool} */
  tool: "build",
  /** @type {Parts} */
  selected: { masses: [], springs: [], joints: [] },
  /** Names of the changes that can be undone and redone; empty for none. */
  undo: "",
  redo: "",
  /** The number of changes that can be undone. */
  count: 0,
  /** The factor by which a stiffer body could keep the shape that it cannot keep now; 0 for none. */
  stiffen: 0,
  /** The place of the pointer over the canvas, or null. @type {Place | null} */
  hover: null,
  /** The present drag of the pointer. @type {Drag | null} */
  drag: null,
  /** The mass at which the next spring begins, or -1. */
  chain: -1,
  /** Whether that will be the mass that is being created, once the server has reported its number. */
  chaining: false,
  /** The mass whose corners are shown, or -1. */
  corner: -1,
  /** The first spring of a new joint, or -1. */
  arm: -1,
};

/** @type {readonly string[]} */
const TOOLS = ["hand", "build", "joint", "select", "cut"];
/** Whether a command is a tool. @param {string | undefined} command @returns {command is Tool} */
export const isTool = (command) => command !== undefined && TOOLS.includes(command);

/** @type {(() => void)[]} */
const listeners = [];
/** Calls back whenever the state changes. @param {() => void} listener */
export const onEditing = (listener) => listeners.push(listener);

/** Changes the state. @param {Partial<typeof editing>} changes */
export function change(changes) {
  Object.assign(editing, changes);
  for (const listener of listeners) listener();
}

/** Whether this page has the tools. */
export const isEditable = () => has("edit");

/** The number of selected parts. */
export const countSelected = () =>
  editing.selected.masses.length + editing.selected.springs.length + editing.selected.joints.length;

/** No gesture is under way. */
const NO_GESTURE = { drag: null, chain: -1, chaining: false, corner: -1, arm: -1 };
/** Ends the present gesture. @returns {boolean} whether there was one; corners that are shown do not count */
export function giveUp() {
  const { drag, chain, chaining, corner, arm } = editing;
  const some = drag !== null || chain >= 0 || chaining || arm >= 0;
  if (some || corner >= 0) change(NO_GESTURE);
  return some;
}

/** Changes the tool, and ends the present gesture. @param {Tool} tool */
export const setTool = (tool) => change({ tool, ...NO_GESTURE });

/** Shows or hides the tools. @param {boolean} on */
export const setEditing = (on) => change({ on: on && isEditable(), ...NO_GESTURE });

/** The selected kinds of parts, each as in "2 masses". @param {Parts} parts */
export const kindsOf = ({ masses, springs, joints }) => [
  ...(masses.length ? [say("edit-masses", { count: masses.length })] : []),
  ...(springs.length ? [say("edit-springs", { count: springs.length })] : []),
  ...(joints.length ? [say("edit-joints", { count: joints.length })] : []),
];

/** A selection in words, as in "2 masses, 1 spring". @param {Parts} parts */
export const inWords = (parts) => joined(kindsOf(parts));

/** The same; a single part by its number. @param {Parts} parts */
export function nameOf(parts) {
  const { masses: [mass], springs: [spring], joints: [joint] } = parts;
  if (parts.masses.length + parts.springs.length + parts.joints.length !== 1) return inWords(parts);
  if (mass !== undefined) return say("edit-mass", { number: String(mass) });
  return spring !== undefined ? say("edit-spring", { number: String(spring) }) : say("edit-joint", { number: String(joint) });
}
