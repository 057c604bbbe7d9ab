// @ts-check
/**
 * The script of a live file: a body that moves, is dragged, and has sliders, in one file without a server. It draws by the same
 * modules as the page, and fetches nothing.
 *
 * @typedef {import("./body.js").BodyData} BodyData
 * @typedef {import("./settings.js").Setting} Setting
 * @typedef {import("../../../stage/plan.js").Plan} Plan
 * @typedef {object} Told
 * @property {BodyData} body
 * @property {"symplectic_euler" | "verlet"} method
 * @property {number} dt length of a step of symplectic Euler, s
 * @property {Setting[]} settings
 * @property {import("./steps.js").Presses | null} up what the key Up does in a second; null where arrow keys do nothing
 * @property {import("./steps.js").Presses | null} right the same for the key Right
 * @property {number} joint whose angle is shown, or -1
 * @property {string} unit of lengths
 * @property {string} energyUnit
 * @property {import("./course.js").Lesson | null} lesson
 * @property {string[]} plans arrays as pages get them: the plan on white and on dark paper
 * @typedef {import("../../static/paint.js").Stage & Told} About
 */
import { isStill } from "../../../ui/access.js";
import { readPlan, UNHARMED } from "../../../stage/plan.js";
import { say } from "../../../words/words.js";
import { paint, screenOf } from "../../static/paint.js";
import { element, unpacked } from "../../static/parts.js";
import { Body } from "./body.js";
import { Clock } from "./clock.js";
import { Hands } from "./hands.js";
import { Panel } from "./panel.js";
import { write } from "./settings.js";
import { isDark } from "./view.js";
// ifdef HAS_LESSON
import { makeChart } from "./chart.js";
import { Course } from "./course.js";
import { Recording } from "./quantities.js";
import { partOfLimit } from "./readings.js";
// endif
// ifdef HAS_DERIVED
import { addDerived } from "./quantities.js";
// endif

/** The two plans of a body: on white and on dark paper. @param {string[]} texts */
const readPlans = (texts) => Promise.all(texts.map(async (text) => readPlan(new Float32Array(await unpacked(text)))));

/** What has yielded and broken, as the drawing has it. @param {Body} body */
function damageOf(body) {
  if (!body.data.limits) return UNHARMED;
  const broken = new Set(Array.from(body.broken.keys()).filter((s) => body.broken[s]));
  return { ...UNHARMED, broken, setLength: Float32Array.from(body.setLength), setAngle: Float32Array.from(body.setAngle) };
}

/** A body and all that is done with it. */
export class Live {
  playing = false;
  speed = 1;
  /** @type {import("./course.js").Course | null} */
  course = null;
  // ifdef HAS_LESSON
  /** @type {ReturnType<typeof makeChart>[]} */
  #charts = [];
  #record = new Recording({ goal: null, names: [] });
  // endif
  /** When the last picture was drawn, ms. */
  #before = performance.now();

  /** @param {About} about @param {Plan[][]} plans of the body, and of each step of its lesson, as it begins and as it runs */
  constructor(about, plans) {
    this.about = about;
    this.canvas = element("canvas", HTMLCanvasElement);
    /** What is shown: the file's body, or that of a step. */
    this.shown = about;
    this.plans = plans;
    this.present = plans[0];
    element("follow", HTMLButtonElement).hidden = plans[0][0].driven < 0;
    // ifdef HAS_DERIVED
    addDerived(about.lesson?.derived ?? {});
    // endif
    this.clock = this.#newClock();
    this.panel = new Panel(about, this);
    this.hands = new Hands(this.canvas, this);
    // ifdef HAS_LESSON
    if (about.lesson) {
      this.#teach(about.lesson);
      return;
    }
    // endif
    this.panel.setUp(about.settings, about.settings.map(({ key }) => key));
    this.play(!isStill());
  }

  get plan() {
    return this.present[Number(isDark())];
  }

  /** Where the world is in the canvas. */
  get place() {
    return screenOf(this.shown, this.canvas);
  }

  /** Whether the body stands only because less motion is wished. */
  get stands() {
    return isStill() && !this.playing && this.body.time === 0 && !this.course?.run.waits;
  }

  get body() {
    return this.clock.body;
  }

  get unit() {
    return this.about.unit;
  }

  /** The clock of the body where it begins. */
  #newClock() {
    const { body, method, dt } = this.shown;
    return new Clock(new Body(body), method, dt);
  }

  // ifdef HAS_LESSON
  /** @param {import("./course.js").Lesson} lesson */
  #teach(lesson) {
    this.course = new Course(lesson, {
      begin: (step, waits) => this.#begin(lesson.steps.indexOf(step), step, waits),
      run: () => this.play(true),
      places: () => Array.from({ length: this.body.masses }, (_, m) => [this.body.positions[2 * m], this.body.positions[2 * m + 1]]),
    });
    document.body.classList.add("taught");
    this.course.run.begin();
  }

  /** Begin a step of the lesson. @param {number} at @param {import("./course.js").Step} step @param {boolean} waits */
  #begin(at, step, waits) {
    const { about } = this;
    const begun = waits ? step.about : step.run ?? step.about;
    this.shown = { ...about, ...begun, body: { ...about.body, ...begun.body } };
    this.present = this.plans[1 + 2 * at + Number(!waits)];
    this.panel.setUp(this.shown.settings, step.controls);
    this.#charts = step.plots.map(makeChart);
    element("charts", HTMLElement).replaceChildren(...this.#charts.map(({ element }) => element));
    this.#record = new Recording({ goal: step.goal, names: step.plots.flatMap(({ names, over }) => (over ? [...names, over] : names)) });
    this.#reset();
    this.play(!waits && !isStill());
  }

  #look() {
    this.#record.take(this.body, !this.clock.exploded, partOfLimit(this.clock));
  }

  // endif
  #reset() {
    this.clock = this.#newClock();
    for (const [setting, value] of this.panel.values) this.#set(setting, value);
    // ifdef HAS_LESSON
    this.#record = new Recording(this.#record);
    this.#look();
    // endif
    this.hands.letGo();
  }

  /** @param {Setting} setting @param {number | string} value */
  #set(setting, value) {
    if (setting.key === "dt") this.clock.dt = Number(value);
    else write(this.body, setting, value);
  }

  // ----------------------------------------------------------------------- what controls do
  /** @param {boolean} on */
  play(on) {
    this.playing = on && !this.clock.exploded;
    this.#before = performance.now();
  }

  toggle() {
    this.play(!this.playing);
  }

  /** Do one time step. */
  step() {
    this.play(false);
    const { clock } = this;
    clock.meter.look();
    if (!clock.exploded) clock.advance(clock.step, 1, this.hands.all, this.panel.presses);
  }

  /** From the beginning, with the sliders as they are. */
  restart() {
    this.#reset();
    this.play(true);
  }

  /** To before the body ran away. */
  goBack() {
    this.clock.goBack();
    this.hands.letGo();
  }

  /** Have the ringed mass follow the pointer, or no longer. */
  follow() {
    this.hands.follows = !this.hands.follows;
  }

  /** @param {Setting} setting @param {number | string} value */
  change(setting, value) {
    this.#set(setting, value);
    this.clock.changed();
  }

  // ----------------------------------------------------------------------- pictures
  /** Go on to a picture, and ask for the next. @param {number} now ms */
  next(now) {
    const { clock, hands } = this;
    if (this.playing) {
      clock.go(((now - this.#before) / 1e3) * this.speed, hands.all, this.panel.presses);
      // ifdef HAS_LESSON
      this.#look();
      if (this.course?.look(this.body.time, this.#record)) this.playing = false;
      // endif
    } else if (!clock.exploded) hands.moveAtOnce();
    this.#before = now;
    if (clock.exploded) this.playing = false;
    this.#draw();
    requestAnimationFrame((later) => this.next(later));
  }

  #draw() {
    const { body, plan } = this;
    plan.restAngle = Float32Array.from(body.restAngle);
    if (plan.wind.length) {
      plan.wind = Float32Array.from([...body.wind, ...body.waves.flatMap((wave) => wave.slice(0, 5))]);
    }
    // A slider may have set another tempo.
    if (body.muscles) plan.muscles.set([body.muscles.frequency, body.muscles.phase]);
    // ifdef HAS_MOTORS
    // Or that motors turn the other way.
    body.motors.forEach(([, speed], k) => (plan.motors[3 * k + 1] = Math.sign(speed)));
    // endif
    const predicted = this.course?.run.present.places;
    /** @type {import("../../../stage/plan.js").Frame} */
    const frame = {
      generation: 0, time: body.time, lengthScale: body.scale, angleShift: body.shift,
      positions: Float32Array.from(body.positions), ghost: predicted ? Float32Array.from(predicted.flat()) : null,
    };
    // ifdef HAS_STEERING
    frame.efforts = Float32Array.from(body.steered);
    // endif
    // ifdef HAS_EFFORTS
    frame.efforts = Float32Array.from(body.efforts);
    // endif
    paint(this.shown, this.canvas, { plan, frame, damage: damageOf(body) });
    this.hands.mark();
    this.panel.show();
    // ifdef HAS_LESSON
    for (const chart of this.#charts) chart.draw(this.#record);
    // endif
  }
}

try {
  const about = /** @type {About} */ (JSON.parse(element("about", HTMLScriptElement).textContent ?? ""));
  const all = [about, ...(about.lesson?.steps ?? []).flatMap(({ about: begun, run }) => [{ ...about, ...begun }, { ...about, ...(run ?? begun) }])];
  const live = new Live(about, await Promise.all(all.map(({ plans }) => readPlans(plans))));
  requestAnimationFrame((now) => live.next(now));
  // For the browser tests.
  Object.assign(window, { __softrod: { now: () => live, place: () => live.place, plan: () => live.plan, sheet: () => live.course?.sheet() } });
} catch (error) {
  const said = document.querySelector("[role=alert]");
  if (said) said.textContent = say("live-too-old");
  throw error;
}
