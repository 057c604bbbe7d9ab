// @ts-check
/**
 * A lesson in the panel's first tab: one step at a time. A question comes first, and the body waits until it is
 * answered. Then it is tried: what to do and what to watch. What is right is told last, when the user asks for it.
 * How far the lesson is outlives a reload.
 */
import { onTold, send, told } from "../../wire/channel.js";
import { make, makeButton } from "../looks/dialog.js";
import { perform } from "../../wire/perform.js";
import { kept, store } from "../files/storage.js";

/**
 * @typedef {import("../../wire/wire.js").Question} Question
 * @typedef {import("../../wire/wire.js").LessonStep} Step
 * @typedef {object} Progress
 * @property {string} lesson
 * @property {number} at the step
 * @property {(number | null)[]} answers the choice at each step
 * @property {boolean[]} told whether it was told at each step what is right
 */

const NAME = "softrod-lesson";
/** Milliseconds between two looks whether viser has made the place of the lesson anew. */
const LOOK_EVERY = 100;

/** @type {Step[]} */
let steps = [];
/** @type {Progress} */
let progress = { lesson: "", at: 0, answers: [], told: [] };
/** @type {HTMLElement | null} */
let card = null;

/** What was kept of a lesson, or its beginning. @param {string} lesson @param {number} count of its steps */
function progressOf(lesson, count) {
  const fresh = { lesson, at: 0, answers: Array(count).fill(null), told: Array(count).fill(false) };
  try {
    const old = JSON.parse(kept(NAME) ?? "null");
    const fits = old?.lesson === lesson && old.at >= 0 && old.at < count;
    return fits && old.answers?.length === count && old.told?.length === count ? /** @type {Progress} */ (old) : fresh;
  } catch {
    return fresh;
  }
}

/** @param {import("../../wire/wire.js").Lesson} lesson */
function take(lesson) {
  steps = lesson.steps;
  progress = progressOf(JSON.stringify(steps), steps.length);
  keepProgress();
  begunIn = "";
  begin();
  show();
}

/** The opening of the lesson's scene, as the server counts them, in which a step was begun. */
let begunIn = "";

/** The step at which the lesson is to begin the next time, without any answers. @type {number | null} */
let first = null;
/** Has the lesson begin at a step the next time that its tab comes. @param {number} step */
export const beginNextAt = (step) => (first = step);

/** Begins a step: the scene anew, as the step wants it. @param {number} step */
function enter(step) {
  progress.at = step;
  tell();
  keepProgress();
  show();
  card?.querySelector("h2")?.focus();
}

/** Tells the server which step begins. The body need not wait for a question that is answered. */
function tell() {
  const answered = steps[progress.at].question !== null && progress.answers[progress.at] !== null;
  send({ do: "beginStep", step: progress.at, how: answered ? "run" : "wait" });
}

/**
 * Whenever the lesson's scene was opened: begins the present step if none has begun, or says which one the page is in
 * the middle of.
 */
function begin() {
  const { page, scene, lesson } = told();
  const opening = `${page}.${scene}`;
  // Its tab is not there while it is being made.
  if (page && lesson === undefined) begunIn = "";
  if (!page || lesson === undefined || steps.length === 0 || begunIn === opening) return;
  begunIn = opening;
  if (first !== null) {
    progress = { lesson: JSON.stringify(steps), at: first, answers: steps.map(() => null), told: steps.map(() => false) };
    first = null;
    keepProgress();
    show();
  }
  if (lesson) send({ do: "beginStep", step: progress.at, how: "on" });
  else tell();
}

const keepProgress = () => store(NAME, JSON.stringify(progress));

/** The first choice starts the body; until it is told what is right, another one can be made. @param {number} choice */
function answer(choice) {
  const first = progress.answers[progress.at] === null;
  progress.answers[progress.at] = choice;
  keepProgress();
  if (first) perform("run");
  show();
  focusOn(first ? ".softrod-lesson-do" : ".softrod-choice[aria-pressed=true]");
}

/** Tells what is right. */
function reveal() {
  progress.told[progress.at] = true;
  keepProgress();
  show();
  focusOn(".softrod-verdict");
}

/** The present step anew, as if nothing had been answered. */
function again() {
  progress.answers[progress.at] = null;
  progress.told[progress.at] = false;
  enter(progress.at);
}

/** Screen readers read on from there. @param {string} selector */
function focusOn(selector) {
  const found = card?.querySelector(selector);
  if (found instanceof HTMLElement) found.focus();
}

/** @param {string} label @param {string} text */
function paragraph(label, text) {
  const made = make("p", "", ` ${text}`);
  made.prepend(make("b", "", label));
  return made;
}

/** The question and its choices. @param {Question} question */
function asked({ text, choices, answer: right }) {
  const [chosen, known] = [progress.answers[progress.at], progress.told[progress.at]];
  const box = make("fieldset", "");
  box.append(make("legend", "", text));
  choices.forEach((choice, i) => {
    const made = makeButton(choice, () => answer(i), "softrod-button softrod-choice");
    made.ariaPressed = String(i === chosen);
    made.disabled = known;
    if (known && i === right) made.dataset.right = "";
    else if (known && i === chosen) made.dataset.wrong = "";
    box.append(made);
  });
  return box;
}

/** What is right, and why; or the button that tells it. @param {Question} question */
function answered({ choices, answer: right, because }) {
  const chosen = progress.answers[progress.at];
  if (!progress.told[progress.at]) return makeButton("What is right?", reveal, "softrod-button softrod-first softrod-lesson-reveal");
  const verdict = paragraph(chosen === right ? "That is right." : `The answer is: ${choices[right]}.`, because);
  verdict.className = "softrod-verdict";
  verdict.tabIndex = -1;
  return verdict;
}

/** Puts the present step into the card. */
function show() {
  const step = steps[progress.at];
  if (!card || !step) return;
  const { question } = step;
  const open = question === null || progress.answers[progress.at] !== null;
  const title = make("h2", "", step.title);
  title.tabIndex = -1;
  const head = make("div", "softrod-lesson-head");
  head.append(title, make("span", "softrod-lesson-count", `${progress.at + 1} / ${steps.length}`));
  const text = make("div", "");
  // The choice stays above what follows from it.
  if (question) text.append(asked(question));
  if (open) {
    const task = paragraph("Do:", step.do);
    task.className = "softrod-lesson-do";
    task.tabIndex = -1;
    text.append(task);
    if (step.watch) text.append(paragraph("Watch:", step.watch));
    if (question) text.append(answered(question));
  }
  const foot = make("div", "softrod-lesson-foot");
  const back = makeButton("Back", () => enter(progress.at - 1));
  back.disabled = progress.at === 0;
  const anew = makeButton("Again", again);
  anew.title = "begin this step anew";
  const next = makeButton(progress.at + 1 < steps.length ? "Next" : "Start over", () => {
    if (progress.at + 1 === steps.length) {
      progress.answers.fill(null);
      progress.told.fill(false);
    }
    enter((progress.at + 1) % steps.length);
  }, "softrod-button softrod-lesson-next");
  next.disabled = !open;
  // One thing to press next: first what is right.
  next.classList.toggle("softrod-first", question === null || progress.told[progress.at]);
  foot.append(back, anew, next);
  card.replaceChildren(head, text, foot);
}

/** Makes the card of lessons, and keeps it in its place in the panel, which viser makes anew now and then. */
export function addLesson() {
  card = make("section", "softrod-lesson");
  card.ariaLabel = "Lesson";
  onTold("lesson", take);
  onTold("pageState", begin);
  setInterval(() => {
    const place = document.getElementById("softrod-lesson");
    if (card && place && card.parentElement !== place) place.replaceChildren(card);
    document.documentElement.toggleAttribute("data-softrod-lesson", place !== null);
  }, LOOK_EVERY);
  show();
}
