// @ts-check
/**
 * The fields of one step of the lesson. Input is sent after a pause, or when its field loses the focus; a value that the
 * server refuses stays in its field, with a sentence below it.
 */
import { send } from "../../wire/channel.js";
import { make, makeButton } from "../../ui/dialog.js";
import { plainText, readNumber } from "../../ui/gui/numbers.js";
import { Chooser } from "./chooser.js";
import { box, labelled, makeArea, makeCheck, makeInput, makeSelect, refusal, setOptions } from "./fields.js";
import { QuestionForm } from "./question_form.js";
import { joined, say } from "../../words/words.js";

/** @typedef {import("../../wire/wire.js").Step} Step */
/** @typedef {import("../../wire/wire.js").LessonOffers} LessonOffers */
/** @typedef {import("../../wire/wire.js").LessonTaken} LessonTaken */
/** @typedef {HTMLInputElement | HTMLTextAreaElement} Field */

/** Milliseconds without a key after which input is sent. */
const PAUSE = 600;
/** Sliders of a step, at most; see `sim.scene.lesson`. */
const MAX_CONTROLS = 6;
const TEXTS = /** @type {const} */ (["title", "do", "watch"]);

/** The field that a name begins with, as in "question.choices[1]". @param {string} name */
const fieldOf = (name) => name.split(/[.[]/)[0];

/** What each kind of arrows is called. @satisfies {Record<NonNullable<Step["arrows"]>[number], import("../../words/keys.js").Plain>} */
const ARROWS = /** @type {const} */ ({ forces: "making-arrow-forces", velocities: "making-arrow-velocities", torques: "making-arrow-torques" });

/** What the arrows of a step are. @param {Step["arrows"]} arrows */
function arrowsText(arrows) {
  if (arrows === null) return say("making-arrows.stay");
  return arrows.length ? say("making-arrows", { arrows: joined(arrows.map((kind) => say(ARROWS[kind]))) }) : say("making-arrows.none");
}

/** A group of fields. @param {string} title @param {...Node} content */
function section(title, ...content) {
  const element = make("fieldset", "");
  element.append(make("legend", "", title), ...content);
  return element;
}

/** The form of one step. */
export class StepForm {
  constructor() {
    this.element = make("div", "softrod-making-step");
    this.number = -1;
    /** What waits to be sent. @type {Map<HTMLElement, {timer: ReturnType<typeof setTimeout>, now: () => void}>} */
    this.waiting = new Map();
    /** The server's last value of each field, as JSON. @type {Map<string, string>} */
    this.known = new Map();
    /** Whether the form has a goal, which the server may have refused so far. */
    this.hasGoal = false;
    this.texts = { title: this.textField("title", makeInput()), do: this.textField("do", makeArea()), watch: this.textField("watch", makeArea()) };
    this.question = new QuestionForm((question) => this.change({ question }), (field, change) => this.sendLater(field, change));
    this.begins = make("p", "softrod-making-now");
    this.takeSettings = makeButton(say("making-begins.take"), () => this.take("settings"));
    this.nowSettings = make("p", "softrod-making-hint");
    this.runs = make("p", "softrod-making-now");
    this.dropRun = makeButton(say("making-runs.drop"), () => this.change({ run: null }));
    this.led = this.numberField(say("making-lead.mass"), "run.leads.mass", () => {});
    this.radius = this.numberField(say("making-lead.circle"), "run.leads.radius", () => {});
    this.turns = this.numberField(say("making-lead.turns"), "run.leads.frequency", () => {});
    this.controlsTitle = make("summary", "");
    this.controls = make("div", "softrod-making-checks");
    const controls = make("details", "");
    controls.append(this.controlsTitle, this.controls, refusal("controls"));
    this.plots = make("p", "softrod-making-now");
    this.takePlots = makeButton(say("making-plots.take"), () => this.take("plots"));
    this.dropPlots = makeButton(say("making-plots.drop"), () => this.change({ plots: null }));
    this.arrows = make("p", "softrod-making-now");
    const takeArrows = makeButton(say("making-arrows.take"), () => this.take("arrows"));
    this.dropArrows = makeButton(say("making-arrows.drop"), () => this.change({ arrows: null }));
    this.ghost = makeSelect(say("making-ghost"));
    this.ghost.addEventListener("change", () => this.change({ ghost: this.ghost.value }));
    this.predict = this.numberField(say("making-predict"), "predict", () => {
      const predict = this.read(this.predict);
      if (predict !== undefined) this.change({ predict });
    });
    const changeGoal = () => this.changeGoal();
    this.aims = makeCheck(say("making-aims"), "goal", (on) => this.toggleGoal(on));
    this.goal = new Chooser(say("making-goal"), "goal.quantity", changeGoal);
    this.low = this.numberField(say("making-goal.low"), "goal.low", changeGoal);
    this.high = this.numberField(say("making-goal.high"), "goal.high", changeGoal);
    this.seconds = this.numberField(say("making-goal.seconds"), "goal.seconds", changeGoal);
    this.goal.element.append(box("softrod-making-row", this.low.box, this.high.box, this.seconds.box), refusal("goal"));
    this.collects = makeCheck(say("making-collects"), "collect", (on) => this.change({ collect: on ? this.collect.reading : null }));
    this.collect = new Chooser(say("making-collect"), "collect.quantity", () => this.change({ collect: this.collect.reading }));
    this.element.append(
      labelled(say("making-step-title"), this.texts.title, "title"),
      labelled(say("making-do"), this.texts.do, "do"),
      labelled(say("making-watch"), this.texts.watch, "watch"),
      this.question.element,
      section(say("making-begins"), this.begins, this.takeSettings, this.nowSettings, refusal("settings")),
      section(
        say("making-runs"),
        this.runs, box("softrod-making-row", makeButton(say("making-runs.take"), () => this.take("run")), this.dropRun), refusal("run"),
        make("p", "softrod-making-hint", say("making-runs.hint")),
        box("softrod-making-row", this.led.box, this.radius.box, this.turns.box),
        makeButton(say("making-lead"), () => this.lead()),
      ),
      controls,
      section(
        say("making-shows"),
        this.plots, box("softrod-making-row", this.takePlots, this.dropPlots), refusal("plots"),
        this.arrows, box("softrod-making-row", takeArrows, this.dropArrows), refusal("arrows"),
        labelled(say("making-ghost"), this.ghost, "ghost"),
      ),
      section(
        say("making-class"),
        this.predict.box, this.aims.label, this.goal.element, this.collects.label, this.collect.element,
        make("p", "softrod-making-hint", say("making-class.hint")),
      ),
    );
  }

  /** @template {Field} T @param {typeof TEXTS[number]} name @param {T} input @returns {T} */
  textField(name, input) {
    this.sendLater(input, () => this.change({ [name]: input.value }));
    return input;
  }

  /** @param {string} label @param {string} name @param {() => void} change */
  numberField(label, name, change) {
    // With letters: a reading may be negative, and the number keypad of some phones has no minus.
    const input = makeInput();
    input.autocomplete = "off";
    this.sendLater(input, change);
    return { input, name, box: labelled(label, input, name) };
  }

  // ------------------------------------------------------------------- what is sent
  /** Has a field's input sent after a pause, and when it loses the focus. @param {Field} field @param {() => void} change */
  sendLater(field, change) {
    const now = () => {
      if (!this.waiting.has(field)) return;
      clearTimeout(this.waiting.get(field)?.timer);
      this.waiting.delete(field);
      change();
    };
    field.addEventListener("input", () => {
      clearTimeout(this.waiting.get(field)?.timer);
      this.waiting.set(field, { timer: setTimeout(now, PAUSE), now });
    });
    field.addEventListener("change", now);
  }

  /** Sends what waits. */
  flush() {
    for (const { now } of [...this.waiting.values()]) now();
  }

  /** @param {import("../../wire/wire.js").StepChanges} changes */
  change(changes) {
    send({ do: "changeStep", step: this.number, changes });
  }

  /** @param {import("../../wire/wire.js").TakeInStep["what"]} what */
  take(what) {
    this.flush();
    send({ do: "takeInStep", step: this.number, what });
  }

  /** Has the run lead a mass. */
  lead() {
    this.flush();
    const [mass, radius, frequency] = [this.led, this.radius, this.turns].map((field) => this.read(field));
    if (mass === undefined || radius === undefined || frequency === undefined) return;
    if (mass === null || !Number.isInteger(mass) || mass < 0) return this.refuse("run", "run.leads.mass", say("making-lead.refused"));
    send({ do: "leadInStep", step: this.number, mass, radius: radius ?? 0, frequency: frequency ?? 1 });
  }

  changeGoal() {
    const [low, high, seconds] = [this.low, this.high, this.seconds].map((field) => this.read(field));
    if (low === undefined || high === undefined || seconds === undefined) return;
    this.change({ goal: { ...this.goal.reading, low, high, seconds: seconds ?? 0 } });
  }

  /** @param {boolean} on */
  toggleGoal(on) {
    this.hasGoal = on;
    this.goal.element.hidden = !on;
    this.refuse("goal", "", "");
    if (on) this.low.input.focus();
    else this.change({ goal: null });
  }

  /**
   * The number in a field: null if it is empty; undefined if it is invalid, which is shown.
   *
   * @param {{input: HTMLInputElement, name: string}} field
   */
  read({ input, name }) {
    const text = input.value.trim();
    if (!text) return null;
    const number = readNumber(text);
    if (!Number.isNaN(number)) return number;
    this.refuse(name, name, say("ui-number-none", { written: text.slice(0, 40) }));
    return undefined;
  }

  // ------------------------------------------------------------------- what is shown
  /**
   * Shows why a value was refused, instead of earlier refusals of the same part.
   *
   * @param {string} part @param {string} field @param {string} sentence empty for nothing
   */
  refuse(part, field, sentence) {
    const lines = /** @type {HTMLElement[]} */ ([...this.element.querySelectorAll(".softrod-refused")]);
    for (const line of lines) if (fieldOf(line.dataset.field ?? "") === fieldOf(part)) line.textContent = "";
    if (!sentence) return;
    // A field without a line of its own is shown at the one that contains it.
    for (let name = field; name; name = name.replace(/[.[]?[^.[]*$/, "")) {
      const line = lines.find(({ dataset }) => dataset.field === name);
      if (!line) continue;
      line.textContent = sentence;
      line.scrollIntoView({ block: "nearest" });
      return;
    }
  }

  /** @param {LessonTaken} taken */
  hear({ part, field, refused }) {
    this.refuse(part, field, refused);
  }

  /** Whether the server has a new value of a field. @param {string} part @param {unknown} value */
  isNew(part, value) {
    const text = JSON.stringify(value ?? null);
    if (this.known.get(part) === text) return false;
    this.known.set(part, text);
    return true;
  }

  /**
   * Shows a step. Input that waits to be sent stays.
   *
   * @param {Step} step @param {number} number @param {{begins: string, runs: string, plots: string}} words what of it is told in words
   * @param {LessonOffers} offers
   */
  show(step, number, { begins, runs, plots }, offers) {
    if (number !== this.number) {
      this.number = number;
      this.known.clear();
      for (const line of this.element.querySelectorAll(".softrod-refused")) line.textContent = "";
    }
    for (const name of TEXTS) this.put(this.texts[name], name, step[name]);
    const typed = [...this.waiting.keys()].some((field) => this.question.element.contains(field));
    if (!typed && this.isNew("question", step.question)) this.question.show(step.question);
    this.begins.textContent = begins || say("making-begins.saved");
    this.nowSettings.textContent = offers.settings ? say("making-begins.now", { settings: offers.settings }) : "";
    this.nowSettings.hidden = !offers.settings || offers.settings === begins;
    this.takeSettings.disabled = offers.settings === begins;
    this.runs.textContent = runs || say("making-runs.same");
    this.dropRun.hidden = !step.run;
    const [lead] = step.run?.leads ?? [];
    if (lead && this.isNew("leads", lead)) {
      for (const [{ input }, value] of /** @type {const} */ ([[this.led, lead.mass], [this.radius, lead.circle.radius], [this.turns, lead.circle.frequency ?? 1]])) input.value = plainText(value);
    }
    this.showControls(step.controls, offers);
    this.plots.textContent = plots ? say("making-plots", { plots }) : say("making-plots.none");
    this.takePlots.textContent = say(plots ? "making-plots.replace" : "making-plots.take");
    this.takePlots.disabled = offers.plots.length === 0 || JSON.stringify(offers.plots) === JSON.stringify(step.plots);
    this.dropPlots.hidden = !step.plots?.length;
    const { arrows } = step;
    this.arrows.textContent = arrowsText(arrows);
    this.dropArrows.hidden = arrows === null;
    setOptions(this.ghost, [["", say("making-ghost.none")], ...Object.entries(offers.methods)], step.ghost ?? "");
    this.showClass(step, offers);
  }

  /** @param {Field} field @param {string} part @param {string | number | null | undefined} value */
  put(field, part, value) {
    if (!this.isNew(part, value) || this.waiting.has(field)) return;
    const text = typeof value === "number" ? plainText(value) : (value ?? "");
    if (field.value !== text) field.value = text;
    this.refuse(part, "", "");
  }

  /** @param {string[]} chosen @param {LessonOffers} offers */
  showControls(chosen, { controls }) {
    if (!this.isNew("controls", [chosen, controls])) return;
    const focused = this.controls.contains(document.activeElement) ? document.activeElement?.getAttribute("data-focus") : null;
    const labels = new Map(controls.map(({ key, label }) => [key, label]));
    this.controlsTitle.textContent = chosen.length
      ? say("making-controls", { controls: joined(chosen.map((key) => labels.get(key) ?? key)) })
      : say("making-controls.none");
    const gone = chosen.filter((key) => !labels.has(key)).map((key) => ({ key, label: say("making-controls.gone", { control: key }) }));
    this.controls.replaceChildren(
      ...[...gone, ...controls].map(({ key, label }) => {
        const { check, label: row } = makeCheck(label, `control ${key}`, (on) =>
          this.change({ controls: on ? [...chosen, key] : chosen.filter((one) => one !== key) }),
        );
        check.checked = chosen.includes(key);
        check.disabled = !check.checked && chosen.length >= MAX_CONTROLS;
        return row;
      }),
    );
    if (focused) /** @type {HTMLElement | null} */ (this.controls.querySelector(`[data-focus="${CSS.escape(focused)}"]`))?.focus();
  }

  /** @param {Step} step @param {LessonOffers} offers */
  showClass({ predict, goal, collect }, offers) {
    this.put(this.predict.input, "predict", predict);
    this.goal.offers = this.collect.offers = offers;
    if (this.isNew("goal", goal)) {
      this.hasGoal = goal !== null;
      this.put(this.low.input, "goal.low", goal?.low);
      this.put(this.high.input, "goal.high", goal?.high);
      this.put(this.seconds.input, "goal.seconds", goal?.seconds || null);
      this.goal.show(goal);
    } else this.goal.refresh();
    this.aims.check.checked = this.hasGoal;
    this.goal.element.hidden = !this.hasGoal;
    if (this.isNew("collect", collect)) this.collect.show(collect);
    else this.collect.refresh();
    this.collects.check.checked = collect !== null;
    this.collect.element.hidden = collect === null;
  }
}
