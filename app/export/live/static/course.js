// @ts-check
/**
 * A lesson in a live file: its card is the page's. What was answered stays in this browser, and can be handed in as a file
 * or as a QR code.
 *
 * @typedef {import("./answers.js").Point} Point
 * @typedef {import("./answers.js").Sheet} Sheet
 * @typedef {import("./chart.js").Plot} Plot
 * @typedef {import("./live.js").About} About
 * @typedef {import("./quantities.js").Goal} Goal
 * @typedef {import("./quantities.js").Recording} Recording
 * @typedef {import("../../../features/lesson/card.js").Step & LiveStep} Step
 * @typedef {object} LiveStep
 * @property {string[]} controls keys of the settings whose sliders stand below the text
 * @property {Plot[]} plots
 * @property {number} predict s after which the body is asked to be where it was predicted; 0 for no such prediction
 * @property {Goal | null} goal
 * @property {string} goalText the goal in words
 * @property {Partial<Omit<About, "body">> & {body: Partial<import("./body.js").BodyData>}} about what is otherwise than in the file
 * @typedef {{code: string, frame: import("./answers.js").Frame, steps: Step[]}} Lesson
 * @typedef {object} Answered
 * @property {number | null} choice
 * @property {boolean} known whether it was told what is right
 * @property {Point[] | null} places
 * @property {string} line
 * @property {boolean} reached
 * @typedef {object} Does what a lesson does to the body
 * @property {(step: Step, waits: boolean) => void} begin it as a step wants it
 * @property {() => void} run
 * @property {() => Point[]} places where the masses are
 */
import { make, makeButton } from "../../../ui/dialog.js";
import { lessonCard } from "../../../features/lesson/card.js";
import { element } from "../../static/parts.js";
import { packed } from "./answers.js";
import { qrCode } from "./qr.js";
import { said } from "./readings.js";

/** Letters of a line and of a name, as a class takes them. */
const [MAX_LETTERS, MAX_NAME] = [140, 20];
/** Modules of light paper around a QR code. */
const QUIET = 4;
/** Milliseconds between two updates of how far a goal is. */
const EVERY = 200;

/** What was kept, or null; a browser may forbid it. @param {string} name */
function kept(name) {
  try {
    return JSON.parse(localStorage.getItem(name) ?? "null");
  } catch {
    return null;
  }
}

/** @param {string} name @param {unknown} value */
function keep(name, value) {
  try {
    localStorage.setItem(name, JSON.stringify(value));
  } catch {
    // It is forbidden, or full: the answers last as long as the file is open.
  }
}

/** @returns {Answered} */
const nothing = () => ({ choice: null, known: false, places: null, line: "", reached: false });

/** @param {Lesson} lesson @param {Does} does */
export function addCourse({ code, frame, steps }, does) {
  const place = `softrod-answers-${code}`;
  const fresh = {
    at: 0, id: [...crypto.getRandomValues(new Uint8Array(5))].map((byte) => byte.toString(16).padStart(2, "0")).join(""),
    turn: 0, name: "", steps: steps.map(nothing),
  };
  const old = kept(place);
  const state = /** @type {typeof fresh} */ (old?.steps?.length === steps.length && steps[old.at] ? old : fresh);
  const card = element("lesson", HTMLElement);
  const store = () => keep(place, state);
  /** @type {Recording | null} */
  let record = null;
  let due = 0;
  /** Whether the run has stood at the moment that was predicted. */
  let stood = false;
  const goal = make("p", "softrod-goal");
  goal.setAttribute("role", "status");

  const present = () => ({ step: steps[state.at], given: state.steps[state.at] });
  /** Whether the body is to wait: for a prediction, or an answer. */
  const waits = () => {
    const { step, given } = present();
    return (step.predict > 0 && !given.places) || (step.question !== null && given.choice === null);
  };
  const begin = () => {
    stood = false;
    does.begin(present().step, waits());
  };
  /** @param {string} selector */
  const focus = (selector) => {
    const found = card.querySelector(selector);
    if (found instanceof HTMLElement) found.focus();
  };
  const changed = () => {
    state.turn++;
    store();
    show();
  };

  const acts = {
    /** @param {number} choice */
    answer(choice) {
      const waited = waits();
      present().given.choice = choice;
      changed();
      if (waited && !waits()) does.run();
      focus(waited && !waits() ? ".softrod-lesson-do" : ".softrod-choice[aria-pressed=true]");
    },
    reveal() {
      present().given.known = true;
      changed();
      focus(".softrod-verdict");
    },
    again() {
      const { line, reached } = present().given;
      state.steps[state.at] = { ...nothing(), line, reached };
      changed();
      begin();
    },
    /** @param {number} step */
    enter(step) {
      state.at = step;
      store();
      show();
      begin();
      focus("h2");
    },
    startOver() {
      state.steps = steps.map(nothing);
      state.turn++;
      acts.enter(0);
    },
  };

  function prediction() {
    const { step, given } = present();
    if (!(step.predict > 0)) return [];
    const text = given.places
      ? `The thin line is your prediction for ${step.predict} s.`
      : `Drag the masses to where they will be after ${step.predict} s. Then press the button.`;
    const button = makeButton("It will be there", () => {
      given.places = does.places();
      changed();
      begin();
      if (!waits()) focus(".softrod-lesson-do");
    }, "softrod-button softrod-first");
    return [make("p", "", text), ...(given.places ? [] : [button])];
  }

  function line() {
    const { given } = present();
    const label = make("label", "softrod-line", "In your own words: ");
    const input = make("input", "");
    Object.assign(input, { maxLength: MAX_LETTERS, value: given.line, autocomplete: "off" });
    input.addEventListener("input", () => {
      given.line = input.value.trim();
      state.turn++;
      store();
    });
    label.append(input);
    return label;
  }

  function show() {
    const { step, given } = present();
    const done = [...(step.goal ? [goal] : []), ...(step.question || step.predict ? [line()] : [])];
    const shown = {
      step, at: state.at, count: steps.length, chosen: given.choice, known: given.known,
      waits: step.predict > 0 && !given.places, more: { asked: prediction(), done },
    };
    card.replaceChildren(...lessonCard(shown, acts));
    tellGoal();
  }

  function tellGoal() {
    const { step, given } = present();
    if (!step.goal) return;
    const now = record && Number.isFinite(record.reading) ? ` Now: ${said(record.reading)}.` : "";
    const text = `${given.reached ? "Reached" : "Goal"}: ${step.goalText}.${given.reached ? "" : now}`;
    if (goal.textContent !== text) goal.textContent = text;
  }

  /** @returns {Sheet} */
  const sheet = () => ({
    format: "softrod-answers", version: 1, lesson: code, id: state.id, turn: state.turn, name: state.name,
    steps: state.steps.map(({ choice, line: text, places, reached }) => ({ choice, line: text, places, reached })),
  });
  addHandIn(sheet, frame, state.name, (name) => {
    state.name = name;
    state.turn++;
    store();
  });
  show();
  return {
    begin,
    /** What is predicted for the present step. */
    predicted: () => present().given.places,
    /** A picture is shown at a time: whether the run is to stand, since it is the moment that was predicted. @param {number} time @param {Recording} seen */
    look(time, seen) {
      record = seen;
      const { step, given } = present();
      if (seen.reached && !given.reached) {
        given.reached = true;
        changed();
      }
      const at = performance.now();
      if (at >= due) {
        due = at + EVERY;
        tellGoal();
      }
      if (stood || !(step.predict > 0) || !given.places || time < step.predict) return false;
      stood = true;
      return true;
    },
    sheet,
  };
}

/**
 * What hands the answers in.
 *
 * @param {() => Sheet} sheet @param {import("./answers.js").Frame} frame @param {string} called @param {(name: string) => void} rename
 */
function addHandIn(sheet, frame, called, rename) {
  const box = element("answers", HTMLDetailsElement);
  box.hidden = false;
  const label = make("label", "softrod-line", "Your name or nickname, if your teacher wants one: ");
  const input = make("input", "");
  Object.assign(input, { maxLength: MAX_NAME, value: called, autocomplete: "off" });
  label.append(input);
  const canvas = make("canvas", "qr");
  canvas.setAttribute("role", "img");
  canvas.ariaLabel = "QR code of the answers";
  const text = make("code", "");
  const note = make("p", "");
  const draw = () => {
    const { text: letters, left } = packed(sheet(), frame);
    text.textContent = letters;
    note.textContent = `The QR code is the text below it, ${letters.length} letters.${left.length ? ` It has no room for ${left.join(" and ")}; the file has all.` : ""}`;
    paintQr(canvas, qrCode(letters));
  };
  const save = makeButton("Save answers as a file", () => {
    const url = URL.createObjectURL(new Blob([JSON.stringify(sheet())], { type: "application/json" }));
    const link = make("a", "");
    const name = (sheet().name || sheet().id).replace(/[^\p{L}\p{N}]+/gu, "-");
    Object.assign(link, { href: url, download: `answers-${name}.json` }).click();
    setTimeout(() => URL.revokeObjectURL(url), 1e4);
  }, "softrod-button softrod-first");
  input.addEventListener("input", () => {
    rename(input.value.trim());
    draw();
  });
  box.addEventListener("toggle", () => box.open && draw());
  box.append(make("p", "", "Nothing leaves this file by itself. Give your teacher the file, or show the QR code."), label, save, canvas, note, text);
  // What is answered while it is open.
  document.addEventListener("click", () => box.open && draw());
}

/** @param {HTMLCanvasElement} canvas @param {boolean[][]} modules */
function paintQr(canvas, modules) {
  const to = canvas.getContext("2d");
  if (!to) return;
  canvas.width = canvas.height = modules.length + 2 * QUIET;
  to.fillStyle = "#fff";
  to.fillRect(0, 0, canvas.width, canvas.height);
  to.fillStyle = "#000";
  modules.forEach((line, row) => line.forEach((dark, column) => dark && to.fillRect(column + QUIET, row + QUIET, 1, 1)));
}
