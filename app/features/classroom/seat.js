// @ts-check
/**
 * A pupil's page in a class: one sentence what to do, and what it takes to do it. What was typed or chosen stays when
 * the class's state comes anew; only what differs is made anew.
 */
import { onMessage, send } from "../../wire/channel.js";
import { make, makeButton } from "../../ui/dialog.js";
import { perform } from "../../wire/perform.js";
import { giveUpConnection } from "../../ui/viser/connection.js";
import { betweenPresses } from "./anew.js";
import { Ghosts, OwnGhost } from "./ghost.js";
import { icon } from "./icons.js";
import { forgetAnswers, give, onOutbox, openOutbox, unsent } from "./outbox.js";
import { keepInPlace } from "./place.js";

/** @typedef {import("../../wire/wire.js").Seat} Seat */
/** @typedef {import("../../wire/wire.js").Asking} Asking */
/** @typedef {import("../../wire/wire.js").Given} Given */

/** Phases in which each pupil has a body of their own. */
const FREE = new Set(["try", "collect"]);
/** Letters of a line. */
const MAX_LETTERS = 140;

/** @type {Seat | null} */
let seat = null;
/** What the card was made for. */
let made = "";
/** Which of two pupils at this page answers now. */
let twin = 0;
/** A line that is being typed. */
let typed = "";
let refusal = "";
/** Whether what can be arranged about the seat is folded out. */
let arranges = false;
/** The phase for which the focus has been moved. */
let led = "";
/** @type {HTMLElement} */
let card;
/** Says to a screen reader what to do; it stays, since one that is made anew is not read. @type {HTMLElement} */
let spoken;
/** @type {OwnGhost} */
let ghost;

/** Makes a pupil's card. */
export function addSeat() {
  card = make("section", "softrod-class softrod-seat");
  card.ariaLabel = "Class";
  spoken = make("p", "softrod-unseen");
  spoken.setAttribute("role", "status");
  document.body.append(spoken);
  keepInPlace(card);
  const ghosts = new Ghosts();
  const anew = betweenPresses(card);
  ghost = new OwnGhost(show);
  openOutbox();
  onMessage("seat", (told) => {
    if (told.asking?.stop !== seat?.asking?.stop || told.asking?.phase !== seat?.asking?.phase) {
      [twin, typed, refusal] = [0, "", ""];
    }
    seat = told;
    anew(show);
  });
  onMessage("predictions", ({ bodies }) => ghosts.show(bodies));
  onMessage("classEnded", () => {
    forgetAnswers();
    ghost.show(false);
    spoken.textContent = "The class is over.";
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
  const task = [...card.querySelectorAll(".softrod-task, .softrod-on-wall, .softrod-warning")].map((text) => text.textContent).join(" ");
  if (spoken.textContent !== task) spoken.textContent = task;
  const again = focused && /** @type {HTMLElement | null} */ (card.querySelector(`[data-focus="${focused}"]`));
  if (again) again.focus();
  else lead(asking);
}

/**
 * Moves the focus to what is asked for, once a phase, for keys and screen readers; but not out of something else, and
 * not on a touch screen, where a keyboard would cover the card.
 *
 * @param {Asking | null} asking
 */
function lead(asking) {
  const now = asking ? `${asking.stop} ${asking.phase} ${asking.round}` : "";
  if (now === led) return;
  led = now;
  const { activeElement } = document;
  const free = !activeElement || activeElement === document.body || activeElement.tagName === "CANVAS" || !activeElement.isConnected;
  if (!asking || !free || matchMedia("(pointer: coarse)").matches) return;
  if (!["ask", "explain"].includes(asking.phase)) return;
  // The question first; a body alone by its grips, which come after the card.
  /** @type {HTMLElement | null} */ (card.querySelector("fieldset, form input") ?? document.querySelector(".softrod-own-grip"))?.focus();
}

/** @param {Seat} seat @returns {HTMLElement[]} */
function parts(seat) {
  if (seat.elsewhere) {
    const whose = seat.elsewhere === "page" ? "Another page of this browser" : "Another device";
    // The server has room for so many pages; this one is left.
    giveUpConnection();
    const back = makeButton("Come back here", () => location.reload(), "softrod-small");
    return [make("p", "softrod-task", `${whose} has your seat now.`), ...(seat.elsewhere === "page" ? [back] : [])];
  }
  if (!seat.asking) return entrance(seat);
  const head = make("header", "softrod-seat-head");
  const name = make("b", "softrod-seat-name", seat.name);
  name.translate = false;
  name.style.setProperty("--softrod-seat", seat.color);
  const up = makeButton(seat.hand ? "Hand is up" : "Hand up", () => send({ do: "raiseHand", up: !seat.hand }), "softrod-small");
  up.ariaPressed = String(seat.hand);
  up.prepend(icon("hand"));
  up.dataset.focus = "hand";
  head.append(name, up);
  const all = [head];
  const task = make("p", "softrod-task", sentence(seat, seat.asking));
  all.push(task);
  if (seat.on_wall) all.push(make("p", "softrod-on-wall", "Yours is on the wall now."));
  all.push(...body(seat, seat.asking));
  if (refusal) all.push(make("p", "softrod-warning", refusal));
  if (unsent().length) all.push(make("p", "softrod-waiting", "Not at the teacher's yet: kept here, and sent as soon as that is possible."));
  if (seat.asking.phase !== "lobby") all.push(about(seat));
  return all;
}

/** What to do, in one sentence. @param {Seat} seat @param {Asking} asking */
function sentence({ paused, away, follows, gathered }, { phase, predict, question, round }) {
  if (away && !["lobby", "try", "collect"].includes(phase)) return "Your teacher's page is away for a moment: wait.";
  if (FREE.has(phase) && gathered) return "Look to the front: this is your teacher's body. Yours waits.";
  if (FREE.has(phase) && follows) return "This is your teacher's body. Yours waits.";
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
  if (FREE.has(phase)) {
    if (seat.gathered) return parts;
    const follow = makeButton(seat.follows ? "Back to my own body" : "Look at the teacher's", () => send({ do: "follow", on: !seat.follows }), "softrod-small");
    follow.dataset.focus = "follow";
    if (seat.follows) return [follow];
    const text = make("p", "", asking.do);
    const anew = makeButton("Begin anew", () => perform("reset"), "softrod-small");
    anew.dataset.focus = "reset";
    if (asking.goal) parts.push(make("p", "softrod-goal", `${seat.reached ? "Reached" : "Goal"}: ${asking.goal}`));
    const row = make("div", "softrod-phases");
    row.append(anew, follow);
    parts.push(text, ...(asking.right >= 0 ? [verdict(asking)] : []), row);
    if (phase === "collect") parts.push(...twins(seat), ...handIn(asking));
  }
  return parts;
}

/** @param {Asking} asking */
function choices(asking) {
  const given = mine(asking, "vote");
  const box = make("fieldset", "");
  // By which a screen reader reads the question first.
  box.tabIndex = -1;
  box.dataset.focus = "question";
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
  input.maxLength = MAX_LETTERS;
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
  // Who was asked again has chosen again.
  const last = asking.phase === "results" ? asking.round : 1;
  const given = (last ? mine({ ...asking, round: last }, "vote") : undefined) ?? mine({ ...asking, round: 0 }, "vote");
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

/** What can be arranged later, too, folded. @param {Seat} seat */
function about(seat) {
  const box = make("details", "");
  const summary = make("summary", "", "This seat");
  summary.dataset.focus = "about";
  box.open = arranges;
  box.addEventListener("toggle", () => (arranges = box.open));
  box.append(summary, ...lobby(seat));
  return box;
}

/** The way back to a seat that another device had. */
function comeBack() {
  const form = make("form", "softrod-back");
  const label = make("label", "", "I had a seat on another device: its two digits ");
  const input = make("input", "");
  input.maxLength = 2;
  input.inputMode = "numeric";
  input.autocomplete = "off";
  input.dataset.focus = "digits";
  label.append(input);
  form.append(label, make("button", "softrod-small", "Take it over"));
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    const digits = input.value.trim();
    if (/^[0-9]{2}$/.test(digits)) send({ do: "takeOver", digits });
  });
  return form;
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
  return [box, comeBack()];
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
  const within = /^[A-Za-z]{4}$/.test(new URLSearchParams(location.search).get("room") ?? "");
  const refused = refusal ? [make("p", "softrod-warning", refusal)] : [];
  return [title, ...(problem ? [make("p", "softrod-warning", problem)] : []), form, ...(within ? [comeBack(), ...refused] : [])];
}
