// @ts-check
/** The bar under the body: play and pause, steps, going back in time, speed and the clock. */
import { awaySince } from "./away.js";
import { onPicture, shown } from "./canvas.js";
import { onTold, send, told } from "./channel.js";
import { FRACTIONS, ICONS as SHARED, SPEEDS } from "../../drawing/static/looks.js";
import { keyOf } from "./key_table.js";

/** Milliseconds between two readings of the clock while the body is at rest. */
const CLOCK_EVERY = 100;

// Outlines of 24 by 24, filled.
const ICONS = {
  ...SHARED,
  back: "M18 5v14l-9-7zM6 5h2v14H6z",
  forward: "M6 5v14l9-7zM16 5h2v14h-2z",
  second: "M20 5v14l-8-7zM11 5v14l-8-7z",
};

/**
 * @typedef {object} Face what a button shows
 * @property {keyof typeof ICONS} icon
 * @property {string} word beside the icon, where there is room
 * @property {string} name for screen readers and the tooltip; it contains the word
 * @property {string} does what, as the table of keys says
 */

/** @satisfies {Record<string, Face>} */
const FACES = {
  play: { icon: "play", word: "Play", name: "Play", does: "play" },
  goOn: { icon: "play", word: "Go on", name: "Go on from here", does: "play" },
  pause: { icon: "pause", word: "Pause", name: "Pause", does: "play" },
  reset: { icon: "reset", word: "Reset", name: "Reset", does: "reset" },
  second: { icon: "second", word: "1 s", name: "Back 1 second", does: "second" },
  back: { icon: "back", word: "Frame", name: "Back 1 frame", does: "back" },
  step: { icon: "forward", word: "Step", name: "1 step", does: "step" },
  forward: { icon: "forward", word: "Frame", name: "Forward 1 frame", does: "forward" },
};

/** What each button shows; its words may be translated. @type {WeakMap<HTMLButtonElement, Face>} */
const dressed = new WeakMap();

/** @param {HTMLButtonElement} element @param {Face} face */
function dress(element, face) {
  if (dressed.get(element) === face) return;
  dressed.set(element, face);
  const { icon, word, name, does } = face;
  element.innerHTML = `<svg viewBox="0 0 24 24" aria-hidden="true"><path d="${ICONS[icon]}"/></svg><span>${word}</span>`;
  element.ariaLabel = name;
  element.title = `${name} (${keyOf(does)})`;
}

/** @param {Face} face @param {() => void} press */
function iconButton(face, press) {
  const element = document.createElement("button");
  element.type = "button";
  element.addEventListener("click", press);
  dress(element, face);
  return element;
}

/** @param {string} text @param {string} command sent when it is pressed */
function offerButton(text, command) {
  const element = document.createElement("button");
  element.type = "button";
  element.className = "softrod-offer";
  element.textContent = text;
  element.addEventListener("click", () => send("do", command));
  return element;
}

/** What the step button does: in the past, go on to the next frame; else make a step. */
export const nextStep = () => (told().scrubbed === "1" ? "forward" : "step");

/** The simulated time. A body at rest sends no pictures, but its clock goes on, while there is a connection. */
export function timeNow() {
  const { frame, since } = shown();
  const passed = told().rest === "1" ? (Math.max(0, Math.min(performance.now(), awaySince()) - since) / 1e3) * Number(told().speed ?? 1) : 0;
  return (frame?.time ?? 0) + passed;
}

/** @param {number} speed */
const speedText = (speed) => `${/** @type {Record<string, string>} */ (FRACTIONS)[speed] ?? speed}×`;

/** How fast time goes. */
function speedBox() {
  const select = document.createElement("select");
  select.ariaLabel = "Speed";
  select.title = "Simulated seconds per second";
  for (const value of SPEEDS) select.add(new Option(speedText(value), String(value)));
  select.addEventListener("change", () => {
    send("speed", select.value);
    // The keys are the body's again, unless somebody goes by keys.
    if (!select.matches(":focus-visible")) select.blur();
  });
  const show = () => {
    const { speed } = told();
    if (speed && document.activeElement !== select) select.value = String(Number(speed));
  };
  return { element: select, show };
}

/** The slider of time. While a finger is on it, it is the finger's. */
function timeSlider() {
  const slider = document.createElement("input");
  slider.type = "range";
  slider.step = "any";
  slider.ariaLabel = "Time shown";
  let held = false;
  let asked = false;
  let wanted = 0;
  const go = () => {
    asked = false;
    send("go", wanted.toFixed(6));
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
    const { start = "0", end = "0", scrubbed } = told();
    const last = scrubbed === "1" ? Number(end) : Math.max(Number(end), now);
    slider.min = start;
    slider.max = String(Math.max(last, Number(start) + 1e-3));
    if (!held) slider.value = String(now);
    slider.ariaValueText = `${now.toFixed(2)} seconds`;
  };
  return { element: slider, show };
}

/** What is offered over the bar after a run that went wrong, or after going back. */
function offers() {
  const line = document.createElement("div");
  line.className = "softrod-line";
  const before = offerButton("Go back to just before it", "before");
  const past = document.createElement("span");
  past.className = "softrod-past";
  const forget = offerButton("Take the line away", "forget");
  line.append(before, past, forget);
  const show = () => {
    const { offer, future } = told();
    before.hidden = offer !== "1";
    forget.hidden = future !== "1";
    past.textContent = future === "1" ? "The thin line is what happened before you went back." : "";
  };
  return { element: line, show };
}

/** Puts up the bar. */
export function addTransport() {
  const bar = document.createElement("div");
  bar.className = "softrod-transport";
  bar.setAttribute("role", "toolbar");
  bar.ariaLabel = "Time";
  const reset = iconButton(FACES.reset, () => send("do", "reset"));
  const second = iconButton(FACES.second, () => send("do", "second"));
  second.classList.add("softrod-second");
  const back = iconButton(FACES.back, () => send("do", "back"));
  const play = iconButton(FACES.pause, () => send("do", "play"));
  play.classList.add("softrod-play");
  const forward = iconButton(FACES.step, () => send("do", nextStep()));
  const clock = document.createElement("output");
  clock.className = "softrod-clock";
  clock.translate = false;
  const [time, speed, line] = [timeSlider(), speedBox(), offers()];
  bar.append(reset, second, back, play, forward, time.element, clock, speed.element);
  const dock = document.createElement("div");
  dock.className = "softrod-dock";
  dock.append(line.element, bar);
  document.body.append(dock);

  const show = () => {
    const now = timeNow();
    const past = told().scrubbed === "1";
    clock.textContent = `${now.toFixed(2)} s`;
    time.show(now);
    dress(play, told().playing === "1" ? FACES.pause : past ? FACES.goOn : FACES.play);
    dress(forward, past ? FACES.forward : FACES.step);
    speed.show();
    line.show();
  };
  onPicture(show);
  setInterval(() => told().rest === "1" && show(), CLOCK_EVERY);
  onTold(show);
}

/**
 * Keeps the bar under the canvas, above what covers it.
 *
 * @param {DOMRect} box of the canvas
 * @param {number} hidden px at its bottom that are covered
 * @returns {number} its height, px
 */
export function placeTransport(box, hidden) {
  const dock = /** @type {HTMLElement | null} */ (document.querySelector(".softrod-dock"));
  if (!dock) return 0;
  dock.style.left = `${box.left}px`;
  dock.style.width = `${box.width}px`;
  dock.style.bottom = `${window.innerHeight - box.bottom + hidden}px`;
  return dock.offsetHeight;
}
