// @ts-check
/** The View menu over the bar of time: looks of the page, and the help. */
import { fit, moveView } from "../../stage/camera.js";
import { isChasing, toggleChase } from "../../stage/chase.js";
import { has, onMessage, pageState } from "../../wire/channel.js";
import { COMMANDS } from "../../wire/commands.js";
import { iconHtml, make, makeButton, overCanvas, untranslated } from "../../ui/dialog.js";
import { keyOf } from "../../ui/hands/key_table.js";
import { openFinder } from "../../ui/gui/finder.js";
import { isSheet } from "../../ui/gui/panel.js";
import { hasWords, isProjector, keepInView, restoreLooks, toggleProjector } from "../../ui/looks.js";
import { hasKept } from "../../ui/kept/keep.js";
import { kept, store } from "../../ui/kept/storage.js";
import { sidesOf } from "../../stage/sides.js";
import { onMarksRedraw } from "../../stage/sight.js";
import { perform } from "../../wire/perform.js";
import { isDark } from "../../ui/viser/viser.js";
import { say } from "../../words/words.js";

/** Key under which the browser's tab stores that the page is dark. */
const DARK = "softrod-dark";
const ICON = "M2 12s4-7 10-7 10 7 10 7-4 7-10 7S2 12 2 12zM12 9a3 3 0 1 1 0 6 3 3 0 0 1 0-6z";

/**
 * @typedef {object} Entry
 * @property {import("../../wire/wire.js").CommandName} name of the command
 * @property {string} part the control that it needs
 * @property {() => boolean} [on] of a switch
 */

/** @type {Entry[]} */
const ENTRIES = [
  { name: "dark", part: "view", on: isDark },
  { name: "larger", part: "view", on: isProjector },
  { name: "meter", part: "view", on: () => pageState().meter ?? false },
  { name: "gizmos", part: "view", on: () => pageState().gizmos ?? false },
  { name: "modes", part: "modes", on: () => document.documentElement.hasAttribute("data-softrod-modes") },
  { name: "chase", part: "view", on: isChasing },
  { name: "fit", part: "view" },
  { name: "describeBody", part: "view" },
  { name: "palette", part: "view" },
  { name: "access", part: "view" },
  { name: "help", part: "help" },
];

/** A part of the view's height, and how many times nearer. */
const [STEP, NEARER] = [0.2, 1.25];
/** Buttons that move the view as dragging and the wheel do: sign, name, and what they do. @type {[string, import("../../words/keys.js").Plain, [number, number, number]][]} */
const MOVES = [
  ["◀", "view-move.left", [-STEP, 0, 1]],
  ["▲", "view-move.up", [0, STEP, 1]],
  ["▼", "view-move.down", [0, -STEP, 1]],
  ["▶", "view-move.right", [STEP, 0, 1]],
  ["−", "view-move.farther", [0, 0, 1 / NEARER]],
  ["+", "view-move.nearer", [0, 0, NEARER]],
];

/** The button and its menu. */
class ViewMenu {
  constructor() {
    this.element = make("div", "softrod-menu");
    this.list = make("div", "softrod-menu-list softrod-floats");
    this.list.id = "softrod-menu-list";
    this.list.setAttribute("role", "menu");
    this.list.ariaLabel = say("view-menu");
    this.list.hidden = true;
    this.lid = makeButton("", () => this.open(this.list.hidden === true), "softrod-menu-lid softrod-floats");
    this.lid.innerHTML = iconHtml(ICON, say("view-menu"));
    this.lid.ariaLabel = say("view-menu");
    this.lid.title = say("view-menu.hint");
    this.lid.ariaHasPopup = "menu";
    this.lid.ariaExpanded = "false";
    this.lid.setAttribute("aria-controls", this.list.id);
    /** @type {{entry: Pick<Entry, "part" | "on">, item: HTMLButtonElement}[]} */
    this.items = ENTRIES.flatMap((entry) => [{ entry, item: this.addItem(entry) }, ...(entry.name === "fit" ? this.addMoves() : [])]);
    this.element.append(this.list, this.lid);
    overCanvas().append(this.element);
    this.listen();
  }

  /** @param {Entry} entry */
  addItem(entry) {
    const item = makeButton("", () => {
      const byKeys = item.matches(":focus-visible");
      this.open(false);
      // Return keyboard focus to the canvas, unless the user goes by keys; a dialog gives it back to where it was before.
      if (byKeys) this.lid.focus();
      perform(entry.name);
    }, "");
    const { label, hint } = COMMANDS[entry.name];
    item.append(make("span", "softrod-menu-mark"), make("span", "", say(label)), untranslated(make("kbd", "", keyOf(entry.name))));
    item.setAttribute("role", entry.on ? "menuitemcheckbox" : "menuitem");
    item.tabIndex = -1;
    item.title = hint ? say(hint) : "";
    this.list.append(item);
    return item;
  }

  /** Buttons that move the view, and leave the menu open. */
  addMoves() {
    const row = make("div", "softrod-menu-moves");
    row.setAttribute("role", "group");
    row.ariaLabel = say("view-move");
    row.dir = "ltr";
    this.list.append(row);
    return MOVES.map(([sign, name, [across, up, nearer]]) => {
      const item = makeButton(sign, () => moveView(across, up, nearer), "");
      item.setAttribute("role", "menuitem");
      item.tabIndex = -1;
      item.ariaLabel = item.title = say(name);
      row.append(item);
      return { entry: { part: "view" }, item };
    });
  }

  /** @param {boolean} on */
  open(on) {
    for (const { entry, item } of this.items) {
      item.hidden = !has(entry.part);
      if (entry.on) item.ariaChecked = String(entry.on());
    }
    this.list.hidden = !on;
    this.element.toggleAttribute("data-open", on);
    this.lid.ariaExpanded = String(on);
    if (!on) return;
    keepInView(this.list);
    this.items.find(({ item }) => !item.hidden)?.item.focus();
  }

  /** Closes it if it is open, and has the focus at its button. */
  leave() {
    if (this.list.hidden) return;
    this.open(false);
    this.lid.focus();
  }

  /** @param {KeyboardEvent} event */
  press(event) {
    if (this.list.hidden) return;
    event.stopPropagation(); // viser would move the camera
    const shown = this.items.filter(({ item }) => !item.hidden).map(({ item }) => item);
    const at = shown.findIndex((item) => item === document.activeElement);
    const to = { ArrowDown: at + 1, ArrowUp: at - 1, Home: 0, End: -1 }[event.key];
    if (event.key === "Escape" || event.key === "Tab") this.leave();
    else if (to !== undefined) shown.at(to % shown.length)?.focus();
    if (to !== undefined || event.key === "Escape") event.preventDefault();
  }

  listen() {
    const { element } = this;
    element.addEventListener("keydown", (event) => this.press(event));
    // A press in the menu does not move the focus, in any browser; a press elsewhere closes the menu.
    element.addEventListener("mousedown", (event) => event.preventDefault());
    element.addEventListener("focusout", ({ relatedTarget }) => {
      if (!(relatedTarget instanceof Node && element.contains(relatedTarget))) this.open(false);
    });
    onMessage("pageState", () => (element.hidden = !has("view") && !has("modes") && !has("help")));
    onMarksRedraw(({ box, floor }) => {
      element.classList.toggle("softrod-words", hasWords(box));
      element.style.insetInlineEnd = `${sidesOf(box).end + 14}px`;
      // On a phone thumbs are for the body and the sliders: the menu is at the top.
      element.classList.toggle("softrod-menu-above", isSheet());
      element.style.bottom = isSheet() ? "" : `${window.innerHeight - floor + 10}px`;
      element.style.top = isSheet() ? `${box.top + 8}px` : "";
      if (!this.list.hidden) keepInView(this.list);
    });
  }
}

/** Has the page dark where the system forces dark colours, and keeps it so when its tab goes to another scene's address; a reload gets all of its state back. */
function restoreDark() {
  const isForced = ["(forced-colors: active)", "(prefers-color-scheme: dark)"].every((query) => matchMedia(query).matches);
  let wanted = (isForced || kept(DARK) === "1") && !hasKept();
  onMessage("pageState", ({ page }) => {
    if (!page || !wanted) return;
    wanted = false;
    if (!isDark()) perform("dark");
  });
  let before = isDark();
  onMarksRedraw(() => {
    if (isDark() !== before) store(DARK, isDark() ? "1" : "");
    before = isDark();
  });
}

/** @type {ViewMenu | null} */
let menu = null;

/** Finds anything. What has had the focus gets it back, which the entry of an open menu cannot. */
function find() {
  menu?.leave();
  openFinder();
}

function begin() {
  restoreLooks();
  restoreDark();
  menu = new ViewMenu();
}

/** @type {import("../../ui/feature.js").Feature<"view">} */
export default { commands: { palette: find, fit: () => void fit(true), chase: toggleChase, larger: toggleProjector }, begin };
