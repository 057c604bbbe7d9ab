// @ts-check
/**
 * The gallery: a dialog with a card for each scene. Arrows go from card to card, letters search, Enter opens. What a
 * user named is text here, never HTML.
 *
 * @typedef {import("../../wire/wire.js").Entry} Entry
 */
import { has, onMessage, send } from "../../wire/channel.js";
import { copied } from "../files/share.js";
import { make, makeButton, makeDialog, untranslated } from "../../ui/dialog.js";
import { alsoFinds, refreshFinder } from "../../ui/gui/finder.js";
import { isDark } from "../../ui/viser/viser.js";
import { say } from "../../words/words.js";
import { focusCard, isFound, meant, moveByKey } from "./finding.js";

const IMAGES = new URL("thumbnails/", import.meta.url);
/** The preset with which one builds a body of one's own. */
const EMPTY = "empty";
/** The choice of all groups. */
const ALL = say("gallery-all");
/** Groups that are more than a heading, as the server calls them. */
const OWN = say("gallery-own");
const LESSONS = say("gallery-lessons");

/**
 * Another use of the gallery than to open a scene.
 *
 * @typedef {object} Picker
 * @property {string} title
 * @property {HTMLElement} line over the cards
 * @property {string} first the group that comes first
 * @property {(name: string) => void} pick what a card does
 */

/** The name of the scene of what lies in a card. @param {Element | null | undefined} part */
const nameOf = (part) => part?.closest(".softrod-card")?.getAttribute("data-name") ?? "";

class Gallery {
  /** @type {Entry[]} */
  #entries = [];
  #present = "";
  #teaches = false;
  /** @type {Picker | undefined} */
  #picker;
  /** Of scenes that are saved, by name. @type {Record<string, string>} */
  #pictures = {};
  /** The scene whose card has the focus, or had it last. */
  #chosen = "";
  #search = make("input", "softrod-search");
  #line = make("div", "");
  /** One of them chooses the group that is shown. */
  #chips = make("div", "softrod-chips");
  #group = ALL;
  /** Where the gallery was left: its group, and how far down. */
  #left = { group: ALL, top: 0 };
  #fresh = makeButton(say("gallery-new"), () => this.#begin());
  #none = make("p", "softrod-none", say("gallery-none"));
  #cards = make("div", "");
  #foot = make("div", "softrod-dialog-foot");
  #said = make("span", "softrod-said");

  constructor() {
    const { dialog, head, body } = makeDialog(say("gallery-title"), "softrod-gallery");
    this.dialog = dialog;
    this.body = body;
    this.title = /** @type {HTMLElement} */ (head.firstElementChild);
    Object.assign(this.#search, { type: "search", placeholder: say("gallery-search"), ariaLabel: say("gallery-search") });
    head.insertBefore(this.#search, head.lastChild);
    this.#chips.setAttribute("role", "radiogroup");
    this.#chips.ariaLabel = say("gallery-groups");
    const bar = make("div", "softrod-gallery-bar");
    bar.append(this.#chips, this.#fresh);
    head.after(bar);
    body.append(this.#line, this.#none, this.#cards);
    this.#foot.hidden = true;
    this.#said.setAttribute("role", "status");
    dialog.append(this.#foot);
    this.#search.addEventListener("input", () => this.#filter());
    dialog.addEventListener("keydown", (event) => this.#press(event));
    // A closed dialog has no place any more, and that in what was searched for is none in all scenes.
    body.addEventListener("scroll", () => {
      if (dialog.open && !this.#picker && !this.#search.value) this.#left.top = body.scrollTop;
    });
  }

  // ----------------------------------------------------------------------- the dialog
  /** Opens the dialog, if it is not open. @param {Picker} [picker] */
  open(picker) {
    if (this.dialog.open) return;
    this.#picker = picker;
    this.#line.replaceChildren(...(picker ? [picker.line] : []));
    this.dialog.toggleAttribute("data-picks", picker !== undefined);
    this.title.textContent = picker?.title ?? say("gallery-title");
    this.#search.value = "";
    this.#show(picker ? ALL : this.#left.group);
    this.#chosen = "";
    this.say();
    this.dialog.showModal();
    this.body.scrollTop = picker ? 0 : this.#left.top;
    // On a touch screen its keyboard would cover half of them.
    if (matchMedia("(pointer: coarse)").matches) this.dialog.focus();
    else this.#search.focus();
    this.list();
  }

  close() {
    if (!this.dialog.open) return;
    this.dialog.close();
    // Return the keyboard focus to the body.
    if (document.activeElement instanceof HTMLElement) document.activeElement.blur();
  }

  /** Shows what was done, or a question, in the foot. @param {(string | Node)[]} content */
  say(...content) {
    this.#said.replaceChildren(...content.filter((part) => typeof part === "string"));
    this.#foot.replaceChildren(this.#said, ...content.filter((part) => typeof part !== "string"));
    this.#foot.hidden = content.length === 0;
  }

  /** Asks for the scenes. */
  list() {
    send({ do: "listScenes", dark: isDark() });
  }

  /** @param {KeyboardEvent} event */
  #press(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const found = this.#found();
    if (moveByKey(event, this.#search, found, this.#reached(found), this.#meant(found)) || event.key !== "Delete") return;
    const name = nameOf(found.find((card) => card === event.target));
    if (this.#entries.find((entry) => entry.name === name)?.own) send({ do: "changeScene", how: "delete", name });
  }

  // ----------------------------------------------------------------------- the cards
  /** The buttons of the cards that are shown. */
  #found() {
    return /** @type {HTMLElement[]} */ ([...this.#cards.querySelectorAll(".softrod-card:not([hidden]) .softrod-open")]);
  }

  /** The card that the Tab key reaches. @param {HTMLElement[]} found */
  #reached(found) {
    return found.find((card) => card.tabIndex === 0) ?? found[0];
  }

  /** One card alone is reached by the Tab key, arrows go on from there. @param {string} name */
  #choose(name) {
    this.#chosen = name;
    for (const button of this.#cards.querySelectorAll(/** @type {"button"} */ (".softrod-card button"))) {
      button.tabIndex = nameOf(button) === name ? 0 : -1;
    }
  }

  /** Shows the scenes that are searched for. */
  #filter() {
    for (const group of this.#cards.children) {
      const isWanted = this.#group === ALL || group.getAttribute("data-group") === this.#group;
      let count = 0;
      for (const card of group.querySelectorAll(".softrod-card")) {
        const entry = this.#entries.find(({ name }) => name === nameOf(card));
        const hit = isWanted && entry !== undefined && isFound(entry, this.#search.value);
        card.toggleAttribute("hidden", !hit);
        count += Number(hit);
      }
      group.toggleAttribute("hidden", count === 0 && !(isWanted && group.matches(".softrod-none-saved") && !this.#search.value));
    }
    const found = this.#found();
    this.#none.hidden = found.length > 0;
    if (!found.map(nameOf).includes(this.#chosen)) this.#choose(nameOf(this.#meant(found)));
  }

  /** The card that is meant by what was typed. @param {HTMLElement[]} found */
  #meant(found) {
    const entries = found.flatMap((card) => this.#entries.filter(({ name }) => name === nameOf(card)));
    const name = meant(entries, this.#search.value);
    return found.find((card) => nameOf(card) === name);
  }

  /** Shows other scenes. @param {import("../../wire/wire.js").Scenes} letter */
  take({ scenes, present, teaches }) {
    this.#entries = scenes;
    this.#present = present;
    this.#teaches = teaches;
    refreshFinder();
    if (this.dialog.open) this.#build();
  }

  #build() {
    const entries = this.#entries;
    const had = this.#cards.contains(document.activeElement);
    const first = entries.filter(({ group }) => group === this.#picker?.first);
    const groups = new Map([...first, ...entries].map(({ group }) => [group, /** @type {Entry[]} */ ([])]));
    for (const entry of entries) groups.get(entry.group)?.push(entry);
    this.#cards.replaceChildren(
      ...(entries.some(({ own }) => own) ? [] : [this.#noneSaved()]),
      ...[...groups].map(([group, members], i) => this.#section(group, members, `softrod-group-${i}`)),
    );
    this.#buildChips([...groups.keys()]);
    this.#fresh.hidden = !entries.some(({ name }) => name === EMPTY);
    const names = entries.map(({ name }) => name);
    this.#choose([this.#chosen, this.#present].find((name) => names.includes(name)) ?? names[0]);
    this.#filter();
    if (had) focusCard(this.#reached(this.#found()));
  }

  /** The scenes, for "Find anything". @returns {import("../../ui/gui/finder.js").Found[]} */
  toFind() {
    return this.#entries.map((entry) => ({ name: entry.title, kind: "scene", about: say("gallery-scene"), also: entry.text, show: () => send({ do: "openScene", name: entry.name }) }));
  }

  /** Shows the scenes of one group. @param {string} group */
  #show(group) {
    this.#group = group;
    if (!this.#picker) this.#left.group = group;
    for (const choice of this.#chips.querySelectorAll("input")) choice.checked = choice.value === group;
    this.#filter();
  }

  /** A choice for each group: one stop of the Tab key, and arrows go from one to the next. @param {string[]} groups */
  #buildChips(groups) {
    const all = [ALL, ...groups.filter((group) => group !== OWN), OWN];
    if (!all.includes(this.#group)) this.#group = ALL;
    if (all.join("\n") === [...this.#chips.children].map(({ textContent }) => textContent).join("\n")) return;
    this.#chips.replaceChildren(
      ...all.map((group) => {
        const chip = make("label", "softrod-chip");
        const choice = make("input", "");
        Object.assign(choice, { type: "radio", name: "softrod-gallery-group", value: group, checked: group === this.#group });
        choice.addEventListener("change", () => {
          this.#show(group);
          this.#cards.parentElement?.scrollTo(0, 0);
          chip.scrollIntoView({ block: "nearest", inline: "nearest" });
        });
        chip.append(choice, group);
        return chip;
      }),
    );
  }

  /** Opens the scene with which one builds a body. */
  #begin() {
    const empty = this.#entries.find(({ name }) => name === EMPTY);
    if (empty) this.#use(empty);
  }

  /** What to do where nothing is saved yet. */
  #noneSaved() {
    const section = make("section", "softrod-none-saved");
    const text = make("p", "", say("gallery-none-saved"));
    const empty = this.#entries.find(({ name }) => name === EMPTY);
    if (empty) text.append(makeButton(empty.title, () => this.#use(empty)));
    section.dataset.group = OWN;
    section.append(make("h3", "", OWN), text);
    return section;
  }

  /** @param {string} title @param {Entry[]} members @param {string} id */
  #section(title, members, id) {
    const section = make("section", "");
    section.dataset.group = title;
    const heading = make("h3", "", title);
    heading.id = id;
    const grid = make("div", "softrod-cards");
    grid.setAttribute("role", "grid");
    grid.setAttribute("aria-labelledby", id);
    grid.append(...members.map((entry) => this.#card(entry)));
    section.append(heading, grid);
    return section;
  }

  /** @param {Entry} entry */
  #card(entry) {
    const { name, title, line, saved } = entry;
    const isPresent = name === this.#present;
    const row = make("div", "softrod-card");
    row.dataset.name = name;
    row.setAttribute("role", "row");
    row.toggleAttribute("data-current", isPresent);
    const cell = make("div", "");
    cell.setAttribute("role", "gridcell");
    const button = makeButton("", () => this.#use(entry), "softrod-open");
    if (isPresent) button.setAttribute("aria-current", "true");
    const image = Object.assign(make("img", ""), { alt: "", loading: "lazy" });
    const source = saved ? this.#pictures[name] : new URL(`${name}${isDark() ? "-dark" : ""}.webp`, IMAGES).href;
    if (source) image.src = source;
    image.addEventListener("error", () => image.removeAttribute("src"));
    const called = make("b", "", title);
    button.append(image, saved ? untranslated(called) : called, make("span", "", line));
    button.addEventListener("focus", () => this.#choose(name));
    cell.append(button);
    row.append(cell, ...this.#actions(entry));
    return row;
  }

  /** What can be done with a scene besides opening it. @param {Entry} entry */
  #actions({ name, title, own, saved, group }) {
    /** @param {"delete" | "duplicate"} how */
    const change = (how) => send({ do: "changeScene", how, name });
    /** @type {["gallery-rename" | "gallery-copy" | "gallery-delete" | "gallery-use", () => void, boolean][]} */
    const actions = [
      ["gallery-rename", () => this.#askForName(name), own],
      ["gallery-copy", () => change("duplicate"), saved],
      ["gallery-delete", () => change("delete"), own],
      // Of the presets, lessons are for classes; a command uses any other.
      ["gallery-use", () => send({ do: "useInClass", name }), this.#teaches && (own || group === LESSONS)],
    ];
    const offered = actions.filter(([, , isOffered]) => isOffered);
    if (!offered.length) return [];
    const cell = make("div", "softrod-actions");
    cell.setAttribute("role", "gridcell");
    for (const [key, press] of offered) {
      const button = makeButton(say(key), press);
      button.ariaLabel = say(`${key}.label`, { title });
      cell.append(button);
    }
    return [cell];
  }

  /** Opens a scene, or picks it. @param {Entry} entry */
  #use({ name }) {
    if (this.#picker) {
      this.#picker.pick(name);
      return;
    }
    send({ do: "openScene", name });
    this.close();
  }

  /** Shows pictures of saved scenes. @param {Record<string, string>} pictures addresses by names */
  picture(pictures) {
    Object.assign(this.#pictures, pictures);
    for (const row of this.#cards.querySelectorAll(".softrod-card")) {
      const [image, source] = [row.querySelector("img"), this.#pictures[nameOf(row)]];
      if (image && source && image.src !== source) image.src = source;
    }
  }

  // ----------------------------------------------------------------------- questions and answers in the foot
  /** @param {string} name */
  #askForName(name) {
    const field = make("input", "softrod-search");
    Object.assign(field, { value: name, maxLength: 60, ariaLabel: say("gallery-rename.name", { name }) });
    const form = make("form", "softrod-dialog-line");
    const enter = make("button", "softrod-button softrod-first", say("gallery-rename"));
    form.append(field, enter, makeButton(say("gallery-cancel"), () => this.say()));
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      this.#chosen = field.value;
      send({ do: "changeScene", how: "rename", name, to: field.value });
    });
    field.addEventListener("keydown", (event) => {
      if (event.key !== "Escape") return;
      // It is the question that is left, not the dialog.
      event.preventDefault();
      event.stopPropagation();
      this.say();
      focusCard(this.#found().find((card) => nameOf(card) === name));
    });
    this.say(form);
    field.select();
  }

  /** @param {string} command by which a class begins that others can come to */
  tellCommand(command) {
    const field = make("textarea", "softrod-command");
    Object.assign(field, { value: command, rows: 1, readOnly: true, ariaLabel: say("gallery-command") });
    const copy = makeButton(say("gallery-command.copy"), async () => {
      copy.textContent = say((await copied(field)) ? "gallery-command.copied" : "gallery-command.keys");
    });
    this.say(say("gallery-command.about"), field, copy);
    copy.focus();
  }
}

/** @type {Gallery} */
let gallery;

/** The dialog, for features that ask for a scene in it. */
export const theGallery = () => gallery;

/** Makes the dialog, which opens when the server says so. */
function begin() {
  gallery = new Gallery();
  alsoFinds(
    () => has("chooser") && gallery.list(),
    () => (has("chooser") ? gallery.toFind() : []),
  );
  onMessage("offerGallery", ({ why }) => {
    gallery.open();
    if (why) gallery.say(why);
  });
  onMessage("shelfChanged", () => gallery.dialog.open && gallery.list());
  onMessage("scenes", (letter) => gallery.take(letter));
  onMessage("scenePictures", ({ pictures }) => gallery.picture(pictures));
  onMessage("usedInClass", ({ address, command }) => (address ? location.assign(address) : gallery.tellCommand(command)));
  onMessage("sceneChanged", ({ text, undo }) => {
    gallery.say(text, ...(undo ? [makeButton(say("command-undo.word"), () => send({ do: "changeScene", how: "restore", name: undo }))] : []));
    gallery.list();
  });
}

/** @type {import("../../ui/feature.js").Feature<"gallery">} */
export default { commands: { gallery: () => gallery.open() }, begin };
