// @ts-check
/**
 * A pupil's page in a class: one sentence what to do, and what it takes to do it. What was typed or chosen stays when
 * the class's state comes anew; only what differs is made anew.
 */
import { onTold, send } from "../../wire/channel.js";
import { make, makeButton } from "../looks/dialog.js";
import { perform } from "../../wire/perform.js";
import { Ghosts, OwnGhost } from "./ghost.js";
import { forgetAnswers, give, onOutbox, openOutbox, unsent } from "./outbox.js";

/** @typedef {import("../../wire/wire.js").Seat} Seat */
/** @typedef {import("../../wire/wire.js").Asking} Asking */
/** @typedef {import("../../wire/wire.js").Given} Given */

/** On a screen this narrow the card is in the panel, above its sliders, where there are any. */
const NARROW = matchMedia("(max-width: 799px)");
/** Milliseconds between two looks whether viser has made that place anew. */
const LOOK_EVERY = 100;
/** Letters of a line. */
const MOST_LETTERS = 140;

/** @type {Seat | null} */
let seat = null;
/** What the card was made for. */
let made = "";
/** Which of two pupils at this page answers now. */
let twin = 0;
/** A line that is being typed. */
let typed = "";
let refusal = "";
/** @type {HTMLElement} */
let card;
/** @type {OwnGhost} */
let ghost;

/** Makes a pupil's card. */
export function addSeat() {
  card = make("section", "softrod-class softrod-seat");
  card.ariaLabel = "Class";
  document.body.append(card);
  setInterval(() => {
    const place = (NARROW.matches && document.getElementById("softrod-seat")) || document.body;
    if (card.parentElement !== place) place.append(card);
  }, LOOK_EVERY);
  const ghosts = new Ghosts();
  ghost = new OwnGhost(show);
  openOutbox();
  onTold("seat", (told) => {
    if (told.asking?.stop !== seat?.asking?.stop || told.asking?.phase !== seat?.asking?.phase) {
      [twin, typed, refusal] = [0, "", ""];
    }
    seat = told;
    show();
  });
  onTold("predictions", ({ bodies }) => ghosts.show(bodies));
  onTold("classEnded", () => {
    forgetAnswers();
    ghost.show(false);
    card.replaceChildren(make("h1", "", "The class is over."), make("p", "", "Nothing that you gave is kept here."));
  });
  onOutbox((refused) => {
    refusal = refused;
    show();
  });
}

/** What was given to what is asked now, or waits to be sent. @param {Asking} asking @param {Given["kind"]} kind */
function mine({ stop, round }, kind) {
  const does = { vote: "giveVote", ghost: "givePlaces", line: "giveLine", work: "handIn" }[kind];
  const late = unsent().find((one) => one.do === does && one.stop === stop && one.round === round && one.twin === twin);
  if (late) return { choice: "choice" in late ? late.choice : -1, text: "text" in late ? late.text : "", sent: false };
  const had = seat?.given.find((one) => one.kind === kind && one.stop === stop && one.round === round && one.twin === twin);
  return had && { choice: had.choice, text: had.text, sent: true };
}

/** @param {Asking} asking */
const place = ({ stop, round }) => ({ stop, round, twin });

function show() {
  if (!seat) return;
  const asking = seat.asking;
  ghost.show(asking?.phase === "ask" && asking.predict > 0 && !seat.elsewhere);
  const now = JSON.stringify([seat, twin, refusal, unsent().map(({ id }) => id), ghost.moved]);
  if (now === made) return;
  made = now;
  const focused = document.activeElement?.getAttribute("data-focus");
  card.replaceChildren(...parts(seat));
  if (focused) /** @type {HTMLElement | null} */ (card.querySelector(`[data-focus="${focused}"]`))?.focus();
}

/** @param {Seat} seat @returns {HTMLElement[]} */
function parts(seat) {
  if (seat.elsewhere) return [make("p", "softrod-task", "Another page of this browser has your seat now.")];
  if (!seat.asking) return entrance(seat);
  const head = make("header", "softrod-seat-head");
  const name = make("b", "softrod-seat-name", seat.name);
  name.style.setProperty("--softrod-seat", seat.color);
  const up = makeButton(seat.hand ? "Hand is up" : "Hand up", () => send({ do: "raiseHand", up: !seat.hand }), "softrod-small");
  up.ariaPressed = String(seat.hand);
  up.dataset.focus = "hand";
  head.append(name, up);
  const all = [head];
  const task = make("p", "softrod-task", sentence(seat, seat.asking));
  task.setAttribute("role", "status");
  all.push(task, ...body(seat, seat.asking));
  if (refusal) all.push(make("p", "softrod-warning", refusal));
  if (unsent().length) all.push(make("p", "softrod-waiting", "Not at the teacher's yet: kept here, and sent as soon as that is possible."));
  return all;
}

/** What to do, in one sentence. @param {Seat} seat @param {Asking} asking */
function sentence({ paused, away }, { phase, predict, question, round }) {
  if (away && !["lobby", "try", "collect"].includes(phase)) return "Your teacher's page is away for a moment: wait.";
  if (paused && (phase === "try" || phase === "collect")) return "Paused: look to the front.";
  if (phase === "lobby") return "You are in. It begins soon.";
  if (phase === "ask" && predict > 0) {
    return `Drag the pale body to where it will be after ${predict} s${question ? ", and answer" : ""}. Nobody sees it yet.`;
  }
  if (phase === "ask") return round > 0 ? "Answer once more. Nobody sees it yet." : "Answer. Nobody sees it yet.";
  if (phase === "explain") return "Why did it do that? Write one line.";
  if (phase === "try") return "Try it: this body is yours.";
  if (phase === "collect") return "Hand in what you found.";
  return "Look to the front.";
}

/** @param {Seat} seat @param {Asking} asking @returns {HTMLElement[]} */
function body(seat, asking) {
  const { phase } = asking;
  if (phase === "lobby") return lobby(seat);
  if (phase === "ask") return [...twins(seat), ...(asking.question ? [choices(asking)] : []), ...prediction(asking)];
  if (phase === "explain") return [...twins(seat), line(asking)];
  const parts = [];
  if (phase === "results" && asking.question) parts.push(verdict(asking));
  if (phase === "try" || phase === "collect") {
    const text = make("p", "", asking.do);
    const anew = makeButton("Begin anew", () => perform("reset"), "softrod-small");
    anew.dataset.focus = "reset";
    if (asking.goal) parts.push(make("p", "softrod-goal", `${seat.reached ? "Reached" : "Goal"}: ${asking.goal}`));
    parts.push(text, ...(asking.right >= 0 ? [verdict(asking)] : []), anew);
    if (phase === "collect") parts.push(...twins(seat), ...handIn(asking));
  }
  return parts;
}

/** @param {Asking} asking */
function choices(asking) {
  const given = mine(asking, "vote");
  const box = make("fieldset", "");
  box.append(make("legend", "", asking.question));
  asking.choices.forEach((choice, i) => {
    const button = makeButton(choice, () => give({ do: "giveVote", ...place(asking), choice: i }), "softrod-choice");
    button.ariaPressed = String(given?.choice === i);
    button.dataset.focus = `choice${i}`;
    box.append(button);
  });
  return box;
}

/** @param {Asking} asking */
function prediction(asking) {
  if (!(asking.predict > 0)) return [];
  const given = mine(asking, "ghost");
  const button = makeButton(
    given && !ghost.moved ? "Your prediction is in" : "It will be there",
    () => {
      give({ do: "givePlaces", ...place(asking), points: ghost.points() });
      ghost.moved = false;
      show();
    },
    "softrod-strong",
  );
  button.disabled = !ghost.moved;
  button.dataset.focus = "predict";
  return [button];
}

/** @param {Asking} asking */
function line(asking) {
  const given = mine(asking, "line");
  const form = make("form", "");
  const label = make("label", "", "Because ");
  const input = make("input", "");
  input.maxLength = MOST_LETTERS;
  input.value = typed || given?.text || "";
  input.dataset.focus = "line";
  input.autocomplete = "off";
  input.addEventListener("input", () => (typed = input.value));
  label.append(input);
  const button = make("button", "softrod-strong", given ? "Change it" : "Give it");
  form.append(label, button);
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    if (input.value.trim()) give({ do: "giveLine", ...place(asking), text: input.value.trim() });
  });
  return form;
}

/** The choice that was made, and once it may be known, what is right. @param {Asking} asking */
function verdict(asking) {
  const given = mine(asking, "vote");
  const text = make("p", "softrod-verdict");
  if (given && given.choice >= 0) text.append("You chose: ", make("b", "", asking.choices[given.choice]), ". ");
  if (asking.right >= 0) text.append("Right is: ", make("b", "", asking.choices[asking.right]), `. ${asking.because}`);
  return text;
}

/** What is handed in, and what was. @param {Asking} asking */
function handIn(asking) {
  const given = mine(asking, "work");
  const what = asking.collects ? `Hand in: ${asking.collects}` : "Hand in this run";
  const button = makeButton(given ? "Hand in anew" : what, () => give({ do: "handIn", ...place(asking) }), "softrod-strong");
  button.dataset.focus = "handin";
  const told = given?.sent ? `Handed in${given.text ? `: ${given.text}` : ""}.` : "";
  return [button, ...(told ? [make("p", "softrod-verdict", told)] : [])];
}

/** Who of two answers. @param {Seat} seat */
function twins({ two }) {
  if (!two) return [];
  const box = make("div", "softrod-twins");
  ["First of you", "Second of you"].forEach((label, i) => {
    const button = makeButton(label, () => {
      twin = i;
      typed = "";
      show();
    }, "softrod-small");
    button.ariaPressed = String(twin === i);
    button.dataset.focus = `twin${i}`;
    box.append(button);
  });
  return [box];
}

/** What can be arranged before it begins. @param {Seat} seat */
function lobby({ two, digits, types_name }) {
  const box = make("div", "softrod-lobby");
  const other = makeButton("Another name", () => send({ do: "newName" }), "softrod-small");
  other.dataset.focus = "name";
  const both = makeButton("We are two", () => send({ do: "sitTogether", two: !two }), "softrod-small");
  both.ariaPressed = String(two);
  both.dataset.focus = "two";
  const move = makeButton(digits ? `On the other device type ${digits}` : "Go on with another device", () => send({ do: "leaveBy" }), "softrod-small");
  move.dataset.focus = "move";
  box.append(other, both, move);
  if (types_name) {
    const form = make("form", "");
    const input = make("input", "");
    input.maxLength = 20;
    input.ariaLabel = "Your name";
    input.placeholder = "Your name";
    form.append(input, make("button", "softrod-small", "That is me"));
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      send({ do: "newName", wanted: input.value });
    });
    box.append(form);
  }
  return [box];
}

/** Where one is in no class: which is it? @param {Seat} seat */
function entrance({ problem }) {
  const form = make("form", "softrod-entrance");
  const label = make("label", "", "The four letters on the wall ");
  const input = make("input", "");
  input.maxLength = 4;
  input.autocapitalize = "characters";
  input.autocomplete = "off";
  input.dataset.focus = "code";
  label.append(input);
  form.append(label, make("button", "softrod-strong", "Come in"));
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    const letters = input.value.trim().toUpperCase();
    if (/^[A-Z]{4}$/.test(letters)) location.search = `?room=${letters}`;
  });
  const title = make("h1", "", "softrod");
  return [title, ...(problem ? [make("p", "softrod-warning", problem)] : []), form];
}
