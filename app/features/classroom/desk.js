// @ts-check
/**
 * The teacher's part of the page: what comes next, what the class does now, who is there, and what was given. What is
 * seldom wanted is folded.
 */
import { onMessage, send } from "../../wire/channel.js";
import { make } from "../../ui/dialog.js";
import { beforehand } from "./beforehand.js";
import { box, button, fold, icon, typedAddress, untranslated, voteBars } from "./elements.js";
import { guide } from "./guide.js";
import { hearImports, importResults, imports } from "./imports.js";
import { keepInPlace } from "./place.js";
import { OWN_BODY } from "./phases.js";
import { plot, power } from "./plot.js";
import { keepPosters, poster, still } from "./poster.js";
import { Predictions } from "./prediction.js";
import { Card } from "./rerender.js";
import { insertMarksLayer, onMarksRedraw, redrawMarks } from "../../stage/sight.js";

/** @typedef {import("../../wire/wire.js").Desk} Desk */
/** @typedef {import("../../wire/wire.js").DeskSeat} DeskSeat */
/** @typedef {import("../../wire/wire.js").DeskAnswer} DeskAnswer */
/** @typedef {import("../../wire/wire.js").Arrange} Arrange */
/** @typedef {import("../../wire/wire.js").OneSeat} OneSeat */
/** @typedef {keyof typeof PHASES} Phase */

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
/** The answers that are listed, by kind; the bars have the votes. @type {[DeskAnswer["kind"], title: string][]} */
const LISTED = [["work", "Handed in"], ["line", "Lines"], ["prediction", "Predictions"]];
/** States of a body that its tile names; all others are moving. */
const NAMED_STATES = new Set(["at rest", "paused", "exploded", "goal reached"]);

/** The seat that is looked at alone, or 0. */
let chosen = 0;
/** @type {Desk | null} */
let desk = null;
/** @type {Card} */
let card;

/** Makes the teacher's part. */
export function addDesk() {
  const element = make("aside", "softrod-class softrod-desk");
  element.ariaLabel = "Class";
  const predictions = new Predictions({ onRedraw: onMarksRedraw, insert: insertMarksLayer, redraw: redrawMarks, at: () => null });
  card = new Card(element, () => (desk ? parts(desk) : []));
  onMessage("predictions", ({ bodies }) => predictions.show(bodies));
  keepPosters(element);
  onMessage("desk", (told) => {
    if (!desk) keepInPlace(element);
    card.defer(() => {
      desk = told;
      show();
    });
  });
  hearImports(() => card.defer(show));
  onMessage("classEnded", () => {
    predictions.show([]);
    element.replaceChildren(make("h2", "", "The class is over"), make("p", "", "Nothing that was given is kept on this computer."));
  });
}

/** The place of the class when the part was scrolled. */
let scrolledAt = "";

function show() {
  if (!desk) return;
  if (!desk.seats.some(({ number }) => number === chosen)) chosen = 0;
  const { stop, phase, round } = desk.asking;
  const at = `${stop} ${phase} ${round}`;
  // In another phase, what comes next is at the top.
  const scrolled = at === scrolledAt ? card.element.scrollTop : 0;
  scrolledAt = at;
  card.show([desk, chosen, importResults()]);
  card.element.scrollTop = scrolled;
}

/** Looks at a seat alone, or at all (0). @param {number} number */
function choose(number) {
  chosen = number;
  show();
  card.focus(number ? "[data-focus=back]" : ".softrod-seats button");
}

/** @param {Desk} desk @returns {HTMLElement[]} */
function parts(desk) {
  const seat = desk.seats.find(({ number }) => number === chosen);
  const present = seat ? alone(desk, seat) : seats(desk);
  if (desk.home) {
    return [
      head(desk),
      homework(desk),
      ...beforehand(desk),
      ...asked(desk),
      ...collected(desk),
      ...given(desk),
      present,
      fold("Answers from files", [imports(() => card.defer(show))]),
      fold("Door, names, saving, end", [foot(desk)]),
    ];
  }
  return [
    head(desk),
    now(desk),
    ...beforehand(desk),
    ...advice(desk),
    actions(desk),
    ...asked(desk),
    ...collected(desk),
    // While pupils write, their lines come first.
    ...(desk.asking.phase === "explain" ? [...given(desk), present] : [present, ...given(desk)]),
    fold("All phases of this step", [phases(desk)]),
    fold("Answers from files", [imports(() => card.defer(show))]),
    fold("Door, names, saving, end", [foot(desk)]),
  ];
}

/** @param {Arrange["what"]} what */
const arrange = (what) => send({ do: "arrange", what });
/** @param {[stop: number, phase: Phase, round: number]} place */
const go = ([stop, phase, round]) => send({ do: "stage", stop, phase, round });

/** @param {Desk} desk */
function head({ code, address, saved, trouble }) {
  const letters = untranslated(make("b", "softrod-desk-code", code));
  const wall = Object.assign(make("a", "softrod-small", "Wall"), { href: `?room=${code}&as=wall`, target: "_blank" });
  wall.dataset.focus = "wall";
  const writing = trouble ? make("b", "softrod-warning", "not kept") : make("span", "softrod-quiet", saved ? "" : "saving…");
  writing.title = trouble;
  return box("header", "", letters, untranslated(make("span", "", typedAddress(address))), writing, wall);
}

/** Homework: until when, how many have done what, and which step is looked at. @param {Desk} desk */
function homework({ home, told, done, stops, asking: { stop } }) {
  const tell = () => confirm("Tell all now what is right? What is answered from then on counts as late.") && arrange("tell");
  const rows = stops.map(({ title }, i) => {
    const [answered, handedIn] = done[i];
    const text = `${i + 1}. ${title}: ${answered} answered, ${handedIn} handed in`;
    return box("li", "", button(text, () => go([i, "show", 0]), { focus: `stop${i}`, pressed: i === stop }));
  });
  return box(
    "section",
    "softrod-desk-now",
    make("h2", "", told ? "Homework: told" : `Homework until ${home}`),
    make("p", "", told ? "All see what is right; what they answer now is late." : "Pupils come in by the address at any time, without you. What is right is told then, or when you tell it."),
    ...(told ? [] : [button("Tell what is right now", tell, { focus: "tell" })]),
    box("ol", "softrod-homework", ...rows),
  );
}

/** The label of a place of the plan on a button. @param {[number, Phase, number]} place @param {number} at */
const labelOf = ([stop, phase, round], at) => (stop === at ? `${PHASES[phase]}${round > 0 ? " again" : ""}` : `Step ${stop + 1}`);

/** What comes next, and what the class does now. @param {Desk} desk */
function now({ stops, asking, next, seats }) {
  const { stop, phase, round } = asking;
  const pick = make("select", "");
  pick.ariaLabel = "Step";
  pick.dataset.focus = "step";
  stops.forEach(({ title }, i) => pick.add(new Option(`${i + 1}. ${title}`, String(i), false, i === stop)));
  pick.addEventListener("change", () => send({ do: "stage", stop: Number(pick.value), phase: "show" }));
  const words = guide(asking);
  const about = box("p", "softrod-desk-about", make("b", "", labelOf([stop, phase, round], stop)));
  about.setAttribute("role", "status");
  if (WAITED[phase]) about.append(`: ${seats.filter(({ here, answered }) => here && answered).length} of ${counted(seats)} ${WAITED[phase]}.`);
  const lines = make("dl", "softrod-desk-guide");
  lines.append(make("dt", "", "Say"), make("dd", "softrod-desk-say", words.say), make("dt", "", "Do"), make("dd", "", words.do));
  return box(
    "section",
    "softrod-desk-now",
    ...(stops.length > 1 ? [pick] : []),
    next ? button(`Next: ${labelOf(next, stop)}`, () => go(next), { focus: "next", name: "softrod-strong" }) : make("p", "softrod-quiet", "That was the last step."),
    about,
    lines,
  );
}

/** How many pupils are waited for: those who are here. @param {DeskSeat[]} seats */
const counted = (seats) => seats.filter(({ here }) => here).length;

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
function asked({ asking: { phase, question, choices, predict }, bars, right, answers, seats }) {
  if (!question && !(predict > 0)) return [];
  const predictions = answers.filter(({ kind }) => kind === "prediction").length;
  const part = box(
    "section",
    "",
    ...(question ? [make("p", "", question), voteBars(choices, bars, right)] : []),
    ...(predict > 0 ? [make("p", "softrod-quiet", `${predictions} of ${counted(seats)} have dragged a prediction.`)] : []),
  );
  return [phase === "ask" || phase === "results" || desk?.home ? part : fold("The question", [part])];
}

/** What a tile says of a seat, beside its name. @param {DeskSeat} seat @param {boolean} hasOwn whether it has a body of its own */
function state({ here, follows, doing }, hasOwn) {
  if (!here) return "away";
  if (hasOwn && follows) return "looks at yours";
  return hasOwn && NAMED_STATES.has(doing) ? doing : "";
}

/** The name of a seat as it is shown. @param {keyof HTMLElementTagNameMap} kind @param {DeskSeat} seat @param {string} [more] */
function nameOf(kind, { name, two, hand }, more = "") {
  const label = untranslated(make(kind, "", `${name}${two ? " (two)" : ""}${more}`));
  if (hand) label.append(icon("hand"));
  return label;
}

/** @param {Desk} desk */
function seats({ seats, asking, seat_on_wall, gathered }) {
  const hasOwn = OWN_BODY.has(asking.phase);
  const up = seats.filter(({ hand }) => hand).map(({ name }) => name);
  const tiles = seats.map((seat) => {
    const { number, name, color, here, two, hand, answered } = seat;
    const said = [state(seat, hasOwn && !gathered), number === seat_on_wall ? "on the wall" : ""].filter(Boolean).join(", ");
    const label = [name, two ? "two" : "", said, answered ? "has answered" : "", hand ? "hand is up" : ""].filter(Boolean).join(", ");
    const tile = button("", () => choose(number), { focus: `seat${number}`, name: "softrod-tile", label });
    if (hasOwn) tile.append(poster(number));
    tile.append(nameOf("span", seat, answered ? " ✓" : ""));
    if (said) tile.append(make("small", "", said));
    const item = box("li", "", tile);
    item.style.setProperty("--softrod-seat", color);
    item.toggleAttribute("data-away", !here);
    return item;
  });
  return box(
    "section",
    "",
    make("h3", "", `${seats.filter(({ here }) => here).length} of ${seats.length} are here`),
    ...(up.length ? [box("p", "softrod-desk-hands", icon("hand"), up.join(", "))] : []),
    box("ul", hasOwn ? "softrod-seats softrod-tiles" : "softrod-seats", ...tiles),
  );
}

/** One seat, larger, and what can be done with it. @param {Desk} desk @param {DeskSeat} seat */
function alone({ asking, seat_on_wall, answers, gathered }, seat) {
  const { number, name, color, digits, doing } = seat;
  const hasOwn = OWN_BODY.has(asking.phase);
  const isShown = seat_on_wall === number;
  /** @param {OneSeat["what"]} what */
  const act = (what) => send({ do: "oneSeat", seat: number, what });
  const own = hasOwn ? [button("Put on the wall", () => act(isShown ? "hide" : "show"), { pressed: isShown }), button("Reset this one", () => act("reset"))] : [];
  const said = state(seat, hasOwn && !gathered) || (hasOwn ? doing : "");
  const part = box(
    "section",
    "softrod-desk-seat",
    box("header", "", nameOf("h3", seat), make("span", "softrod-quiet", said), button("Back to all", () => choose(0), { focus: "back" })),
    ...(hasOwn ? [poster(number)] : []),
    box(
      "div",
      "softrod-phases",
      ...own,
      button(digits ? `On the other device: ${digits}` : "Move to another device", () => act("move")),
      button("Remove", () => confirm(`Close the seat of ${name}? What it gave goes, too.`) && act("sendAway")),
    ),
    ...(digits ? [make("p", "softrod-quiet", `There, come in, choose “This seat” and type ${digits}.`)] : []),
    ...answers.filter((answer) => answer.seat === number).map((answer) => make("p", "", `Gave: ${wordsOf(answer, asking.choices)}`)),
  );
  part.style.setProperty("--softrod-seat", color);
  return part;
}

/** An answer in words. @param {DeskAnswer} answer @param {string[]} choices of the question */
function wordsOf({ kind, text, choice, late, doubt }, choices) {
  const what = { vote: choices[choice] ?? "", prediction: "a prediction", line: text, work: text || "a run" }[kind];
  return `${what}${late ? " (late)" : ""}${doubt && `: ${doubt}`}`;
}

/** The answers that are listed. @param {Desk} desk */
function given({ answers, seats, on_wall, asking }) {
  return LISTED.flatMap(([kind, title]) => {
    const items = answers.filter((answer) => answer.kind === kind).map((answer) => item(answer, seats, on_wall));
    const list = box("ul", "softrod-lines", ...items);
    // The lines are open while they are written; predictions are over the body already.
    return !items.length ? [] : [kind === "line" && asking.phase === "explain" ? list : fold(`${title}: ${items.length}`, [list], title)];
  });
}

/** The class's plot. @param {Desk} desk */
function collected({ answers, asking, over, turned, law, shows_law }) {
  const found = answers.flatMap(({ setting, found, doubt }) => (setting === null || found === null || doubt ? [] : [{ setting, found }]));
  if (!found.length || (asking.phase !== "collect" && !desk?.home)) return [];
  const words = law && shows_law ? [make("p", "", power(law, asking.collects, over))] : [];
  return [box("section", "", plot(found, over, asking.collects, { law: shows_law ? law : null, turned }), ...words)];
}

/** @param {DeskAnswer} answer @param {DeskSeat[]} seats @param {string} on_wall */
function item(answer, seats, on_wall) {
  const { id, seat, kind, starred, places } = answer;
  const { name = "", color = "" } = seats.find(({ number }) => number === seat) ?? {};
  const isShown = on_wall === id;
  const what = kind === "prediction" ? `the prediction of ${name} alone` : `the body of ${name}`;
  const item = box(
    "li",
    "",
    ...(places.length ? [still(places)] : []),
    make("span", "", `${name}: ${wordsOf(answer, [])}`),
    kind === "line"
      ? button("", () => send({ do: "star", answer: id, on: !starred }), {
          focus: `star${id}`, name: "softrod-cross", label: `Show this line on the wall, by ${name}`, pressed: starred, icon: "star",
        })
      : button("Wall", () => send({ do: "toWall", answer: isShown ? "" : id }), { focus: `wall${id}`, label: `Show ${what} on the wall`, pressed: isShown }),
  );
  item.style.setProperty("--softrod-seat", color);
  return item;
}

/** All phases of the present step. @param {Desk} desk */
function phases({ stops, asking: { stop, ...now } }) {
  const buttons = stops[stop].phases.map(([phase, round]) =>
    button(labelOf([stop, phase, round], stop), () => go([stop, phase, round]), { pressed: phase === now.phase && round === now.round }),
  );
  return box("div", "softrod-phases", ...buttons);
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
