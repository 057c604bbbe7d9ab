// @ts-check
/**
 * The fields of one step of the lesson that is being made. What is typed is sent after a pause, or when its field is
 * left; what the server refuses stays in its field, with a sentence below it.
 */
import { send } from "../../wire/channel.js";
import { make, makeButton } from "../../ui/dialog.js";
import { readNumber } from "../../ui/viser/numbers.js";
import { Chooser } from "./chooser.js";
import { labelled, makeCheck, makeSelect, refusal, setOptions } from "./fields.js";
import { QuestionForm } from "./question_form.js";

/** @typedef {import("../../wire/wire.js").Step} Step */
/** @typedef {import("../../wire/wire.js").LessonOffers} LessonOffers */
/** @typedef {import("../../wire/wire.js").LessonTaken} LessonTaken */
/** @typedef {HTMLInputElement | HTMLTextAreaElement} Field */

/** Milliseconds without a key after which what was typed is sent. */
const PAUSE = 600;
/** Sliders that a step has at most, see `sim.scene.lesson`. */
const MAX_CONTROLS = 6;

/** The form of one step. */
export class StepForm {
  constructor() {
    this.element = make("div", "softrod-making-step");
    this.number = -1;
    /** What waits to be sent. @type {Map<HTMLElement, {timer: ReturnType<typeof setTimeout>, say: () => void}>} */
    this.waiting = new Map();
    /** What the server had last of each part. @type {Map<string, string>} */
    this.known = new Map();
    /** Whether there is a goal in the form, though the server may have refused it so far. */
    this.aims = false;
    this.texts = {
      title: this.textField("title", make("input", "")),
      do: this.textField("do", make("textarea", "")),
      watch: this.textField("watch", make("textarea", "")),
    };
    this.question = new QuestionForm(
      (question) => (question ? send({ do: "askInStep", step: this.number, ...question }) : this.drop("question")),
      (field, say) => this.sendLater(field, say),
    );
    this.begins = make("p", "softrod-making-now");
    this.takeSettings = makeButton("Begin as it is now", () => this.take("settings"));
    this.nowSettings = make("p", "softrod-making-hint");
    this.controlsTitle = make("summary", "");
    this.controls = make("div", "softrod-making-checks");
    this.plots = make("p", "softrod-making-now");
    this.takePlots = makeButton("Plots as they are open now", () => this.take("plots"));
    this.dropPlots = makeButton("No plots", () => this.drop("plots"));
    this.arrows = make("p", "softrod-making-now");
    this.takeArrows = makeButton("Arrows as they are on now", () => this.take("arrows"));
    this.dropArrows = makeButton("Leave arrows alone", () => this.drop("arrows"));
    this.ghost = makeSelect("A second body to compare with");
    this.ghost.addEventListener("change", () => send({ do: "compareInStep", step: this.number, ghost: this.ghost.value }));
    this.predict = this.numberField("Predict where it is after (s)", "predict", () => this.sayPredict());
    this.aim = makeCheck("A goal to reach", "goal", () => this.toggleGoal());
    const sayGoal = () => this.sayGoal();
    this.goal = new Chooser("Goal", "goal.quantity", sayGoal);
    this.low = this.numberField("from", "goal.low", sayGoal);
    this.high = this.numberField("to", "goal.high", sayGoal);
    this.seconds = this.numberField("for (s)", "goal.seconds", sayGoal);
    this.goalBox = make("div", "softrod-making-part");
    this.collects = makeCheck("Each one hands in a reading", "collect", () =>
      this.collects.box.checked ? this.sayCollect() : this.drop("collect"),
    );
    this.collect = new Chooser("Hand in", "collect.quantity", () => this.sayCollect());
    this.collectBox = make("div", "softrod-making-part");
    this.element.append(
      labelled("Title", this.texts.title, "title"),
      labelled("What to do", this.texts.do, "do"),
      labelled("What to watch meanwhile (may be empty)", this.texts.watch, "watch"),
      this.question.element,
      this.beginning(),
      this.sliders(),
      this.shown(),
      this.inClass(),
    );
  }

  // ------------------------------------------------------------------- what is in it
  /** @param {string} title */
  section(title) {
    const box = make("fieldset", "");
    box.append(make("legend", "", title));
    return box;
  }

  beginning() {
    const box = this.section("Begins with");
    box.append(this.begins, this.takeSettings, this.nowSettings, refusal("settings"));
    return box;
  }

  sliders() {
    const box = make("details", "");
    box.append(this.controlsTitle, this.controls, refusal("controls"));
    return box;
  }

  shown() {
    const box = this.section("Shows");
    const [one, two] = [make("div", "softrod-making-row"), make("div", "softrod-making-row")];
    one.append(this.takePlots, this.dropPlots);
    two.append(this.takeArrows, this.dropArrows);
    const ghost = labelled("A second body to compare with", this.ghost, "ghost");
    box.append(this.plots, one, refusal("plots"), this.arrows, two, refusal("arrows"), ghost);
    return box;
  }

  inClass() {
    const box = this.section("In a class");
    const range = make("div", "softrod-making-row");
    range.append(this.low.box, this.high.box, this.seconds.box);
    this.goalBox.append(this.goal.element, this.goal.refused, range, refusal("goal"));
    this.collectBox.append(this.collect.element, this.collect.refused);
    const hint = make("p", "softrod-making-hint", "Click a mass to choose among what is at it.");
    box.append(this.predict.box, this.aim.label, this.goalBox, this.collects.label, this.collectBox, hint);
    return box;
  }

  /**
   * A text of the step.
   *
   * @template {Field} T
   * @param {"title" | "do" | "watch"} field @param {T} input
   */
  textField(field, input) {
    if (input instanceof HTMLTextAreaElement) input.rows = 2;
    else input.type = "text";
    this.sendLater(input, () => send({ do: "writeStep", step: this.number, field, text: input.value }));
    return input;
  }

  /** @param {string} label @param {string} name @param {() => void} say */
  numberField(label, name, say) {
    const input = make("input", "");
    input.type = "text";
    input.inputMode = "decimal";
    input.autocomplete = "off";
    this.sendLater(input, say);
    return { input, name, box: labelled(label, input, name) };
  }

  // ------------------------------------------------------------------- what is said
  /** Has a field sent after a pause, and when it is left. @param {Field} field @param {() => void} say */
  sendLater(field, say) {
    const now = () => {
      const one = this.waiting.get(field);
      if (!one) return;
      clearTimeout(one.timer);
      this.waiting.delete(field);
      say();
    };
    field.addEventListener("input", () => {
      clearTimeout(this.waiting.get(field)?.timer);
      this.waiting.set(field, { timer: setTimeout(now, PAUSE), say: now });
    });
    field.addEventListener("change", now);
  }

  /** Sends what waits. */
  flush() {
    for (const { say } of [...this.waiting.values()]) say();
  }

  /** @param {import("../../wire/wire.js").TakeInStep["what"]} what */
  take(what) {
    this.flush();
    send({ do: "takeInStep", step: this.number, what });
  }

  /** @param {import("../../wire/wire.js").DropFromStep["what"]} what */
  drop(what) {
    send({ do: "dropFromStep", step: this.number, what });
  }

  sayPredict() {
    const seconds = this.read(this.predict);
    if (seconds === null) this.drop("predict");
    else if (seconds !== undefined) send({ do: "predictInStep", step: this.number, seconds });
  }

  sayGoal() {
    const [low, high, seconds] = [this.low, this.high, this.seconds].map((field) => this.read(field));
    if (low === undefined || high === undefined || seconds === undefined) return;
    send({ do: "aimInStep", step: this.number, ...this.goal.reading, low, high, seconds: seconds ?? 0 });
  }

  toggleGoal() {
    this.aims = this.aim.box.checked;
    this.goalBox.hidden = !this.aims;
    this.refuse("goal", "", "");
    if (this.aims) this.low.input.focus();
    else this.drop("goal");
  }

  sayCollect() {
    send({ do: "collectInStep", step: this.number, ...this.collect.reading });
  }

  /**
   * The number in a field: null if it is empty, undefined if it is none, which is said.
   *
   * @param {{input: HTMLInputElement, name: string}} field
   */
  read({ input, name }) {
    const text = input.value.trim();
    if (!text) return null;
    const number = readNumber(text);
    if (!Number.isNaN(number)) return number;
    this.refuse(name, name, `“${text.slice(0, 40)}” is not a number. Write one as 20000, 2e4 or 0.05.`);
    return undefined;
  }

  // ------------------------------------------------------------------- what is shown
  /**
   * Shows a sentence beside the field that it is about, or takes those of a part away.
   *
   * @param {string} part @param {string} field @param {string} sentence
   */
  refuse(part, field, sentence) {
    const lines = /** @type {HTMLElement[]} */ ([...this.element.querySelectorAll(".softrod-refused")]);
    for (const line of lines) if ((line.dataset.field ?? "").split(/[.[]/)[0] === part.split(/[.[]/)[0]) line.textContent = "";
    if (!sentence) return;
    // Where the field itself has no place, what it is in has one.
    for (let name = field; name; name = name.replace(/[.[]?[^.[]*$/, "")) {
      const line = lines.find(({ dataset }) => dataset.field === name);
      if (line) {
        line.textContent = sentence;
        return;
      }
    }
  }

  /** @param {LessonTaken} taken */
  hear({ part, field, refused }) {
    this.refuse(part, field, refused);
  }

  /**
   * Whether the server has another value of a part than before.
   *
   * @param {string} part @param {unknown} value
   */
  isNew(part, value) {
    const text = JSON.stringify(value ?? null);
    if (this.known.get(part) === text) return false;
    this.known.set(part, text);
    return true;
  }

  /**
   * Shows a step. What is typed and not sent yet stays.
   *
   * @param {Step} step @param {number} number @param {string} begins @param {LessonOffers} offers
   */
  show(step, number, begins, offers) {
    if (number !== this.number) {
      this.number = number;
      this.known.clear();
      for (const line of this.element.querySelectorAll(".softrod-refused")) line.textContent = "";
    }
    for (const field of /** @type {const} */ (["title", "do", "watch"])) this.put(this.texts[field], field, step[field]);
    const { element } = this.question;
    // What is typed there and not sent yet stays.
    const typed = [...this.waiting.keys()].some((field) => element.contains(field));
    if (!typed && this.isNew("question", step.question)) this.question.show(step.question);
    this.begins.textContent = begins || "The scene as it is saved.";
    this.nowSettings.textContent = offers.settings ? `Now: ${offers.settings}.` : "";
    this.nowSettings.hidden = !offers.settings || offers.settings === begins;
    this.takeSettings.disabled = offers.settings === begins;
    this.showControls(step.controls, offers);
    this.plots.textContent = step.plots?.length ? `Plots: ${step.plots.join("; ")}.` : "No plots.";
    this.takePlots.disabled = offers.plots.length === 0;
    this.dropPlots.hidden = !step.plots?.length;
    const arrows = step.arrows;
    this.arrows.textContent = arrows === null ? "Arrows stay as they are." : arrows.length ? `Arrows: ${arrows.join(", ")}.` : "No arrows.";
    this.dropArrows.hidden = arrows === null;
    setOptions(this.ghost, [["", "none"], ...Object.entries(offers.methods)], step.ghost ?? "");
    this.showClass(step, offers);
  }

  /** @param {Field} field @param {string} part @param {string} value */
  put(field, part, value) {
    if (!this.isNew(part, value) || this.waiting.has(field)) return;
    if (field.value !== value) field.value = value;
    this.refuse(part, "", "");
  }

  /** @param {string[]} chosen @param {LessonOffers} offers */
  showControls(chosen, { controls }) {
    if (!this.isNew("controls", [chosen, controls])) return;
    const focused = this.controls.contains(document.activeElement) ? document.activeElement?.getAttribute("data-focus") : null;
    const labels = new Map(controls.map(({ key, label }) => [key, label]));
    this.controlsTitle.textContent = chosen.length
      ? `Pupils get: ${chosen.map((key) => labels.get(key) ?? key).join(", ")}`
      : "Pupils get no sliders";
    const gone = chosen.filter((key) => !labels.has(key)).map((key) => ({ key, label: `${key}, which the scene has no use for` }));
    this.controls.replaceChildren(
      ...[...gone, ...controls].map(({ key, label }) => {
        const { box, label: row } = makeCheck(label, `control ${key}`, () => {
          const now = box.checked ? [...chosen, key] : chosen.filter((one) => one !== key);
          send({ do: "offerInStep", step: this.number, controls: now });
        });
        box.checked = chosen.includes(key);
        box.disabled = !box.checked && chosen.length >= MAX_CONTROLS;
        return row;
      }),
    );
    if (focused) /** @type {HTMLElement | null} */ (this.controls.querySelector(`[data-focus="${CSS.escape(focused)}"]`))?.focus();
  }

  /** @param {Step} step @param {LessonOffers} offers */
  showClass({ predict, goal, collect }, offers) {
    this.put(this.predict.input, "predict", predict === null ? "" : String(predict));
    this.goal.offers = this.collect.offers = offers;
    if (this.isNew("goal", goal)) {
      this.aims = goal !== null;
      this.put(this.low.input, "goal.low", goal?.low == null ? "" : String(goal.low));
      this.put(this.high.input, "goal.high", goal?.high == null ? "" : String(goal.high));
      this.put(this.seconds.input, "goal.seconds", goal?.seconds ? String(goal.seconds) : "");
      this.goal.show(goal);
    } else this.goal.show(this.goal.part.value ? this.goal.reading : null);
    this.aim.box.checked = this.aims;
    this.goalBox.hidden = !this.aims;
    if (this.isNew("collect", collect)) this.collect.show(collect);
    else this.collect.show(this.collect.part.value ? this.collect.reading : null);
    this.collects.box.checked = collect !== null;
    this.collectBox.hidden = collect === null;
  }
}
