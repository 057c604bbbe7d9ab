// @ts-check
/** "Find anything": commands, the controls of the panel with their values, and scenes, by parts of their names. */
import { answer, takeOver } from "../../wire/channel.js";
import { iconHtml, make } from "../dialog.js";
import { folded, say } from "../../words/words.js";

/**
 * @typedef {object} Found
 * @property {string} name
 * @property {"command" | "control" | "scene"} kind
 * @property {string} [about] its key, or its value and where it is
 * @property {string} [also] further words by which it is found, such as its choices and its description
 * @property {() => void} show
 */

/**
 * The entries that have all words of a text: first those whose names begin with the first one, last those that have some
 * only in their further words, from the beginning of a word on.
 *
 * @template {{name: string, also?: string}} E
 * @param {E[]} entries @param {string} text
 * @returns {E[]}
 */
export function matching(entries, text) {
  const words = folded(text).split(/\s+/).filter(Boolean);
  /** @param {E} entry */
  const rank = ({ name, also = "" }) => {
    const [low, more] = [folded(name), ` ${folded(also)}`];
    if (words.every((word) => low.includes(word))) return words.length && low.startsWith(words[0]) ? 0 : 1;
    return words.every((word) => low.includes(word) || more.includes(` ${word}`)) ? 2 : 3;
  };
  const ranked = entries.map((entry) => ({ entry, rank: rank(entry) })).filter((each) => each.rank < 3);
  return ranked.sort((one, other) => one.rank - other.rank).map(({ entry }) => entry);
}

/** Outlines in 24 by 24, by kinds. */
const ICONS = {
  command: "M7 6l6 6l-6 6M14 18h5",
  control: "M12 3v4M12 17v4M3 12h4M17 12h4M12 7a5 5 0 1 1 0 10a5 5 0 0 1 0-10z",
  scene: "M4 4h6v6H4zM14 4h6v6h-6zM4 14h6v6H4zM14 14h6v6h-6z",
};

/**
 * A name in parts, every second of which was searched for.
 *
 * @param {string} name @param {string} text
 */
export function partsOf(name, text) {
  const words = folded(text).split(/\s+/).filter(Boolean);
  const low = folded(name);
  const parts = [];
  let at = 0;
  while (at < name.length) {
    const hits = words.map((word) => ({ from: low.indexOf(word, at), size: word.length })).filter(({ from }) => from >= 0);
    if (!hits.length) break;
    const { from, size } = hits.reduce((one, other) => (other.from < one.from || (other.from === one.from && other.size > one.size) ? other : one));
    parts.push(name.slice(at, from), name.slice(from, from + size));
    at = from + size;
  }
  return [...parts, name.slice(at)];
}

/** The dialog; made when it is first opened. */
class Finder {
  /** @param {() => Found[]} entries */
  constructor(entries) {
    this.entries = entries;
    /** @type {Found[]} */
    this.found = [];
    this.at = 0;
    this.dialog = make("dialog", "softrod-dialog softrod-finder");
    this.dialog.ariaLabel = say("command-palette");
    this.input = make("input", "softrod-finder-input");
    this.input.type = "text";
    this.input.placeholder = say("command-palette");
    this.input.autocomplete = "off";
    this.input.spellcheck = false;
    this.input.setAttribute("role", "combobox");
    this.input.setAttribute("aria-controls", "softrod-found");
    this.input.ariaExpanded = "true";
    this.input.ariaLabel = say("command-palette");
    this.list = make("div", "softrod-found");
    this.list.id = "softrod-found";
    this.list.setAttribute("role", "listbox");
    this.list.ariaLabel = say("ui-found");
    this.none = make("p", "softrod-none", say("ui-found.none"));
    const keys = make("kbd", "softrod-found-key", say("key-esc"));
    keys.ariaHidden = "true";
    const head = make("div", "softrod-finder-head");
    head.append(this.input, keys);
    this.dialog.append(head, this.list, this.none);
    document.body.append(this.dialog);
    this.input.addEventListener("input", () => this.search());
    this.dialog.addEventListener("keydown", (event) => this.press(event));
    this.dialog.addEventListener("pointerdown", ({ target }) => target === this.dialog && this.dialog.close());
  }

  open() {
    if (this.dialog.open) return;
    this.input.value = "";
    this.search();
    for (const { ask } of others) ask();
    this.dialog.showModal();
    this.input.focus();
  }

  /** Searches again, after there is more to be found. */
  refresh() {
    if (!this.dialog.open) return;
    const { at } = this;
    this.search();
    if (at < this.found.length) this.mark(at);
  }

  search() {
    const { value } = this.input;
    this.found = matching(this.entries(), value);
    this.none.hidden = this.found.length > 0;
    this.list.replaceChildren(
      ...this.found.map(({ name, about = "", kind }, i) => {
        const row = make("div", "softrod-found-row");
        row.id = `softrod-found-${i}`;
        row.setAttribute("role", "option");
        const words = make("span", "");
        words.append(...partsOf(name, value).map((part, k) => (k % 2 ? make("mark", "", part) : part)));
        row.innerHTML = iconHtml(ICONS[kind]);
        row.append(words, make("span", "softrod-found-about", about));
        row.addEventListener("click", () => this.take(i));
        row.addEventListener("pointermove", () => this.mark(i));
        return row;
      }),
    );
    this.mark(0);
  }

  /** @param {number} at */
  mark(at) {
    this.at = at;
    [...this.list.children].forEach((row, i) => (row.ariaSelected = String(i === at)));
    this.list.children[at]?.scrollIntoView({ block: "nearest" });
    this.input.setAttribute("aria-activedescendant", this.found.length ? `softrod-found-${at}` : "");
  }

  /** @param {number} at */
  take(at) {
    const found = this.found[at];
    this.dialog.close();
    found?.show();
  }

  /** @param {KeyboardEvent} event */
  press(event) {
    const steps = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (steps !== undefined) {
      event.preventDefault();
      const { length } = this.found;
      if (length) this.mark((this.at + steps + length) % length);
    } else if (event.key === "Enter") {
      event.preventDefault();
      this.take(this.at);
    }
  }
}

/** @type {Finder | null} */
let finder = null;
/** @type {() => Found[]} */
let entriesOf = () => [];

/** Further things to be found. @type {{ask: () => void, entries: () => Found[]}[]} */
const others = [];

/** Finds further things. @param {() => void} ask asks for them, each time it opens @param {() => Found[]} entries */
export const alsoFinds = (ask, entries) => void others.push({ ask, entries });

/** Searches again if it is open, after there is more to be found. */
export const refreshFinder = () => finder?.refresh();

/** Opens it. */
export function openFinder() {
  finder ??= new Finder(entriesOf);
  finder.open();
}

/** The commands of the server. @type {Map<string, {label: string, description: string | null, disabled: boolean}>} */
const commands = new Map();

/** Forgets the commands of a connection that is over. */
export const forgetCommands = () => commands.clear();

/** Begins to receive the commands of the server. @param {() => Found[]} controls those of the panel */
export function takeCommands(controls) {
  takeOver("RegisterCommandMessage", ({ uuid, props }) => commands.set(uuid, /** @type {any} */ (props)));
  takeOver("CommandUpdateMessage", ({ uuid, updates }) => Object.assign(commands.get(uuid) ?? {}, updates));
  takeOver("RemoveCommandMessage", ({ uuid }) => commands.delete(uuid));
  entriesOf = () => [
    ...[...commands]
      .filter(([, { disabled }]) => !disabled)
      .map(([uuid, { label, description }]) => ({
        name: label,
        kind: /** @type {const} */ ("command"),
        about: description ?? "",
        show: () => answer({ type: "CommandTriggerMessage", uuid }),
      })),
    ...controls(),
    ...others.flatMap(({ entries }) => entries()),
  ];
}
