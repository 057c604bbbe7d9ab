// @ts-check
/** The right-hand part of the teacher's page: the class as it is. Who is there, what their bodies do, and what they gave. */
import { send } from "../../wire/channel.js";
import { make, untranslated } from "../../ui/dialog.js";
import { isolated, joined, say } from "../../words/words.js";
import { box, button, fold, icon, voteBars } from "./elements.js";
import { OWN_BODY, PREDICTED } from "./phases.js";
import { plot, power } from "./plot.js";
import { poster, still } from "./poster.js";

/** @typedef {import("../../wire/wire.js").Desk} Desk */
/** @typedef {import("../../wire/wire.js").DeskSeat} DeskSeat */
/** @typedef {import("../../wire/wire.js").DeskAnswer} DeskAnswer */
/** @typedef {import("../../wire/wire.js").OneSeat} OneSeat */

/** The answers that are listed, by kind; the bars have the votes. @type {[DeskAnswer["kind"], title: "desk-work" | "desk-lines" | "desk-predictions"][]} */
const LISTED = [["work", "desk-work"], ["line", "desk-lines"], ["prediction", "desk-predictions"]];
/** What bodies do. @satisfies {Record<Exclude<DeskSeat["doing"], "">, string>} */
const DOING = /** @type {const} */ ({
  moving: "desk-moving",
  untouched: "desk-untouched",
  "at rest": "desk-at-rest",
  paused: "desk-paused",
  exploded: "desk-exploded",
  "goal reached": "desk-goal-reached",
});

/** The seat that is looked at alone, or 0. */
let chosen = 0;
/** Shows the part again. */
let again = () => {};

/** Has it shown again whenever another seat is looked at. @param {(focus: string) => void} show gets what is to have the focus */
export function onChosen(show) {
  again = () => show(chosen ? "[data-focus=allSeats]" : ".softrod-seats button");
}

/** The seat that is looked at alone, or 0. */
export const chosenSeat = () => chosen;

/** Looks at a seat alone, or at all (0). @param {number} number */
function choose(number) {
  chosen = number;
  again();
}

/** What there is to see of the class. @param {Desk} desk @returns {HTMLElement[]} */
export function present(desk) {
  if (!desk.seats.some(({ number }) => number === chosen)) chosen = 0;
  const seat = desk.seats.find(({ number }) => number === chosen);
  const who = seat ? alone(desk, seat) : seats(desk);
  const { phase } = desk.asking;
  // While pupils write, their lines come first; what they find belongs together in one picture.
  if (phase === "explain") return [...given(desk), who, ...asked(desk)];
  if (seat) return [...counts(desk), who, ...asked(desk), ...collected(desk), ...given(desk)];
  return [...counts(desk), ...asked(desk), ...collected(desk), who, ...given(desk)];
}

/** @param {number} number @param {string} text @param {string} [name] @returns {HTMLElement} */
function count(number, text, name = "") {
  const item = box("li", name, make("b", "", String(number)), make("span", "", text));
  return item;
}

/** How far they are while each one has a body of their own. @param {Desk} desk @returns {HTMLElement[]} */
function counts({ asking: { phase }, seats, doing, home }) {
  if (home || !OWN_BODY.has(phase)) return [];
  const done = seats.filter(({ here, answered }) => here && answered).length;
  const { trying, exploded, untouched } = doing;
  const items = [
    ...(phase === "collect" ? [count(done, say("desk-count-handed-in", { count: done }), "softrod-done")] : []),
    count(trying, say("desk-count-trying", { count: trying })),
    ...(exploded ? [count(exploded, say("desk-count-exploded", { count: exploded }), "softrod-idle")] : []),
    ...(untouched ? [count(untouched, say("desk-count-idle", { count: untouched }), "softrod-idle")] : []),
  ];
  return [box("ul", "softrod-desk-counts", ...items)];
}

/** The question, and who has chosen what; only the teacher sees that before it is shown. @param {Desk} desk @returns {HTMLElement[]} */
function asked({ asking: { phase, question, choices, predict }, bars, right, seats, answers, home }) {
  if (!(question || predict > 0) || !(PREDICTED.has(phase) || home)) return [];
  const predictions = answers.filter(({ kind }) => kind === "prediction").length;
  const sealed = make("span", "softrod-chip", say("desk-sealed"));
  // The wrong choice of most: one of them is asked why.
  const most = Math.max(0, ...bars.filter((_, i) => i !== right));
  const wrong = choices[bars.findIndex((bar, i) => i !== right && bar === most)];
  const ask = phase === "results" && most > 0 && right >= 0 ? [make("p", "softrod-quiet", say("desk-most", { count: most, choice: wrong }))] : [];
  return [
    box(
      "section",
      "",
      box("header", "", make("h2", "", say(phase === "ask" || home ? "desk-chose.now" : "desk-chose")), ...(phase === "ask" || home ? [sealed] : [])),
      ...(question ? [voteBars(choices, bars, right)] : []),
      ...ask,
      ...(predict > 0 ? [make("p", "softrod-quiet", home ? say("desk-predicted", { count: predictions }) : say("desk-predicted.some", { count: predictions, all: counted(seats) }))] : []),
    ),
  ];
}

/** What a body does, in words. @param {DeskSeat["doing"]} doing */
const doingText = (doing) => (doing ? say(DOING[doing]) : "");

/** What a tile says of a seat, beside its name; nothing of a body that just moves. @param {DeskSeat} seat @param {boolean} hasOwn whether it has a body of its own */
function state({ here, follows, doing, done }, hasOwn) {
  if (!here) return say("desk-away");
  if (hasOwn && follows) return say("desk-follows");
  if (done.length) return say("desk-done", { done: done.filter(Boolean).length, steps: done.length });
  return hasOwn && doing !== "moving" ? doingText(doing) : "";
}

/** The name of a seat as it is shown. @param {keyof HTMLElementTagNameMap} kind @param {DeskSeat} seat */
function nameOf(kind, { name, two, hand }) {
  const label = untranslated(make(kind, "", two ? say("desk-name-two", { name }) : name));
  if (hand) label.append(icon("hand"));
  return label;
}

/** How many pupils are waited for: those who are here. @param {DeskSeat[]} seats */
export const counted = (seats) => seats.filter(({ here }) => here).length;

/** What a seat gave to what is asked, on its tile. @param {Desk} desk @param {number} seat */
function gaveOf({ answers, home, asking: { phase, choices } }, seat) {
  if (!PREDICTED.has(phase) && !home) return { choice: "", dots: /** @type {[number, number][]} */ ([]) };
  const mine = answers.filter((answer) => answer.seat === seat);
  const vote = mine.find(({ kind }) => kind === "vote");
  return { choice: vote ? choices[vote.choice] ?? "" : "", dots: mine.find(({ kind }) => kind === "prediction")?.places ?? [] };
}

/** @param {Desk} desk */
function seats(desk) {
  const { seats, asking, seat_on_wall, gathered } = desk;
  const hasOwn = OWN_BODY.has(asking.phase);
  const hasPicture = hasOwn || ((PREDICTED.has(asking.phase) || Boolean(desk.home)) && asking.predict > 0);
  const up = seats.filter(({ hand }) => hand).map(({ name }) => name);
  const tiles = seats.map((seat) => {
    const { number, name, color, here, two, hand, answered } = seat;
    const { choice, dots } = gaveOf(desk, number);
    const said = joined([state(seat, hasOwn && !gathered), choice, number === seat_on_wall && say("desk-on-wall")]);
    const label = joined([name, two && say("desk-two"), said, dots.length > 0 && say("desk-has-predicted"), answered && say("desk-has-answered"), hand && say("desk-hand")]);
    const tile = button("", () => choose(number), { focus: `seat${number}`, name: "softrod-tile", label });
    if (hasPicture) tile.append(poster(hasOwn ? number : 0, dots));
    tile.append(nameOf("span", seat), ...(said ? [make("small", "", said)] : []));
    if (answered) tile.append(icon("done"));
    const item = box("li", "", tile);
    item.style.setProperty("--softrod-seat", color);
    item.toggleAttribute("data-away", !here);
    item.toggleAttribute("data-hand", hand);
    return item;
  });
  const here = counted(seats), away = seats.length - here;
  const hands = up.length
    ? [box("span", "softrod-desk-hands", icon("hand"), joined(up)), button(say("desk-lower-hands"), () => send({ do: "arrange", what: "lowerHands" }))]
    : [];
  return box(
    "section",
    "",
    box("header", "", make("h2", "", say("desk-who")), make("span", "softrod-quiet", away ? say("desk-who-away", { here, away }) : String(here))),
    ...(hands.length ? [box("div", "softrod-desk-hands-up", ...hands)] : []),
    ...(tiles.length ? [] : [make("p", "softrod-quiet", say("desk-nobody"))]),
    box("ul", hasPicture ? "softrod-seats softrod-tiles" : "softrod-seats", ...tiles),
  );
}

/** One seat, larger, and what can be done with it. @param {Desk} desk @param {DeskSeat} seat */
function alone(desk, seat) {
  const { asking, seat_on_wall, answers, gathered } = desk;
  const { number, name, color, digits, doing } = seat;
  const hasOwn = OWN_BODY.has(asking.phase);
  const isShown = seat_on_wall === number;
  const { dots } = gaveOf(desk, number);
  /** @param {OneSeat["what"]} what */
  const act = (what) => send({ do: "oneSeat", seat: number, what });
  const own = hasOwn ? [button(say(isShown ? "desk-off-wall" : "desk-to-wall"), () => act(isShown ? "hide" : "show"), { focus: "onWall" }), button(say("desk-reset-one"), () => act("reset"))] : [];
  const said = state(seat, hasOwn && !gathered) || (hasOwn ? doingText(doing) : "");
  const part = box(
    "section",
    "softrod-desk-seat",
    box("header", "", nameOf("h2", seat), make("span", "softrod-quiet", said), button(say("desk-to-all"), () => choose(0), { focus: "allSeats" })),
    ...(hasOwn || dots.length ? [poster(hasOwn ? number : 0, dots)] : []),
    box(
      "div",
      "softrod-phases",
      ...own,
      button(digits ? say("desk-move-digits", { digits }) : say("desk-move"), () => act("move")),
      button(say("desk-remove"), () => confirm(say("desk-remove.confirm", { name })) && act("sendAway")),
    ),
    ...(digits ? [make("p", "softrod-quiet", say("desk-move-how", { digits }))] : []),
    ...answers.filter((answer) => answer.seat === number).map((answer) => make("p", "", say("desk-gave", { what: wordsOf(answer, asking.choices) }))),
  );
  part.style.setProperty("--softrod-seat", color);
  return part;
}

/** An answer in words. @param {DeskAnswer} answer @param {string[]} choices of the question */
function wordsOf({ kind, text, choice, late, doubt }, choices) {
  const what = { vote: choices[choice] ?? "", prediction: text || say("desk-a-prediction"), line: isolated(text), work: text || say("desk-a-run") }[kind];
  const said = late ? say("desk-late", { what }) : what;
  return doubt ? say("desk-doubt", { what: said, doubt }) : said;
}

/** The answers that are listed. @param {Desk} desk */
function given({ answers, seats, on_wall, asking }) {
  return LISTED.flatMap(([kind, title]) => {
    const items = answers.filter((answer) => answer.kind === kind).map((answer) => item(answer, seats, on_wall));
    const list = box("ul", "softrod-lines", ...items);
    // The lines are open while they are written; predictions are over the body already.
    return !items.length ? [] : [kind === "line" && asking.phase === "explain" ? list : fold(say(title, { count: items.length }), [list], kind)];
  });
}

/** The class's plot. @param {Desk} desk */
function collected({ answers, asking, axes, law, shows_law, home }) {
  const found = answers.flatMap(({ setting, found, doubt }) => (setting === null || found === null || doubt ? [] : [{ setting, found }]));
  if (!found.length || (asking.phase !== "collect" && !home)) return [];
  const words = law && shows_law ? [make("p", "", power(law, axes))] : [];
  return [box("section", "", make("h2", "", say("desk-found")), plot(found, axes, { law: shows_law ? law : null }), ...words)];
}

/** @param {DeskAnswer} answer @param {DeskSeat[]} seats @param {string} on_wall */
function item(answer, seats, on_wall) {
  const { id, seat, kind, starred, places } = answer;
  const { name = "", color = "" } = seats.find(({ number }) => number === seat) ?? {};
  const isShown = on_wall === id;
  const item = box(
    "li",
    "",
    ...(kind === "work" && places.length ? [still(places)] : []),
    make("span", "", say("desk-by", { name, what: wordsOf(answer, []) })),
    kind === "line"
      ? button("", () => send({ do: "star", answer: id, on: !starred }), {
          focus: `star${id}`, name: "softrod-cross", label: say("desk-star", { name }), pressed: starred, icon: "star",
        })
      : button(say("desk-wall"), () => send({ do: "toWall", answer: isShown ? "" : id }), { focus: `wall${id}`, label: say(kind === "prediction" ? "desk-show-prediction" : "desk-show-body", { name }), pressed: isShown }),
  );
  item.style.setProperty("--softrod-seat", color);
  return item;
}
