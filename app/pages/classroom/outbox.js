// @ts-check
/**
 * The answers that a pupil gives in a class. They stay in the browser until the server has them, through outages, reloads
 * and restarts of the server, and are repeated until then. The server counts each once.
 */
import { onMessage, pageState, send } from "../../wire/channel.js";

/**
 * @typedef {import("../../wire/wire.js").GiveVote | import("../../wire/wire.js").GivePrediction |
 *   import("../../wire/wire.js").GiveLine | import("../../wire/wire.js").GiveWork} Answer
 * @typedef {Answer extends infer A ? A extends Answer ? Omit<A, "id" | "turn"> : never : never} Draft
 */

/** Milliseconds between two repetitions of what is not acknowledged. */
const REPEAT_EVERY = 2000;
const NAME = `softrod-class-${(new URLSearchParams(location.search).get("room") ?? "").toUpperCase()}`;
/** Names that earlier versions stored. @type {Record<string, string>} */
const RENAMED = { givePlaces: "givePrediction", handIn: "giveWork" };

/** What the server has not acknowledged, in order. @type {Answer[]} */
let waiting = read();
/** The turn of the next answer. */
let turn = 1 + Math.max(0, ...waiting.map((answer) => answer.turn));
/** @type {((refused: string) => void)[]} */
const listeners = [];

/** @returns {Answer[]} */
function read() {
  try {
    const found = JSON.parse(localStorage.getItem(NAME) ?? "[]");
    const answers = Array.isArray(found) ? found.filter((answer) => typeof answer?.id === "string") : [];
    return answers.map((answer) => ({ ...answer, do: RENAMED[answer.do] ?? answer.do }));
  } catch {
    return [];
  }
}

function store() {
  try {
    if (waiting.length) localStorage.setItem(NAME, JSON.stringify(waiting));
    else localStorage.removeItem(NAME);
  } catch {
    // Forbidden or full: the page has it for as long as it is open.
  }
}

/** Calls back when something was given, was taken, or was refused, with why. @param {(refused: string) => void} listener */
export const onOutbox = (listener) => listeners.push(listener);

/** What is not acknowledged. */
export const unsent = () => waiting;

/** @param {{stop: number, round: number, twin: number}} one @param {{stop: number, round: number, twin: number}} other */
export const isSamePlace = (one, other) => one.stop === other.stop && one.round === other.round && one.twin === other.twin;

/** Gives an answer, instead of one to the same that still waits. @param {Draft} draft */
export function give(draft) {
  const bytes = crypto.getRandomValues(new Uint8Array(8));
  const id = [...bytes].map((byte) => byte.toString(16).padStart(2, "0")).join("");
  const answer = /** @type {Answer} */ ({ ...draft, id, turn: turn++ });
  waiting = [...waiting.filter((old) => old.do !== answer.do || !isSamePlace(old, answer)), answer];
  store();
  send(answer);
  for (const listener of listeners) listener("");
}

/** Forgets everything: the class is over. */
export function forgetAnswers() {
  waiting = [];
  store();
}

/** Begins to send what waits, and to hear what was taken. */
export function openOutbox() {
  onMessage("taken", ({ ids, refused }) => {
    waiting = waiting.filter(({ id }) => !ids.includes(id));
    store();
    for (const listener of listeners) listener(refused);
  });
  onMessage("seat", (seat) => (turn = Math.max(turn, seat.turn)));
  const repeat = () => {
    if (pageState().page) for (const answer of waiting) send(answer);
  };
  setInterval(repeat, REPEAT_EVERY);
  let page = "";
  onMessage("pageState", () => {
    if (pageState().page === page) return;
    page = pageState().page ?? "";
    // After the page has said whose it is.
    setTimeout(repeat, 200);
  });
}
