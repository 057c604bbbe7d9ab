// @ts-check
/**
 * The form in which the scene's lesson is made, beside the body: its steps in order, and the fields of the one that is
 * chosen. The lesson is the server's, with undo; the form shows what the server has.
 */
import { onMessage, send } from "../../wire/channel.js";
import { COMMANDS } from "../../wire/commands.js";
import { kept, store } from "../../ui/kept/storage.js";
import { make, makeButton } from "../../ui/dialog.js";
import { beginNextAt } from "../lesson/lesson.js";
import { markCanvas } from "../../ui/viser/widgets.js";
import { StepForm } from "./step_form.js";

/** @typedef {import("../../wire/wire.js").LessonForm} LessonForm */

/** Under which the browser keeps that the form is open. */
const NAME = "softrod-making";
const MAX_STEPS = 20;
/** Milliseconds between two looks whether viser has made its canvas anew. */
const LOOK_EVERY = 200;
/** Size of a phone's page. */
const PHONE = "width=390,height=844";
const ABOUT =
  "A lesson goes step by step beside the body: a question, what to do, the sliders for it. It is part of the scene: save it, download it or make a link of it in the Share tab.";

/** @type {LessonForm} */
let form = { tell: "lessonForm", open: false, trying: -1, steps: [], begins: [] };
/** @type {import("../../wire/wire.js").LessonOffers | null} */
let offers = null;
/** The step that is chosen. */
let at = 0;
/** Whether the link that comes next is to be opened as a phone's page. */
let wantsPhone = false;

/** @param {"undo" | "redo"} name */
function stepButton(name) {
  const { icon, word } = COMMANDS[name];
  const button = makeButton("", () => {
    fields.flush();
    send({ do: "perform", command: name });
  }, "softrod-making-icon");
  button.innerHTML = `<svg viewBox="0 0 24 24" aria-hidden="true"><path d="${icon}"/></svg>`;
  button.ariaLabel = word ?? name;
  return button;
}

/** @type {StepForm} */
let fields;

/** Makes the form, which is shown when the server says so. */
function begin() {
  fields = new StepForm();
  const box = make("aside", "softrod-making");
  box.ariaLabel = "Make a lesson";
  const [undo, redo] = [stepButton("undo"), stepButton("redo")];
  const title = make("h2", "", "Lesson");
  title.tabIndex = -1;
  const fold = makeButton("Hide", () => {
    const folded = box.toggleAttribute("data-folded");
    fold.textContent = folded ? "Show" : "Hide";
    fold.ariaExpanded = String(!folded);
  }, "softrod-button softrod-making-fold");
  fold.ariaExpanded = "true";
  const done = makeButton("Done", () => {
    fields.flush();
    send({ do: "makeLesson", on: false });
  });
  const head = make("header", "");
  head.append(title, undo, redo, fold, done);
  const about = make("p", "softrod-making-hint", ABOUT);
  const list = make("ol", "softrod-steps");
  const add = makeButton("Add a step", () => {
    fields.flush();
    const place = form.steps.length ? at + 1 : 0;
    send({ do: "addStep", at: place });
    go(place);
  });
  const said = make("p", "softrod-refused");
  said.setAttribute("role", "status");
  const foot = make("footer", "");
  const attempt = makeButton("Try this step", () => {
    fields.flush();
    beginNextAt(at);
    send({ do: "tryStep", step: at });
  }, "softrod-button softrod-first");
  const phone = makeButton("See as phone", () => {
    fields.flush();
    wantsPhone = true;
    send({ do: "share", pose: false, page: new URL(".", location.href).href });
  });
  const drop = makeButton("Delete lesson", () => send({ do: "dropLesson" }));
  drop.title = "Undo brings it back";
  foot.append(attempt, phone);
  const body = make("div", "softrod-making-body");
  body.append(about, list, add, said, fields.element, drop);
  box.append(head, body, foot);

  const bar = make("aside", "softrod-trying");
  bar.ariaLabel = "A step is tried";
  const seen = make("span", "");
  bar.append(seen, makeButton("Back to the form", () => send({ do: "endTrying" }), "softrod-button softrod-first"));

  /** The step that is to be chosen once the server has it. @type {number | null} */
  let wanted = null;
  /** @param {number} step */
  const go = (step) => {
    wanted = step;
    show();
  };
  /** @param {number} step */
  const choose = (step) => {
    fields.flush();
    wanted = null;
    at = step;
    said.textContent = "";
    show();
  };

  /** @param {number} i */
  const row = (i) => {
    const item = make("li", "");
    const one = makeButton(`${i + 1}. ${form.steps[i].title}`, () => choose(i), "softrod-making-title");
    one.dataset.focus = `step ${i}`;
    if (i === at) one.setAttribute("aria-current", "step");
    one.addEventListener("keydown", (event) => {
      const by = { ArrowUp: -1, ArrowDown: 1 }[event.key] ?? 0;
      const to = i + by;
      if (!by || to < 0 || to >= form.steps.length) return;
      event.preventDefault();
      if (event.altKey) move(to);
      else choose(to);
      focus(`step ${to}`);
    });
    item.append(one);
    if (i !== at) return item;
    const tools = make("div", "softrod-making-tools");
    /** @param {string} text @param {string} label @param {() => void} press @param {boolean} able */
    const tool = (text, label, press, able = true) => {
      const button = makeButton(text, () => {
        fields.flush();
        press();
      }, "softrod-button");
      button.ariaLabel = button.title = label;
      button.dataset.focus = label;
      button.disabled = !able;
      tools.append(button);
    };
    tool("↑", "Move up", () => move(at - 1), at > 0);
    tool("↓", "Move down", () => move(at + 1), at + 1 < form.steps.length);
    tool("Duplicate", "Duplicate", () => {
      send({ do: "copyStep", step: at });
      go(at + 1);
    }, form.steps.length < MAX_STEPS);
    tool("Remove", "Remove", () => {
      send({ do: "removeStep", step: at });
      focus(`step ${Math.max(0, at - 1)}`);
    });
    item.append(tools);
    return item;
  };
  /** @param {number} to */
  const move = (to) => {
    fields.flush();
    send({ do: "moveStep", step: at, to });
    go(to);
  };
  /** What is to have the focus once it is there. */
  let focused = "";
  /** @param {string} name */
  const focus = (name) => (focused = name);

  let before = "";
  const show = () => {
    const { steps, begins } = form;
    const titles = JSON.stringify(steps.map(({ title }) => title));
    // A step that was added or moved is chosen when it is in its place.
    const changed = titles !== before;
    if (wanted !== null && (changed || wanted === at)) [at, wanted] = [wanted, null];
    at = Math.max(0, Math.min(at, steps.length - 1));
    const now = `${titles} ${at}`;
    if (list.dataset.made !== now) {
      const name = focused || (list.contains(document.activeElement) ? (document.activeElement?.getAttribute("data-focus") ?? "") : "");
      list.dataset.made = now;
      list.replaceChildren(...steps.map((_, i) => row(i)));
      const again = /** @type {HTMLButtonElement | null} */ (name ? list.querySelector(`[data-focus="${name}"]`) : null);
      // What cannot be pressed any more has no focus, either.
      if (again?.disabled) /** @type {HTMLElement | null} */ (list.querySelector("[aria-current]"))?.focus();
      else again?.focus();
      focused = "";
    }
    before = titles;
    const some = steps.length > 0;
    about.hidden = some;
    add.textContent = some ? "Add a step" : "Add the first step";
    add.classList.toggle("softrod-first", !some);
    add.disabled = steps.length >= MAX_STEPS;
    fields.element.hidden = foot.hidden = drop.hidden = !some || offers === null;
    if (some && offers) fields.show(steps[at], at, begins[at] ?? "", offers);
  };

  onMessage("lessonForm", (now) => {
    const was = form;
    form = now;
    store(NAME, now.open ? "1" : "");
    const shows = now.open && now.trying < 0;
    if (shows && !box.parentNode) {
      document.body.append(box);
      title.focus();
    } else if (!shows) box.remove();
    if (now.trying >= 0) {
      seen.textContent = `Step ${now.trying + 1} as a pupil sees it`;
      if (!bar.parentNode) document.body.append(bar);
    } else bar.remove();
    document.documentElement.toggleAttribute("data-softrod-making", shows);
    // Another scene's lesson, or one that was opened just now, begins with its first step.
    if (now.open && !was.open) at = 0;
    if (shows) show();
  });
  onMessage("lessonOffers", (now) => {
    offers = now;
    if (box.parentNode) show();
  });
  onMessage("lessonTaken", (taken) => {
    if (taken.step === at || taken.step < 0) fields.hear(taken);
    else if (taken.refused) said.textContent = `Step ${taken.step + 1}: ${taken.refused} It stays as it was.`;
  });
  onMessage("versions", (versions) => {
    undo.disabled = !versions.undo;
    redo.disabled = !versions.redo;
    undo.title = versions.undo ? `Undo: ${versions.undo}` : "Nothing to undo";
    redo.title = versions.redo ? `Redo: ${versions.redo}` : "Nothing to redo";
  });
  onMessage("link", ({ link }) => {
    if (!wantsPhone || !link) return;
    wantsPhone = false;
    // By this page's own address, and without what this window has kept.
    const url = new URL(link);
    window.open(new URL(`s${url.search}${url.hash}`, new URL(".", location.href)), "_blank", `noopener,popup,${PHONE}`);
  });
  // After a reload or an outage the server has another page, which knows of no form.
  let page = "";
  onMessage("pageState", (state) => {
    if (state.page === page) return;
    page = state.page;
    if (kept(NAME) === "1") send({ do: "makeLesson", on: true });
  });
  setInterval(() => {
    if (box.parentNode) markCanvas();
  }, LOOK_EVERY);
}

/** @type {import("../../ui/feature.js").Feature<"making">} */
export default { commands: {}, begin };
