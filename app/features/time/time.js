// @ts-check
/** The bar under the body: play and pause, steps, going back in time, speed and the clock. */
import { FRACTIONS, SPEEDS } from "../../stage/looks.js";
import { onPicture } from "../../stage/canvas.js";
import { nextStep, timeNow } from "../../ui/clock.js";
import { has, onMessage, pageState, send } from "../../wire/channel.js";
import { COMMANDS } from "../../wire/commands.js";
import { iconHtml, make, makeButton } from "../../ui/dialog.js";
import { withKey } from "../../ui/hands/key_table.js";
import { perform } from "../../wire/perform.js";

/** Three dots: on a phone they show the rest of the bar. */
const MORE = "M5 10.2a1.8 1.8 0 1 1 0 3.6 1.8 1.8 0 0 1 0-3.6zM12 10.2a1.8 1.8 0 1 1 0 3.6 1.8 1.8 0 0 1 0-3.6zM19 10.2a1.8 1.8 0 1 1 0 3.6 1.8 1.8 0 0 1 0-3.6z";
/** Milliseconds between two updates of the clock while the body is at rest. */
const CLOCK_EVERY = 100;

/**
 * @typedef {object} Face of a button
 * @property {string} icon
 * @property {string} word beside the icon, if there is room
 * @property {string} name for screen readers and the tooltip; it contains the word
 * @property {CommandName} does
 *
 * @typedef {import("../../wire/wire.js").CommandName} CommandName
 */

/** @param {CommandName} does @returns {Face} */
const faceOf = (does) => ({ icon: COMMANDS[does].icon ?? "", word: COMMANDS[does].word ?? "", name: COMMANDS[does].label, does });

const FACES = {
  play: { ...faceOf("play"), word: "Play", name: "Play" },
  goOn: { ...faceOf("play"), word: "Go on", name: "Go on from here" },
  pause: { ...faceOf("pause"), does: /** @type {const} */ ("play") },
  reset: faceOf("reset"),
  second: faceOf("second"),
  back: faceOf("back"),
  step: faceOf("step"),
  forward: faceOf("forward"),
};

/** The present faces of buttons; their words may be translated in the page. @type {WeakMap<HTMLButtonElement, Face>} */
const dressed = new WeakMap();

/** @param {HTMLButtonElement} element @param {Face} face */
function dress(element, face) {
  if (dressed.get(element) === face) return;
  dressed.set(element, face);
  const { icon, word, name, does } = face;
  element.innerHTML = iconHtml(icon, word);
  element.ariaLabel = name;
  element.title = withKey(name, does);
}

/** @param {Face} face @param {() => void} press */
function iconButton(face, press) {
  const element = makeButton("", press, "");
  dress(element, face);
  return element;
}

/** @param {CommandName} command */
const offerButton = (command) =>
  makeButton(COMMANDS[command].word ?? COMMANDS[command].label, () => perform(command), "softrod-offer");

/** @type {Record<string, string>} */
const SPEED_TEXTS = FRACTIONS;
/** @param {number} speed */
const speedText = (speed) => `${SPEED_TEXTS[speed] ?? speed}×`;

/** The list of speeds. */
function speedBox() {
  const select = make("select", "");
  select.ariaLabel = "Speed";
  select.title = "Simulated seconds per second";
  for (const value of SPEEDS) select.add(new Option(speedText(value), String(value)));
  select.addEventListener("change", () => {
    send({ do: "speed", speed: Number(select.value) });
    // Return keyboard focus to the canvas, unless the user goes by keys.
    if (!select.matches(":focus-visible")) select.blur();
  });
  const show = () => {
    const { speed = 1 } = pageState();
    if (document.activeElement !== select) select.value = String(speed);
  };
  return { element: select, show };
}

/** The slider of time, which the page does not move while the user holds it. */
function timeSlider() {
  const slider = make("input", "");
  slider.type = "range";
  slider.step = "any";
  slider.ariaLabel = "Time shown";
  let held = false;
  let asked = false;
  let wanted = 0;
  const go = () => {
    asked = false;
    send({ do: "goTo", time: Number(wanted.toFixed(6)) });
  };
  slider.addEventListener("input", () => {
    held = true;
    wanted = Number(slider.value);
    if (!asked) requestAnimationFrame(go);
    asked = true;
  });
  slider.addEventListener("change", () => (held = false));
  /** @param {number} now */
  const show = (now) => {
    const { start = 0, end = 0, scrubbed } = pageState();
    const last = scrubbed ? end : Math.max(end, now);
    slider.min = String(start);
    slider.max = String(Math.max(last, start + 1e-3));
    if (!held) slider.value = String(now);
    slider.ariaValueText = `${now.toFixed(2)} seconds`;
  };
  return { element: slider, show };
}

/** Offers over the bar after a run that exploded, or after going back. */
function offers() {
  const line = make("div", "softrod-line");
  const [before, past, forget] = [offerButton("before"), make("span", "softrod-past"), offerButton("forget")];
  line.append(before, past, forget);
  const show = () => {
    const { offer, future } = pageState();
    before.hidden = !offer;
    forget.hidden = !future;
    past.textContent = future ? "The thin line is what happened before you went back." : "";
  };
  return { element: line, show };
}

/** Adds the bar to the page. */
function begin() {
  const bar = make("div", "softrod-transport softrod-floats");
  bar.setAttribute("role", "toolbar");
  bar.ariaLabel = "Time";
  const reset = iconButton(FACES.reset, () => perform("reset"));
  const second = iconButton(FACES.second, () => perform("second"));
  second.classList.add("softrod-second");
  const back = iconButton(FACES.back, () => perform("back"));
  const play = iconButton(FACES.pause, () => perform("play"));
  play.classList.add("softrod-play");
  const forward = iconButton(FACES.step, () => perform(nextStep()));
  const clock = make("output", "softrod-clock");
  clock.translate = false;
  const [time, speed, line] = [timeSlider(), speedBox(), offers()];
  const more = makeButton("", () => (more.ariaExpanded = String(bar.toggleAttribute("data-more"))), "softrod-more");
  more.innerHTML = iconHtml(MORE);
  more.ariaLabel = more.title = "More of time";
  more.ariaExpanded = "false";
  bar.append(reset, second, back, play, forward, time.element, clock, speed.element, more);
  const dock = make("div", "softrod-dock");
  dock.append(line.element, bar);
  document.body.append(dock);

  const show = () => {
    const now = timeNow();
    const past = pageState().scrubbed;
    clock.textContent = `${now.toFixed(2)} s`;
    time.show(now);
    dress(play, pageState().playing ? FACES.pause : past ? FACES.goOn : FACES.play);
    dress(forward, past ? FACES.forward : FACES.step);
    speed.show();
    line.show();
  };
  onPicture(show);
  setInterval(() => pageState().rest && show(), CLOCK_EVERY);
  onMessage("pageState", () => {
    document.documentElement.toggleAttribute("data-softrod-no-time", !has("play"));
    show();
  });
}

/** @type {import("../../ui/feature.js").Feature<"time">} */
export default { commands: {}, begin };
