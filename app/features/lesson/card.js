// @ts-check
/**
 * The card of a lesson: one step, its question and what to do. It is drawn alike in the panel and in a file that lives
 * without a server.
 */
import { make, makeButton } from "../../ui/dialog.js";

/**
 * @typedef {import("../../wire/wire.js").Question} Question
 * @typedef {import("../../wire/wire.js").LessonStep} Step
 * @typedef {object} Shown
 * @property {Step} step
 * @property {number} at which step that is, counted from 0
 * @property {number} count of steps
 * @property {number | null} chosen the choice that was made
 * @property {boolean} known whether it was told what is right
 * @property {boolean} [waits] whether something beside the question is to be answered first
 * @property {{asked?: HTMLElement[], done?: HTMLElement[]}} [more] what stands below the question, and below what to do
 * @typedef {object} Does
 * @property {(choice: number) => void} answer
 * @property {() => void} reveal
 * @property {() => void} again the present step anew
 * @property {(step: number) => void} enter another step
 * @property {() => void} startOver with the first step, without any answer
 */

/** @param {string} label @param {string} text */
function paragraph(label, text) {
  const made = make("p", "", ` ${text}`);
  made.prepend(make("b", "", label));
  return made;
}

/** The question and its choices. @param {Question} question @param {Shown} shown @param {Does} does */
function asked({ text, choices, answer: right }, { chosen, known }, does) {
  const box = make("fieldset", "");
  box.append(make("legend", "", text));
  choices.forEach((choice, i) => {
    const made = makeButton(choice, () => does.answer(i), "softrod-button softrod-choice");
    made.ariaPressed = String(i === chosen);
    made.disabled = known;
    if (known && i === right) made.dataset.right = "";
    else if (known && i === chosen) made.dataset.wrong = "";
    box.append(made);
  });
  return box;
}

/** What is right, and why; or the button that tells it. @param {Question} question @param {Shown} shown @param {Does} does */
function answered({ choices, answer: right, because }, { chosen, known }, does) {
  if (!known) return makeButton("What is right?", does.reveal, "softrod-button softrod-first softrod-lesson-reveal");
  const verdict = paragraph(chosen === right ? "That is right." : `The answer is: ${choices[right]}.`, because);
  verdict.className = "softrod-verdict";
  verdict.tabIndex = -1;
  return verdict;
}

/** What the card has of a step. @param {Shown} shown @param {Does} does @returns {HTMLElement[]} */
export function lessonCard(shown, does) {
  const { step, at, count, chosen, known, waits = false, more = {} } = shown;
  const { question } = step;
  const open = !waits && (question === null || chosen !== null);
  const title = make("h2", "", step.title);
  title.tabIndex = -1;
  const head = make("div", "softrod-lesson-head");
  head.append(title, make("span", "softrod-lesson-count", `${at + 1} / ${count}`));
  const text = make("div", "");
  // The choice stays above what follows from it.
  if (question) text.append(asked(question, shown, does));
  text.append(...(more.asked ?? []));
  if (open) {
    const task = paragraph("Do:", step.do);
    task.className = "softrod-lesson-do";
    task.tabIndex = -1;
    text.append(task);
    if (step.watch) text.append(paragraph("Watch:", step.watch));
    text.append(...(more.done ?? []));
    if (question) text.append(answered(question, shown, does));
  }
  const foot = make("div", "softrod-lesson-foot");
  const back = makeButton("Back", () => does.enter(at - 1));
  back.disabled = at === 0;
  const anew = makeButton("Again", does.again);
  anew.title = "begin this step anew";
  const last = at + 1 === count;
  const next = makeButton(last ? "Start over" : "Next", () => (last ? does.startOver() : does.enter(at + 1)), "softrod-button softrod-lesson-next");
  next.disabled = !open;
  // One thing to press next: first what is right.
  next.classList.toggle("softrod-first", question === null || known);
  foot.append(back, anew, next);
  return [head, text, foot];
}
