// @ts-check
/**
 * Editing by keys: letters choose tools, undo and redo work everywhere, and once the Tab key has reached the body, keys
 * can do all that the pointer can.
 */
import { shown } from "../../stage/canvas.js";
import { pageState, send } from "../../wire/channel.js";
import { pasteHere, copySelection } from "./clipboard.js";
import { line, stepBack } from "./gestures.js";
import { crossAt, dropCross, moveCross, pressCross } from "./cross.js";
import { placeOf, springsOf, step } from "./pick.js";
import { tell } from "./speech.js";
import { placeText } from "../../stage/measures.js";
import { change, countSelected, editing, giveUp, isEditable, isTool, setTool } from "./editing.js";
import { ARROWS } from "../../ui/hands/arrow_keys.js";
import { commandOf } from "../../ui/hands/key_table.js";
import { isFree, swallow } from "../../ui/hands/keys.js";
import { moveSelected } from "./move.js";
import { chosenMass } from "../../stage/overlay.js";
import { sight } from "../../stage/sight.js";
import { massAt } from "../../ui/hands/pointer.js";

/** Factor by which an arrow key moves less with Shift. */
const FINE = 0.1;
/** Length of a new spring, in steps of the grid, and in pixels at least. */
const NEW_STEPS = 5;
const MIN_NEW = 30;
const NOWHERE = { x: 0, y: 0 };
/** Milliseconds after a movement by keys in which its place is not said yet. */
const SAID_AFTER = 250;
/** The timer of what is said next. */
let saying = 0;

/** Whether keys with Ctrl go to the page: no text is being typed and no dialog is open. @param {KeyboardEvent} event */
const isFreeWithCtrl = ({ target }) => isFree(/** @type {any} */ ({ target }));

/** Whether text of the page is selected, which is copied then. */
const isTextSelected = () => !(getSelection()?.isCollapsed ?? true);

/** Whether a key goes to an instrument. @param {KeyboardEvent} event */
const isForInstrument = ({ target }) => target instanceof Element && target.matches(".softrod-grip");

/** The mass that is chosen by keys, if the body has the focus; else -1. @param {KeyboardEvent} event */
const massOf = ({ target }) => (target instanceof Element && target.matches(".softrod-body") ? chosenMass() : -1);

/** The target without a selection: the mass that is chosen by keys, or the one under the pointer. @param {number} mass */
function aim(mass) {
  const under = mass < 0 && editing.hover ? massAt(editing.hover, "mouse") : mass;
  return under >= 0 ? { under } : {};
}

/** @param {KeyboardEvent} event @returns {boolean} whether it did something */
function pressWithCtrl(event) {
  const { shiftKey, repeat } = event;
  if (!isFreeWithCtrl(event)) return false;
  const [everywhere, does] = [commandOf(event), commandOf(event, "edit")];
  if (everywhere === "undo") stepBack(shiftKey ? "redo" : "undo");
  else if (everywhere === "redo" && !shiftKey) stepBack("redo");
  else if (!editing.on || shiftKey) return false;
  else if (does === "duplicate" || does === "all") repeat || send({ do: "act", what: does });
  else if (does === "copy" && countSelected() && !isTextSelected()) repeat || copySelection();
  else return false;
  return true;
}

/** Moves the selection, or the chosen mass, by a step of the grid. @param {KeyboardEvent} event @param {number} mass */
function nudge({ key, shiftKey }, mass) {
  const { pictured: plan } = shown();
  const by = step() * (plan?.scale ?? 1) * (shiftKey ? FINE : 1);
  const [x, y] = ARROWS[key];
  if (!countSelected() && mass < 0) return;
  moveSelected(x * by, y * by, { ...aim(mass), keys: true });
  clearTimeout(saying);
  const [moved = mass] = editing.selected.masses;
  saying = setTimeout(() => {
    const { frame } = shown();
    if (frame && moved >= 0) tell(placeText(frame.positions[2 * moved], frame.positions[2 * moved + 1], pageState().unit ?? ""));
  }, SAID_AFTER);
}

/** Selects a mass, and all that is between it and those selected before: as a frame around them would. @param {number} mass */
function surround(mass) {
  const seen = sight();
  if (!seen) return;
  const { joints } = seen.plan;
  const masses = [...new Set([...editing.selected.masses, mass])];
  const springs = springsOf(seen).filter(({ ends }) => ends.every((end) => masses.includes(end))).map(({ spring }) => spring);
  const between = Array.from({ length: joints.length / 4 }, (_, i) => i).filter((i) => joints.subarray(4 * i, 4 * i + 2).every((one) => springs.includes(one)));
  const selected = { masses, springs, joints: between };
  change({ selected }); // at once: the next key may come before the server has told of it
  send({ do: "select", ...selected });
}

/** The Enter key on a mass. @param {number} mass @param {boolean} isMore with Shift @returns {boolean} whether it did something */
function enter(mass, isMore) {
  const { tool, chain } = editing;
  if (tool === "select" && isMore) surround(mass);
  else if (tool === "select") send({ do: "select", masses: [mass], toggle: true });
  else if (tool === "joint") send({ do: "act", what: "corners", mass });
  else if (tool === "build" && chain === mass) change({ chain: -1 });
  else if (tool === "build" && chain >= 0) line(chain, NOWHERE, mass, NOWHERE);
  else if (tool === "build") change({ chain: mass });
  else return false;
  return true;
}

/** Selects the next spring or joint at a mass. @param {number} mass @param {number} by 1 for the next, -1 for the one before */
function walk(mass, by) {
  const seen = sight();
  if (!seen) return;
  const { joints } = seen.plan;
  const all = [
    ...springsOf(seen).filter(({ ends }) => ends.includes(mass)).map(({ spring }) => ({ springs: [spring] })),
    ...Array.from({ length: joints.length / 4 }, (_, j) => j).filter((j) => joints[4 * j + 2] === mass).map((j) => ({ joints: [j] })),
  ];
  const now = JSON.stringify(editing.selected.springs.length ? { springs: editing.selected.springs } : { joints: editing.selected.joints });
  const at = all.findIndex((part) => JSON.stringify(part) === now);
  const next = at < 0 ? all.at(by > 0 ? 0 : -1) : all[(at + by + all.length) % all.length];
  if (next) send({ do: "select", ...next });
}

/** Adds a spring to a new mass. @param {number} mass */
function grow(mass) {
  const seen = sight();
  if (!seen) return;
  const at = placeOf(seen, mass);
  const far = Math.max(NEW_STEPS * step() * seen.plan.scale * seen.on.step, MIN_NEW);
  // Away from its neighbours, or upwards.
  let [dx, dy] = [0, 0];
  for (const { ends: [a, b] } of springsOf(seen)) {
    if (a !== mass && b !== mass) continue;
    const { x, y } = placeOf(seen, a === mass ? b : a);
    dx += at.x - x;
    dy += at.y - y;
  }
  const size = Math.hypot(dx, dy);
  const [x, y] = size > 1 ? [dx / size, dy / size] : [0, -1];
  line(mass, NOWHERE, -1, { x: at.x + far * x, y: at.y + far * y });
}

/** @param {KeyboardEvent} event */
function press(event) {
  if (!isEditable()) return;
  const { key, ctrlKey, metaKey, altKey } = event;
  if ((ctrlKey || metaKey) && !altKey) {
    if (pressWithCtrl(event)) swallow(event);
    return;
  }
  const isOnBody = event.target instanceof Element && event.target.matches(".softrod-body");
  const isCross = isOnBody && crossAt() !== null;
  const mass = isCross ? -1 : massOf(event);
  if (altKey) {
    if (!editing.on || !ARROWS[key] || !isFreeWithCtrl(event)) return;
    nudge(event, mass);
    swallow(event);
    return;
  }
  if (!isFree(event) || !editing.on) return;
  const does = commandOf(event, "edit");
  const way = ARROWS[key];
  if (isCross && way) moveCross(way, event.shiftKey);
  else if (isCross && (key === "Enter" || key === " ")) pressCross();
  else if (mass >= 0 && way && event.shiftKey && editing.tool === "select") walk(mass, way[0] - way[1] > 0 ? 1 : -1);
  else if (isTool(does)) setTool(does);
  else if (does === "remove" || does === "pin") {
    if (does === "remove" && isForInstrument(event)) return;
    // What was built last is still selected: that is not what keys have chosen since.
    const chosen = mass >= 0 && editing.tool !== "select" ? { mass } : aim(mass);
    if (!event.repeat) send({ do: "act", what: does, ...chosen });
  } else if (key === "Escape") {
    if (!leave()) return;
  } else if (mass >= 0 && key === "Enter") {
    if (!enter(mass, event.shiftKey)) return;
  } else if (mass >= 0 && key === "+") grow(mass);
  else return;
  swallow(event);
}

/** Ends the present gesture, or else the selection. @returns {boolean} whether there was one */
function leave() {
  if (giveUp() || dropCross()) return true;
  if (!countSelected()) return false;
  send({ do: "select" });
  return true;
}

/** Begins to listen; before the keys of the body are listened to. */
export function listenToEditKeys() {
  window.addEventListener("keydown", press, true);
  window.addEventListener("paste", (event) => {
    if (!editing.on || !isEditable() || !isFreeWithCtrl(/** @type {any} */ (event))) return;
    event.preventDefault();
    pasteHere(event.clipboardData?.getData("text/plain") ?? "");
  });
}
