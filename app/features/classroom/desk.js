// @ts-check
/**
 * The teacher's part of the page: what comes next, what the class does now, who is there, and what was given. What is
 * seldom wanted is folded.
 */
import { onMessage, send } from "../../wire/channel.js";
import { make, makeButton } from "../../ui/dialog.js";
import { betweenPresses } from "./anew.js";
import { brought, broughtSoFar, hearBrought } from "./brought.js";
import { Ghosts } from "./ghost.js";
import { beforehand } from "./beforehand.js";
import { icon } from "./icons.js";
import { keepInPlace } from "./place.js";
import { plot, power } from "./plot.js";
import { keepPosters, poster, still } from "./poster.js";
import { voted } from "./wall.js";

/** @typedef {import("../../wire/wire.js").Desk} Desk */
/** @typedef {import("../../wire/wire.js").DeskSeat} DeskSeat */
/** @typedef {import("../../wire/wire.js").DeskAnswer} DeskAnswer */
/** @typedef {import("../../wire/wire.js").Arrange} Arrange */
/** @typedef {import("../../wire/wire.js").OneSeat} OneSeat */
/** @typedef {keyof typeof PHASES} Phase */

/** What each phase is called on its button. */
const PHASES = {
  lobby: "Come in",
  show: "Look at me",
  ask: "Ask",
  results: "Show answers",
  run: "Run it",
  explain: "Explain in a line",
  try: "Let them try",
  collect: "Collect",
};
/** What the class does in it. */
const ABOUT = {
  lobby: "Put the wall on the projector: they come in by its code.",
  show: "All look at your body: what you do with it, they see.",
  ask: "Each one answers, unseen by the others.",
  results: "All see what was answered, without names.",
  run: "All see the same run.",
  explain: "Each one writes a line. Star those that the wall is to show: it does as soon as you go on.",
  try: "Each one has a body of their own.",
  collect: "Each one hands in what they found.",
};
/** Phases in which each pupil has a body of their own. @type {Phase[]} */
const FREE = ["try", "collect"];
/** Phases that wait for something from each pupil. @type {Phase[]} */
const WAITS = ["ask", "explain", "collect"];
/** Part of right answers, %, below which it is taught once more, and up to which they talk in pairs (Mazur 1997). */
const [TEACH, PAIRS] = [35, 70];
/** What is given beside votes, and its title. @type {[DeskAnswer["kind"], string][]} */
const KINDS = [["work", "Handed in"], ["line", "Lines"], ["ghost", "Predictions"]];
/** What a tile says of a body; what all do is not said. */
const TOLD = new Set(["at rest", "paused", "exploded", "goal reached"]);

/** The seat that is looked at alone, or 0. */
let chosen = 0;
/** Names of what is folded out. @type {Set<string>} */
const open = new Set();

/** Makes the teacher's part. */
export function addDesk() {
  const desk = make("aside", "softrod-class softrod-desk");
  desk.ariaLabel = "Class";
  const ghosts = new Ghosts();
  const anew = betweenPresses(desk);
  let made = "";
  let place = "";
  /** @type {Desk | null} */
  let last = null;
  onMessage("predictions", ({ bodies }) => ghosts.show(bodies));
  keepPosters(desk);
  /** @param {Desk} told */
  const show = (told) => {
    if (!desk.isConnected && !made) keepInPlace(desk);
    if (!told.seats.some(({ number }) => number === chosen)) chosen = 0;
    last = told;
    const now = JSON.stringify([told, chosen, broughtSoFar()]);
    if (now === made) return;
    made = now;
    const focused = document.activeElement?.getAttribute("data-focus");
    const { stop, phase, round } = told.asking;
    const at = `${stop} ${phase} ${round}`;
    // What comes next is at the top.
    const scrolled = at === place ? desk.scrollTop : 0;
    place = at;
    desk.replaceChildren(...parts(told, () => anew(again), (seat) => {
      chosen = seat;
      show(told);
      /** @type {HTMLElement | null} */ (desk.querySelector(seat ? "[data-focus=back]" : ".softrod-seats button"))?.focus();
    }));
    desk.scrollTop = scrolled;
    if (focused) /** @type {HTMLElement | null} */ (desk.querySelector(`[data-focus="${focused}"]`))?.focus();
  };
  const again = () => last && show(last);
  onMessage("desk", (told) => anew(() => show(told)));
  hearBrought(() => anew(again));
  onMessage("classEnded", () => {
    ghosts.show([]);
    desk.replaceChildren(make("h2", "", "The class is over"), make("p", "", "Nothing that was given is kept on this computer."));
  });
}

/** @param {Desk} desk @param {() => void} changed @param {(seat: number) => void} choose @returns {HTMLElement[]} */
function parts(desk, changed, choose) {
  const seat = desk.seats.find(({ number }) => number === chosen);
  const present = seat ? alone(desk, seat, choose) : seats(desk, choose);
  return [
    head(desk),
    now(desk),
    ...beforehand(desk),
    ...advice(desk),
    actions(desk),
    ...asked(desk),
    ...collected(desk),
    // While they write, what they write is looked at first.
    ...(desk.asking.phase === "explain" ? [...given(desk), present] : [present, ...given(desk)]),
    fold("All phases of this step", phases(desk)),
    fold("Answers from files", brought(changed)),
    fold("Door, names, saving, end", foot(desk)),
  ];
}

/** A button that keeps the focus when the part is made anew. @param {string} text @param {() => void} press @param {string} [name] */
function button(text, press, name = "softrod-small") {
  const made = makeButton(text, press, name);
  made.dataset.focus = text;
  return made;
}

/** A part that is folded until it is wanted. @param {string} title @param {HTMLElement} content @param {string} [name] by which it is known again */
function fold(title, content, name = title) {
  const box = make("details", "");
  const summary = make("summary", "", title);
  summary.dataset.focus = name;
  box.open = open.has(name);
  box.addEventListener("toggle", () => (box.open ? open.add(name) : open.delete(name)));
  box.append(summary, content);
  return box;
}

/** @param {Arrange["what"]} what */
const arrange = (what) => send({ do: "arrange", what });

/** @param {Desk} desk */
function head({ code, address, saved, trouble }) {
  const box = make("header", "");
  const letters = make("b", "softrod-desk-code", code);
  const typed = make("span", "", address.replace(/^http:\/\/|\/$/g, ""));
  letters.translate = typed.translate = false;
  box.append(letters, typed);
  const wall = make("a", "softrod-small", "Wall");
  wall.href = `?room=${code}&as=wall`;
  wall.target = "_blank";
  wall.dataset.focus = "wall";
  const writing = trouble ? make("b", "softrod-warning", "not kept") : make("span", "softrod-quiet", saved ? "" : "saving…");
  writing.title = trouble;
  box.append(writing, wall);
  return box;
}

/** A place of the plan, as a button calls it. @param {[number, Phase, number]} place @param {number} at */
const called = ([stop, phase, round], at) => (stop === at ? `${PHASES[phase]}${round > 0 ? " again" : ""}` : `Step ${stop + 1}`);

/** What comes next, and what the class does now. @param {Desk} desk */
function now(desk) {
  const { stops, asking, next, seats } = desk;
  const box = make("section", "softrod-desk-now");
  const pick = make("select", "");
  pick.ariaLabel = "Step";
  pick.dataset.focus = "step";
  stops.forEach(({ title }, i) => {
    const option = make("option", "", `${i + 1}. ${title}`);
    option.value = String(i);
    option.selected = i === asking.stop;
    pick.append(option);
  });
  pick.addEventListener("change", () => send({ do: "stage", stop: Number(pick.value), phase: "show" }));
  if (stops.length > 1) box.append(pick);
  if (next) {
    const go = button(`Next: ${called(next, asking.stop)}`, () => send({ do: "stage", stop: next[0], phase: next[1], round: next[2] }), "softrod-strong");
    go.dataset.focus = "next";
    box.append(go);
  } else box.append(make("p", "softrod-quiet", "That was the last step."));
  const about = make("p", "softrod-desk-about");
  about.setAttribute("role", "status");
  about.append(make("b", "", called([asking.stop, asking.phase, asking.round], asking.stop)), ` – ${ABOUT[asking.phase]}`);
  if (WAITS.includes(asking.phase)) about.append(` ${seats.filter(({ answered }) => answered).length} of ${counted(seats)} have.`);
  if (asking.phase === "run" && asking.predict > 0) about.append(` It stands at ${asking.predict} s.`);
  box.append(about);
  return box;
}

/** How many there are to wait for: who left without an answer is not one of them. @param {DeskSeat[]} seats */
const counted = (seats) => seats.filter(({ here, answered }) => here || answered).length;

/** What the part of right answers means, once all have answered or all see it. @param {Desk} desk @returns {HTMLElement[]} */
function advice({ asking, bars, right, seats, stops }) {
  const votes = bars.reduce((sum, bar) => sum + bar, 0);
  const here = seats.filter((seat) => seat.here);
  const complete = asking.phase === "ask" && here.length > 0 && here.every(({ answered }) => answered);
  if (!votes || right < 0 || !(complete || asking.phase === "results")) return [];
  const part = Math.round((100 * bars[right]) / votes);
  const text = part < TEACH ? "teach it once more" : part <= PAIRS ? "let them talk in pairs, then ask again" : "go on";
  const box = make("div", "softrod-desk-advice");
  box.append(make("p", "", `${part} % right: ${text}.`));
  /** @type {[Phase, number] | null} */
  const way = part < TEACH ? ["show", 0] : part <= PAIRS && asking.round === 0 ? ["ask", 1] : null;
  if (way && asking.phase === "results" && stops[asking.stop].phases.some(([phase, round]) => phase === way[0] && round === way[1])) {
    const [phase, round] = way;
    const go = button(called([asking.stop, phase, round], asking.stop), () => send({ do: "stage", stop: asking.stop, phase, round }));
    go.dataset.focus = "advice";
    box.append(go);
  }
  return [box];
}

/** What can be done in the present phase with all. @param {Desk} desk */
function actions({ asking, paused, gathered, again, law, shows_law }) {
  const row = make("div", "softrod-phases");
  if (again !== "no") {
    const slowly = button(again === "now" ? "Slowly, from the start…" : "Again, slowly", () => arrange("again"));
    slowly.dataset.focus = "again";
    row.append(slowly);
  }
  if (!FREE.includes(asking.phase)) return row;
  const gather = button("All look at mine", () => arrange(gathered ? "giveBack" : "gather"));
  gather.ariaPressed = String(gathered);
  const stand = button("Pause all", () => arrange(paused ? "goOn" : "pause"));
  stand.ariaPressed = String(paused);
  row.append(
    gather,
    stand,
    button("Reset all", () => arrange("reset")),
    button("Give all mine", () => confirm("Give each one your body as it is now? What they have is gone.") && arrange("asMine")),
  );
  if (law) {
    const show = button("Show the law", () => arrange(shows_law ? "noLaw" : "law"));
    show.ariaPressed = String(shows_law);
    row.append(show);
  }
  return row;
}

/** @param {Desk} desk */
function asked({ asking, bars, right, answers, seats }) {
  const now = asking.phase === "ask" || asking.phase === "results";
  if (!asking.question && !(asking.predict > 0)) return [];
  const box = make("section", "");
  if (asking.question) box.append(make("p", "", asking.question), voted(asking.choices, bars, right));
  const ghosts = answers.filter(({ kind }) => kind === "ghost").length;
  if (asking.predict > 0) box.append(make("p", "softrod-quiet", `${ghosts} of ${counted(seats)} have dragged a prediction.`));
  return [now ? box : fold("The question", box)];
}

/** What a tile says of a seat, beside its name. @param {DeskSeat} seat @param {boolean} own whether it has a body */
function state({ here, follows, doing }, own) {
  if (!here) return "away";
  if (own && follows) return "looks at yours";
  return own && TOLD.has(doing) ? doing : "";
}

/** @param {Desk} desk @param {(seat: number) => void} choose */
function seats({ seats, asking, seat_on_wall, gathered }, choose) {
  const own = FREE.includes(asking.phase);
  const box = make("section", "");
  const here = seats.filter((seat) => seat.here).length;
  box.append(make("h3", "", `${here} of ${seats.length} are here`));
  const up = seats.filter(({ hand }) => hand).map(({ name }) => name);
  if (up.length) {
    const hands = make("p", "softrod-desk-hands");
    hands.append(icon("hand"), up.join(", "));
    box.append(hands);
  }
  const grid = make("ul", own ? "softrod-seats softrod-tiles" : "softrod-seats");
  for (const seat of seats) {
    const { number, name, color, here, two, hand, answered } = seat;
    const item = make("li", "");
    item.style.setProperty("--softrod-seat", color);
    item.toggleAttribute("data-away", !here);
    const tile = button("", () => choose(number), "softrod-tile");
    tile.dataset.focus = `seat${number}`;
    if (own) tile.append(poster(number));
    const label = make("span", "", `${name}${two ? " (two)" : ""}${answered ? " ✓" : ""}`);
    label.translate = false;
    if (hand) label.append(icon("hand"));
    tile.append(label);
    const said = [state(seat, own && !gathered), number === seat_on_wall ? "on the wall" : ""].filter(Boolean).join(", ");
    if (said) tile.append(make("small", "", said));
    tile.ariaLabel = [name, two ? "two" : "", said, answered ? "has answered" : "", hand ? "hand is up" : ""].filter(Boolean).join(", ");
    item.append(tile);
    grid.append(item);
  }
  box.append(grid);
  return box;
}

/** One seat, larger, and what can be done with it. @param {Desk} desk @param {DeskSeat} seat @param {(seat: number) => void} choose */
function alone({ asking, seat_on_wall, answers, gathered }, seat, choose) {
  const { number, name, color, digits, two, hand } = seat;
  const own = FREE.includes(asking.phase);
  const box = make("section", "softrod-desk-seat");
  box.style.setProperty("--softrod-seat", color);
  const back = button("Back to all", () => choose(0));
  back.dataset.focus = "back";
  const title = make("h3", "", `${name}${two ? " (two)" : ""}`);
  title.translate = false;
  if (hand) title.append(icon("hand"));
  const said = state(seat, own && !gathered);
  const row = make("header", "");
  row.append(title, make("span", "softrod-quiet", said || (own ? seat.doing : "")), back);
  box.append(row);
  if (own) box.append(poster(number));
  /** @param {OneSeat["what"]} what */
  const act = (what) => send({ do: "oneSeat", seat: number, what });
  const acts = make("div", "softrod-phases");
  if (own) {
    const shown = seat_on_wall === number;
    const wall = button("Put on the wall", () => act(shown ? "hide" : "show"));
    wall.ariaPressed = String(shown);
    acts.append(wall, button("Reset this one", () => act("reset")));
  }
  acts.append(
    button(digits ? `On the other device: ${digits}` : "Move to another device", () => act("move")),
    button("Remove", () => confirm(`Close the seat of ${name}? What it gave goes, too.`) && act("sendAway")),
  );
  box.append(acts);
  if (digits) box.append(make("p", "softrod-quiet", `There, come in, choose “This seat” and type ${digits}.`));
  for (const { kind, text, choice, late } of answers.filter((answer) => answer.seat === number)) {
    const what = { vote: asking.choices[choice] ?? "", ghost: "a prediction", line: text, work: text || "a run" }[kind];
    box.append(make("p", "", `Gave: ${what}${late ? " (late)" : ""}`));
  }
  return box;
}

/** What was given, but for votes. @param {Desk} desk */
function given({ answers, seats, on_wall, asking }) {
  /** @param {DeskAnswer["kind"]} wanted */
  const list = (wanted) => {
    const list = make("ul", "softrod-lines");
    for (const answer of answers) if (answer.kind === wanted) list.append(item(answer, seats, on_wall));
    return list;
  };
  const lists = [];
  for (const [kind, title] of KINDS) {
    const made = list(kind);
    if (!made.children.length) continue;
    // The lines are open while they are written; predictions are on the body already.
    if (kind === "line" && asking.phase === "explain") lists.push(made);
    else lists.push(fold(`${title}: ${made.children.length}`, made, title));
  }
  return lists;
}

/** The class's plot. @param {Desk} desk */
function collected({ answers, asking, over, law, shows_law }) {
  const found = answers.flatMap(({ setting, found, doubt }) => (setting === null || found === null || doubt ? [] : [{ setting, found }]));
  if (!found.length || asking.phase !== "collect") return [];
  const box = make("section", "");
  box.append(plot(found, over, asking.collects, shows_law ? law : null));
  if (law && shows_law) box.append(make("p", "", power(law, asking.collects, over)));
  return [box];
}

/** @param {DeskAnswer} answer @param {DeskSeat[]} seats @param {string} on_wall */
function item({ id, seat, kind, text, late, starred, doubt, places }, seats, on_wall) {
  const item = make("li", "");
  const { name = "", color = "" } = seats.find(({ number }) => number === seat) ?? {};
  item.style.setProperty("--softrod-seat", color);
  if (places.length) item.append(still(places));
  item.append(make("span", "", `${name}: ${kind === "ghost" ? "a prediction" : text || "a run"}${late ? " (late)" : ""}${doubt && `: ${doubt}`}`));
  if (kind === "line") {
    const star = button("", () => send({ do: "star", answer: id, on: !starred }), "softrod-cross");
    star.append(icon("star"));
    star.ariaLabel = `Show this line on the wall, by ${name}`;
    star.ariaPressed = String(starred);
    star.dataset.focus = `star${id}`;
    item.append(star);
  } else {
    const shown = on_wall === id;
    const wall = button("Wall", () => send({ do: "toWall", answer: shown ? "" : id }));
    wall.ariaLabel = kind === "ghost" ? `Show the prediction of ${name} alone on the wall` : `Show the body of ${name} on the wall`;
    wall.ariaPressed = String(shown);
    wall.dataset.focus = `wall${id}`;
    item.append(wall);
  }
  return item;
}

/** All phases of the present step. @param {Desk} desk */
function phases({ stops, asking }) {
  const row = make("div", "softrod-phases");
  for (const [phase, round] of stops[asking.stop].phases) {
    const one = button(called([asking.stop, phase, round], asking.stop), () => send({ do: "stage", stop: asking.stop, phase, round }));
    one.ariaPressed = String(phase === asking.phase && round === asking.round);
    row.append(one);
  }
  return row;
}

/** @param {Desk} desk */
function foot({ open, own_names }) {
  const box = make("div", "softrod-phases");
  box.append(
    button(open ? "Close the door" : "Open the door", () => arrange(open ? "close" : "open")),
    button(own_names ? "Names by us" : "Let them type names", () => arrange(own_names ? "givenNames" : "ownNames")),
    button("Save all as a zip", () => arrange("zip")),
    button("End", () => confirm("End the class? Everything that was given is deleted.") && arrange("end")),
  );
  return box;
}
