// @ts-check
/**
 * The form in which the scene's lesson is made, next to the body: its steps in order, and the fields of the chosen one.
 * The server has the lesson, with undo; the form shows what the server has.
 */
import { send } from "../../wire/channel.js";
import { COMMANDS } from "../../wire/commands.js";
import { make, makeButton, overCanvas } from "../../ui/dialog.js";
import { beginNextAt } from "../lesson/lesson.js";
import { box } from "./fields.js";
import { StepForm } from "./step_form.js";
import { MAX_STEPS, StepList } from "./step_list.js";
import { say } from "../../words/words.js";

/** @typedef {import("../../wire/wire.js").LessonForm} LessonForm */

/** Size of a phone's page. */
const PHONE = "width=390,height=844";

export class MakingForm {
  /** @type {LessonForm} */
  lesson = { tell: "lessonForm", open: false, trying: -1, steps: [], begins: [], runs: [], plots: [] };
  /** @type {import("../../wire/wire.js").LessonOffers | null} */
  offers = null;
  /** The chosen step. */
  at = 0;
  /** The step to choose once the server has it. @type {number | null} */
  expected = null;
  /** Whether the next link is to be opened as a phone's page. */
  wantsPhone = false;

  constructor() {
    this.fields = new StepForm();
    this.list = new StepList(() => this.fields.flush(), (step) => this.choose(step), (step) => this.expect(step));
    this.title = make("h2", "", say("making-title"));
    this.title.tabIndex = -1;
    this.undo = this.historyButton("undo");
    this.redo = this.historyButton("redo");
    const fold = makeButton(say("making-fold"), () => {
      const folded = this.element.toggleAttribute("data-folded");
      fold.textContent = say(folded ? "making-fold.unfold" : "making-fold");
      fold.ariaExpanded = String(!folded);
    }, "softrod-button softrod-making-fold");
    fold.ariaExpanded = "true";
    const head = make("header", "");
    head.append(this.title, this.undo, this.redo, fold, this.button(say("making-done"), () => send({ do: "makeLesson", on: false })));
    this.about = make("p", "softrod-making-hint", say("making-about"));
    this.add = this.button("", () => {
      const at = this.lesson.steps.length ? this.at + 1 : 0;
      send({ do: "addStep", at });
      this.expect(at);
    });
    this.says = make("p", "softrod-refused");
    this.says.setAttribute("role", "status");
    this.foot = make("footer", "");
    this.foot.append(
      this.button(say("making-try"), () => {
        beginNextAt(this.at);
        send({ do: "tryStep", step: this.at });
      }, "softrod-button softrod-first"),
      this.button(say("making-phone"), () => {
        this.wantsPhone = true;
        send({ do: "share", pose: false, page: new URL(".", location.href).href });
      }),
    );
    this.drop = makeButton(say("making-drop"), () => send({ do: "dropLesson" }));
    this.drop.title = say("making-drop.hint");
    this.element = make("aside", "softrod-making");
    this.element.ariaLabel = say("making-form");
    this.element.append(
      head,
      box("softrod-making-body", this.about, this.list.element, this.add, this.says, this.fields.element, this.drop),
      this.foot,
    );
    this.bar = make("aside", "softrod-trying");
    this.bar.ariaLabel = say("making-trying.label");
    this.trying = make("span", "");
    this.bar.append(this.trying, makeButton(say("making-trying.back"), () => send({ do: "endTrying" }), "softrod-button softrod-first"));
  }

  /** A button that first sends what was typed. @param {string} text @param {() => void} press @param {string} [name] of its class */
  button(text, press, name) {
    return makeButton(text, () => {
      this.fields.flush();
      press();
    }, name);
  }

  /** @param {"undo" | "redo"} command */
  historyButton(command) {
    const { icon, word, label } = COMMANDS[command];
    const button = this.button("", () => send({ do: "perform", command }), "softrod-making-icon");
    button.innerHTML = `<svg viewBox="0 0 24 24" aria-hidden="true"><path d="${icon}"/></svg>`;
    button.ariaLabel = say(word ?? label);
    return button;
  }

  /** @param {number} step */
  choose(step) {
    this.fields.flush();
    this.expected = null;
    this.at = step;
    this.says.textContent = "";
    this.show();
  }

  /** Chooses a step when the server has it. @param {number} step */
  expect(step) {
    this.expected = step;
    this.show();
  }

  show() {
    const { steps, begins, runs, plots } = this.lesson;
    const titles = steps.map(({ title }) => title);
    const changed = JSON.stringify(titles) !== JSON.stringify(this.list.titles);
    if (this.expected !== null && (changed || this.expected === this.at)) [this.at, this.expected] = [this.expected, null];
    this.at = Math.max(0, Math.min(this.at, steps.length - 1));
    this.list.show(titles, this.at);
    const some = steps.length > 0;
    this.about.hidden = some;
    this.add.textContent = say(some ? "making-add" : "making-add.first");
    this.add.classList.toggle("softrod-first", !some);
    this.add.disabled = steps.length >= MAX_STEPS;
    this.fields.element.hidden = this.foot.hidden = this.drop.hidden = !some || this.offers === null;
    if (some && this.offers) this.fields.show(steps[this.at], this.at, { begins: begins[this.at] ?? "", runs: runs[this.at] ?? "", plots: plots[this.at] ?? "" }, this.offers);
  }

  /** @param {LessonForm} lesson */
  take(lesson) {
    const wasOpen = this.lesson.open;
    this.lesson = lesson;
    const isShown = lesson.open && lesson.trying < 0;
    if (isShown && !this.element.parentNode) {
      overCanvas().append(this.element);
      this.title.focus();
    } else if (!isShown) this.element.remove();
    this.trying.textContent = say("making-trying", { step: String(lesson.trying + 1) });
    if (lesson.trying < 0) this.bar.remove();
    else if (!this.bar.parentNode) overCanvas().append(this.bar);
    document.documentElement.toggleAttribute("data-softrod-making", isShown);
    // A form that was just opened begins with the first step.
    if (lesson.open && !wasOpen) this.at = 0;
    if (isShown) this.show();
  }

  /** @param {import("../../wire/wire.js").Received["lessonForm" | "lessonOffers" | "lessonTaken" | "versions" | "link"]} message */
  hear(message) {
    switch (message.tell) {
      case "lessonForm":
        this.take(message);
        break;
      case "lessonOffers":
        this.offers = message;
        if (this.element.parentNode) this.show();
        break;
      case "lessonTaken":
        if (message.step === this.at || message.step < 0) this.fields.hear(message);
        else if (message.refused) this.says.textContent = say("making-refused", { step: String(message.step + 1), why: message.refused });
        break;
      case "versions":
        this.showHistory(message.undo, message.redo);
        break;
      case "link":
        this.openPhone(message.link);
    }
  }

  /** @param {string} undo @param {string} redo what they would do; empty for nothing */
  showHistory(undo, redo) {
    this.undo.disabled = !undo;
    this.redo.disabled = !redo;
    this.undo.title = undo ? say("edit-undo", { what: undo }) : say("edit-undo.none");
    this.redo.title = redo ? say("edit-redo", { what: redo }) : say("edit-redo.none");
  }

  /** Opens a link as a phone's page, if that was asked for. @param {string} link */
  openPhone(link) {
    if (!this.wantsPhone || !link) return;
    this.wantsPhone = false;
    // At this page's own address, and without what this window has stored.
    const { search, hash } = new URL(link);
    window.open(new URL(`s${search}${hash}`, new URL(".", location.href)), "_blank", `noopener,popup,${PHONE}`);
  }
}
