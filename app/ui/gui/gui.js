// @ts-check
/** Takes the messages on the panel out of viser's queue, and keeps the controls that they declare. */
import { onMessage, takeOver } from "../../wire/channel.js";
import { CONTAINERS, isFolder, isTabs } from "./containers.js";
import { Control, Place } from "./control.js";
import { FIELDS } from "./fields.js";
import { takeFiles } from "./files.js";
import { forgetCommands, takeCommands } from "./finder.js";
import { closeDialogs, takeDialogs } from "./modal.js";
import { takeNotices } from "./notices.js";
import { panel } from "./panel.js";
import { Plot } from "./plot.js";

/** @typedef {import("./control.js").Declared} Declared */

const KINDS = { ...FIELDS, ...CONTAINERS, GuiUplotMessage: Plot };

/** The id of the panel itself. */
const ROOT = "root";
/** @type {Map<string, Control>} */
const controls = new Map();
/** Where controls are: the panel, tabs, folders and dialogs. @type {Map<string, Place>} */
const places = new Map();
/** The place of each control. @type {Map<Control, string>} */
const whereabouts = new Map();

/** @param {Declared} declared */
function declare(declared) {
  remove(declared.uuid);
  const control = new KINDS[/** @type {keyof typeof KINDS} */ (declared.type)](declared);
  controls.set(declared.uuid, control);
  control.show(true);
  keepPlaces(control);
  put(control, declared.container_uuid);
}

/** @param {Control} control */
function keepPlaces(control) {
  for (const [id, place] of control.places) places.set(id, place);
}

/** @param {Control} control @param {string} id of its place */
function put(control, id) {
  whereabouts.set(control, id);
  const place = places.get(id);
  if (!place) return;
  place.put(control);
  if (id === ROOT) panel.changed();
}

/** @param {string} id */
function remove(id) {
  const control = controls.get(id);
  if (!control) return;
  controls.delete(id);
  const place = whereabouts.get(control) ?? "";
  places.get(place)?.drop(control);
  whereabouts.delete(control);
  for (const inside of control.places.keys()) places.delete(inside);
  control.element.remove();
  if (place === ROOT) panel.changed();
}

/** @param {string} id @param {Record<string, any>} updates */
function update(id, updates) {
  const control = controls.get(id);
  if (!control) return;
  control.take(updates);
  if (isTabs(control)) keepPlaces(control);
  // A new order is a new place among its neighbours.
  if ("order" in updates) put(control, whereabouts.get(control) ?? ROOT);
}

/** Shows the tab with an id. @param {string} id */
export function showTab(id) {
  for (const control of controls.values()) if (isTabs(control) && control.tabs.has(id)) control.choose(id);
  panel.unfold();
}

/** The control with an id. @param {string} id */
export const controlOf = (id) => controls.get(id);

/** The plots over time, for the browser tests. */
export const charts = () => [...controls.values()].filter((control) => control instanceof Plot);

/** The controls that can be found by their names. */
export const named = () => [...controls.values()].filter((control) => control.name && !control.element.hidden);

/** What holds a control. @param {Control} control */
function holderOf(control) {
  const id = whereabouts.get(control) ?? "";
  return { id, holder: [...controls.values()].find(({ places: inside }) => inside.has(id)) };
}

/** The words of the tab that a control is in; empty outside of all. @param {Control} control @returns {string} */
function tabOf(control) {
  const { id, holder } = holderOf(control);
  if (!holder) return "";
  return isTabs(holder) ? (holder.tabs.get(id)?.tab.textContent ?? "") : tabOf(holder);
}

/** Shows a control, wherever it is, and moves the focus to it. @param {Control} control */
export function reveal(control) {
  /** @type {Control | undefined} */
  let inside = control;
  while (inside) {
    const { id, holder } = holderOf(inside);
    if (holder && isTabs(holder)) holder.choose(id);
    if (holder && isFolder(holder)) holder.open();
    inside = holder;
  }
  panel.unfold();
  control.element.scrollIntoView({ block: "nearest" });
  control.focus();
}

/** Removes all that a connection has declared. */
export function clearPanel() {
  for (const id of [...controls.keys()]) remove(id);
  forgetCommands();
  closeDialogs();
}

/** Begins to draw the panel. */
export function drawPanel() {
  places.set(ROOT, new Place(panel.controls));
  for (const kind of Object.keys(KINDS)) takeOver(kind, (message) => declare(/** @type {any} */ (message)));
  takeOver("GuiUpdateMessage", ({ uuid, updates }) => update(uuid, updates ?? {}));
  takeOver("GuiRemoveMessage", ({ uuid }) => remove(uuid));
  onMessage("controlLook", (look) => controls.get(look.id)?.describe(look));
  takeDialogs(places);
  takeNotices();
  takeCommands(() =>
    named().map((control) => ({
      name: control.name,
      kind: "control",
      about: [control.saying, tabOf(control)].filter(Boolean).join(" · "),
      also: [...(control.props.options ?? []), control.props.hint ?? ""].join(" "),
      show: () => reveal(control),
    })),
  );
  takeFiles();
  panel.begin();
}
