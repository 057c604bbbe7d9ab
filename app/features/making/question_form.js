// @ts-check
/**
 * The question of a step. It is sent as a whole, and is in the lesson once all of it is there; until then the server
 * says what is missing.
 */
import { make, makeButton } from "../../ui/dialog.js";
import { labelled, makeCheck, refusal } from "./fields.js";

/** @typedef {{text: string, choices: string[], answer: number, because: string}} Question */
/** @typedef {HTMLInputElement | HTMLTextAreaElement} Field */

/** What a question has at most, see `sim.scene.lesson`. */
const MAX_CHOICES = 5;

export class QuestionForm {
  /**
   * @param {(question: Question | null) => void} say sends it, or that there is none
   * @param {(field: Field, say: () => void) => void} sendLater
   */
  constructor(say, sendLater) {
    this.say = say;
    this.sendLater = sendLater;
    this.element = make("fieldset", "");
    /** @type {Question | null} */
    this.question = null;
    this.build();
  }

  /** Shows what the server has. @param {Question | null} question */
  show(question) {
    if (JSON.stringify(question) === JSON.stringify(this.question)) return;
    this.question = question && { text: question.text, choices: [...question.choices], answer: question.answer, because: question.because };
    this.build();
  }

  /** Makes the fields of the question anew. @param {string} [focus] the name of the field that gets the focus */
  build(focus) {
    const question = this.question;
    const { box: on, label } = makeCheck("Ask a question first", "question", () => {
      this.question = on.checked ? { text: "", choices: ["", ""], answer: 0, because: "" } : null;
      this.build("question.text");
      if (!on.checked) this.say(null);
    });
    on.checked = question !== null;
    this.element.replaceChildren(label);
    if (!question) return;
    const text = this.area(question.text, (value) => (question.text = value));
    this.element.append(labelled("Question", text, "question.text"));
    const list = make("div", "softrod-making-choices");
    list.setAttribute("role", "group");
    list.ariaLabel = "Answers; the right one is marked";
    question.choices.forEach((choice, i) => list.append(this.choiceRow(question, choice, i)));
    const more = makeButton("Add an answer", () => {
      question.choices.push("");
      this.build(`question.choices[${question.choices.length - 1}]`);
    }, "softrod-button");
    more.hidden = question.choices.length >= MAX_CHOICES;
    const because = this.area(question.because, (value) => (question.because = value));
    this.element.append(list, refusal("question.choices"), more, labelled("Why that is right", because, "question.because"), refusal("question"));
    const line = focus && this.element.querySelector(`[data-field="${focus}"]`);
    const field = line && line.parentElement?.querySelector("textarea, input[type=text]");
    if (field instanceof HTMLElement) field.focus();
  }

  /** @param {string} value @param {(value: string) => void} write */
  area(value, write) {
    const area = make("textarea", "");
    area.rows = 2;
    area.value = value;
    this.ofQuestion(area, write);
    return area;
  }

  /** A field of the question, which is sent as a whole. @param {Field} field @param {(value: string) => void} write */
  ofQuestion(field, write) {
    field.addEventListener("input", () => write(field.value));
    this.sendLater(field, () => this.say(this.question));
  }

  /** @param {Question} question @param {string} choice @param {number} i */
  choiceRow(question, choice, i) {
    const box = make("div", "softrod-making-field");
    const row = make("div", "softrod-making-choice");
    const right = make("input", "");
    Object.assign(right, { type: "radio", name: "softrod-right", checked: i === question.answer, title: "This is the right one" });
    right.ariaLabel = `Answer ${i + 1} is right`;
    right.addEventListener("change", () => {
      question.answer = i;
      this.say(question);
    });
    const input = make("input", "");
    input.type = "text";
    input.value = choice;
    input.ariaLabel = `Answer ${i + 1}`;
    this.ofQuestion(input, (value) => (question.choices[i] = value));
    const away = makeButton("×", () => {
      question.choices.splice(i, 1);
      if (question.answer > i || question.answer >= question.choices.length) question.answer = Math.max(0, question.answer - 1);
      this.build(`question.choices[${Math.min(i, question.choices.length - 1)}]`);
      this.say(question);
    }, "softrod-making-cross");
    away.ariaLabel = `Remove answer ${i + 1}`;
    away.disabled = question.choices.length <= 2;
    row.append(right, input, away);
    box.append(row, refusal(`question.choices[${i}]`));
    return box;
  }
}
