// @ts-check
/**
 * A lesson in the panel's first tab: one step at a time. A question comes first, and the body waits until it is
 * answered. Then it is tried: what to do and what to watch. What is right is told last, when the user asks for it.
 * How far the lesson is outlives a reload.
 */
import { onMessage, pageState, send } from "../../wire/channel.js";
import { make } from "../../ui/dialog.js";
import { perform } from "../../wire/perform.js";
import { kept, store } from "../../ui/kept/storage.js";
import { lessonCard } from "./card.js";

/**
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
  beginPresent();
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
function beginPresent() {
  const { page, scene, lesson } = pageState();
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

/** Puts the present step into the card. */
function show() {
  const { at, answers, told: known } = progress;
  const step = steps[at];
  if (!card || !step) return;
  const shown = { step, at, count: steps.length, chosen: answers[at], known: known[at] };
  card.replaceChildren(...lessonCard(shown, { answer, reveal, again, enter, startOver }));
}

/** The lesson from its first step on, without any answers. */
function startOver() {
  progress.answers.fill(null);
  progress.told.fill(false);
  enter(0);
}

/** Makes the card of lessons, and keeps it in its place in the panel, which viser makes anew now and then. */
function begin() {
  card = make("section", "softrod-lesson");
  card.ariaLabel = "Lesson";
  onMessage("lesson", take);
  onMessage("pageState", beginPresent);
  setInterval(() => {
    const place = document.getElementById("softrod-lesson");
    if (card && place && card.parentElement !== place) place.replaceChildren(card);
    document.documentElement.toggleAttribute("data-softrod-lesson", place !== null);
  }, LOOK_EVERY);
  show();
}

/** @type {import("../../ui/feature.js").Feature<"lesson">} */
export default { commands: {}, begin };
