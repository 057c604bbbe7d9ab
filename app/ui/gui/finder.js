// @ts-check
/** "Find anything": commands, and the controls of the panel, by parts of their names. */
import { answer, takeOver } from "../../wire/channel.js";
import { make } from "../dialog.js";

/**
 * @typedef {object} Found
 * @property {string} name
 * @property {string} [about] its key, or where it is
 * @property {() => void} show
 */

/**
 * The entries that have all words of a text, those that begin with the first one first.
 *
 * @template {{name: string}} E
 * @param {E[]} entries @param {string} text
 * @returns {E[]}
 */
export function matching(entries, text) {
  const words = text.toLowerCase().split(/\s+/).filter(Boolean);
  const fits = entries.filter(({ name }) => words.every((word) => name.toLowerCase().includes(word)));
  /** @param {E} entry */
  const rank = ({ name }) => (words.length && name.toLowerCase().startsWith(words[0]) ? 0 : 1);
  return fits.sort((a, b) => rank(a) - rank(b));
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
    this.dialog.ariaLabel = "Find anything";
    this.input = make("input", "softrod-finder-input");
    this.input.type = "text";
    this.input.placeholder = "Find anything";
    this.input.autocomplete = "off";
    this.input.spellcheck = false;
    this.input.setAttribute("role", "combobox");
    this.input.setAttribute("aria-controls", "softrod-found");
    this.input.ariaExpanded = "true";
    this.input.ariaLabel = "Find anything";
    this.list = make("div", "softrod-found");
    this.list.id = "softrod-found";
    this.list.setAttribute("role", "listbox");
    this.list.ariaLabel = "Found";
    this.none = make("p", "softrod-none", "Nothing has this name.");
    this.dialog.append(this.input, this.list, this.none);
    document.body.append(this.dialog);
    this.input.addEventListener("input", () => this.search());
    this.dialog.addEventListener("keydown", (event) => this.press(event));
    this.dialog.addEventListener("pointerdown", ({ target }) => target === this.dialog && this.dialog.close());
  }

  open() {
    if (this.dialog.open) return;
    this.input.value = "";
    this.search();
    this.dialog.showModal();
    this.input.focus();
  }

  search() {
    this.found = matching(this.entries(), this.input.value);
    this.none.hidden = this.found.length > 0;
    this.list.replaceChildren(
      ...this.found.map(({ name, about }, i) => {
        const row = make("div", "softrod-found-row");
        row.id = `softrod-found-${i}`;
        row.setAttribute("role", "option");
        row.append(make("span", "", name), make("span", "softrod-found-about", about ?? ""));
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
        about: description ?? "",
        show: () => answer({ type: "CommandTriggerMessage", uuid }),
      })),
    ...controls(),
  ];
}
