// @ts-check
/** The card of a lesson: one step, its question and what to do. */
import { make, makeButton } from "../../ui/dialog.js";

/**
 * @typedef {import("../../wire/wire.js").Question} Question
 * @typedef {import("./run.js").LessonRun<import("./run.js").Step, import("./run.js").Given>} Run
 */

/** @param {string} label @param {string} text */
function paragraph(label, text) {
  const made = make("p", "", ` ${text}`);
  made.prepend(make("b", "", label));
  return made;
}

/** The question and its choices. @param {Question} question @param {Run} run */
function asked({ text, choices, answer: right }, run) {
  const { choice: chosen, known } = run.present;
  const box = make("fieldset", "");
  box.append(make("legend", "", text));
  choices.forEach((choice, i) => {
    const made = makeButton(choice, () => run.answer(i), "softrod-button softrod-choice");
    made.ariaPressed = String(i === chosen);
    made.disabled = known;
    if (known && i === right) made.dataset.right = "";
    else if (known && i === chosen) made.dataset.wrong = "";
    box.append(made);
  });
  return box;
}

/** The right answer and why it is right, or the button that reveals it. @param {Question} question @param {Run} run */
function answered({ choices, answer: right, because }, run) {
  const { choice, known } = run.present;
  if (!known) return makeButton("What is right?", () => run.reveal(), "softrod-button softrod-first softrod-lesson-reveal");
  const verdict = paragraph(choice === right ? "That is right." : `The answer is: ${choices[right]}.`, because);
  verdict.className = "softrod-verdict";
  verdict.tabIndex = -1;
  return verdict;
}

/**
 * The parts of the card for the present step.
 *
 * @param {Run} run @param {{asked?: HTMLElement[], done?: HTMLElement[]}} more what else stands below the question, and below
 *   what is to be done
 * @returns {HTMLElement[]}
 */
export function lessonCard(run, more) {
  const { step, at, steps, waits } = run;
  const { question } = step;
  const title = make("h2", "", step.title);
  title.tabIndex = -1;
  const head = make("div", "softrod-lesson-head");
  head.append(title, make("span", "softrod-lesson-count", `${at + 1} / ${steps.length}`));
  const text = make("div", "");
  // The choice stays above what follows from it.
  if (question) text.append(asked(question, run));
  text.append(...(more.asked ?? []));
  if (!waits) {
    const task = paragraph("Do:", step.do);
    task.className = "softrod-lesson-do";
    task.tabIndex = -1;
    text.append(task);
    if (step.watch) text.append(paragraph("Watch:", step.watch));
    text.append(...(more.done ?? []));
    if (question) text.append(answered(question, run));
  }
  const foot = make("div", "softrod-lesson-foot");
  const back = makeButton("Back", () => run.enter(at - 1));
  back.disabled = at === 0;
  const again = makeButton("Again", () => run.again());
  again.title = "begin this step again";
  const isLast = at + 1 === steps.length;
  const next = makeButton(isLast ? "Start over" : "Next", () => (isLast ? run.startOver() : run.enter(at + 1)), "softrod-button softrod-lesson-next");
  next.disabled = waits;
  // One thing to press next: first what is right.
  next.classList.toggle("softrod-first", question === null || run.present.known);
  foot.append(back, again, next);
  return [head, text, foot];
}
