// @ts-check
/**
 * Editing by keys: the tools' letters, undo and redo everywhere, and on the body itself, which the Tab key reaches, all
 * that the pointer can do.
 */
import { shown } from "../../stage/canvas.js";
import { send } from "../../wire/channel.js";
import { pasteHere, toClipboard } from "./clipboard.js";
import { line, stepBack } from "./gestures.js";
import { step } from "./places.js";
import { change, countSelected, editing, giveUp, isEditable, isTool, setTool } from "./editing.js";
import { ARROWS, commandOf } from "../../ui/hands/key_table.js";
import { isFree, swallow } from "../../ui/hands/keys.js";
import { moveSelected } from "./move.js";
import { chosenMass } from "../../stage/overlay.js";
import { sight } from "../../stage/sight.js";
import { massAt } from "../../ui/hands/pointer.js";

/** By how much less an arrow moves with Shift. */
const FINE = 0.1;

/** Whether keys go to the page, even with Ctrl: nobody types, no dialog is open. @param {KeyboardEvent} event */
const isFreeWithCtrl = ({ target }) => isFree(/** @type {any} */ ({ target }));

/** Whether some text of the page is marked: that is what is copied then. */
const isTextMarked = () => !(getSelection()?.isCollapsed ?? true);

/** Whether a key takes an instrument away. @param {KeyboardEvent} event */
const isForInstrument = ({ target }) => target instanceof Element && target.matches(".softrod-grip");

/** The mass that the keys have chosen, if they are on the body. @param {KeyboardEvent} event */
const massOf = ({ target }) => (target instanceof Element && target.matches(".softrod-body") ? chosenMass() : -1);

/** The mass that is meant where nothing is selected: that of the keys, or the one under the pointer. @param {number} mass */
function aim(mass) {
  const under = mass < 0 && editing.hover ? massAt(editing.hover, "mouse") : mass;
  return under >= 0 ? { under } : {};
}

/** @param {KeyboardEvent} event @returns {boolean} whether that was one */
function withCtrl(event) {
  const { shiftKey, repeat } = event;
  if (!isFreeWithCtrl(event)) return false;
  const [everywhere, does] = [commandOf(event), commandOf(event, "edit")];
  if (everywhere === "undo") stepBack(shiftKey ? "redo" : "undo");
  else if (everywhere === "redo" && !shiftKey) stepBack("redo");
  else if (!editing.on || shiftKey) return false;
  else if (does === "duplicate" || does === "all") repeat || send({ do: "act", what: does });
  else if (does === "copy" && countSelected() && !isTextMarked()) repeat || toClipboard();
  else return false;
  return true;
}

/** Moves what is selected, or the mass of the keys, by a step of the grid. @param {KeyboardEvent} event @param {number} mass */
function nudge({ key, shiftKey }, mass) {
  const { pictured: plan } = shown();
  const by = step() * (plan?.scale ?? 1) * (shiftKey ? FINE : 1);
  const [x, y] = ARROWS[key];
  if (countSelected() || mass >= 0) moveSelected(x * by, y * by, { ...aim(mass), keys: true });
}

/** Enter on a mass. @param {number} mass */
function enter(mass) {
  const { tool, chain } = editing;
  const none = { x: 0, y: 0 };
  if (tool === "select") send({ do: "select", masses: [mass], toggle: true });
  else if (tool === "joint") send({ do: "act", what: "corners", mass });
  else if (tool === "build" && chain === mass) change({ chain: -1 });
  else if (tool === "build" && chain >= 0) line(chain, none, mass, none);
  else if (tool === "build") change({ chain: mass });
  else return false;
  return true;
}

/** A spring to a new mass, away from the body. @param {number} mass */
function grow(mass) {
  const seen = sight();
  if (!seen) return;
  const { plan, places, on } = seen;
  const far = Math.max(5 * step() * plan.scale * on.step, 30);
  // Away from those that it is joined to already, or upwards.
  let [dx, dy] = [0, 0];
  for (let s = 0; 2 * s < plan.springs.length; s++) {
    const [a, b] = [plan.springs[2 * s], plan.springs[2 * s + 1]];
    if (a !== mass && b !== mass) continue;
    const other = a === mass ? b : a;
    dx += places[2 * mass] - places[2 * other];
    dy += places[2 * mass + 1] - places[2 * other + 1];
  }
  const size = Math.hypot(dx, dy);
  const [x, y] = size > 1 ? [dx / size, dy / size] : [0, -1];
  line(mass, { x: 0, y: 0 }, -1, { x: places[2 * mass] + far * x, y: places[2 * mass + 1] + far * y });
}

/** @param {KeyboardEvent} event */
function press(event) {
  if (!isEditable()) return;
  const { key, ctrlKey, metaKey, altKey } = event;
  if ((ctrlKey || metaKey) && !altKey) {
    if (withCtrl(event)) swallow(event);
    return;
  }
  const mass = massOf(event);
  if (altKey) {
    if (!editing.on || !ARROWS[key] || !isFreeWithCtrl(event)) return;
    nudge(event, mass);
    swallow(event);
    return;
  }
  if (!isFree(event)) return;
  if (!editing.on) return;
  const does = commandOf(event, "edit");
  if (isTool(does)) setTool(does);
  else if (does === "remove" || does === "pin") {
    if (does === "remove" && isForInstrument(event)) return;
    if (!event.repeat) send({ do: "act", what: does, ...aim(mass) });
  } else if (key === "Escape") {
    if (!leave()) return;
  } else if (mass >= 0 && key === "Enter") {
    if (!enter(mass)) return;
  } else if (mass >= 0 && key === "+") grow(mass);
  else return;
  swallow(event);
}

/** Leaves what is under way: the chain, then the selection. @returns {boolean} whether there was something */
function leave() {
  if (giveUp()) return true;
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
