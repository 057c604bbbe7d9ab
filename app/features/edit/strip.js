// @ts-check
/** The strip of tools where lines start on the canvas, and the bar with what can be done to the selection. */
import { onMessage, send } from "../../wire/channel.js";
import { copySelection, pasteHere } from "./clipboard.js";
import { COMMANDS } from "../../wire/commands.js";
import { make, makeButton, overCanvas } from "../../ui/dialog.js";
import { stepBack } from "./gestures.js";
import { change, countSelected, editing, inWords, isEditable, kindsOf, nameOf, onEditing, setEditing, setTool } from "./editing.js";
import { addSpeech, tell } from "./speech.js";
import { withKey } from "../../ui/hands/key_table.js";
import { isSheet } from "../../ui/gui/panel.js";
import { hasWords, larger } from "../../ui/looks.js";
import { setTakesNewLengths, takesNewLengths } from "./move.js";
import { floorOf } from "../../stage/dock.js";
import { sidesOf } from "../../stage/sides.js";
import { onMarksRedraw } from "../../stage/sight.js";
import { perform } from "../../wire/perform.js";
import { canvasBox } from "../../ui/viser/viser.js";
import { decimal, say } from "../../words/words.js";

/** @typedef {import("../../wire/wire.js").Act["what"]} Action */

/** @type {import("./editing.js").Tool[]} */
const TOOLS = ["hand", "build", "joint", "select", "cut"];
/** Actions on a selection. @type {Action[]} */
const ACTIONS = ["pin", "remove", "duplicate", "mirror"];
/** Actions that without a selection are for the whole body. @type {Action[]} */
const ALWAYS = ["corners", "triangulate", "rest", "keep"];

/** What a tool waits for while nothing is selected; where the tools have no words. @type {Record<import("./editing.js").Tool, string>} */
const WAITS_FOR = {
  hand: "",
  build: say("edit-waits-build"),
  joint: say("edit-waits-joint"),
  select: say("edit-waits-select"),
  cut: say("edit-waits-cut"),
};

/** Pixels between buttons over the bar of time and what stands next to them. */
const GAP = 10;
/** Pixels between the strip and the edge of the canvas. */
const MARGIN = 14;
/** Pixels by which the text above the tools may become shorter, as when the clock runs, while the tools stay in place. */
const SLACK = 60;
/** Height that a column of tools needs, pixels, with the bar below. */
const COLUMN = 480;
/** Additional height where everything is twice as large, for a projector, pixels. */
const LARGER_COLUMN = 150;

/** The width that a button takes with its gap, pixels. @param {string} selector */
function widthOf(selector) {
  const width = document.querySelector(selector)?.clientWidth;
  return width ? width + GAP : 0;
}

/** @param {import("../../wire/wire.js").CommandName} name @param {() => void} press */
function iconButton(name, press) {
  const { icon, word, label, hint } = COMMANDS[name];
  const text = say(word ?? label);
  const button = makeButton("", press, "");
  button.innerHTML = `<svg viewBox="0 0 24 24" aria-hidden="true"><path d="${icon}"/></svg><span>${text}</span>`;
  button.title = hint ? withKey(say(hint), name) : "";
  button.ariaLabel = text; // also where the word is hidden
  return button;
}

/** @param {import("../../wire/wire.js").CommandName} name @param {() => void} press */
function wordButton(name, press) {
  const { label, hint } = COMMANDS[name];
  const button = makeButton(say(label), press, "");
  button.title = withKey(hint ? say(hint) : "", name);
  return button;
}

/** @param {Action} what */
const actionButton = (what) => wordButton(what, () => send({ do: "act", what }));

/** @param {string} name of its class @param {string} label */
function toolbar(name, label) {
  const element = make("div", name);
  element.setAttribute("role", "toolbar");
  element.ariaLabel = label;
  return element;
}

/** @param {Element} element @param {boolean} on */
const showIf = (element, on) => element.toggleAttribute("hidden", !on);

class EditStrip {
  /** The top of the tools, pixels; 0 while they are hidden. */
  top = 0;
  /** What was announced last. */
  before = { ...editing };

  /** @param {{button: HTMLElement, row: HTMLElement, says: HTMLElement}} tracing controls of the picture behind the body */
  constructor(tracing) {
    this.strip = toolbar("softrod-edit softrod-floats", say("edit-tools"));
    this.lid = iconButton("edit", () => perform("edit"));
    this.tools = make("div", "softrod-edit-tools");
    this.buttons = TOOLS.map((tool) => ({ tool, button: iconButton(tool, () => setTool(tool)) }));
    this.tools.append(...this.buttons.map(({ button }) => button));
    this.undo = iconButton("undo", () => stepBack("undo"));
    this.redo = iconButton("redo", () => stepBack("redo"));
    for (const button of [this.undo, this.redo]) button.classList.add("softrod-edit-step");
    this.strip.append(this.lid, this.tools, this.undo, this.redo);

    this.bar = toolbar("softrod-edit-bar softrod-floats", say("edit-bar"));
    this.count = make("span", "softrod-edit-count");
    this.hint = make("span", "softrod-edit-count");
    this.onSelected = [...ACTIONS.map(actionButton), makeButton(say("command-copy"), copySelection, "")];
    this.muscle = wordButton("muscle", () => perform("muscle"));
    this.stiffen = actionButton("stiffen");
    this.rests = makeButton(say("edit-rests"), () => setTakesNewLengths(!takesNewLengths()), "");
    this.rests.title = say("edit-rests.hint");
    this.bar.append(
      this.count, this.hint, ...this.onSelected, this.muscle, makeButton(say("edit-paste"), () => pasteHere(), ""), ...ALWAYS.map(actionButton),
      this.stiffen, this.rests, tracing.button, tracing.says, makeButton(say("edit-done"), () => setEditing(false), ""), tracing.row,
    );
    overCanvas().append(this.strip, this.bar);
    addSpeech();
  }

  show() {
    const isShown = isEditable();
    const focused = document.activeElement;
    const { on, tool, selected, undo, redo, stiffen } = editing;
    const some = countSelected() > 0;
    document.documentElement.dataset.softrodTool = isShown && on ? tool : "";
    showIf(this.strip, isShown);
    showIf(this.bar, isShown && on);
    this.lid.ariaPressed = String(on);
    showIf(this.tools, on);
    for (const each of this.buttons) each.button.ariaPressed = String(tool === each.tool);
    showIf(this.undo, on || undo !== "" || redo !== "");
    showIf(this.redo, on || redo !== "");
    this.undo.disabled = !undo;
    this.redo.disabled = !redo;
    this.undo.title = undo ? withKey(say("edit-undo", { what: undo }), "undo") : say("edit-undo.none");
    this.redo.title = redo ? withKey(say("edit-redo", { what: redo }), "redo") : say("edit-redo.none");
    for (const button of this.onSelected) showIf(button, some);
    showIf(this.muscle, selected.springs.length + selected.joints.length > 0);
    const isNew = this.stiffen.hidden && stiffen > 0;
    showIf(this.stiffen, stiffen > 0);
    this.stiffen.textContent = say("edit-stiffen", { times: decimal(String(Number(stiffen.toPrecision(3)))) });
    this.rests.ariaPressed = String(takesNewLengths());
    this.announce();
    // If the button with the focus is gone or disabled.
    const isIn = focused instanceof HTMLButtonElement && (this.strip.contains(focused) || this.bar.contains(focused));
    if (isIn && (focused.disabled || !focused.checkVisibility())) this.lid.focus();
    this.place();
    if (isNew) this.stiffen.scrollIntoView({ block: "nearest", inline: "nearest" }); // on a phone the bar is longer than the screen
  }

  /** Announces what has changed. Without the tools, whatever changed the scene says so itself. */
  announce() {
    const { on, tool, selected, undo, redo, count, chain, chaining } = editing;
    const { before } = this;
    const news = [];
    if (on !== before.on) news.push(on ? say("edit-open", { tool: say(COMMANDS[tool].label) }) : say("edit-open.closed"));
    else if (on && tool !== before.tool) news.push(say(COMMANDS[tool].label));
    if (on && selected !== before.selected) news.push(countSelected() ? say("edit-selected", { parts: nameOf(selected) }) : say("edit-selected.none"));
    const isDone = undo !== before.undo || count > before.count;
    if (redo !== "" && redo !== before.redo && redo === before.undo) news.push(say("edit-undo.done", { what: redo }));
    else if (undo !== "" && isDone && (on || undo === before.redo)) news.push(undo);
    if (on && chain >= 0 && before.chain < 0) news.push(say("edit-begins", { mass: String(chain) }));
    else if (on && before.chain >= 0 && chain < 0 && !chaining && !news.length) news.push(say("edit-begins.ended"));
    if (news.length) tell(news.join(". "));
    this.before = { ...editing };
  }

  place() {
    const canvas = canvasBox();
    if (!canvas || this.strip.hidden) return;
    const { on, selected, tool } = editing;
    const { strip, bar, count, hint } = this;
    const hud = document.querySelector(".softrod-hud")?.getBoundingClientRect();
    const { start, end } = sidesOf(canvas);
    const outer = start + MARGIN;
    const free = Math.max(canvas.top, hud?.bottom ?? 0) + GAP;
    const top = free < this.top && this.top < free + SLACK ? this.top : free;
    this.top = on ? top : 0;
    const floor = floorOf(canvas);
    // On a phone they stand in a row, without words.
    const isRow = floor - top < COLUMN + (larger() - 1) * LARGER_COLUMN;
    strip.classList.toggle("softrod-edit-row", isRow || !on);
    strip.classList.toggle("softrod-edit-closed", !on);
    strip.classList.toggle("softrod-words", !on && hasWords(canvas));
    bar.classList.toggle("softrod-edit-row", isRow);
    const words = inWords(selected);
    const counted = isRow && kindsOf(selected).length > 1 ? say("edit-parts", { count: countSelected() }) : words;
    if (count.textContent !== counted) count.textContent = counted;
    const waits = isRow && !words ? WAITS_FOR[tool] : "";
    if (hint.textContent !== waits) hint.textContent = waits;
    const inner = outer + widthOf(".softrod-box-lid"); // of the box of instruments
    const below = window.innerHeight - floor;
    if (!on) {
      Object.assign(strip.style, { insetInlineStart: `${inner}px`, top: "auto", bottom: `${below + GAP}px` });
      return;
    }
    // A row is as wide as a phone, where the scale bar is, too.
    const scale = document.querySelector(".softrod-scale")?.getBoundingClientRect();
    const under = isRow && scale && window.innerWidth - sidesOf(scale).end - scale.width < outer + strip.offsetWidth ? scale.bottom : 0;
    // On a phone it takes all of the width, so that each tool has room for a thumb.
    const begin = isSheet() ? start + 1 : outer;
    Object.assign(strip.style, { insetInlineStart: `${begin}px`, top: `${Math.max(top, under + GAP)}px`, bottom: "auto" });
    // Over the bar of time, between the box of instruments and the View menu.
    const maxWidth = `${window.innerWidth - end - inner - widthOf(".softrod-menu-lid") - MARGIN}px`;
    Object.assign(bar.style, { insetInlineStart: `${inner}px`, maxWidth, bottom: `${below + 8}px` });
  }
}

/** Adds the strip and the bar. @param {{button: HTMLElement, row: HTMLElement, says: HTMLElement}} tracing see `EditStrip` */
export function addEditStrip(tracing) {
  const strip = new EditStrip(tracing);
  let shown = "";
  let { selected } = editing;
  onEditing(() => {
    document.documentElement.toggleAttribute("data-softrod-editing", editing.on);
    // Not at every move of the pointer.
    const { on, tool, undo, redo, count, chain, stiffen } = editing;
    const now = [on, tool, undo, redo, count, chain, stiffen, takesNewLengths()].join("|");
    if (now === shown && editing.selected === selected) return;
    [shown, selected] = [now, editing.selected];
    strip.show();
  });
  onMessage("pageState", () => {
    if (editing.on && !isEditable()) change({ on: false });
    strip.show();
  });
  onMarksRedraw(() => strip.place()); // after the scale bar
  window.addEventListener("resize", () => strip.place());
  strip.show();
}
