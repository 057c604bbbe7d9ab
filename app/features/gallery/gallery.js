// @ts-check
/**
 * The gallery: a dialog with a card for each scene. Arrows go from card to card, letters search, Enter opens. What a
 * user named is text here, never HTML.
 *
 * @typedef {import("../../wire/wire.js").Entry} Entry
 */
import { onMessage, send } from "../../wire/channel.js";
import { copied } from "../files/share.js";
import { make, makeButton, makeDialog } from "../../ui/dialog.js";
import { isDark } from "../../ui/viser/widgets.js";
import { arrived, isFound } from "./finding.js";

const IMAGES = new URL("thumbnails/", import.meta.url);
/** The preset with which one builds a body of one's own. */
const EMPTY = "empty";
const NONE_SAVED = "You have saved no scene yet. Save the one that you see in the Share tab, or build one: ";
const CARD = ".softrod-card:not([hidden]) .softrod-open";

/**
 * Another use of the gallery than to open a scene.
 *
 * @typedef {object} Picker
 * @property {string} title
 * @property {HTMLElement} line over the cards
 * @property {string} first the group that comes first
 * @property {(name: string) => void} pick what a card does
 */

/** The gallery, once it is there. */
export const gallery = {
  /** @param {Picker} [_picker] */
  open: (_picker) => {},
  /** Says something in the foot. @param {string} _text */
  say: (_text) => {},
  close: () => {},
};

/** Puts up the dialog, which opens when the server says so. */
function begin() {
  const { dialog, head, body } = makeDialog("Scenes", "softrod-gallery");
  const search = make("input", "softrod-search");
  search.type = "search";
  search.placeholder = "Find a scene";
  search.ariaLabel = "Find a scene";
  head.insertBefore(search, head.lastChild);
  const line = make("div", "");
  const none = make("p", "softrod-none", "No scene has all of these words.");
  const cards = make("div", "");
  body.append(line, none, cards);
  const foot = make("div", "softrod-dialog-foot");
  foot.hidden = true;
  const said = make("span", "softrod-said");
  said.setAttribute("role", "status");
  dialog.append(foot);

  /** @type {Entry[]} */
  let entries = [];
  let present = "";
  let teaches = false;
  /** @type {Picker | undefined} */
  let picker;
  /** Of scenes that are saved, by name. @type {Record<string, string>} */
  const pictures = {};
  /** The scene whose card has the focus, or had it last. */
  let chosen = "";

  const found = () => /** @type {HTMLElement[]} */ ([...cards.querySelectorAll(CARD)]);
  /** @param {HTMLElement | undefined} card */
  const focus = (card) => {
    card?.focus();
    card?.scrollIntoView({ block: "nearest" });
  };
  /** One card alone is reached with the Tab key, arrows go on from there. @param {string} name */
  const choose = (name) => {
    chosen = name;
    for (const button of /** @type {NodeListOf<HTMLButtonElement>} */ (cards.querySelectorAll(".softrod-card button"))) {
      button.tabIndex = button.closest(".softrod-card")?.getAttribute("data-name") === name ? 0 : -1;
    }
  };
  const filter = () => {
    for (const group of cards.children) {
      let count = 0;
      for (const card of group.querySelectorAll(".softrod-card")) {
        const entry = entries.find(({ name }) => name === card.getAttribute("data-name"));
        const hit = entry !== undefined && isFound(entry, search.value);
        card.toggleAttribute("hidden", !hit);
        count += Number(hit);
      }
      group.toggleAttribute("hidden", count === 0 && !(group.matches(".softrod-none-saved") && !search.value));
    }
    const names = found().map((card) => card.parentElement?.parentElement?.dataset.name ?? "");
    none.hidden = names.length > 0;
    if (!names.includes(chosen)) choose(names[0] ?? "");
  };
  /** @param {Entry} entry */
  const open = ({ name }) => {
    if (picker) {
      picker.pick(name);
      return;
    }
    send({ do: "openScene", name });
    close();
  };
  const close = () => {
    dialog.close();
    // The keys are the body's.
    if (document.activeElement instanceof HTMLElement) document.activeElement.blur();
  };
  /** What was done, or a question, in the foot. @param {(string | Node)[]} content */
  const say = (...content) => {
    said.replaceChildren(...content.filter((part) => typeof part === "string"));
    foot.replaceChildren(said, ...content.filter((part) => typeof part !== "string"));
    foot.hidden = content.length === 0;
  };
  const list = () => send({ do: "listScenes", dark: isDark() });

  /** @param {Entry} entry */
  const askForName = ({ name }) => {
    const field = make("input", "softrod-search");
    field.value = name;
    field.maxLength = 60;
    field.ariaLabel = `New name of ${name}`;
    const form = make("form", "softrod-dialog-line");
    const enter = make("button", "softrod-button softrod-first", "Rename");
    form.append(field, enter, makeButton("Cancel", () => say()));
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      chosen = field.value;
      send({ do: "changeScene", how: "rename", name, to: field.value });
    });
    field.addEventListener("keydown", (event) => {
      if (event.key !== "Escape") return;
      // It is the question that is left, not the dialog.
      event.preventDefault();
      event.stopPropagation();
      say();
      focus(found().find((card) => card.closest("[data-name]")?.getAttribute("data-name") === name));
    });
    say(form);
    field.select();
  };

  /** @param {Entry} entry */
  const card = (entry) => {
    const { name, title, line, own, saved, group } = entry;
    const row = make("div", "softrod-card");
    row.dataset.name = name;
    row.setAttribute("role", "row");
    const cell = make("div", "");
    cell.setAttribute("role", "gridcell");
    const button = makeButton("", () => open(entry), "softrod-open");
    if (name === present) button.setAttribute("aria-current", "true");
    row.toggleAttribute("data-current", name === present);
    const image = make("img", "");
    image.alt = "";
    image.loading = "lazy";
    const source = saved ? pictures[name] : new URL(`${name}${isDark() ? "-dark" : ""}.webp`, IMAGES).href;
    if (source) image.src = source;
    image.addEventListener("error", () => image.removeAttribute("src"));
    button.append(image, make("b", "", title), make("span", "", line));
    button.addEventListener("focus", () => choose(name));
    cell.append(button);
    row.append(cell);
    // Of the presets, lessons are for classes; a command uses any other.
    const forClass = teaches && (own || group === "Lessons");
    if (saved || forClass) {
      const actions = make("div", "softrod-actions");
      actions.setAttribute("role", "gridcell");
      /** @param {string} text @param {() => void} press */
      const action = (text, press) => {
        const one = makeButton(text, press);
        one.ariaLabel = `${text} ${title}`;
        actions.append(one);
      };
      if (own) action("Rename", () => askForName(entry));
      if (saved) action("Copy", () => send({ do: "changeScene", how: "duplicate", name }));
      if (own) action("Delete", () => send({ do: "changeScene", how: "delete", name }));
      if (forClass) action("Use in class", () => send({ do: "useInClass", name }));
      row.append(actions);
    }
    return row;
  };

  /** What to do where nothing is saved yet. */
  const noneSaved = () => {
    const section = make("section", "softrod-none-saved");
    const begin = entries.find(({ name }) => name === EMPTY);
    section.append(make("h3", "", "Your own"), make("p", "", NONE_SAVED));
    if (begin) section.lastChild?.appendChild(makeButton(begin.title, () => open(begin)));
    return section;
  };

  const build = () => {
    const had = cards.contains(document.activeElement);
    const first = entries.filter(({ group }) => group === picker?.first);
    const groups = new Map([...first, ...entries].map(({ group }) => [group, /** @type {Entry[]} */ ([])]));
    for (const entry of entries) groups.get(entry.group)?.push(entry);
    cards.replaceChildren(
      ...(entries.some(({ own }) => own) ? [] : [noneSaved()]),
      ...[...groups].map(([group, members], i) => {
        const section = make("section", "");
        const heading = make("h3", "", group);
        heading.id = `softrod-group-${i}`;
        const grid = make("div", "softrod-cards");
        grid.setAttribute("role", "grid");
        grid.setAttribute("aria-labelledby", heading.id);
        grid.append(...members.map(card));
        section.append(heading, grid);
        return section;
      }),
    );
    const names = entries.map(({ name }) => name);
    choose(names.includes(chosen) ? chosen : names.includes(present) ? present : names[0]);
    filter();
    if (had) focus(found().find((one) => one.tabIndex === 0));
  };

  /** @param {Picker} [wanted] */
  const show = (wanted) => {
    if (dialog.open) return;
    picker = wanted;
    line.replaceChildren(...(picker ? [picker.line] : []));
    dialog.toggleAttribute("data-picks", picker !== undefined);
    if (head.firstElementChild) head.firstElementChild.textContent = picker?.title ?? "Scenes";
    search.value = "";
    chosen = "";
    say();
    dialog.showModal();
    // On a touch screen its keyboard would cover half of them.
    if (matchMedia("(pointer: coarse)").matches) dialog.focus();
    else search.focus();
    list();
  };

  search.addEventListener("input", filter);
  dialog.addEventListener("keydown", (event) => {
    const { target, key } = event;
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const on = found();
    if (target === search) {
      if (key === "Enter") on[0]?.click();
      else if (key === "ArrowDown") focus(on.find((one) => one.tabIndex === 0) ?? on[0]);
      else return;
      event.preventDefault();
      return;
    }
    const from = on.findIndex((one) => one === target);
    if (from >= 0 && /^(Arrow(Up|Down|Left|Right)|Home|End)$/.test(key)) {
      event.preventDefault();
      const places = on.map((one) => one.getBoundingClientRect());
      const to = arrived(key, from, places);
      if (key === "ArrowUp" && to === from) search.focus();
      else focus(on[to]);
    } else if (from >= 0 && key === "Delete") {
      const name = on[from].closest(".softrod-card")?.getAttribute("data-name") ?? "";
      if (entries.find((entry) => entry.name === name)?.own) send({ do: "changeScene", how: "delete", name });
    } else if (key.length === 1 && key !== " " && !(target instanceof HTMLInputElement)) {
      search.focus(); // which takes the letter
    }
  });
  Object.assign(gallery, { open: show, say, close: () => dialog.open && close() });
  onMessage("offerGallery", ({ why }) => {
    show();
    if (why) say(why);
  });
  onMessage("shelfChanged", () => dialog.open && list());
  onMessage("scenes", (letter) => {
    ({ scenes: entries, present, teaches } = letter);
    if (dialog.open) build();
  });
  onMessage("scenePictures", (letter) => {
    Object.assign(pictures, letter.pictures);
    for (const row of /** @type {NodeListOf<HTMLElement>} */ (cards.querySelectorAll(".softrod-card"))) {
      const [image, source] = [row.querySelector("img"), pictures[row.dataset.name ?? ""]];
      if (image && source && image.src !== source) image.src = source;
    }
  });
  onMessage("usedInClass", ({ address, command }) => {
    if (address) {
      location.assign(address);
      return;
    }
    const field = make("textarea", "softrod-command");
    field.value = command;
    field.rows = 1;
    field.readOnly = true;
    field.ariaLabel = "Command";
    const copy = makeButton("Copy", async () => (copy.textContent = (await copied(field)) ? "Copied" : "Press Ctrl+C"));
    say("Only this computer reaches this server. A class that others can come to begins in a terminal:", field, copy);
    copy.focus();
  });
  onMessage("sceneChanged", ({ text, undo }) => {
    say(text, ...(undo ? [makeButton("Undo", () => send({ do: "changeScene", how: "restore", name: undo }))] : []));
    list();
  });
}

/** @type {import("../../ui/feature.js").Feature<"gallery">} */
export default { commands: { gallery: () => gallery.open() }, begin };
