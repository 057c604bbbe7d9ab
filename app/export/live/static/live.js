// @ts-check
/**
 * The script of a live file: a body that moves, is dragged, and has sliders, in one file without a server. It draws with
 * what the page draws by, and fetches nothing.
 *
 * @typedef {import("./body.js").BodyData} BodyData
 * @typedef {import("./settings.js").Setting} Setting
 * @typedef {object} Told
 * @property {BodyData} body
 * @property {"symplectic_euler" | "verlet"} method
 * @property {number} dt length of a step of symplectic Euler, s
 * @property {Setting[]} settings
 * @property {import("./steps.js").Presses | null} up what the key Up does in a second; null where arrow keys do nothing
 * @property {import("./steps.js").Presses | null} right the same for the key Right
 * @property {number} joint whose angle is read out, or -1
 * @property {string} unit of length
 * @property {string} energyUnit
 * @property {number} speed at which the clock runs at first
 * @property {string[]} foremost keys of the settings whose sliders are not folded
 * @property {import("./course.js").Lesson | null} lesson
 * @property {string[]} plans arrays as pages get them: the plan on white and on dark paper
 * @typedef {import("../../static/paint.js").Stage & Told} About
 */
import { readPlan, UNHARMED } from "../../../stage/plan.js";
import { paint, screenOf } from "../../static/paint.js";
import { element, unpacked } from "../../static/parts.js";
import { Body } from "./body.js";
import { makeChart } from "./chart.js";
import { Clock } from "./clock.js";
import { addCourse } from "./course.js";
import { addHands } from "./hands.js";
import { addPanel } from "./panel.js";
import { Recording } from "./quantities.js";
import { partOfLimit } from "./readings.js";
import { write } from "./settings.js";
import { isDark } from "./view.js";

/** The body and its time, as they are now; another one after a reset. @param {About} about */
function begin(about) {
  const body = new Body(about.body);
  return { body, clock: new Clock(body, about.method, about.dt) };
}

/** The two plans of a body: on white and on dark paper. @param {About} about */
const plansOf = (about) =>
  Promise.all(about.plans.map(async (text) => readPlan(new Float32Array(await unpacked(text)))));

/** What has yielded and broken, as the drawing has it. @param {Body} body */
function damageOf(body) {
  if (!body.data.limits) return UNHARMED;
  const broken = new Set(Array.from(body.broken.keys()).filter((s) => body.broken[s]));
  return { ...UNHARMED, broken, setLength: Float32Array.from(body.setLength), setAngle: Float32Array.from(body.setAngle) };
}

/** @param {About} about @param {import("../../../stage/plan.js").Plan[][]} plans of the body, and of each step of its lesson */
function run(about, plans) {
  const canvas = element("canvas", HTMLCanvasElement);
  /** What is shown: the file's body, or that of a step. */
  let shown = about;
  let [white, dark] = plans[0];
  const plan = () => (isDark() ? dark : white);
  element("follow", HTMLButtonElement).hidden = white.driven < 0;
  let now = begin(about);
  let record = new Recording({ goal: null, names: [] });
  /** @type {ReturnType<typeof makeChart>[]} */
  let charts = [];
  let [playing, speed, before] = [false, about.speed, 0];
  const place = () => screenOf(shown, canvas);
  /** @param {import("./settings.js").Setting} setting @param {number | string} value */
  const put = (setting, value) => {
    write(now.body, setting, value);
    if (setting.key === "dt") now.clock.dt = Number(value);
  };
  const look = () => record.take(now.body, !now.clock.exploded, partOfLimit(now.clock));
  const reset = () => {
    now = begin(shown);
    for (const [setting, value] of panel.values()) put(setting, value);
    record = new Recording(record);
    look();
    hands.letGo();
  };
  const panel = addPanel(about, {
    play: () => set(!playing),
    step: () => {
      set(false);
      now.clock.meter.look();
      if (!now.clock.exploded) now.clock.advance(now.clock.step, 1, hands.hands(), panel.presses());
    },
    reset: () => {
      reset();
      set(true);
    },
    back: () => {
      now.clock.goBack();
      hands.letGo();
    },
    follow: () => hands.follow(),
    speed: (value) => (speed = value),
    changed: (setting, value) => {
      put(setting, value);
      now.clock.changed();
    },
  });
  const hands = addHands(canvas, { body: () => now.body, plan, place });
  /** @param {boolean} on */
  function set(on) {
    playing = on && !now.clock.exploded;
    before = performance.now();
  }
  const { lesson } = about;
  const course = lesson && addCourse(lesson, {
    begin: (step, waits) => {
      shown = { ...about, ...step.about, body: { ...about.body, ...step.about.body } };
      [white, dark] = plans[1 + lesson.steps.indexOf(step)];
      panel.setUp(shown.settings, step.controls);
      charts = step.plots.map(makeChart);
      element("charts", HTMLElement).replaceChildren(...charts.map(({ element }) => element));
      record = new Recording({ goal: step.goal, names: step.plots.flatMap(({ names, over }) => (over ? [...names, over] : names)) });
      reset();
      set(!waits);
    },
    run: () => set(true),
    places: () => Array.from({ length: now.body.masses }, (_, m) => [now.body.positions[2 * m], now.body.positions[2 * m + 1]]),
  });
  const draw = () => {
    const { body } = now;
    const drawn = plan();
    drawn.restAngle = Float32Array.from(body.restAngle);
    if (drawn.wind.length) {
      drawn.wind = Float32Array.from([...body.wind, ...body.waves.flatMap((wave) => wave.slice(0, 5))]);
    }
    // A slider may have set another tempo.
    if (body.muscles) drawn.muscles.set([body.muscles.frequency, body.muscles.phase]);
    const predicted = course?.predicted();
    const frame = {
      generation: 0, time: body.time, lengthScale: body.scale, angleShift: body.shift,
      positions: Float32Array.from(body.positions), ghost: predicted ? Float32Array.from(predicted.flat()) : null,
    };
    paint(shown, canvas, { plan: drawn, frame, damage: damageOf(body) });
    hands.mark();
    panel.show(shown, now, playing, hands.follows());
    for (const chart of charts) chart.draw(record);
  };
  /** @param {number} time ms */
  const next = (time) => {
    if (playing) {
      now.clock.go(((time - before) / 1e3) * speed, hands.hands(), panel.presses());
      if (course) look();
      if (course?.look(now.body.time, record)) playing = false;
    } else if (!now.clock.exploded) hands.moveAtOnce();
    before = time;
    if (now.clock.exploded) playing = false;
    draw();
    requestAnimationFrame(next);
  };
  document.body.classList.toggle("taught", course !== null);
  if (course) course.begin();
  else {
    panel.setUp(about.settings, about.foremost);
    set(!matchMedia("(prefers-reduced-motion: reduce)").matches);
  }
  before = performance.now();
  requestAnimationFrame(next);
  // For the browser tests.
  Object.assign(window, { __softrod: { now: () => now, place, plan, sheet: course?.sheet } });
}

try {
  const about = /** @type {About} */ (JSON.parse(element("about", HTMLScriptElement).textContent ?? ""));
  const all = [about, ...(about.lesson?.steps ?? []).map((step) => ({ ...about, ...step.about }))];
  run(about, await Promise.all(all.map((one) => plansOf(/** @type {About} */ (one)))));
} catch (error) {
  const said = document.querySelector("[role=alert]");
  if (said) said.textContent = "This browser cannot show the file; a newer one can.";
  throw error;
}
