// @ts-check
/** The tools at the left of the canvas, undo and redo, and what can be done to what is selected. */
import { onMessage, send } from "../../wire/channel.js";
import { toClipboard, pasteHere } from "./clipboard.js";
import { COMMANDS } from "../../wire/commands.js";
import { make, makeButton } from "../../ui/dialog.js";
import { stepBack } from "./gestures.js";
import { change, countSelected, editing, isEditable, onEditing, setEditing, setTool } from "./editing.js";
import { withKey } from "../../ui/hands/key_table.js";
import { hasWords, larger } from "../../ui/looks.js";
import { setTakesNew, takesNew } from "./move.js";
import { floorOf, onMarksRedraw } from "../../stage/sight.js";
import { perform } from "../../wire/perform.js";
import { canvasBox } from "../../ui/viser/viser.js";

/** @type {import("./editing.js").Tool[]} */
const TOOLS = ["hand", "build", "joint", "select", "cut"];
/** What can be done to what is selected. @type {import("../../wire/wire.js").Act["what"][]} */
const ACTIONS = ["pin", "remove", "duplicate", "mirror"];
/** Also without a selection: then for the whole body. @type {typeof ACTIONS} */
const ALWAYS = ["corners", "triangulate", "rest", "keep"];

/** Pixels between the other buttons over the bar of time and what stands beside them. */
const GAP = 10;
/** Pixels by which the words above the tools may grow shorter, as when the clock runs, and the tools stay in place. */
const STAYS = 60;
/** Pixels of height that a column of tools needs, with the bar below. */
const COLUMN = 480;
/** Pixels more that it needs where it is twice as large, for a projector. */
const MORE = 150;

/** Pixels that one of them takes. @param {string} name */
function taken(name) {
  const width = document.querySelector(name)?.clientWidth;
  return width ? width + GAP : 0;
}

/** @param {import("../../wire/wire.js").CommandName} name @param {() => void} press */
function iconButton(name, press) {
  const { icon, word, label, hint } = COMMANDS[name];
  const button = makeButton("", press, "");
  button.innerHTML = `<svg viewBox="0 0 24 24" aria-hidden="true"><path d="${icon}"/></svg><span>${word ?? label}</span>`;
  button.title = hint ? withKey(hint, name) : "";
  button.ariaLabel = word ?? label; // also where its word is left out
  return button;
}

/** Puts up the tools. @param {{button: HTMLElement, row: HTMLElement, said: HTMLElement}} tracing the picture behind the body */
export function addEditStrip(tracing) {
  const strip = make("div", "softrod-edit");
  strip.setAttribute("role", "toolbar");
  strip.ariaLabel = "Editing";
  const lid = iconButton("edit", () => perform("edit"));
  const tools = make("div", "softrod-edit-tools");
  const undo = iconButton("undo", () => stepBack("undo"));
  const redo = iconButton("redo", () => stepBack("redo"));
  const buttons = TOOLS.map((tool) => {
    const button = iconButton(tool, () => setTool(tool));
    tools.append(button);
    return /** @type {const} */ ([tool, button]);
  });
  strip.append(lid, tools, undo, redo);

  const bar = make("div", "softrod-edit-bar");
  bar.setAttribute("role", "toolbar");
  bar.ariaLabel = "What is selected";
  const count = make("span", "softrod-edit-count");
  /** @param {import("../../wire/wire.js").Act["what"]} what */
  const actionButton = (what) => {
    const { label, hint = "" } = COMMANDS[what];
    const button = makeButton(label, () => send({ do: "act", what }), "");
    button.title = withKey(hint, what);
    return button;
  };
  const onSelected = [...ACTIONS.map(actionButton), makeButton("Copy", toClipboard, "")];
  const muscle = makeButton(COMMANDS.muscle.label, () => perform("muscle"), "");
  muscle.title = withKey(COMMANDS.muscle.hint ?? "", "muscle");
  const stiffen = actionButton("stiffen");
  const paste = makeButton("Paste", pasteHere, "");
  const rests = makeButton("Moved rest", () => setTakesNew(!takesNew()), "");
  rests.title = "Springs and joints of what is moved take their new lengths and angles as rest, or keep the old ones";
  const done = makeButton("Done", () => setEditing(false), "");
  bar.append(count, ...onSelected, muscle, paste, ...ALWAYS.map(actionButton), stiffen, rests, tracing.button, tracing.said, done, tracing.row);
  const live = make("div", "softrod-tell");
  live.setAttribute("role", "status");
  document.body.append(strip, bar, live);

  /** @param {Element} element @param {boolean} on */
  const showIf = (element, on) => element.toggleAttribute("hidden", !on);
  /** Where the tools begin. */
  let above = 0;
  let before = { undo: "", redo: "", selected: editing.selected };
  const show = () => {
    const able = isEditable();
    const focused = document.activeElement;
    const { on, tool, selected, undo: undoable, redo: redoable } = editing;
    document.documentElement.dataset.softrodTool = able && on ? tool : "";
    strip.hidden = !able;
    bar.hidden = !(able && on);
    lid.ariaPressed = String(on);
    showIf(tools, on);
    for (const [one, button] of buttons) button.ariaPressed = String(tool === one);
    showIf(undo, on || undoable !== "" || redoable !== "");
    showIf(redo, on || redoable !== "");
    undo.disabled = !undoable;
    redo.disabled = !redoable;
    undo.title = undoable ? `Undo: ${undoable} (Ctrl Z)` : "Nothing to undo";
    redo.title = redoable ? `Redo: ${redoable} (Ctrl Y)` : "Nothing to redo";
    const some = countSelected();
    for (const button of onSelected) showIf(button, some > 0);
    showIf(muscle, selected.springs.length + selected.joints.length > 0);
    const offered = stiffen.hidden && editing.stiffen > 0;
    showIf(stiffen, editing.stiffen > 0);
    stiffen.textContent = `Keep it, ${Number(editing.stiffen.toPrecision(3))} times as stiff`;
    rests.ariaPressed = String(takesNew());
    if (on && selected !== before.selected) live.textContent = some ? `${named(selected)} selected` : "Nothing selected";
    else if (undoable !== before.undo || redoable !== before.redo) {
      const isUndone = redoable !== "" && redoable === before.undo;
      live.textContent = isUndone ? `Undone: ${redoable}` : undoable;
    }
    before = { undo: undoable, redo: redoable, selected };
    // What had the focus is gone, or cannot be pressed any more.
    const isIn = focused instanceof HTMLButtonElement && (strip.contains(focused) || bar.contains(focused));
    if (isIn && (focused.disabled || !focused.checkVisibility())) lid.focus();
    place();
    if (offered) stiffen.scrollIntoView({ block: "nearest", inline: "nearest" }); // on a phone the bar is longer than it shows
  };
  const place = () => {
    const canvas = canvasBox();
    if (!canvas || strip.hidden) return;
    const hud = document.querySelector(".softrod-hud")?.getBoundingClientRect();
    const left = canvas.left + 14;
    const free = Math.max(canvas.top, hud?.bottom ?? 0) + 10;
    const top = free < above && above < free + STAYS ? above : free;
    above = editing.on ? top : 0;
    const bottom = floorOf(canvas);
    // On a phone they stand in a row, without words.
    const low = bottom - top < COLUMN + (larger() - 1) * MORE;
    const beside = taken(".softrod-box-lid");
    strip.classList.toggle("softrod-edit-row", low || !editing.on);
    strip.classList.toggle("softrod-edit-closed", !editing.on);
    strip.classList.toggle("softrod-words", !editing.on && hasWords(canvas));
    bar.classList.toggle("softrod-edit-row", low);
    const words = inWords(editing.selected);
    const counted = low && words.includes(",") ? `${countSelected()} parts` : words;
    if (count.textContent !== counted) count.textContent = counted;
    if (!editing.on) {
      // Out of the body's way, beside the box of instruments.
      Object.assign(strip.style, { left: `${left + beside}px`, top: "auto", bottom: `${window.innerHeight - bottom + 10}px` });
      return;
    }
    Object.assign(strip.style, { left: `${left}px`, bottom: "auto" });
    // The row is as wide as a phone, and the scale bar is there, too.
    const scale = document.querySelector(".softrod-scale")?.getBoundingClientRect();
    const under = low && scale && scale.left < left + strip.offsetWidth ? scale.bottom : 0;
    strip.style.top = `${Math.max(top, under + 10)}px`;
    // Over the bar of time, between the box of instruments and the View menu.
    bar.style.left = `${left + beside}px`;
    bar.style.maxWidth = `${canvas.right - left - beside - taken(".softrod-menu-lid") - 14}px`;
    bar.style.bottom = `${window.innerHeight - bottom + 8}px`;
  };
  let shown = "";
  let { selected } = editing;
  onEditing(() => {
    // Not at every move of the pointer.
    const { on, tool, undo, redo, stiffen: factor } = editing;
    const now = [on, tool, undo, redo, factor, takesNew()].join("|");
    if (now === shown && editing.selected === selected) return;
    [shown, selected] = [now, editing.selected];
    show();
  });
  onMessage("pageState", () => {
    if (editing.on && !isEditable()) change({ on: false });
    show();
  });
  onMarksRedraw(place); // after the scale bar
  window.addEventListener("resize", place);
  show();
}

/** @param {number} count @param {string} one @param {string} several */
const number = (count, one, several) => (count ? [`${count} ${count === 1 ? one : several}`] : []);

/** What is selected, in words. @param {import("./pick.js").Parts} parts */
const inWords = ({ masses, springs, joints }) =>
  [...number(masses.length, "mass", "masses"), ...number(springs.length, "spring", "springs"), ...number(joints.length, "joint", "joints")].join(", ");

/** As in words; one alone by its number. @param {import("./pick.js").Parts} parts */
function named(parts) {
  const { masses: [mass], springs: [spring], joints: [joint] } = parts;
  if (countSelected() !== 1) return inWords(parts);
  return mass !== undefined ? `mass ${mass}` : spring !== undefined ? `spring ${spring}` : `joint ${joint}`;
}
