// @ts-check
/**
 * A lesson in a live file. What was answered stays in this browser.
 *
 * @typedef {import("./answers.js").Point} Point
 * @typedef {import("./answers.js").Sheet} Sheet
 * @typedef {import("./chart.js").Plot} Plot
 * @typedef {import("./live.js").About} About
 * @typedef {import("./quantities.js").Goal} Goal
 * @typedef {import("./quantities.js").Recording} Recording
 * @typedef {Partial<Omit<About, "body">> & {body: Partial<import("./body.js").BodyData>}} Differing from what the file has
 * @typedef {Omit<import("../../../wire/wire.js").LessonStep, "run"> & LiveStep} Step
 * @typedef {object} LiveStep
 * @property {string[]} controls keys of the settings whose sliders stand below the text
 * @property {Plot[]} plots
 * @property {number} predict s after which the body is to be where it was predicted; 0 for no such prediction
 * @property {Goal | null} goal
 * @property {string} goalText the goal in words
 * @property {Differing} about with what it begins
 * @property {Differing | null} run with what the case begins that it asks about; null if that is the same
 * @typedef {{code: string, frame: import("./answers.js").Frame, steps: Step[], derived?: Record<string,
 *   {node: import("./derived.js").Node, unwrapped: boolean}>}} Lesson what its steps measure that is computed, by its name
 * @typedef {object} Given
 * @property {number | null} choice
 * @property {boolean} known whether the right answer was revealed
 * @property {Point[] | null} places the prediction
 * @property {string} line
 * @property {boolean} reached whether the goal was
 * @typedef {object} Stored what the browser stores
 * @property {number} at the present step
 * @property {string} id
 * @property {number} turn counts the changes of answers
 * @property {string} name
 * @property {Given[]} steps
 * @typedef {object} Body what a lesson does to the body
 * @property {(step: Step, waits: boolean) => void} begin sets it up as a step wants it, or runs the case that it asks about
 * @property {() => void} run
 * @property {() => Point[]} places where the masses are
 */
import { make, makeButton } from "../../../ui/dialog.js";
import { LessonRun } from "../../../features/lesson/run.js";
import { say } from "../../../words/words.js";
import { element } from "../../static/parts.js";
import { addHandIn, lineField } from "./hand_in.js";
import { said } from "./readings.js";

/** Letters of a line, as a class takes them. */
const MAX_LETTERS = 140;
/** Milliseconds between two updates of how far a goal is. */
const UPDATE_EVERY = 200;

/** @returns {Given} */
const blank = () => ({ choice: null, known: false, places: null, line: "", reached: false });

/** What was stored, or the beginning. A browser may forbid to store anything. @param {string} name @param {number} count of steps @returns {Stored} */
function stored(name, count) {
  const id = [...crypto.getRandomValues(new Uint8Array(5))].map((byte) => byte.toString(16).padStart(2, "0")).join("");
  const fresh = { at: 0, id, turn: 0, name: "", steps: Array.from({ length: count }, blank) };
  try {
    const old = JSON.parse(localStorage.getItem(name) ?? "null");
    return old?.steps?.length === count && old.steps[old.at] ? old : fresh;
  } catch {
    return fresh;
  }
}

export class Course {
  /** @type {Recording | null} */
  #record = null;
  /** When the goal is updated next, ms. */
  #due = 0;
  /** Whether the run was stopped at the moment that was predicted. */
  #stood = false;
  #goal = make("p", "softrod-goal");

  /** @param {Lesson} lesson @param {Body} body */
  constructor({ code, frame, steps }, body) {
    this.code = code;
    this.body = body;
    this.name = `softrod-answers-${code}`;
    this.state = stored(this.name, steps.length);
    /** @type {LessonRun<Step, Given>} */
    this.run = new LessonRun(element("lesson", HTMLElement), steps, this.state.at, this.state.steps, {
      blank,
      begin: (waits) => this.#begin(waits),
      run: () => {
        if (this.run.step.run) this.run.begin();
        body.run();
      },
      store: (isAnswer) => this.#store(isAnswer),
      more: () => this.#more(),
    });
    addHandIn(() => this.sheet(), frame, (name) => {
      this.state.name = name;
      this.#store(true);
    });
    this.run.show();
  }

  /** @param {boolean} waits */
  #begin(waits) {
    this.#stood = false;
    this.body.begin(this.run.step, waits);
  }

  /** @param {boolean} isAnswer */
  #store(isAnswer) {
    const { at, given } = this.run;
    Object.assign(this.state, { at, steps: given, turn: this.state.turn + Number(isAnswer) });
    try {
      localStorage.setItem(this.name, JSON.stringify(this.state));
    } catch {
      // It is forbidden, or full: the answers last as long as the file is open.
    }
  }

  /** What the card has besides the question and what to do. */
  #more() {
    const { step, present } = this.run;
    this.#showGoal();
    const line = lineField(say("live-own-words"), present.line, MAX_LETTERS, (text) => {
      present.line = text;
      this.#store(true);
    });
    return { asked: this.#prediction(), done: [...(step.goal ? [this.#goal] : []), ...(step.question || step.predict ? [line] : [])] };
  }

  #prediction() {
    const { run } = this;
    const { predict } = run.step;
    if (!predict) return [];
    if (!run.isToPredict) return [make("p", "", say("live-predict.seen", { time: predict }))];
    const button = makeButton(say("live-predict.done"), () => {
      run.present.places = this.body.places();
      run.changed();
      run.begin();
      if (run.waits) return;
      this.body.run();
      run.focus(".softrod-lesson-do");
    }, "softrod-button softrod-first");
    return [make("p", "", say("live-predict", { time: predict })), button];
  }

  #showGoal() {
    const { step, present } = this.run;
    if (!step.goal) return;
    const reading = this.#record?.reading ?? NaN;
    const goal = step.goalText;
    let text = say("live-goal", { goal });
    if (present.reached) text = say("live-goal.reached", { goal });
    else if (Number.isFinite(reading)) text = say("live-goal.now", { goal, reading: said(reading) });
    if (this.#goal.textContent !== text) this.#goal.textContent = text;
  }

  /**
   * A picture is shown.
   *
   * @param {number} time of the body, s @param {Recording} record of its run
   * @returns {boolean} whether the run is to stop, since this is the moment that was predicted
   */
  look(time, record) {
    this.#record = record;
    const { step, present } = this.run;
    if (record.reached && !present.reached) {
      present.reached = true;
      this.run.changed();
      element("says", HTMLElement).textContent = say("live-goal.reached", { goal: step.goalText });
    }
    const now = performance.now();
    if (now >= this.#due) {
      this.#due = now + UPDATE_EVERY;
      this.#showGoal();
    }
    if (this.#stood || !step.predict || !present.places || time < step.predict) return false;
    this.#stood = true;
    return true;
  }

  /** @returns {Sheet} */
  sheet() {
    const { id, turn, name } = this.state;
    const steps = this.run.given.map(({ choice, line, places, reached }) => ({ choice, line, places, reached }));
    return { format: "softrod-answers", version: 1, lesson: this.code, id, turn, name, steps };
  }
}
