// @ts-check
/**
 * A lesson in the panel's first tab, one step at a time. How far it is outlives a reload.
 *
 * @typedef {import("./run.js").Given} Given
 * @typedef {LessonRun<import("./run.js").Step, Given>} Run
 */
import { onMessage, pageState, send } from "../../wire/channel.js";
import { make } from "../../ui/dialog.js";
import { perform } from "../../wire/perform.js";
import { kept, store } from "../../ui/kept/storage.js";
import { say } from "../../words/words.js";
import { LessonRun } from "./run.js";

/** Under this name the tab stores `{lesson, at, answers, told}`: each step's choice, and whether the right one was revealed. */
const NAME = "softrod-lesson";
/** Milliseconds between two looks whether viser has made the place of the lesson again. */
const LOOK_EVERY = 100;

/** @type {HTMLElement} */
let card;
/** The buttons, which stay at the lower end of the panel. @type {HTMLElement | null} */
let foot = null;
/** @type {Run | null} */
let run = null;
/** The opening of the lesson's scene, as the server counts them, in which a step was begun. */
let begunIn = "";
/** The step at which the lesson is to begin the next time, without any answers. @type {number | null} */
let first = null;

/** Has the lesson begin at a step the next time that its tab comes. @param {number} step */
export const beginNextAt = (step) => (first = step);

/** @returns {Given} */
const blank = () => ({ choice: null, known: false });

/** What was stored of a lesson, or its beginning. @param {string} lesson @param {number} count of its steps @returns {{at: number, given: Given[]}} */
function progressOf(lesson, count) {
  try {
    const old = JSON.parse(kept(NAME) ?? "null");
    const fits = old?.lesson === lesson && old.at >= 0 && old.at < count;
    if (fits && old.answers?.length === count && old.told?.length === count) {
      return { at: old.at, given: Array.from({ length: count }, (_, i) => ({ choice: old.answers[i], known: old.told[i] })) };
    }
  } catch {
    // Not as this version stores it.
  }
  return { at: 0, given: Array.from({ length: count }, blank) };
}

/** @param {import("../../wire/wire.js").Lesson} lesson */
function take({ name, steps }) {
  const { at, given } = progressOf(name, steps.length);
  /** @type {Run} */
  const taken = new LessonRun(card, steps, at, given, {
    blank,
    begin(waits) {
      send({ do: "beginStep", step: taken.at, how: waits ? "wait" : "run" });
      document.dispatchEvent(new CustomEvent("softrod-step", { detail: { at: taken.at, title: taken.step.title } }));
    },
    run: () => (taken.step.run ? taken.begin() : perform("run")),
    placeFoot(next) {
      foot?.replaceWith(next);
      foot = next;
    },
    store() {
      const answers = taken.given.map(({ choice }) => choice);
      store(NAME, JSON.stringify({ lesson: name, at: taken.at, answers, told: taken.given.map(({ known }) => known) }));
    },
  });
  run = taken;
  run.host.store(false);
  begunIn = "";
  beginPresent();
  if (steps.length) run.show();
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
  if (!page || lesson === undefined || !run?.steps.length || begunIn === opening) return;
  begunIn = opening;
  if (first !== null) {
    run.at = first;
    run.given = run.steps.map(blank);
    first = null;
    run.changed();
  }
  if (lesson) send({ do: "beginStep", step: run.at, how: "on" });
  else run.begin();
}

/** Makes the card of lessons, and keeps it in its place in the panel, which viser makes again now and then. */
function begin() {
  card = make("section", "softrod-lesson");
  card.ariaLabel = say("lesson-card");
  onMessage("lesson", take);
  onMessage("pageState", beginPresent);
  setInterval(() => {
    const place = document.getElementById("softrod-lesson");
    if (place && card.parentElement !== place) place.replaceChildren(card);
    const page = place?.closest("[role=tabpanel]");
    page?.classList.add("softrod-lesson-page");
    if (page && foot && page.nextElementSibling !== foot) page.after(foot);
    document.documentElement.toggleAttribute("data-softrod-lesson", place !== null);
  }, LOOK_EVERY);
}

/** @type {import("../../ui/feature.js").Feature<"lesson">} */
export default { commands: {}, begin };
