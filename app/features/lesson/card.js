// @ts-check
/** The card of a lesson: one step, its question and what to do. */
import { make, makeButton } from "../../ui/dialog.js";
import { say } from "../../words/words.js";

/**
 * @typedef {import("../../wire/wire.js").Question} Question
 * @typedef {import("./run.js").LessonRun<import("./run.js").Step, import("./run.js").Given>} Run
 */

/** @param {string} label @param {string} text */
function paragraph(label, text) {
  const made = make("p", "");
  made.append(make("b", "", `${label} `), make("bdi", "", text));
  return made;
}

/** The question and its choices. @param {Question} question @param {Run} run */
function asked({ text, choices, answer: right }, run) {
  const { choice: chosen, known } = run.present;
  const box = make("fieldset", "");
  box.append(make("legend", "", text));
  choices.forEach((choice, i) => {
    const made = makeButton(choice, () => run.answer(i), "softrod-button softrod-choice");
    made.dir = "auto";
    made.ariaPressed = String(i === chosen);
    made.disabled = known;
    if (known && i === right) made.dataset.right = "";
    else if (known && i === chosen) made.dataset.wrong = "";
    box.append(made);
  });
  return box;
}

/** The right answer and why it is right. @param {Question} question @param {Run} run */
function answered({ choices, answer: right, because }, run) {
  const { choice } = run.present;
  const verdict = paragraph(choice === right ? say("lesson-right") : say("lesson-answer", { choice: choices[right] }), because);
  verdict.className = "softrod-verdict";
  verdict.tabIndex = -1;
  return verdict;
}

/** How far the lesson is, as dashes and in words. @param {Run} run */
function progress({ at, steps }) {
  const count = make("span", "softrod-lesson-count");
  const dashes = make("span", "softrod-lesson-dashes");
  dashes.ariaHidden = "true";
  dashes.append(...steps.map((_, i) => make("i", i <= at ? "softrod-done" : "")));
  count.append(dashes, make("span", "", say("lesson-count", { at: String(at + 1), count: String(steps.length) })));
  return count;
}

/** The one thing to press next: first what is right, then the next step. @param {Run} run */
function primary(run) {
  const { at, steps, step, present, waits } = run;
  const button = "softrod-button softrod-first softrod-lesson-next";
  if (step.question && !present.known) {
    const check = makeButton(say("lesson-check"), () => run.reveal(), `${button} softrod-lesson-reveal`);
    check.disabled = waits;
    return check;
  }
  const isLast = at + 1 === steps.length;
  const next = makeButton(say(isLast ? "lesson-next.first" : "lesson-next"), () => (isLast ? run.startOver() : run.enter(at + 1)), button);
  next.disabled = waits;
  return next;
}

/**
 * The parts of the card for the present step, and its foot.
 *
 * @param {Run} run @param {{asked?: HTMLElement[], done?: HTMLElement[]}} more what else stands below the question, and below
 *   what is to be done
 * @returns {{parts: HTMLElement[], foot: HTMLElement}}
 */
export function lessonCard(run, more) {
  const { step, at, waits } = run;
  const { question } = step;
  const title = make("h2", "", step.title);
  title.tabIndex = -1;
  const head = make("div", "softrod-lesson-head");
  head.append(title, progress(run));
  const text = make("div", "");
  // The choice stays above what follows from it.
  if (question) text.append(asked(question, run));
  text.append(...(more.asked ?? []));
  if (!waits) {
    const told = question !== null && run.present.known;
    // What was to be done makes room for what is right.
    if (!told) {
      const task = paragraph(say("lesson-do"), step.do);
      task.className = "softrod-lesson-do";
      task.tabIndex = -1;
      text.append(task);
      if (step.watch) text.append(paragraph(say("lesson-watch"), step.watch));
    }
    text.append(...(more.done ?? []));
    if (told) text.append(answered(question, run));
  }
  const foot = make("div", "softrod-lesson-foot");
  const back = makeButton(say("lesson-back"), () => run.enter(at - 1));
  back.disabled = at === 0;
  const again = makeButton(say("lesson-again"), () => run.again());
  again.title = say("lesson-again.hint");
  foot.append(back, again, primary(run));
  return { parts: [head, text], foot };
}
