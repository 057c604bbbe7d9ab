// @ts-check
/**
 * The teacher's page: at the left what to say and do, and what comes next; at the right the class as it is, or the
 * controls of the teacher's own body. What is seldom wanted is in a menu.
 */
import { onMessage, send } from "../../wire/channel.js";
import { make, untranslated } from "../../ui/dialog.js";
import { say } from "../../words/words.js";
import { beforehand } from "./beforehand.js";
import { box, button, fold, icon, sayWith, typedAddress } from "./elements.js";
import { guide } from "./guide.js";
import { hearImports, importResults, imports } from "./imports.js";
import { OWN_BODY } from "./phases.js";
import { keepPosters } from "./poster.js";
import { Predictions } from "./prediction.js";
import { chosenSeat, counted, onChosen, present } from "./present.js";
import { Card } from "./rerender.js";
import { insertMarksLayer, onMarksRedraw, redrawMarks } from "../../stage/sight.js";

/** @typedef {import("../../wire/wire.js").Desk} Desk */
/** @typedef {import("../../wire/wire.js").Arrange} Arrange */
/** @typedef {keyof typeof PHASES} Phase */
/** @typedef {[stop: number, phase: Phase, round: number]} Place */

/** Labels of the phases on their buttons. */
const PHASES = /** @type {const} */ ({
  lobby: "desk-lobby",
  show: "desk-show",
  ask: "desk-ask",
  results: "desk-results",
  run: "desk-run",
  reveal: "desk-reveal",
  explain: "desk-explain",
  try: "desk-try",
  collect: "desk-collect",
});
/** Of those that come again. @type {Partial<Record<Phase, "desk-ask.again" | "desk-results.again">>} */
const AGAIN = { ask: "desk-ask.again", results: "desk-results.again" };
/** Phases that wait for each pupil, and how many have done it. @type {Partial<Record<Phase, "class-answered" | "class-wrote" | "class-handed-in">>} */
const WAITED = { ask: "class-answered", explain: "class-wrote", collect: "class-handed-in" };
/** Percentage of right answers below which the step is taught once more (Mazur 1997). */
const TEACH_BELOW = 35;
/** Percentage of right answers up to which pupils talk in pairs, and are asked again (Mazur 1997). */
const PAIRS_UP_TO = 70;
/** Milliseconds after which the minutes are looked at again. */
const MINUTES_EVERY = 5000;

/** @type {Desk | null} */
let desk = null;
/** When it was told, ms since the page began. */
let toldAt = 0;
/** Whether the controls of the teacher's own body are at the right, instead of the class. */
let showsControls = false;

/** Makes the teacher's part. */
export function addDesk() {
  const lead = make("aside", "softrod-class softrod-desk");
  lead.ariaLabel = say("desk-lead");
  const room = make("aside", "softrod-class softrod-desk-room");
  room.ariaLabel = say("desk-room");
  const both = box("div", "softrod-desk-parts", lead, room);
  const predictions = new Predictions({ onRedraw: onMarksRedraw, insert: insertMarksLayer, redraw: redrawMarks, at: () => null });
  const left = new Part(lead, parts, importResults);
  const right = new Part(room, present, chosenSeat);
  onMessage("predictions", ({ bodies }) => predictions.show(bodies));
  keepPosters();
  onMessage("desk", (told) => {
    if (!desk) document.body.append(both);
    [desk, toldAt] = [told, performance.now()];
    left.show();
    right.show();
  });
  document.addEventListener("pointerdown", ({ target }) => {
    const menu = /** @type {HTMLDetailsElement | null} */ (lead.querySelector(".softrod-desk-more"));
    if (menu && !menu.contains(/** @type {Node} */ (target))) menu.open = false;
  });
  setInterval(() => showMinutes(lead), MINUTES_EVERY);
  hearImports(() => left.show());
  refresh = () => left.show();
  onChosen((focus) => {
    right.show();
    right.card.focus(focus);
  });
  onMessage("classEnded", () => {
    predictions.show([]);
    room.remove();
    lead.replaceChildren(make("h2", "", say("desk-over")), make("p", "", say("desk-nothing-kept")));
  });
}

/** Shows the left-hand part again. */
let refresh = () => {};

/** One half of the page, which is remade when what it shows has changed, and is scrolled to its top in another phase. */
class Part {
  #at = "";

  /** @param {HTMLElement} element @param {(desk: Desk) => HTMLElement[]} make @param {() => unknown} more what it shows besides the class */
  constructor(element, make, more) {
    this.card = new Card(element, () => (desk ? make(desk) : []));
    this.more = more;
  }

  show() {
    this.card.defer(() => {
      if (!desk) return;
      const { stop, phase, round } = desk.asking;
      const at = `${stop} ${phase} ${round}`, { element } = this.card;
      const scrolled = at === this.#at ? element.scrollTop : 0;
      this.#at = at;
      this.card.show([{ ...desk, elapsed: 0 }, showsControls, this.more()]);
      element.scrollTop = scrolled;
    });
  }
}

/** What is at the left. @param {Desk} desk @returns {HTMLElement[]} */
function parts(desk) {
  if (desk.home) {
    const ahead = beforehand(desk);
    return [head(desk), homework(desk), ...(ahead.length ? [fold(say("desk-come-in"), ahead)] : [])];
  }
  return [head(desk), now(desk), ...beforehand(desk), ...advice(desk), actions(desk), onward(desk)];
}

/** @param {Arrange["what"]} what */
const arrange = (what) => send({ do: "arrange", what });
/** @param {Place} place */
const go = ([stop, phase, round]) => send({ do: "stage", stop, phase, round });

/** @param {Desk} desk */
function head(desk) {
  const { code, address, saved, trouble, seats } = desk;
  const letters = untranslated(make("b", "softrod-desk-code", code));
  const here = make("span", "softrod-chip", say("desk-here", { count: counted(seats) }));
  const wall = Object.assign(make("a", "softrod-small", say("desk-wall")), { href: `?room=${code}&as=wall`, target: "_blank" });
  wall.dataset.focus = "wall";
  const controls = button(say("desk-controls"), showControls, { focus: "controls", pressed: showsControls, label: say("desk-controls.label") });
  const writing = trouble ? make("b", "softrod-warning", say("desk-not-kept")) : make("span", "softrod-quiet", saved ? "" : say("desk-saving"));
  writing.title = trouble;
  const way = box("p", "softrod-quiet", ...sayWith("desk-pupils-type", { address: untranslated(make("b", "", typedAddress(address))), code }));
  const more = fold("", [box("div", "softrod-desk-menu", way, foot(desk), fold(say("desk-files"), [imports(refresh)]))], "More");
  more.classList.add("softrod-desk-more");
  const summary = /** @type {HTMLElement} */ (more.firstElementChild);
  summary.ariaLabel = say("desk-more");
  summary.append(icon("more"));
  return box("header", "", letters, here, writing, controls, wall, more);
}

/** Shows the controls of the teacher's own body, or the class again. */
function showControls() {
  showsControls = !showsControls;
  document.documentElement.toggleAttribute("data-softrod-controls", showsControls);
  document.querySelector(".softrod-desk-parts")?.scrollTo(0, 0);
  refresh();
}

/** Homework: until when, how many have done what, and which step is looked at. @param {Desk} desk */
function homework({ home, told, done, stops, asking: { stop } }) {
  const tell = () => confirm(say("desk-tell.confirm")) && arrange("tell");
  const rows = stops.map(({ title }, i) => {
    const [answered, handedIn] = done[i];
    const text = say("desk-home-step", { number: i + 1, title, answered, handed: handedIn });
    return box("li", "", button(text, () => go([i, "show", 0]), { focus: `stop${i}`, pressed: i === stop }));
  });
  return box(
    "section",
    "softrod-desk-now",
    make("h2", "", told ? say("desk-home-told") : say("desk-home-until", { date: home })),
    make("p", "", say(told ? "desk-home-told.about" : "desk-home-until.about")),
    ...(told ? [] : [button(say("desk-tell"), tell, { focus: "tell" })]),
    box("ol", "softrod-homework", ...rows),
  );
}

/** The label of a place of the plan on a button. @param {Place} place @param {number} at */
const labelOf = ([stop, phase, round], at) => (stop === at ? say((round > 0 && AGAIN[phase]) || PHASES[phase]) : say("desk-step", { number: stop + 1 }));

/** How many minutes the class has had. */
function minutes() {
  if (!desk || desk.elapsed < 0) return "";
  return say("desk-minutes", { minutes: Math.floor((desk.elapsed + (performance.now() - toldAt) / 1000) / 60) });
}

/** @param {HTMLElement} element */
function showMinutes(element) {
  const shown = element.querySelector(".softrod-desk-minutes");
  if (shown) shown.textContent = minutes();
}

/** The phases that a step goes through, as `Room.next` does. @param {Desk["stops"]} stops @param {Desk["asking"]} asking */
function wayOf(stops, asking) {
  const { stop, round, phase } = asking;
  const collects = asking.collects || asking.goal || !asking.do || phase === "collect";
  return stops[stop].phases.filter(([one, time]) => (time === 0 || round > 0) && (one !== "collect" || collects));
}

/** How far the step is. @param {Desk} desk @returns {HTMLElement[]} */
function progress({ stops, asking }) {
  const { phase, round } = asking;
  const phases = wayOf(stops, asking);
  const at = phases.findIndex(([one, time]) => one === phase && time === round);
  if (at < 0) return [];
  const bar = box("div", "softrod-desk-bar", ...phases.map((_, i) => Object.assign(make("i", ""), { className: i < at ? "softrod-past" : i === at ? "softrod-now" : "" })));
  bar.ariaHidden = "true";
  return [box("div", "softrod-desk-progress", make("span", "", say("desk-phase", { number: at + 1, phases: phases.length })), make("span", "softrod-desk-minutes", minutes()), bar)];
}

/** What the class does now, and what to say and do. @param {Desk} desk */
function now(desk) {
  const { stops, asking, seats } = desk;
  const { stop, phase, round } = asking;
  const pick = make("select", "");
  pick.ariaLabel = say("desk-steps");
  pick.dataset.focus = "step";
  stops.forEach(({ title }, i) => pick.add(new Option(`${i + 1}. ${title}`, String(i), false, i === stop)));
  pick.addEventListener("change", () => send({ do: "stage", stop: Number(pick.value), phase: "show" }));
  const words = guide(asking);
  const about = box("div", "softrod-desk-about", make("b", "", labelOf([stop, phase, round], stop)));
  about.setAttribute("role", "status");
  const waited = WAITED[phase];
  if (waited) about.append(make("span", "", say(waited, { done: seats.filter(({ here, answered }) => here && answered).length, all: counted(seats) })));
  const lines = make("dl", "softrod-desk-guide");
  lines.append(make("dt", "", say("desk-say")), make("dd", "softrod-desk-say", words.say), make("dt", "", say("desk-do")), make("dd", "", words.do));
  return box("section", "softrod-desk-now", ...(stops.length > 1 ? [pick] : []), ...progress(desk), about, lines);
}

/** Where the class came from, as the plan has it; null at its beginning. @param {Desk} desk @returns {Place | null} */
function before({ stops, asking }) {
  const { stop, phase, round } = asking;
  const way = wayOf(stops, asking);
  const at = way.findIndex(([one, time]) => one === phase && time === round);
  if (at > 0) return [stop, ...way[at - 1]];
  const last = stops[stop - 1]?.phases.at(-1);
  return at === 0 && last ? [stop - 1, ...last] : null;
}

/** Where the class goes from here; it stays in sight. @param {Desk} desk */
function onward(desk) {
  const { stops, asking: { stop, ...now }, next } = desk;
  const back = before(desk);
  const all = fold(say("desk-all-phases"), [
    box("div", "softrod-phases", ...stops[stop].phases.map(([phase, round]) => {
      const pressed = phase === now.phase && round === now.round;
      return button(labelOf([stop, phase, round], stop), () => go([stop, phase, round]), { pressed });
    })),
  ]);
  return box(
    "footer",
    "softrod-desk-onward",
    next ? button(say("desk-next", { place: labelOf(next, stop) }), () => go(next), { focus: "next", name: "softrod-strong" }) : make("p", "softrod-quiet", say("desk-last")),
    ...(back ? [button(say("desk-back"), () => go(back), { focus: "back", name: "softrod-plain", label: say("desk-back.label", { place: labelOf(back, stop) }) })] : []),
    all,
  );
}

/** What the percentage of right answers suggests, once all have answered or all see it. @param {Desk} desk @returns {HTMLElement[]} */
function advice({ asking: { stop, phase, round }, bars, right, seats, stops }) {
  const votes = bars.reduce((sum, bar) => sum + bar, 0);
  const here = seats.filter((seat) => seat.here);
  const isComplete = phase === "ask" && here.length > 0 && here.every(({ answered }) => answered);
  if (!votes || right < 0 || !(isComplete || phase === "results")) return [];
  const part = Math.round((100 * bars[right]) / votes);
  const key = part < TEACH_BELOW ? "desk-teach" : part <= PAIRS_UP_TO ? "desk-pairs" : "desk-on";
  /** @type {[number, Phase, number] | null} */
  const way = part < TEACH_BELOW ? [stop, "show", 0] : part <= PAIRS_UP_TO && round === 0 ? [stop, "ask", 1] : null;
  const isThere = way && stops[stop].phases.some(([phase, round]) => phase === way[1] && round === way[2]);
  const buttons = isThere && phase === "results" ? [button(labelOf(way, stop), () => go(way), { focus: "advice" })] : [];
  const text = votes < here.length ? say(`${key}.some`, { part, votes }) : say(key, { part });
  return [box("div", "softrod-desk-advice", make("p", "", text), ...buttons)];
}

/** What can be done with all in the present phase. @param {Desk} desk */
function actions({ asking, paused, gathered, again, law, shows_law }) {
  const replay = button(say(again === "now" ? "desk-replay.now" : "desk-replay"), () => arrange("again"), { focus: "again" });
  const giveMine = () => confirm(say("desk-give-mine.confirm")) && arrange("asMine");
  return box(
    "div",
    "softrod-phases",
    ...(again !== "no" ? [replay] : []),
    ...(OWN_BODY.has(asking.phase)
      ? [
          button(say("desk-gather"), () => arrange(gathered ? "giveBack" : "gather"), { pressed: gathered }),
          button(say("desk-pause"), () => arrange(paused ? "goOn" : "pause"), { pressed: paused }),
          button(say("desk-reset"), () => arrange("reset")),
          button(say("desk-give-mine"), giveMine),
          ...(law ? [button(say("desk-law"), () => arrange(shows_law ? "noLaw" : "law"), { pressed: shows_law })] : []),
        ]
      : []),
  );
}

/** @param {Desk} desk */
function foot({ open, own_names }) {
  return box(
    "div",
    "softrod-phases",
    button(say(open ? "desk-close" : "desk-open"), () => arrange(open ? "close" : "open")),
    button(say(own_names ? "desk-given-names" : "desk-own-names"), () => arrange(own_names ? "givenNames" : "ownNames")),
    button(say("desk-sheet"), () => arrange("sheet")),
    button(say("desk-zip"), () => arrange("zip")),
    button(say("desk-end"), () => confirm(say("desk-end.confirm")) && arrange("end")),
  );
}
