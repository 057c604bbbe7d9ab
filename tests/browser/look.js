/** Draws every control of the panel in every state, with the page's own scripts and styles; see `look.py`. */
import { CONTAINERS } from "../../app/ui/gui/containers.js";
import { FIELDS } from "../../app/ui/gui/fields.js";
import { takeNotices } from "../../app/ui/gui/notices.js";
import { Plot } from "../../app/ui/gui/plot.js";
import { iconHtml, make, makeButton } from "../../app/ui/dialog.js";
import { receive } from "../../app/wire/channel.js";
import { lessonCard } from "../../app/features/lesson/card.js";

const KINDS = { ...FIELDS, ...CONTAINERS, GuiUplotMessage: Plot };
const EYE = "M2 12s4-7 10-7s10 7 10 7s-4 7-10 7s-10-7-10-7zM12 9a3 3 0 1 1 0 6a3 3 0 0 1 0-6z";
/** States by the class that stands for them, see `look.py`. */
const STATES = { idle: "", hover: "look-hover", held: "look-held look-hover", "by keys": "look-keys look-focus" };
let count = 0;
/** Kinds of controls that are not in the sheet, for its test. */
const missing = new Set(Object.keys(KINDS));

/** A control as a message declares it. */
function control(kind, { value, look = {}, ...props }) {
  missing.delete(`Gui${kind}Message`);
  const made = new KINDS[`Gui${kind}Message`]({ type: "", uuid: `look-${(count += 1)}`, container_uuid: "", value, props });
  made.describe({ place: "", note: "", ...look });
  return made;
}

/** A figure: something in a state, and the state's name. */
function figure(element, name) {
  const box = make("figure", "");
  box.append(element, make("figcaption", "", name));
  return box;
}

function section(title, width, ...figures) {
  const box = make("section", "");
  const row = make("div", "look-row");
  row.style.setProperty("--least", `${width}px`);
  row.append(...figures);
  box.append(make("h2", "", title), row);
  document.querySelector("main").append(box);
}

/** A control in each of its states. `part` finds what is pressed in it. */
function states(kind, props, part) {
  const figures = Object.entries(STATES).map(([name, classes]) => {
    const { element } = control(kind, props);
    if (classes) element.querySelector(part).classList.add(...classes.split(" "));
    return figure(element, name);
  });
  return [...figures, figure(control(kind, { ...props, disabled: true }).element, "disabled")];
}

/** A plain element in each of its states. */
const plain = (makeOne) =>
  Object.entries(STATES).map(([name, classes]) => {
    const element = makeOne();
    if (classes) element.classList.add(...classes.split(" "));
    return figure(element, name);
  });

const gravity = { label: "Gravity", min: 0, max: 2500, step: 1, value: 1000, look: { unit: "px/s²" } };
const press = () => {};
/** The value of a token. */
const token = (name) => getComputedStyle(document.documentElement).getPropertyValue(`--softrod-${name}`);

section("Button", 110, ...states("Button", { label: "Start again", color: "gray" }, "button"));
section("Primary", 110, ...states("Button", { label: "Check it" }, "button"));
section("Danger", 110, ...states("Button", { label: "Delete", color: "red" }, "button"));
section(
  "Icon button",
  70,
  ...plain(() => {
    const button = makeButton("", press, "softrod-icon-button");
    button.innerHTML = iconHtml(EYE);
    button.ariaLabel = "View";
    return button;
  }),
);

const refused = control("Slider", gravity);
refused.box.input.value = "2e9";
refused.box.type();
refused.look.high = 1e6;
refused.box.settle();
section(
  "Slider with its number",
  180,
  ...states("Slider", gravity, "input[type=range]"),
  figure(control("Slider", { ...gravity, label: "Curl of every joint", min: -90, max: 90, value: -24, look: { unit: "°" } }).element, "with a middle"),
  figure(control("Slider", { ...gravity, label: "Stiffness", min: 1, max: 1e6, value: 1000, look: { unit: "kg/s²", logarithmic: true } }).element, "logarithmic"),
  figure(refused.element, "a number that cannot be"),
);
section("Number", 180, ...states("Number", { label: "Largest error", value: 0.1, look: { unit: "px" } }, "input"));
section("Switch", 180, ...states("Checkbox", { label: "Follow the pointer", value: true }, "input"), figure(control("Checkbox", { label: "Trails", value: false }).element, "off"));
section("List", 240, ...states("Dropdown", { label: "Law", value: "Sine law", options: ["Sine law", "Angle law"] }, "select"));
section("Text", 240, ...states("Text", { label: "Name", value: "My bridge" }, "input"));
section("Buttons in a row", 240, figure(control("ButtonGroup", { label: "Add", options: ["Line", "Circle", "Both"] }).element, "idle"));

const steps = [{ title: "Twice the weight", do: "Pull the mass down and let go.", watch: "", question: { text: "How far does it hang?", choices: ["71 px", "100 px", "200 px"], answer: 1, because: "The pull doubles, so the spring is twice as long." } }];
const lesson = (choice, known) => {
  const run = { step: steps[0], steps, at: 0, waits: false, present: { choice, known }, answer: press, enter: press, again: press, reveal: press, startOver: press };
  const { parts, foot } = lessonCard(run, {});
  const box = make("div", "");
  const card = make("div", "softrod-lesson");
  card.append(...parts);
  box.append(card, foot);
  return box;
};
section("Answer", 260, figure(lesson(-1, false), "asked"), figure(lesson(2, false), "chosen"), figure(lesson(2, true), "told"));

const tabs = control("TabGroup", { _tab_container_ids: ["a", "b", "c"], _tab_labels: ["Play", "Measure", "Solver"] });
tabs.list.children[1].classList.add("look-hover");
tabs.list.children[2].classList.add("look-keys");
section("Tabs", 300, figure(tabs.element, "chosen, hover, by keys"));
const folder = control("Folder", { label: "More numbers", expand_by_default: true });
folder.places.values().next().value.put(control("Checkbox", { label: "Trails", value: true }));
const closed = control("Folder", { label: "Damping", expand_by_default: false });
closed.details.open = false;
section("Folder", 240, figure(folder.element, "open"), figure(closed.element, "closed"));

const seconds = Float64Array.from({ length: 61 }, (_, i) => i / 20);
const plot = control("Uplot", {
  data: [seconds, seconds.map((t) => Math.exp(-t / 2) * Math.cos(5 * t)), seconds.map((t) => 0.6 * Math.sin(3 * t))],
  series: [{}, { label: "x, px", stroke: token("brand"), width: 2, scale: "px" }, { label: "y, px", stroke: token("pulled"), width: 2, scale: "px" }],
  axes: [{ scale: "x", label: "Time, s" }, { scale: "px", label: "Place of a mass, px" }],
});
section("Plot", 300, figure(plot.element, "two curves"));
section("Row of a table", 260, figure(control("Html", { content: '<table class="softrod-table"><tr><td>Joint 6, angle</td><td>−4.2°</td></tr><tr><td>Joint 7, angle</td><td>−3.8°</td></tr></table>' }).element, "two"));
section("Line between controls", 240, figure(control("Divider", {}).element, "one"));
section("Card", 260, ...states("Button", { label: "Rope", color: "gray", _icon_html: iconHtml(EYE), look: { place: "card", note: "Choose another scene" } }, "button"));
section("How far", 240, figure(control("ProgressBar", { value: 40 }).element, "40 %"));

takeNotices();
const say = (title, body, color) =>
  receive({ type: "NotificationShowMessage", uuid: title, props: { title, body, color, auto_close_seconds: null } });
say("Mass removed", "", null);
say("This computer draws slowly.", "With simpler springs it moves smoothly.", "orange");
say("The file cannot be read.", "line 3: “gravity” is missing.", "red");
section("Notice", 360, figure(document.querySelector(".softrod-notices"), "plain, take care, refused"));
Object.assign(window, { missing: [...missing] });
document.documentElement.dataset.ready = "";
