// @ts-check
/** The bar under the body: play and pause, steps, going back in time, speed and the clock. */
import { onPicture, shown } from "./canvas.js";
import { onTold, send, told } from "./channel.js";

/** Milliseconds between two readings of the clock while the body is at rest. */
const CLOCK_EVERY = 100;
const SPEEDS = [0.125, 0.25, 0.5, 1, 2, 4];
/** @type {Record<string, string>} */
const FRACTIONS = { 0.125: "⅛", 0.25: "¼", 0.5: "½" };

// Outlines of 24 by 24, filled.
const ICONS = {
  play: "M7 4v16l13-8z",
  pause: "M6 4h4v16H6zM14 4h4v16h-4z",
  reset: "M12 5V1L7 6l5 5V7a5 5 0 1 1-5 5H5a7 7 0 1 0 7-7z",
  back: "M18 5v14l-9-7zM6 5h2v14H6z",
  forward: "M6 5v14l9-7zM16 5h2v14h-2z",
  second: "M20 5v14l-8-7zM11 5v14l-8-7z",
};

/**
 * @param {keyof typeof ICONS} icon
 * @param {string} name for those who cannot see it, and of the tooltip
 * @param {string} key that does the same
 * @param {() => void} press
 */
function button(icon, name, key, press) {
  const element = document.createElement("button");
  element.type = "button";
  element.addEventListener("click", press);
  dress(element, icon, name, key);
  return element;
}

/**
 * @param {HTMLButtonElement} element
 * @param {keyof typeof ICONS} icon
 * @param {string} name
 * @param {string} key
 */
function dress(element, icon, name, key) {
  if (element.ariaLabel === name) return;
  element.innerHTML = `<svg viewBox="0 0 24 24" aria-hidden="true"><path d="${ICONS[icon]}"/></svg>`;
  element.ariaLabel = name;
  element.title = key ? `${name} (${key})` : name;
}

/** What the step button does: in the past, go on to the next frame; else make a step. */
export const nextStep = () => (told().scrubbed === "1" ? "forward" : "step");

/**
 * The simulated time. A body at rest sends no pictures, but its clock goes on.
 */
function timeNow() {
  const { frame, since } = shown();
  const passed = told().rest === "1" ? ((performance.now() - since) / 1e3) * Number(told().speed ?? 1) : 0;
  return (frame?.time ?? 0) + passed;
}

/** @param {number} speed */
const speedText = (speed) => `${FRACTIONS[speed] ?? speed}×`;

/** Puts up the bar. */
export function addTransport() {
  const bar = document.createElement("div");
  bar.className = "softrod-transport";
  bar.setAttribute("role", "toolbar");
  bar.ariaLabel = "Time";

  const play = button("pause", "Pause", "Space", () => send("do", "play"));
  play.classList.add("softrod-play");
  const reset = button("reset", "Reset", "R", () => send("do", "reset"));
  const second = button("second", "Back 1 second", "J", () => send("do", "second"));
  second.classList.add("softrod-second");
  const back = button("back", "Back 1 frame", ",", () => send("do", "back"));
  const forward = button("forward", "1 step", "N", () => send("do", nextStep()));

  const time = document.createElement("input");
  time.type = "range";
  time.step = "any";
  time.ariaLabel = "Time shown";
  const clock = document.createElement("output");
  clock.className = "softrod-clock";
  const speed = document.createElement("select");
  speed.ariaLabel = "Speed";
  speed.title = "Simulated seconds per second";
  for (const value of SPEEDS) speed.add(new Option(speedText(value), String(value)));
  speed.addEventListener("change", () => {
    send("speed", speed.value);
    // The keys are the body's again, unless somebody goes by keys.
    if (!speed.matches(":focus-visible")) speed.blur();
  });

  const offer = document.createElement("button");
  offer.type = "button";
  offer.className = "softrod-offer";
  offer.textContent = "Go back to just before it";
  offer.addEventListener("click", () => send("do", "before"));
  const past = document.createElement("span");
  past.className = "softrod-past";
  const forget = document.createElement("button");
  forget.type = "button";
  forget.className = "softrod-offer";
  forget.textContent = "Take the line away";
  forget.addEventListener("click", () => send("do", "forget"));

  bar.append(reset, second, back, play, forward, time, clock, speed);
  const frame = document.createElement("div");
  frame.className = "softrod-dock";
  const line = document.createElement("div");
  line.className = "softrod-line";
  line.append(offer, past, forget);
  frame.append(line, bar);
  document.body.append(frame);

  // While a finger is on the slider it is the finger's.
  let held = false;
  let asked = false;
  let wanted = 0;
  const go = () => {
    asked = false;
    send("go", wanted.toFixed(6));
  };
  time.addEventListener("input", () => {
    held = true;
    wanted = Number(time.value);
    if (!asked) requestAnimationFrame(go);
    asked = true;
  });
  time.addEventListener("change", () => (held = false));

  const show = () => {
    const { start = "0", end = "0", playing, scrubbed, speed: factor, offer: offered, future } = told();
    const now = timeNow();
    const last = scrubbed === "1" ? Number(end) : Math.max(Number(end), now);
    clock.textContent = `${now.toFixed(2)} s`;
    time.min = start;
    time.max = String(Math.max(last, Number(start) + 1e-3));
    if (!held) time.value = String(now);
    time.ariaValueText = `${now.toFixed(2)} seconds`;
    if (playing === "1") dress(play, "pause", "Pause", "Space");
    else if (scrubbed === "1") dress(play, "play", "Go on from here", "Space");
    else dress(play, "play", "Play", "Space");
    if (factor && document.activeElement !== speed) speed.value = String(Number(factor));
    dress(forward, "forward", scrubbed === "1" ? "Forward 1 frame" : "1 step", scrubbed === "1" ? "." : "N");
    offer.hidden = offered !== "1";
    forget.hidden = future !== "1";
    past.textContent = future === "1" ? "The thin line is what happened before you went back." : "";
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
 */
export function placeTransport(box, hidden) {
  const dock = /** @type {HTMLElement | null} */ (document.querySelector(".softrod-dock"));
  if (!dock) return 0;
  dock.style.left = `${box.left}px`;
  dock.style.width = `${box.width}px`;
  dock.style.bottom = `${window.innerHeight - box.bottom + hidden}px`;
  return dock.offsetHeight;
}
