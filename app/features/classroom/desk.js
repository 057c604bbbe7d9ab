// @ts-check
/**
 * The teacher's page: at the left what to say and do, and what comes next; at the right the class as it is, or the
 * controls of the teacher's own body. What is seldom wanted is in a menu.
 */
import { onMessage, send } from "../../wire/channel.js";
import { make } from "../../ui/dialog.js";
import { beforehand } from "./beforehand.js";
import { box, button, fold, icon, typedAddress, untranslated } from "./elements.js";
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
const PHASES = {
  lobby: "Come in",
  show: "Look at me",
  ask: "Ask",
  results: "Show answers",
  run: "Run it",
  reveal: "Reveal",
  explain: "Explain in a line",
  try: "Let them try",
  collect: "Collect",
};
/** Phases that wait for each pupil, and what for. @type {Partial<Record<Phase, string>>} */
const WAITED = { ask: "have answered", explain: "have written a line", collect: "have handed in" };
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
  lead.ariaLabel = "What to say and do";
  const room = make("aside", "softrod-class softrod-desk-room");
  room.ariaLabel = "The class";
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
    lead.replaceChildren(make("h2", "", "The class is over"), make("p", "", "Nothing that was given is kept on this computer."));
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
    return [head(desk), homework(desk), ...(ahead.length ? [fold("How pupils come in", ahead)] : [])];
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
  const here = make("span", "softrod-chip", `${counted(seats)} here`);
  const wall = Object.assign(make("a", "softrod-small", "Wall"), { href: `?room=${code}&as=wall`, target: "_blank" });
  wall.dataset.focus = "wall";
  const controls = button("Controls", showControls, { focus: "controls", pressed: showsControls, label: "Controls of my own body" });
  const writing = trouble ? make("b", "softrod-warning", "not kept") : make("span", "softrod-quiet", saved ? "" : "saving…");
  writing.title = trouble;
  const way = box("p", "softrod-quiet", "Pupils type ", untranslated(make("b", "", typedAddress(address))), ` and ${code}.`);
  const more = fold("", [box("div", "softrod-desk-menu", way, foot(desk), fold("Answers from files", [imports(refresh)]))], "More");
  more.classList.add("softrod-desk-more");
  const summary = /** @type {HTMLElement} */ (more.firstElementChild);
  summary.ariaLabel = "More";
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
  const tell = () => confirm("Tell everybody the right answers now? What comes in after that counts as late.") && arrange("tell");
  const rows = stops.map(({ title }, i) => {
    const [answered, handedIn] = done[i];
    const text = `${i + 1}. ${title}: ${answered} answered, ${handedIn} handed in`;
    return box("li", "", button(text, () => go([i, "show", 0]), { focus: `stop${i}`, pressed: i === stop }));
  });
  return box(
    "section",
    "softrod-desk-now",
    make("h2", "", told ? "Homework: answers told" : `Homework until ${home}`),
    make("p", "", told ? "Everybody sees the right answers. What comes in now counts as late." : "Pupils come in at any time, without you. They see the right answers then, or as soon as you tell them."),
    ...(told ? [] : [button("Tell the right answers now", tell, { focus: "tell" })]),
    box("ol", "softrod-homework", ...rows),
  );
}

/** The label of a place of the plan on a button. @param {Place} place @param {number} at */
const labelOf = ([stop, phase, round], at) => (stop === at ? `${PHASES[phase]}${round > 0 ? " again" : ""}` : `Step ${stop + 1}`);

/** How many minutes the class has had. */
function minutes() {
  if (!desk || desk.elapsed < 0) return "";
  return `${Math.floor((desk.elapsed + (performance.now() - toldAt) / 1000) / 60)} min so far`;
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
  return [box("div", "softrod-desk-progress", make("span", "", `Phase ${at + 1} of ${phases.length}`), make("span", "softrod-desk-minutes", minutes()), bar)];
}

/** What the class does now, and what to say and do. @param {Desk} desk */
function now(desk) {
  const { stops, asking, seats } = desk;
  const { stop, phase, round } = asking;
  const pick = make("select", "");
  pick.ariaLabel = "Step";
  pick.dataset.focus = "step";
  stops.forEach(({ title }, i) => pick.add(new Option(`${i + 1}. ${title}`, String(i), false, i === stop)));
  pick.addEventListener("change", () => send({ do: "stage", stop: Number(pick.value), phase: "show" }));
  const words = guide(asking);
  const about = box("div", "softrod-desk-about", make("b", "", labelOf([stop, phase, round], stop)));
  about.setAttribute("role", "status");
  if (WAITED[phase]) about.append(make("span", "", `${seats.filter(({ here, answered }) => here && answered).length} of ${counted(seats)} ${WAITED[phase]}`));
  const lines = make("dl", "softrod-desk-guide");
  lines.append(make("dt", "", "Say"), make("dd", "softrod-desk-say", words.say), make("dt", "", "Do"), make("dd", "", words.do));
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
  const all = fold("All phases", [
    box("div", "softrod-phases", ...stops[stop].phases.map(([phase, round]) => {
      const pressed = phase === now.phase && round === now.round;
      return button(labelOf([stop, phase, round], stop), () => go([stop, phase, round]), { pressed });
    })),
  ]);
  return box(
    "footer",
    "softrod-desk-onward",
    next ? button(`Next: ${labelOf(next, stop)}`, () => go(next), { focus: "next", name: "softrod-strong" }) : make("p", "softrod-quiet", "That was the last step."),
    ...(back ? [button("Back", () => go(back), { focus: "back", name: "softrod-plain", label: `Back to: ${labelOf(back, stop)}` })] : []),
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
  const text = part < TEACH_BELOW ? "teach it once more" : part <= PAIRS_UP_TO ? "let them talk in pairs, then ask again" : "go on";
  /** @type {[number, Phase, number] | null} */
  const way = part < TEACH_BELOW ? [stop, "show", 0] : part <= PAIRS_UP_TO && round === 0 ? [stop, "ask", 1] : null;
  const isThere = way && stops[stop].phases.some(([phase, round]) => phase === way[1] && round === way[2]);
  const buttons = isThere && phase === "results" ? [button(labelOf(way, stop), () => go(way), { focus: "advice" })] : [];
  const some = votes < here.length ? ` of the ${votes} who have answered` : "";
  return [box("div", "softrod-desk-advice", make("p", "", `${part} % right${some}: ${text}.`), ...buttons)];
}

/** What can be done with all in the present phase. @param {Desk} desk */
function actions({ asking, paused, gathered, again, law, shows_law }) {
  const replay = button(again === "now" ? "Slowly, from the start…" : "Again, slowly", () => arrange("again"), { focus: "again" });
  const giveMine = () => confirm("Give each one your body as it is now? What they have is gone.") && arrange("asMine");
  return box(
    "div",
    "softrod-phases",
    ...(again !== "no" ? [replay] : []),
    ...(OWN_BODY.has(asking.phase)
      ? [
          button("All look at mine", () => arrange(gathered ? "giveBack" : "gather"), { pressed: gathered }),
          button("Pause all", () => arrange(paused ? "goOn" : "pause"), { pressed: paused }),
          button("Reset all", () => arrange("reset")),
          button("Give all mine", giveMine),
          ...(law ? [button("Show the law", () => arrange(shows_law ? "noLaw" : "law"), { pressed: shows_law })] : []),
        ]
      : []),
  );
}

/** @param {Desk} desk */
function foot({ open, own_names }) {
  return box(
    "div",
    "softrod-phases",
    button(open ? "Close the door" : "Open the door", () => arrange(open ? "close" : "open")),
    button(own_names ? "Names by us" : "Let them type names", () => arrange(own_names ? "givenNames" : "ownNames")),
    button("Save a sheet to print", () => arrange("sheet")),
    button("Save all as a zip", () => arrange("zip")),
    button("End", () => confirm("End the class? Everything that was given is deleted.") && arrange("end")),
  );
}
