// @ts-check
/**
 * The question of a step. It is sent as a whole, and becomes part of the lesson once it is complete; until then the
 * server says what is missing.
 */
import { make, makeButton } from "../../ui/dialog.js";
import { box, labelled, makeArea, makeCheck, makeInput, refusal } from "./fields.js";
import { say } from "../../words/words.js";

/** @typedef {import("../../wire/wire.js").QuestionDraft} Question */
/** @typedef {HTMLInputElement | HTMLTextAreaElement} Field */

/** Answers of a question, at most; see `sim.scene.lesson`. */
const MAX_CHOICES = 5;

export class QuestionForm {
  /**
   * @param {(question: Question | null) => void} change sends the question, or removes it
   * @param {(field: Field, send: () => void) => void} sendLater
   */
  constructor(change, sendLater) {
    this.change = change;
    this.sendLater = sendLater;
    this.element = make("fieldset", "");
    /** @type {Question | null} */
    this.question = null;
    this.build();
  }

  /** Shows the server's question. @param {Question | null} question */
  show(question) {
    if (JSON.stringify(question) === JSON.stringify(this.question)) return;
    this.question = question && { ...question, choices: [...question.choices] };
    this.build();
  }

  /** Rebuilds the fields. @param {string} [focus] the name of the field that gets the focus */
  build(focus) {
    const { question } = this;
    const { check, label } = makeCheck(say("making-ask"), "question", (on) => {
      this.question = on ? { text: "", choices: ["", ""], answer: 0, because: "" } : null;
      this.build("question.text");
      if (!on) this.change(null);
    });
    check.checked = question !== null;
    this.element.replaceChildren(label);
    if (!question) return;
    const list = box("softrod-making-choices", ...question.choices.map((_, i) => this.choiceRow(question, i)));
    list.setAttribute("role", "group");
    list.ariaLabel = say("making-answers");
    const more = makeButton(say("making-answers.add"), () => {
      question.choices.push("");
      this.build(`question.choices[${question.choices.length - 1}]`);
    });
    more.hidden = question.choices.length >= MAX_CHOICES;
    this.element.append(
      labelled(say("making-question"), this.edits(makeArea(question.text), (value) => (question.text = value)), "question.text"),
      list,
      refusal("question.choices"),
      more,
      labelled(say("making-because"), this.edits(makeArea(question.because), (value) => (question.because = value)), "question.because"),
      refusal("question"),
    );
    const line = focus && this.element.querySelector(`[data-field="${focus}"]`);
    const field = line && line.parentElement?.querySelector("textarea, input[type=text]");
    if (field instanceof HTMLElement) field.focus();
  }

  /** Has a field edit the question. @template {Field} T @param {T} field @param {(value: string) => void} write @returns {T} */
  edits(field, write) {
    field.addEventListener("input", () => write(field.value));
    this.sendLater(field, () => this.change(this.question));
    return field;
  }

  /** @param {Question} question @param {number} i */
  choiceRow(question, i) {
    const right = make("input", "");
    Object.assign(right, { type: "radio", name: "softrod-right", checked: i === question.answer, title: say("making-right") });
    right.ariaLabel = say("making-answer.right", { number: String(i + 1) });
    right.addEventListener("change", () => {
      question.answer = i;
      this.change(question);
    });
    const input = this.edits(makeInput(question.choices[i]), (value) => (question.choices[i] = value));
    input.ariaLabel = say("making-answer", { number: String(i + 1) });
    const remove = makeButton("×", () => {
      question.choices.splice(i, 1);
      if (question.answer > i || question.answer >= question.choices.length) question.answer = Math.max(0, question.answer - 1);
      this.build(`question.choices[${Math.min(i, question.choices.length - 1)}]`);
      this.change(question);
    }, "softrod-making-icon");
    remove.ariaLabel = say("making-answer.remove", { number: String(i + 1) });
    remove.disabled = question.choices.length <= 2;
    return box("softrod-making-field", box("softrod-making-choice", right, input, remove), refusal(`question.choices[${i}]`));
  }
}
