// @ts-check
/**
 * One run through a lesson, in the page and in a live file. At each step a question comes first, or a prediction, and the
 * body waits for it; then the body runs. The right answer is revealed last, when the user asks for it.
 */
import { lessonCard } from "./card.js";

/**
 * @typedef {Omit<import("../../wire/wire.js").LessonStep, "run"> & {run: unknown, predict?: number}} Step with s after which the body is to be where it
 *   was predicted; 0 or nothing where there is no such prediction
 * @typedef {object} Given what the user has given at a step
 * @property {number | null} choice
 * @property {boolean} known whether the right answer was revealed
 * @property {unknown} [places] the prediction
 */
/**
 * @template {Given} G
 * @typedef {object} Host who shows the lesson
 * @property {() => G} blank what is given at the beginning
 * @property {(waits: boolean) => void} begin sets up the body for the present step; it waits for an answer or runs at once
 * @property {() => void} run has the body that waited run
 * @property {(isAnswer: boolean) => void} store stores how far the lesson is, after an answer or after a change of the step
 * @property {() => {asked?: HTMLElement[], done?: HTMLElement[]}} [more] what the card has below its question, and below what
 *   is to be done
 * @property {(foot: HTMLElement) => void} [placeFoot] places the buttons; without it they are at the end of the card
 */

/** @template {Step} S @template {Given} G */
export class LessonRun {
  /**
   * @param {HTMLElement} card @param {S[]} steps @param {number} at the present step, counted from 0
   * @param {G[]} given at each step @param {Host<G>} host
   */
  constructor(card, steps, at, given, host) {
    this.card = card;
    this.steps = steps;
    this.at = at;
    this.given = given;
    this.host = host;
  }

  get step() {
    return this.steps[this.at];
  }

  /** What is given at the present step. */
  get present() {
    return this.given[this.at];
  }

  /** Whether a prediction is still to be made. */
  get isToPredict() {
    return Boolean(this.step.predict) && !this.present.places;
  }

  /** Whether the body waits. */
  get waits() {
    return this.isToPredict || (this.step.question !== null && this.present.choice === null);
  }

  show() {
    const { parts, foot } = lessonCard(this, this.host.more?.() ?? {});
    this.card.replaceChildren(...parts);
    if (this.host.placeFoot) this.host.placeFoot(foot);
    else this.card.append(foot);
  }

  begin() {
    this.host.begin(this.waits);
  }

  /** The first choice starts the body; until the right one is revealed, another can be made. @param {number} choice */
  answer(choice) {
    const waited = this.waits;
    this.present.choice = choice;
    this.changed();
    const starts = waited && !this.waits;
    if (starts) this.host.run();
    this.focus(starts ? ".softrod-lesson-do" : ".softrod-choice[aria-pressed=true]");
  }

  reveal() {
    this.present.known = true;
    this.changed();
    this.focus(".softrod-verdict");
  }

  /** Begin the present step again, as if nothing had been answered. */
  again() {
    Object.assign(this.present, { choice: null, known: false, places: null });
    this.host.store(true);
    this.enter(this.at);
  }

  /** Begin a step. @param {number} at */
  enter(at) {
    this.at = at;
    this.host.store(false);
    this.show();
    this.begin();
    this.focus("h2");
  }

  /** Begin with the first step, without any answers. */
  startOver() {
    this.given = this.steps.map(this.host.blank);
    this.host.store(true);
    this.enter(0);
  }

  /** Something was given. */
  changed() {
    this.host.store(true);
    this.show();
  }

  /** Moves the focus within the card, from where screen readers read on. @param {string} selector */
  focus(selector) {
    const found = this.card.querySelector(selector);
    if (found instanceof HTMLElement) found.focus();
  }
}
