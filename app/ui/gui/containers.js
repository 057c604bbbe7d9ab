// @ts-check
/** Controls that hold others: folders and tabs. */
import { make, makeButton } from "../dialog.js";
import { direction, joined, language, say } from "../../words/words.js";
import { Control, newId, Place, setText } from "./control.js";

/** @typedef {import("./control.js").Declared} Declared */

/** Pixels of a window in which all folders begin open. */
const ROOMY = 900;

/** Characters of what is in a closed folder. */
const TOLD = 28;

/** Folders that the user has opened or closed, by their labels: they are made again with each scene. @type {Map<string, boolean>} */
const opened = new Map();

/** A folder, closed or open. */
class Folder extends Control {
  /** @param {Declared} declared */
  constructor(declared) {
    super(declared, "softrod-folder");
    this.details = make("details", "");
    this.summary = make("summary", "");
    this.title = make("span", "");
    this.holds = make("span", "softrod-folder-holds");
    this.summary.append(this.title, this.holds);
    const inside = make("div", "softrod-controls");
    this.details.append(this.summary, inside);
    this.element.append(this.details);
    this.place = new Place(inside);
    this.inside = new Map([[declared.uuid, this.place]]);
    new MutationObserver(() => this.tell()).observe(inside, { childList: true, subtree: true, attributeFilter: ["hidden"] });
    const { label = "", expand_by_default: open } = declared.props;
    this.details.open = opened.get(label) ?? (open || innerHeight >= ROOMY);
    this.summary.addEventListener("click", () => opened.set(this.props.label, !this.details.open));
  }

  get places() {
    return this.inside;
  }

  get name() {
    return "";
  }

  /** @param {boolean} valued */
  show(valued) {
    super.show(valued);
    setText(this.title, this.props.label ?? "");
  }

  /** Tells what is in it, while it is closed. */
  tell() {
    const names = this.place.members.filter(({ name, element }) => name && !element.hidden).map(({ name }) => name);
    // In English a list goes on in small letters; in German nouns keep their capitals.
    const words = language === "en" ? names.map((name) => `${name.slice(0, 1).toLowerCase()}${name.slice(1)}`) : names;
    let [count, length] = [1, words[0]?.length ?? 0];
    while (count < words.length && length + words[count].length < TOLD) length += words[count++].length + 2;
    const said = joined(words.slice(0, count));
    setText(this.holds, names.length > 1 ? `${names.length}: ${said}${count < words.length ? " …" : ""}` : "");
  }

  /** Opens it, for a control inside. */
  open() {
    this.details.open = true;
  }
}

/** The words of the tab that was chosen last, as the server has them: tabs are made again with other controls, and browsers translate. */
let chosen = "";
/** The first tab then. */
let first = "";

/** Tabs: one stop of the Tab key; arrows go from one to the next. */
class Tabs extends Control {
  /** @param {Declared} declared */
  constructor(declared) {
    super(declared, "softrod-tabs");
    this.list = make("div", "softrod-tab-list");
    this.list.setAttribute("role", "tablist");
    this.list.ariaLabel = say("ui-panel");
    this.element.append(this.list);
    /** @type {Map<string, {tab: HTMLButtonElement, page: HTMLElement, place: Place}>} */
    this.tabs = new Map();
    /** The id of the tab that is shown. */
    this.shown = "";
    this.list.addEventListener("keydown", (event) => this.press(event));
  }

  get places() {
    return new Map([...this.tabs].map(([id, { place }]) => [id, place]));
  }

  get name() {
    return "";
  }

  /** @param {boolean} valued */
  show(valued) {
    super.show(valued);
    const { _tab_container_ids: ids = [], _tab_labels: labels = [] } = /** @type {Record<string, string[]>} */ (this.props);
    for (const [id, { tab, page }] of this.tabs) {
      if (ids.includes(id)) continue;
      tab.remove();
      page.remove();
      this.tabs.delete(id);
    }
    ids.forEach((id, i) => {
      const known = this.tabs.get(id) ?? this.add(id);
      setText(known.tab, labels[i]);
    });
    if (!this.tabs.has(this.shown) && ids.length) {
      // Where a lesson begins, its tab is the new first one.
      const before = labels[0] === first ? labels.indexOf(chosen) : 0;
      first = labels[0];
      this.choose(ids[Math.max(before, 0)]);
    }
  }

  /** @param {string} id */
  add(id) {
    const tab = makeButton("", () => this.choose(id), "softrod-tab");
    const page = make("div", "softrod-controls softrod-tab-page");
    tab.id = newId();
    page.id = newId();
    tab.setAttribute("role", "tab");
    tab.setAttribute("aria-controls", page.id);
    page.setAttribute("role", "tabpanel");
    page.setAttribute("aria-labelledby", tab.id);
    page.hidden = true;
    tab.ariaSelected = "false";
    tab.tabIndex = -1;
    this.list.append(tab);
    this.element.append(page);
    const made = { tab, page, place: new Place(page) };
    this.tabs.set(id, made);
    return made;
  }

  /** Shows a tab. @param {string} id */
  choose(id) {
    this.shown = id;
    const { _tab_container_ids: ids = [], _tab_labels: labels = [] } = /** @type {Record<string, string[]>} */ (this.props);
    chosen = labels[ids.indexOf(id)] ?? "";
    for (const [other, { tab, page }] of this.tabs) {
      const on = other === id;
      tab.ariaSelected = String(on);
      tab.tabIndex = on ? 0 : -1;
      page.hidden = !on;
    }
    this.element.dispatchEvent(new CustomEvent("softrod-tab", { bubbles: true, detail: id }));
  }

  /** @param {KeyboardEvent} event */
  press(event) {
    const ids = [...this.tabs.keys()];
    const at = ids.indexOf(this.shown);
    const on = direction === "rtl" ? -1 : 1;
    const to = { ArrowRight: at + on, ArrowLeft: at - on, Home: 0, End: ids.length - 1 }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    const id = ids[(to + ids.length) % ids.length];
    this.choose(id);
    this.tabs.get(id)?.tab.focus();
  }
}

/** Controls by the messages that declare them. @type {Record<string, new (declared: Declared) => Control>} */
export const CONTAINERS = { GuiFolderMessage: Folder, GuiTabGroupMessage: Tabs };
/** @param {Control} control @returns {control is Tabs} */
export const isTabs = (control) => control instanceof Tabs;
/** @param {Control} control @returns {control is Folder} */
export const isFolder = (control) => control instanceof Folder;
