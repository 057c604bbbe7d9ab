// @ts-check
/** A pupil's page in a class: one sentence that says what to do, and what it takes to do it. */
import { onMessage, pageState, send } from "../../wire/channel.js";
import { access, setAccess } from "../../ui/access.js";
import { make, untranslated } from "../../ui/dialog.js";
import { element as known } from "../../export/static/parts.js";
import { box, button, fold, sayWith, typedLine, typedText } from "../../features/classroom/elements.js";
import { partsOf as textsOf } from "../../features/classroom/guide.js";
import { OWN_BODY } from "../../features/classroom/phases.js";
import { plot } from "../../features/classroom/plot.js";
import { OwnPrediction, Predictions } from "../../features/classroom/prediction.js";
import { Card, deferWhilePressed } from "../../features/classroom/rerender.js";
import { joined, say } from "../../words/words.js";
import { Alone } from "./alone.js";
import { keepAwake } from "./awake.js";
import { Bench } from "./bench.js";
import { listenForDescription } from "./description.js";
import { addHands } from "./hands.js";
import { hangUp } from "./line.js";
import { forgetAnswers, give, isSamePlace, onOutbox, openOutbox, unsent } from "./outbox.js";

/** @typedef {import("../../wire/wire.js").Seat} Seat */
/** @typedef {import("../../wire/wire.js").Asking} Asking */
/** @typedef {import("../../wire/wire.js").Given} Given */
/** @typedef {Capitalize<Given["kind"]>} Kind */

/** Letters of a line, and of a name. */
const MAX_LETTERS = 140;
const MAX_NAME_LETTERS = 20;
/** Buttons that move what is predicted: sign, name, label, and the way across and up. */
const STEPS = /** @type {const} */ ([
  ["◀", "left", "seat-step-left", -1, 0],
  ["▲", "up", "seat-step-up", 0, 1],
  ["▼", "down", "seat-step-down", 0, -1],
  ["▶", "right", "seat-step-right", 1, 0],
]);
/** Phases in which one sees again what one chose, and what is right once that may be known. */
const TOLD = new Set(["results", "run", "reveal"]);
/** Simulated seconds per second of a body that moves slowly. */
const SLOW = 0.25;

/** @type {Seat | null} */
let seat = null;
/** Which of two pupils at this page answers now. */
let twin = 0;
/** A line that is being typed. */
let typed = "";
let refusal = "";
/** The step whose prediction was handed in by the page, as the answers were shown. */
let handedIn = -1;
/** The phase for which the focus has been moved. */
let focusedPhase = "";
/** @type {Card} */
let card;
/** Says to a screen reader what to do; it stays, since one that is remade is not read. @type {HTMLElement} */
let spoken;
/** Says where what is predicted was put. @type {HTMLElement} */
let placed;
/** @type {OwnPrediction} */
let prediction;
/** @type {Alone} */
let alone;

/** Whether the body that is shown is this page's own. */
const hasOwn = () => seat !== null && seat.asking !== null && OWN_BODY.has(seat.asking.phase) && !seat.follows && !seat.gathered && !seat.elsewhere;

/** Whether the class waits for an answer of this page; homework has all the time there is. @param {Seat} seat */
const hasOpenQuestion = ({ asking, elsewhere, home }) => !home && !elsewhere && ["ask", "explain"].includes(asking?.phase ?? "");

/**
 * Makes a pupil's card.
 *
 * @param {import("./picture.js").Picture} picture
 * @returns {{lineChanged: (away: boolean) => string}} says what a lost connection means, in words
 */
export function addSeat(picture) {
  const element = make("section", "softrod-class softrod-seat");
  element.setAttribute("aria-label", say("seat-region"));
  const parts = make("div", "softrod-card"), work = make("div", "softrod-bench"), below = make("div", "softrod-card");
  element.append(parts, work, below);
  spoken = make("div", "softrod-tell");
  spoken.setAttribute("role", "status");
  placed = make("div", "softrod-tell");
  placed.setAttribute("role", "status");
  document.body.append(element, spoken, placed);
  const others = new Predictions(picture);
  const bench = new Bench(work, (dial, value) => alone.change(dial, value));
  const hands = addHands(picture, () => hasOwn() && !alone.isOn);
  alone = new Alone(picture, bench, () => hands);
  listenForDescription(() => hands.chosen);
  around = [
    new Card(known("head", HTMLElement), () => (seat ? headOf(seat) : [])),
    new Card(below, () => (seat ? belowOf(seat) : [])),
  ];
  card = new Card(parts, () => (seat ? partsOf(seat) : []));
  prediction = new OwnPrediction(picture, show);
  openOutbox();
  const defer = deferWhilePressed(document.body);
  let hasMoved = false;
  onMessage("pageState", () => defer(show));
  onMessage("seat", (told) => {
    if (seat) handInMoved(seat, told);
    if (told.asking?.stop !== seat?.asking?.stop || told.asking?.phase !== seat?.asking?.phase) {
      twin = 0;
      typed = refusal = "";
      hasMoved = true;
    }
    seat = told;
    keepAwake(hasOpenQuestion(told));
    defer(() => {
      show();
      // What is to be done now is at the top.
      if (hasMoved) {
        element.scrollTop = 0;
        // In a small window either the body is in sight or the card.
        (told.asking?.phase === "run" ? document.body : element).scrollIntoView();
      }
      hasMoved = false;
    });
  });
  onMessage("predictions", ({ bodies }) => others.show(bodies, seat?.asking?.masses));
  onMessage("classEnded", () => {
    forgetAnswers();
    keepAwake(false);
    prediction.show(false);
    spoken.textContent = say("class-over");
    seat = null;
    element.replaceChildren(make("h1", "", say("class-over")), make("p", "", say("seat-nothing-kept")));
    hangUp();
  });
  onOutbox((refused) => {
    refusal = refused;
    show();
  });
  return {
    lineChanged(away) {
      if (!away) {
        if (alone.isOn) alone.end();
        return "";
      }
      alone.begin(hasOwn());
      show();
      if (alone.isOn) return say("seat-away-alone");
      return hasOwn() ? say("line-body-waits") : "";
    },
  };
}

/** The head of the page, and what stands below sliders and plots. @type {Card[]} */
let around = [];

/** What was given to what is asked now, or waits to be sent. @param {Pick<Asking, "stop" | "round">} asking @param {Kind} kind */
function mine(asking, kind) {
  const at = place(asking);
  const late = unsent().find((one) => one.do === `give${kind}` && isSamePlace(one, at));
  if (late) return { choice: "choice" in late ? late.choice : -1, text: "text" in late ? late.text : "", sent: false, late: false };
  const had = seat?.given.find((one) => one.kind === kind.toLowerCase() && isSamePlace(one, at));
  return had && { choice: had.choice, text: had.text, sent: true, late: had.late };
}

/** Hands in what was dragged and not handed in, once the class is no longer asked. @param {Seat} before @param {Seat} now */
function handInMoved({ asking, home }, now) {
  if (!asking || asking.phase !== "ask" || home || now.elsewhere || !now.asking || !prediction.moved) return;
  if (now.asking.phase === "ask" && now.asking.stop === asking.stop) return;
  // One that was handed in before stays; the server says so.
  if (!mine(asking, "Prediction")) handedIn = asking.stop;
  give({ do: "givePrediction", ...place(asking), points: prediction.points() });
}

/** @param {Pick<Asking, "stop" | "round">} asking */
const place = ({ stop, round }) => ({ stop, round, twin });

function show() {
  if (!seat) return;
  const asking = seat.asking;
  prediction.show(asking?.phase === "ask" && asking.predict > 0 && asking.round === 0 && !seat.elsewhere, asking?.masses);
  const shows = [seat, twin, refusal, unsent().map(({ id }) => id), prediction.moved, prediction.isSingle, prediction.said(unit()), isPlaying(), isSlow(), access().taps];
  for (const other of around) other.show(shows);
  const isFree = card.show(shows);
  const task = [...card.element.querySelectorAll(".softrod-task, .softrod-on-wall, .softrod-warning, .softrod-goal[data-met], .softrod-verdict, .softrod-handed")].map((text) => text.textContent).join(" ");
  if (spoken.textContent !== task) spoken.textContent = task;
  const news = prediction.news(unit());
  if (placed.textContent !== news) placed.textContent = news;
  if (isFree) focusTask(asking);
}

/**
 * Moves the focus to what is asked for, once a phase, for keys and screen readers; but not out of something else, and
 * not on a touch screen, where a keyboard would cover the card.
 *
 * @param {Asking | null} asking
 */
function focusTask(asking) {
  const now = asking ? `${asking.stop} ${asking.phase} ${asking.round}` : "";
  if (now === focusedPhase) return;
  focusedPhase = now;
  const { activeElement: active } = document;
  const isFree = !active || active === document.body || active.tagName === "CANVAS" || !active.isConnected;
  if (!isFree || !["ask", "explain"].includes(asking?.phase ?? "") || matchMedia("(pointer: coarse)").matches) return;
  // The question first; a body alone by its grips, which come after the card.
  if (!card.focus("fieldset, form input")) /** @type {HTMLElement | null} */ (document.querySelector(".softrod-own-grip"))?.focus();
}

/** Whether the clock of the page's own body runs. */
const isPlaying = () => (alone.isOn ? alone.playing : Boolean(pageState().playing));

/** Whether the page's own body moves slowly. */
const isSlow = () => (pageState().speed ?? 1) < 1;

/** The unit of lengths. */
const unit = () => pageState().unit || "px";

/** Who sits here, and the hand to raise. @param {Seat} seat @returns {HTMLElement[]} */
function headOf({ name, color, hand, elsewhere, asking }) {
  if (!asking || elsewhere) return [];
  const named = untranslated(make("b", "softrod-seat-name", name));
  named.style.setProperty("--softrod-seat", color);
  const up = button(say(hand ? "seat-hand-is-up" : "seat-hand-up"), () => send({ do: "raiseHand", up: !hand }), { focus: "hand", pressed: hand, icon: "hand" });
  return [named, up];
}

/** @param {Seat} seat @returns {HTMLElement[]} */
function partsOf(seat) {
  const { elsewhere, asking } = seat;
  if (elsewhere) {
    // The server has room for a limited number of pages; this one is given up.
    hangUp();
    const back = button(say("seat-come-back"), () => location.reload());
    return [make("p", "softrod-task", say(elsewhere === "page" ? "seat-on-page" : "seat-on-device")), ...(elsewhere === "page" ? [back] : [])];
  }
  if (!asking) return entrance(seat);
  const who = seat.home && seat.is_given ? [make("p", "softrod-task", say("seat-who")), nameLine()] : [];
  return [
    ...who,
    make("p", "softrod-task", sentence(seat, asking)),
    ...(seat.on_wall ? [make("p", "softrod-on-wall", say("seat-on-wall"))] : []),
    ...body(seat, asking),
    ...(TOLD.has(asking.phase) ? predicted(asking) : []),
    ...(TOLD.has(asking.phase) && handedIn === asking.stop ? [make("p", "softrod-handed", say("seat-handed-moved"))] : []),
    ...(refusal ? [make("p", "softrod-warning", refusal)] : []),
  ];
}

/** The prediction that was handed in, if words can tell it. @param {Asking} asking */
function predicted(asking) {
  const given = mine({ ...asking, round: 0 }, "Prediction");
  if (!given?.sent || !given.text) return [];
  // One that the page has handed in by itself was moved in time.
  const late = lateness({ late: given.late && handedIn !== asking.stop });
  // What the class is told about now is not marked as done.
  const name = TOLD.has(asking.phase) ? "softrod-handed softrod-plain" : "softrod-handed";
  return [make("p", name, say("seat-handed.text", { text: given.text, late }))];
}

/** What stands below sliders and plots. @param {Seat} seat @returns {HTMLElement[]} */
function belowOf(seat) {
  const { asking } = seat;
  if (!asking || seat.elsewhere) return [];
  const { phase, right, because } = asking;
  const follow = button(say(seat.follows ? "seat-own-body" : "seat-follow"), () => send({ do: "follow", on: !seat.follows }), { focus: "follow" });
  const mayFollow = OWN_BODY.has(phase) && !seat.gathered;
  if (seat.home) return [...waiting(), ...homework(seat, asking), fold(say("seat-about"), lobbyOf(seat), "about")];
  return [
    ...waiting(),
    ...(mayFollow ? [box("div", "softrod-phases", follow)] : []),
    ...(mayFollow && !seat.follows && phase === "collect" ? classPlot(seat) : []),
    ...(hasOwn() && (right >= 0 || because) ? [fold(say("seat-why"), [make("p", "", asking.question), verdict(asking)], "why")] : []),
    ...(phase !== "lobby" ? [fold(say("seat-about"), lobbyOf(seat), "about")] : []),
  ];
}

/** What is said while answers wait to be sent. */
const waiting = () => (unsent().length ? [make("p", "softrod-waiting", say("seat-waiting"))] : []);

/** What stands below sliders and plots in homework: a line, the run to hand in, and the way to other steps. @param {Seat} seat @param {Asking} asking */
function homework(seat, asking) {
  const { stop, question, right } = asking;
  const { done } = seat;
  /** @param {number} to */
  const walk = (to) => send({ do: "walkTo", stop: to });
  const steps = done.map((isDone, i) =>
    button(`${i + 1}${isDone ? " ✓" : ""}`, () => walk(i), { focus: `walk ${i}`, label: say(isDone ? "seat-step-done" : "seat-step", { number: i + 1 }), pressed: i === stop }),
  );
  const open = done.flatMap((isDone, i) => (isDone ? [] : [i + 1]));
  const left = open.length ? say("seat-to-do", { count: open.length, steps: joined(open.map(String)) }) : say("seat-all-done");
  const next = stop + 1 < done.length ? [button(say("seat-next-step", { number: stop + 2, steps: done.length }), () => walk(stop + 1), { focus: "walk on", name: done[stop] ? "softrod-strong" : "softrod-small" })] : [];
  return [
    ...(hasOwn() ? twins(seat) : []),
    ...(hasOwn() && question ? [make("p", "softrod-task", say("class-why")), explanation(asking)] : []),
    ...(hasOwn() ? classPlot(seat) : []),
    ...(hasOwn() && question && right < 0 ? [box("p", "softrod-quiet", ...verdict(asking).childNodes, ` ${say("seat-told-on", { date: seat.home })}`)] : []),
    ...next,
    box("div", "softrod-phases", ...steps),
    make("p", "softrod-quiet", left),
  ];
}

/** Whether there is something to hand in: a number, or a goal. @param {Asking} asking */
const collects = ({ collects, goal, do: task }) => Boolean(collects || goal || !task);

/** What to do, in one sentence. @param {Seat} seat @param {Asking} asking */
function sentence({ paused, away, follows, gathered, home, told }, asking) {
  const { phase, predict, question, round } = asking;
  const hasOwn = OWN_BODY.has(phase), seconds = String(predict);
  if (home && phase === "ask") {
    const what = !(predict > 0) ? say("seat-home-choose") : say(question ? "seat-home-both" : "seat-home-drag", { seconds });
    return told ? `${what} ${say("seat-late-now")}` : what;
  }
  if (home) return say("seat-home-own");
  if (away && phase !== "lobby" && !hasOwn) return say("seat-teacher-away");
  if (hasOwn && gathered) return say("seat-gathered");
  if (hasOwn && follows) return say("seat-follows");
  if (hasOwn && paused) return say("seat-paused");
  if (phase === "lobby") return say("seat-is-in");
  if (phase === "ask" && mine(asking, "Vote") && (mine(asking, "Prediction") || !(predict > 0) || round > 0)) return say("seat-can-change");
  if (phase === "ask" && predict > 0 && round === 0) {
    return say(question ? "seat-ask-both" : "seat-ask-drag", { seconds });
  }
  if (phase === "ask") return say(round > 0 ? "seat-ask-again" : "seat-ask-choose");
  if (phase === "explain") return say("class-why");
  if (phase === "try") return say("seat-try");
  if (phase === "collect") return say("class-hand-in");
  return say("seat-look");
}

/** @param {Seat} seat @param {Asking} asking @returns {HTMLElement[]} */
function body(seat, asking) {
  const { phase } = asking;
  if (phase === "lobby") return lobbyOf(seat);
  if (phase === "ask") return [...twins(seat), ...(asking.question ? [choices(asking)] : []), ...(asking.predict > 0 && asking.round === 0 ? predictButton(asking) : [])];
  if (phase === "explain") return [...twins(seat), explanation(asking)];
  if (TOLD.has(phase) && asking.question) return [verdict(asking)];
  if (!OWN_BODY.has(phase) || seat.gathered || seat.follows) return [];
  const gives = seat.home ? collects(asking) : phase === "collect";
  return [
    ...(seat.home && asking.question && asking.right >= 0 ? [verdict(asking)] : []),
    ...(asking.goal ? [goalLine(seat, asking.goal)] : []),
    make("p", "", asking.do),
    ...(asking.watch && phase !== "collect" ? [box("p", "softrod-watch", make("b", "", say("seat-watch")), ` ${asking.watch}`)] : []),
    box("div", "softrod-phases", ...timeButtons()),
    ...(gives ? [...(seat.home ? [] : twins(seat)), ...handIn(seat, asking)] : []),
  ];
}

/** What to reach, and whether it was. @param {Seat} seat @param {string} goal */
function goalLine({ reached }, goal) {
  const line = make("p", "softrod-goal", say(reached ? "class-goal-met" : "class-goal", { goal }));
  line.toggleAttribute("data-met", reached);
  return line;
}

/** @param {Asking} asking */
function choices(asking) {
  const given = mine(asking, "Vote"), before = asking.round > 0 ? mine({ ...asking, round: 0 }, "Vote") : undefined;
  const buttons = asking.choices.map((text, choice) =>
    button(text, () => give({ do: "giveVote", ...place(asking), choice }), { focus: `choice${choice}`, name: "softrod-choice", pressed: given?.choice === choice }),
  );
  for (const each of buttons) each.dir = "auto";
  const had = before && before.choice >= 0 ? [make("p", "softrod-quiet", say("seat-chose-before", { choice: asking.choices[before.choice] }))] : [];
  const { given: told, asked } = textsOf(asking.question);
  const fieldset = box("fieldset", "", make("legend", "", `${told} ${asked}`.trim()), ...had, ...buttons);
  // So that a screen reader reads the question first.
  fieldset.tabIndex = -1;
  fieldset.dataset.focus = "question";
  return fieldset;
}

/** @param {Asking} asking */
function predictButton(asking) {
  const predict = () => {
    give({ do: "givePrediction", ...place(asking), points: prediction.points() });
    prediction.moved = false;
    show();
  };
  const isIn = mine(asking, "Prediction") && !prediction.moved;
  const said = prediction.said(unit());
  const made = button(said ? say(isIn ? "seat-predicted.place" : "seat-predict.place", { place: said }) : say(isIn ? "seat-predicted" : "seat-predict"), predict, { focus: "predict", name: "softrod-strong" });
  made.disabled = !prediction.moved;
  const steps = STEPS.map(([sign, name, label, across, up]) =>
    button(sign, () => prediction.stepBy(across, up), { focus: `step ${name}`, label: say(label) }),
  );
  return [...(prediction.isSingle ? [box("div", "softrod-steps", ...steps)] : []), made, ...(prediction.moved ? predicted(asking) : [])];
}

/** @param {Asking} asking */
function explanation(asking) {
  const given = mine(asking, "Line");
  /** @param {string} text */
  const take = (text) => {
    if (!text) return;
    typed = "";
    give({ do: "giveLine", ...place(asking), text });
  };
  const form = typedText(say("seat-because"), { maxLength: MAX_LETTERS, value: typed || given?.text || "" }, [say(given ? "seat-change" : "seat-send"), "softrod-strong"], take, "line");
  form.addEventListener("input", ({ target }) => (typed = /** @type {HTMLTextAreaElement} */ (target).value));
  if (given?.sent && !typed) form.append(make("p", "softrod-handed", say("seat-sent")));
  return form;
}

/** The choice that was made, and what is right once that may be known. @param {Asking} asking */
function verdict(asking) {
  // Whoever was asked again has chosen again.
  const last = asking.phase === "results" ? asking.round : 1;
  const given = mine({ ...asking, round: last }, "Vote") ?? mine({ ...asking, round: 0 }, "Vote");
  const text = make("p", "softrod-verdict");
  /** @param {number} choice */
  const bold = (choice) => make("b", "", asking.choices[choice]);
  if (given && given.choice >= 0) text.append(...sayWith("seat-chose", { choice: bold(given.choice), late: lateness(given) }), " ");
  if (asking.right >= 0) {
    text.append(...sayWith("seat-right", { choice: bold(asking.right) }), ` ${asking.because}`);
    if (given) text.classList.add(given.choice === asking.right ? "softrod-right" : "softrod-wrong");
  }
  return text;
}

/** What has the body begin anew, and its clock stand or go on. */
function timeButtons() {
  /** @param {"reset" | "play"} command */
  const perform = (command) => {
    if (!alone.isOn) send({ do: "perform", command });
    else if (command === "reset") alone.reset();
    else alone.playing = !alone.playing;
    show();
  };
  return [
    button(say(isPlaying() ? "seat-pause" : "seat-play"), () => perform("play"), { focus: "play" }),
    button(say("seat-reset"), () => perform("reset"), { focus: "reset" }),
    ...(alone.isOn ? [] : [button("¼×", () => send({ do: "speed", speed: isSlow() ? 1 : SLOW }), { focus: "slow", pressed: isSlow(), label: say("seat-slow") })]),
  ];
}

/** The number that would be handed in, the button that does it, and what was handed in. @param {Seat} seat @param {Asking} asking */
function handIn({ reading }, asking) {
  const given = mine(asking, "Work");
  const isSame = Boolean(given?.sent && given.text && reading.startsWith(given.text));
  const made = button(handInText(asking.collects, reading, Boolean(given && !isSame)), () => give({ do: "giveWork", ...place(asking) }), { focus: "handin", name: "softrod-strong" });
  made.disabled = isSame || (Boolean(asking.collects) && !reading);
  return [
    ...(asking.collects ? [make("p", "softrod-reading", reading ? say("seat-reading", { what: asking.collects, reading }) : say("seat-no-reading"))] : []),
    made,
    ...(given?.sent ? [make("p", "softrod-handed", given.text ? say("seat-handed.text", { text: given.text, late: lateness(given) }) : say("seat-handed", { late: lateness(given) }))] : []),
  ];
}

/** The button that hands in. @param {string} collects what is collected @param {string} reading its value @param {boolean} isInstead whether there was another before */
function handInText(collects, reading, isInstead) {
  if (!collects) return say(isInstead ? "seat-hand-in-run.instead" : "seat-hand-in-run");
  if (!reading) return say(isInstead ? "seat-hand-in-it.instead" : "seat-hand-in-it");
  return say(isInstead ? "seat-hand-in.instead" : "seat-hand-in", { reading });
}

/** What the class found, once one has put a point there. @param {Seat} seat */
const classPlot = ({ found, own, axes }) =>
  found.length ? [box("figure", "softrod-found", make("figcaption", "", say("class-found")), plot(found, axes, { own }))] : [];

/** Whether an answer was late, as texts choose by it. @param {{late: boolean}} given */
const lateness = ({ late }) => (late ? "yes" : "no");

/** Which of two pupils answers. @param {Seat} seat */
function twins({ two }) {
  if (!two) return [];
  /** @param {string} text @param {number} which */
  const choice = (text, which) => {
    const choose = () => {
      twin = which;
      typed = "";
      show();
    };
    return button(text, choose, { focus: `twin${which}`, pressed: twin === which });
  };
  return [box("div", "softrod-twins", choice(say("seat-first"), 0), choice(say("seat-second"), 1))];
}

/** The way back to a seat that another device had. */
function comeBack() {
  /** @param {string} digits */
  const take = (digits) => /^[0-9]{2}$/.test(digits) && send({ do: "takeOver", digits });
  return typedLine(say("seat-had"), { maxLength: 2, inputMode: "numeric" }, [say("seat-take-over")], take, "digits");
}

/** What can be arranged about the seat. @param {Seat} seat @returns {HTMLElement[]} */
function lobbyOf({ two, digits, types_name }) {
  const move = digits ? say("seat-move-digits", { digits }) : say("seat-move");
  const parts = [
    button(say("seat-another-name"), () => send({ do: "newName" }), { focus: "name" }),
    button(say("seat-two"), () => send({ do: "sitTogether", two: !two }), { focus: "two", pressed: two }),
    button(move, () => send({ do: "leaveBy" }), { focus: "move" }),
    button(say("command-describe-body"), () => send({ do: "describe", mass: null }), { focus: "describe" }),
    button(say("access-taps"), () => (setAccess({ taps: !access().taps }), show()), { focus: "taps", pressed: access().taps }),
  ];
  const own = types_name ? [nameLine()] : [];
  return [box("div", "softrod-lobby", ...parts), ...own, comeBack()];
}

/** Where a pupil types their own name. */
function nameLine() {
  const named = { maxLength: MAX_NAME_LETTERS, autocomplete: /** @type {any} */ ("nickname"), ariaLabel: say("seat-your-name"), placeholder: say("seat-your-name") };
  return typedLine("", named, [say("seat-name-me")], (wanted) => send({ do: "newName", wanted }), "own name");
}

/** The page of somebody who is in no class: which one do they come to? @param {Seat} seat */
function entrance({ problem }) {
  /** @param {string} text */
  const enter = (text) => /^[A-Za-z]{4}$/.test(text) && (location.search = `?room=${text.toUpperCase()}`);
  const isNamed = /^[A-Za-z]{4}$/.test(new URLSearchParams(location.search).get("room") ?? "");
  return [
    make("h1", "", "softrod"),
    ...(problem ? [make("p", "softrod-warning", problem)] : []),
    typedLine(say("seat-letters"), { maxLength: 4, autocapitalize: "characters" }, [say("seat-come-in"), "softrod-strong"], enter, "code"),
    ...(isNamed ? [comeBack(), ...(refusal ? [make("p", "softrod-warning", refusal)] : [])] : []),
  ];
}
