// @ts-check
/**
 * The script of a replay file: reads the motion in the file, and draws it into a canvas by the same modules as the page.
 * It fetches nothing.
 *
 * @typedef {object} Moving what the file says about its motion
 * @property {number} frames how many
 * @property {number} interval seconds between two
 * @property {number[]} plans the frame from which on each is valid; each has arrays for white and for dark paper
 * @property {number[]} damages the frame from which on each is valid
 * @typedef {import("./paint.js").Stage & Moving} About what the file says
 */
import { between, readDamage, readFrame, readPlan, UNHARMED } from "../../stage/plan.js";
import { sections } from "../../wire/unpack.js";
import { decimal, say } from "../../words/words.js";
import { paint } from "./paint.js";
import { element, unpacked } from "./parts.js";

/** Seconds by which an arrow key moves the time. */
const NUDGE = 0.1;
/** The same with Shift. */
const LEAP = 1;

/** @param {About} about @param {ArrayBuffer} data the arrays of plans, damages and frames, as pages get them */
function readMotion(about, data) {
  const take = sections(new Float32Array(data));
  const plans = about.plans.map((from) => ({ from, light: readPlan(take()), dark: readPlan(take()) }));
  const damages = about.damages.map((from) => ({ from, damage: readDamage(take()) }));
  const frames = Array.from({ length: about.frames }, () => readFrame(take()));
  /** @template {{from: number}} T @param {T[]} list @param {number} frame */
  const present = (list, frame) => list.filter(({ from }) => from <= frame).at(-1);
  return {
    /** What is shown at a time, seconds from the beginning. @param {number} time @param {boolean} dark */
    at(time, dark) {
      const at = time / about.interval;
      const before = Math.min(Math.max(Math.floor(at + 1e-6), 0), frames.length - 1);
      const plan = present(plans, before)?.[dark ? "dark" : "light"];
      if (!plan) throw new Error("a frame has no plan");
      const [one, two] = frames.slice(before, before + 2);
      const frame = two ? between(one, two, Math.max(at - before, 0)) : one;
      return { plan, frame, damage: present(damages, before)?.damage ?? UNHARMED };
    },
  };
}

/** @param {About} about @param {ReturnType<typeof readMotion>} motion */
function player(about, motion) {
  const play = element("play", HTMLButtonElement);
  const slider = element("time", HTMLInputElement);
  const speed = element("speed", HTMLSelectElement);
  const clock = element("clock", HTMLOutputElement);
  const canvas = element("canvas", HTMLCanvasElement);
  const seconds = (about.frames - 1) * about.interval;
  let [time, playing, asked, before] = [0, false, false, 0];
  slider.max = String(seconds);
  const night = matchMedia("(prefers-color-scheme: dark)");
  const draw = () => {
    const shown = motion.at(time, night.matches);
    paint(about, canvas, shown);
    return shown.frame;
  };
  const show = () => {
    const frame = draw();
    slider.value = String(time);
    clock.value = `${decimal(frame.time.toFixed(2))} s`;
    slider.setAttribute("aria-valuetext", clock.value);
    play.dataset.icon = playing ? "pause" : time >= seconds ? "again" : "play";
    play.ariaLabel = say(playing ? "live-pause" : time >= seconds ? "replay-again" : "live-play");
  };
  /** @param {number} now ms */
  const next = (now) => {
    asked = false;
    if (playing) time = Math.min(time + (Math.min(now - before, 100) / 1e3) * Number(speed.value), seconds);
    before = now;
    if (time >= seconds) playing = false;
    show();
    if (playing) ask();
  };
  const ask = () => {
    if (!asked) requestAnimationFrame(next);
    asked = true;
  };
  /** @param {boolean} on */
  const set = (on) => {
    playing = on;
    before = performance.now();
    if (on && time >= seconds) time = 0;
    ask();
  };
  /** @param {number} to */
  const go = (to) => {
    playing = false;
    time = Math.min(Math.max(to, 0), seconds);
    ask();
  };
  play.addEventListener("click", () => set(!playing));
  canvas.addEventListener("click", () => set(!playing));
  slider.addEventListener("input", () => go(Number(slider.value)));
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.target === speed) return;
    const far = event.shiftKey ? LEAP : NUDGE;
    /** @type {Record<string, () => void>} */
    const keys = {
      " ": () => set(!playing),
      ArrowLeft: () => go(time - far),
      ArrowRight: () => go(time + far),
      Home: () => go(0),
      End: () => go(seconds),
    };
    if (!keys[event.key] || (event.key === " " && event.repeat)) return;
    event.preventDefault();
    keys[event.key]();
  });
  new ResizeObserver(ask).observe(canvas);
  // The browser had taken its memory back.
  canvas.addEventListener("contextrestored", ask);
  for (const query of ["(prefers-color-scheme: dark)", `(resolution: ${devicePixelRatio}dppx)`]) {
    matchMedia(query).addEventListener("change", ask);
  }
  set(!matchMedia("(prefers-reduced-motion: reduce)").matches);
  // For the browser tests.
  Object.assign(window, { __softrod: { playing: () => playing, shown: draw } });
}

try {
  const [about, text] = ["about", "data"].map((id) => element(id, HTMLScriptElement).textContent ?? "");
  const given = /** @type {About} */ (JSON.parse(about));
  player(given, readMotion(given, await unpacked(JSON.parse(text))));
} catch (error) {
  const said = document.querySelector("[role=alert]");
  if (said) said.textContent = say("replay-too-old");
  throw error;
}
