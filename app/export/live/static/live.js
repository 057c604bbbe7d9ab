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
 * @property {number} speed at which the clock runs at first
 * @property {string[]} plans arrays as pages get them: the plan on white and on dark paper
 * @typedef {import("../../static/paint.js").Stage & Told} About
 */
import { readPlan, UNHARMED } from "../../../drawing/static/plan.js";
import { paint, screenOf } from "../../static/paint.js";
import { element, isDark, unpacked } from "../../static/parts.js";
import { Body } from "./body.js";
import { Clock } from "./clock.js";
import { addHands } from "./hands.js";
import { addPanel } from "./panel.js";

/** The body and its time, as they are now; another one after a reset. @param {About} about */
function begin(about) {
  const body = new Body(about.body);
  return { body, clock: new Clock(body, about.method, about.dt) };
}

/** What has yielded and broken, as the drawing has it. @param {Body} body */
function damageOf(body) {
  if (!body.data.limits) return UNHARMED;
  const broken = new Set(Array.from(body.broken.keys()).filter((s) => body.broken[s]));
  return { ...UNHARMED, broken, setLength: Float32Array.from(body.setLength), setAngle: Float32Array.from(body.setAngle) };
}

/** @param {About} about @param {import("../../../drawing/static/plan.js").Plan[]} plans on white and on dark paper */
function run(about, plans) {
  const canvas = element("canvas", HTMLCanvasElement);
  let now = begin(about);
  let [playing, speed, before] = [!matchMedia("(prefers-reduced-motion: reduce)").matches, about.speed, 0];
  const place = () => screenOf(about, canvas);
  const plan = () => plans[isDark() ? 1 : 0];
  const panel = addPanel(about, {
    play: () => set(!playing),
    step: () => {
      set(false);
      now.clock.meter.look();
      now.clock.advance(now.clock.step, 1, hands.hands(), panel.presses());
    },
    reset: () => {
      const kept = panel.values();
      now = begin(about);
      for (const [setting, value] of kept) panel.write(now.body, setting, value);
      hands.letGo();
      set(true);
    },
    speed: (value) => (speed = value),
    changed: (setting, value) => {
      panel.write(now.body, setting, value);
      now.clock.changed();
    },
  });
  const hands = addHands(canvas, { body: () => now.body, plan, place });
  /** @param {boolean} on */
  function set(on) {
    playing = on && !now.clock.exploded;
    before = performance.now();
  }
  const draw = () => {
    const { body } = now;
    const shown = plan();
    shown.restAngle = Float32Array.from(body.restAngle);
    if (shown.wind.length) {
      shown.wind = Float32Array.from([...body.wind, ...body.waves.flatMap((wave) => wave.slice(0, 5))]);
    }
    const frame = {
      generation: 0, time: body.time, lengthScale: body.scale, angleShift: body.shift,
      positions: Float32Array.from(body.positions), ghost: null,
    };
    paint(about, canvas, { plan: shown, frame, damage: damageOf(body) });
    hands.mark();
    panel.show(now, playing);
  };
  /** @param {number} time ms */
  const next = (time) => {
    if (playing) now.clock.go(((time - before) / 1e3) * speed, hands.hands(), panel.presses());
    else hands.moveAtOnce();
    before = time;
    if (now.clock.exploded) playing = false;
    draw();
    requestAnimationFrame(next);
  };
  before = performance.now();
  requestAnimationFrame(next);
  // For the browser tests.
  Object.assign(window, { __softrod: { now: () => now, place, plan } });
}

try {
  const about = /** @type {About} */ (JSON.parse(element("about", HTMLScriptElement).textContent ?? ""));
  run(about, await Promise.all(about.plans.map(async (text) => readPlan(new Float32Array(await unpacked(text))))));
} catch (error) {
  const said = document.querySelector("[role=alert]");
  if (said) said.textContent = "This browser cannot show the file; a newer one can.";
  throw error;
}
