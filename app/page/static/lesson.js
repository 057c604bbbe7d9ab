// @ts-check
/**
 * A lesson beside the body: one step at a time. A question comes first, and the body waits until it is
 * answered; then what to do and what to watch. How far the lesson is outlives a reload.
 */
import { onTold, send, told } from "./channel.js";
import { kept, store } from "./storage.js";

/**
 * @typedef {object} Question
 * @property {string} text
 * @property {string[]} choices
 * @property {number} answer index of the right one
 * @property {string} because
 * @typedef {object} Step
 * @property {string} title
 * @property {string} do
 * @property {string} watch
 * @property {Question | null} question
 * @typedef {object} Progress
 * @property {string} lesson
 * @property {number} at the step
 * @property {(number | null)[]} answers the choice at each step
 */

const SOURCE = '<div id="softrod-lesson"';
const NAME = "softrod-lesson";
/** Pixels of the canvas from which on the card stands beside the body, and not over it at the bottom. */
const WIDE = 720;
/** Parts of the canvas, and of what of it can be seen, that the card takes at the bottom, at most. */
const [PART, FREE_PART] = [0.36, 0.6];
/** Pixels of the card and its margins beside the body. */
const COLUMN = 332;

/** @type {Step[]} */
let steps = [];
/** @type {Progress} */
let progress = { lesson: "", at: 0, answers: [] };
/** @type {HTMLElement | null} */
let card = null;
let folded = false;

/** What was kept of a lesson, or its beginning. @param {string} lesson @param {number} count of its steps */
function progressOf(lesson, count) {
  const fresh = { lesson, at: 0, answers: Array(count).fill(null) };
  try {
    const old = JSON.parse(kept(NAME) ?? "null");
    const fits = old?.lesson === lesson && old.at >= 0 && old.at < count && old.answers?.length === count;
    return fits ? /** @type {Progress} */ (old) : fresh;
  } catch {
    return fresh;
  }
}

/** Takes what a message has for the lesson, if it is for it. @param {unknown} content */
export function hearLesson(content) {
  if (typeof content !== "string" || !content.startsWith(SOURCE)) return;
  const template = document.createElement("template");
  template.innerHTML = content;
  const element = template.content.firstElementChild;
  const lesson = (element instanceof HTMLElement && element.dataset.steps) || "[]";
  if (lesson === progress.lesson) return;
  steps = JSON.parse(lesson);
  progress = progressOf(lesson, steps.length);
  keepProgress();
  begunIn = "";
  begin();
  show();
}

/** The opening of the lesson's scene, as the server counts them, in which a step was begun. */
let begunIn = "";

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
  send("lesson", `${progress.at}${answered ? "|run" : ""}`);
}

/** Begins the present step, whenever the lesson's scene was opened and no step of it has begun. */
function begin() {
  const opening = `${told().channel}.${told().scene?.split(".")[0]}`;
  if (!told().channel || told().lesson !== "0" || steps.length === 0 || begunIn === opening) return;
  begunIn = opening;
  tell();
}

const keepProgress = () => store(NAME, JSON.stringify(progress));

/** @param {number} choice */
function answer(choice) {
  progress.answers[progress.at] = choice;
  keepProgress();
  send("do", "run");
  show();
  const verdict = /** @type {HTMLElement | null | undefined} */ (card?.querySelector(".softrod-verdict"));
  verdict?.focus();
}

/**
 * @template {keyof HTMLElementTagNameMap} K
 * @param {K} kind
 * @param {string} text shown as it is, never read as HTML
 * @param {string} [name] of its class
 */
function element(kind, text, name) {
  const made = document.createElement(kind);
  made.textContent = text;
  if (name) made.className = name;
  return made;
}

/** @param {string} text @param {() => void} press @param {string} [name] */
function button(text, press, name) {
  const made = element("button", text, name);
  made.type = "button";
  made.addEventListener("click", press);
  return made;
}

/** @param {string} label @param {string} text */
function paragraph(label, text) {
  const made = element("p", ` ${text}`);
  made.prepend(element("b", label));
  return made;
}

/** The question, its choices, and what is said once one is chosen. @param {Question} question */
function asked({ text, choices, answer: right, because }) {
  const chosen = progress.answers[progress.at];
  const box = element("fieldset", "");
  box.append(element("legend", text));
  choices.forEach((choice, i) => {
    const made = button(choice, () => answer(i), "softrod-choice");
    if (chosen !== null) {
      made.disabled = true;
      if (i === right) made.dataset.right = "";
      else if (i === chosen) made.dataset.wrong = "";
      if (i === chosen) made.ariaPressed = "true";
    }
    box.append(made);
  });
  if (chosen === null) return [box];
  const verdict = paragraph(chosen === right ? "That is right." : `The answer is: ${choices[right]}.`, because);
  verdict.className = "softrod-verdict";
  verdict.tabIndex = -1;
  return [box, verdict];
}

/** Puts the present step into the card. */
function show() {
  const step = steps[progress.at];
  if (!card || !step) return;
  const open = step.question === null || progress.answers[progress.at] !== null;
  const head = element("div", "", "softrod-lesson-head");
  const title = element("h2", step.title);
  title.tabIndex = -1;
  const fold = button(folded ? "Show" : "Hide", () => {
    folded = !folded;
    show();
    /** @type {HTMLElement | null | undefined} */ (card?.querySelector(".softrod-lesson-head button"))?.focus();
  });
  fold.ariaExpanded = String(!folded);
  head.append(element("span", `${progress.at + 1} / ${steps.length}`, "softrod-lesson-count"), fold);
  const text = element("div", "", "softrod-lesson-text");
  // The choice stays above what follows from it.
  if (step.question) text.append(...asked(step.question));
  if (open) {
    text.append(paragraph("Do:", step.do));
    if (step.watch) text.append(paragraph("Watch:", step.watch));
  }
  const foot = element("div", "", "softrod-lesson-foot");
  const back = button("Back", () => enter(progress.at - 1));
  back.disabled = progress.at === 0;
  const again = button("Again", () => enter(progress.at));
  again.title = "begin this step anew";
  const next = button(progress.at + 1 < steps.length ? "Next" : "From the beginning", () => {
    if (progress.at + 1 === steps.length) progress.answers.fill(null);
    enter((progress.at + 1) % steps.length);
  });
  next.className = "softrod-lesson-next";
  next.disabled = !open;
  foot.append(back, again, next);
  card.dataset.folded = folded ? "1" : "";
  card.replaceChildren(head, title, ...(folded ? [] : [text, foot]));
}

/** Pixels of the canvas that the card takes. */
let room = { left: 0, bottom: 0 };
export const lessonRoom = () => room;

/**
 * Keeps the card beside the body, or at the bottom where there is no room.
 *
 * @param {DOMRect} box of the canvas
 * @param {number} hidden px at its bottom that are covered
 * @returns {{left: number, bottom: number}} px of the canvas that the card takes
 */
export function placeLesson(box, hidden) {
  if (!card || card.hidden) return (room = { left: 0, bottom: 0 });
  const wide = box.width >= WIDE;
  const hud = document.querySelector(".softrod-hud")?.getBoundingClientRect();
  card.dataset.wide = wide ? "1" : "";
  card.style.left = `${box.left + 12}px`;
  card.style.width = `${wide ? COLUMN - 24 : box.width - 24}px`;
  card.style.bottom = `${window.innerHeight - box.bottom + hidden + 4}px`;
  const top = Math.max(box.top + 8, wide ? (hud?.bottom ?? 0) + 8 : 0);
  const most = wide ? box.bottom - hidden - top - 4 : Math.min(PART * box.height, FREE_PART * (box.height - hidden));
  card.style.maxHeight = `${most}px`;
  room = wide ? { left: folded ? 0 : COLUMN, bottom: 0 } : { left: 0, bottom: card.offsetHeight + 8 };
  return room;
}

/** Puts up the card of lessons, which shows in scenes that have one. */
export function addLesson() {
  card = element("section", "", "softrod-lesson");
  card.ariaLabel = "Lesson";
  card.hidden = true;
  document.body.append(card);
  onTold(() => {
    if (card) card.hidden = !told().lesson || steps.length === 0;
    begin();
  });
  show();
}
