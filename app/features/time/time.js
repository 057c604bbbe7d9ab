// @ts-check
/** The bar under the body: play and pause, steps, going back in time, speed and the clock. */
import { FRACTIONS, SPEEDS } from "../../stage/looks.js";
import { onPicture } from "../../stage/canvas.js";
import { isStill } from "../../ui/access.js";
import { nextStep, timeNow } from "../../ui/clock.js";
import { has, onMessage, pageState, send } from "../../wire/channel.js";
import { COMMANDS } from "../../wire/commands.js";
import { iconHtml, make, makeButton, overCanvas } from "../../ui/dialog.js";
import { withKey } from "../../ui/hands/key_table.js";
import { perform } from "../../wire/perform.js";
import { barOf } from "./span.js";
import { decimal, say } from "../../words/words.js";

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
function faceOf(does) {
  const { icon = "", word, label } = COMMANDS[does];
  return { icon, word: word ? say(word) : "", name: say(label), does };
}

const FACES = {
  play: { ...faceOf("play"), word: say("command-run"), name: say("command-run") },
  goOn: { ...faceOf("play"), word: say("time-go-on.word"), name: say("time-go-on") },
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
  makeButton(say(COMMANDS[command].word ?? COMMANDS[command].label), () => perform(command), "softrod-offer");

/** @type {Record<string, string>} */
const SPEED_TEXTS = FRACTIONS;
/** @param {number} speed */
const speedText = (speed) => `${SPEED_TEXTS[speed] ?? speed}×`;

/** The list of speeds. */
function speedBox() {
  const select = make("select", "");
  select.ariaLabel = say("time-speed");
  select.title = say("time-speed.hint");
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

/** Seconds by which keys move the slider. @type {Readonly<Record<string, number>>} */
const BY_KEYS = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1, PageDown: -60, PageUp: 60 };

/** Milliseconds that a moment may take to come; until then the slider stays where it was put. */
const COMES_WITHIN = 1500;

/** The slider of time, of the whole run; the page does not move it while the user holds it. */
function timeSlider() {
  const slider = make("input", "");
  slider.type = "range";
  slider.step = "any";
  slider.ariaLabel = say("time-shown");
  let held = false;
  let asked = false;
  let wanted = 0;
  let shown = 0;
  let put = { at: 0, until: 0 }; // the time shown when the user let go, and until when the slider stays
  let bar = barOf(0, 1e-3);
  const go = () => {
    asked = false;
    send({ do: "goTo", time: Number(wanted.toFixed(6)) });
  };
  /** @param {number} time */
  const ask = (time) => {
    wanted = time;
    if (!asked) requestAnimationFrame(go);
    asked = true;
  };
  slider.addEventListener("input", () => {
    held = true;
    ask(bar.time(Number(slider.value)));
  });
  slider.addEventListener("change", () => {
    held = false;
    put = { at: shown, until: performance.now() + COMES_WITHIN };
  });
  slider.addEventListener("keydown", (event) => {
    const step = BY_KEYS[event.key];
    if (step === undefined || event.ctrlKey || event.altKey || event.metaKey || !slider.matches(":focus-visible")) return;
    event.preventDefault();
    ask((asked ? wanted : shown) + step);
  });
  slider.addEventListener("pointermove", ({ clientX, pointerType }) => {
    const { left, width } = slider.getBoundingClientRect();
    const part = Math.min(Math.max((clientX - left) / width, 0), 1);
    slider.title = pointerType === "mouse" ? `${decimal(bar.time(bar.low + part * (Number(slider.max) - bar.low)).toFixed(1))} s` : "";
  });
  /** @param {number} now */
  const show = (now) => {
    const { start = 0, end = 0, scrubbed } = pageState();
    const last = Math.max(scrubbed ? end : Math.max(end, now), start + 1e-3);
    bar = barOf(start, last);
    shown = now;
    slider.min = String(bar.low);
    slider.max = String(last);
    const comes = now === put.at && performance.now() < put.until && !pageState().playing;
    if (!held && !comes) slider.value = String(bar.position(now));
    slider.ariaValueText = say("time-shown.said", { seconds: decimal(now.toFixed(2)) });
  };
  return { element: slider, show };
}

/** Offers over the bar after a run that exploded, or after going back. */
function offers() {
  const line = make("div", "softrod-line");
  const [before, past, forget] = [offerButton("before"), make("span", "softrod-past"), offerButton("forget")];
  const stands = make("span", "softrod-past", say("time-stands"));
  line.append(before, past, stands, forget);
  const show = () => {
    const { offer, future, scrubbed, start = 0 } = pageState();
    before.hidden = !offer;
    forget.hidden = !future;
    const { page, playing, lesson } = pageState();
    stands.hidden = !(isStill() && page && !playing && !lesson && timeNow() === 0);
    const lost = scrubbed && start > 0 ? say("time-lost", { seconds: decimal(start.toFixed(1)) }) : "";
    past.textContent = future ? say("time-past") : lost;
  };
  return { element: line, show };
}

/** Adds the bar to the page. */
function begin() {
  const bar = make("div", "softrod-transport softrod-floats");
  bar.setAttribute("role", "toolbar");
  bar.ariaLabel = say("time-bar");
  const reset = iconButton(FACES.reset, () => perform("reset"));
  const second = iconButton(FACES.second, () => perform("second"));
  second.classList.add("softrod-second");
  const back = iconButton(FACES.back, () => perform("back"));
  const play = iconButton(FACES.pause, () => perform("play"));
  play.classList.add("softrod-play");
  const forward = iconButton(FACES.step, () => perform(nextStep()));
  const clock = make("output", "softrod-clock");
  clock.ariaLive = "off"; // it never stands still
  clock.translate = false;
  const [time, speed, line] = [timeSlider(), speedBox(), offers()];
  const more = makeButton("", () => (more.ariaExpanded = String(bar.toggleAttribute("data-more"))), "softrod-more");
  more.innerHTML = iconHtml(MORE);
  more.ariaLabel = more.title = say("time-bar.more");
  more.ariaExpanded = "false";
  bar.append(reset, second, back, play, forward, time.element, clock, speed.element, more);
  const dock = make("div", "softrod-dock");
  dock.append(line.element, bar);
  overCanvas().append(dock);

  const show = () => {
    const now = timeNow();
    const past = pageState().scrubbed;
    clock.textContent = `${decimal(now.toFixed(2))} s`;
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
