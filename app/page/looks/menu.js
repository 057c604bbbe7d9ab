// @ts-check
/** The View menu over the bar of time: how the page looks, and the help. */
import { has, onTold, send, told } from "../../wire/channel.js";
import { COMMANDS } from "../../wire/commands.js";
import { make, makeButton } from "./dialog.js";
import { hasWords, isDark, isProjector, keepInView } from "./looks.js";
import { onSight } from "../body/overlay.js";
import { perform } from "../../wire/perform.js";

const ICON = "M2 12s4-7 10-7 10 7 10 7-4 7-10 7S2 12 2 12zM12 9a3 3 0 1 1 0 6 3 3 0 0 1 0-6z";

/**
 * @typedef {object} Entry
 * @property {string} label
 * @property {string} [key] that does the same
 * @property {string} [hint]
 * @property {"view" | "help"} part of the controls of a page without which it is left out
 * @property {() => boolean} [on] of a switch
 * @property {() => void} press
 */

/** @param {"gizmos" | "meter"} what as the server tells it @returns {Pick<Entry, "on" | "press">} */
const toldSwitch = (what) => ({
  on: () => told()[what] ?? false,
  press: () => send({ do: "switch", what, on: !told()[what] }),
});
/** @param {import("../../wire/wire.js").CommandName} name @returns {Pick<Entry, "label" | "key" | "press">} */
const command = (name) => ({ label: COMMANDS[name].label, key: COMMANDS[name].shown, press: () => perform(name) });

/** @type {Entry[]} */
const ENTRIES = [
  { label: "Dark", part: "view", on: isDark, press: () => send({ do: "switch", what: "dark", on: !isDark() }) },
  { ...command("larger"), part: "view", on: isProjector },
  { label: "Stability bar", hint: "always, not only where the time step is near its limit", part: "view", ...toldSwitch("meter") },
  { label: "Arrows at held masses", hint: "to drag them along one axis", part: "view", ...toldSwitch("gizmos") },
  { ...command("fit"), part: "view" },
  { ...command("help"), part: "help" },
];

/** Puts up the button and its menu. */
export function addMenu() {
  const element = make("div", "softrod-menu");
  const list = make("div", "softrod-menu-list");
  list.id = "softrod-menu-list";
  list.setAttribute("role", "menu");
  list.ariaLabel = "View";
  list.hidden = true;
  const lid = makeButton("", () => open(list.hidden === true), "softrod-menu-lid");
  lid.innerHTML = `<svg viewBox="0 0 24 24" aria-hidden="true"><path d="${ICON}"/></svg><span>View</span>`;
  lid.ariaLabel = "View";
  lid.title = "View: dark, projector, help and more";
  lid.ariaHasPopup = "menu";
  lid.ariaExpanded = "false";
  lid.setAttribute("aria-controls", list.id);
  const items = ENTRIES.map((entry) => {
    const item = makeButton("", () => {
      const byKeys = item.matches(":focus-visible");
      open(false);
      entry.press();
      // The keys are the body's again, unless somebody goes by keys.
      if (byKeys) lid.focus();
    }, "");
    item.append(make("span", "softrod-menu-mark"), make("span", "", entry.label), make("kbd", "", entry.key ?? ""));
    item.setAttribute("role", entry.on ? "menuitemcheckbox" : "menuitem");
    item.tabIndex = -1;
    if (entry.hint) item.title = entry.hint;
    list.append(item);
    return { entry, item };
  });
  element.append(list, lid);
  document.body.append(element);

  /** @param {boolean} on */
  function open(on) {
    for (const { entry, item } of items) {
      item.hidden = !has(entry.part);
      if (entry.on) item.ariaChecked = String(entry.on());
    }
    list.hidden = !on;
    element.toggleAttribute("data-open", on);
    lid.ariaExpanded = String(on);
    if (!on) return;
    keepInView(list);
    items.find(({ item }) => !item.hidden)?.item.focus();
  }
  element.addEventListener("keydown", (event) => {
    if (list.hidden) return;
    event.stopPropagation(); // viser would move the camera
    const shown = items.filter(({ item }) => !item.hidden).map(({ item }) => item);
    const at = shown.findIndex((item) => item === document.activeElement);
    const to = { ArrowDown: at + 1, ArrowUp: at - 1, Home: 0, End: -1 }[event.key];
    if (event.key === "Escape" || event.key === "Tab") {
      open(false);
      lid.focus();
    } else if (to !== undefined) shown.at(to % shown.length)?.focus();
    if (to !== undefined || event.key === "Escape") event.preventDefault();
  });
  // A press in the menu leaves the focus where it is, in every browser; any other press takes it away.
  element.addEventListener("mousedown", (event) => event.preventDefault());
  element.addEventListener("focusout", ({ relatedTarget }) => {
    if (!(relatedTarget instanceof Node && element.contains(relatedTarget))) open(false);
  });
  onTold("pageState", () => (element.hidden = !has("view") && !has("help")));
  onSight(({ box }) => {
    const dock = document.querySelector(".softrod-dock")?.getBoundingClientRect();
    element.classList.toggle("softrod-words", hasWords(box));
    element.style.right = `${window.innerWidth - box.right + 14}px`;
    element.style.bottom = `${window.innerHeight - Math.min(box.bottom, dock?.top ?? Infinity) + 10}px`;
    if (!list.hidden) keepInView(list);
  });
}
