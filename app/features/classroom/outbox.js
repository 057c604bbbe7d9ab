// @ts-check
/**
 * What a pupil gives in a class. It stays in the browser until the server has it, through outages, reloads and a server
 * that is started anew, and is said again until then. The server counts it once.
 */
import { onMessage, pageState, send } from "../../wire/channel.js";

/**
 * @typedef {import("../../wire/wire.js").GiveVote | import("../../wire/wire.js").GivePlaces |
 *   import("../../wire/wire.js").GiveLine | import("../../wire/wire.js").HandIn} Answer
 * @typedef {Answer extends infer A ? A extends Answer ? Omit<A, "id" | "turn"> : never : never} Draft
 */

/** Milliseconds between two sayings of what is not acknowledged. */
const AGAIN_EVERY = 2000;
const NAME = `softrod-class-${(new URLSearchParams(location.search).get("room") ?? "").toUpperCase()}`;

/** What the server has not acknowledged, in order. @type {Answer[]} */
let waiting = read();
/** The turn of the next answer. */
let turn = 1 + Math.max(0, ...waiting.map((answer) => answer.turn));
/** @type {((refused: string) => void)[]} */
const onlookers = [];

/** @returns {Answer[]} */
function read() {
  try {
    const found = JSON.parse(localStorage.getItem(NAME) ?? "[]");
    return Array.isArray(found) ? found.filter((answer) => typeof answer?.id === "string") : [];
  } catch {
    return [];
  }
}

function keep() {
  try {
    if (waiting.length) localStorage.setItem(NAME, JSON.stringify(waiting));
    else localStorage.removeItem(NAME);
  } catch {
    // Forbidden or full: it is kept as long as the page is there.
  }
}

/** Calls back when something was given, was taken, or was refused, with why. @param {(refused: string) => void} look */
export const onOutbox = (look) => onlookers.push(look);

/** What is not acknowledged. */
export const unsent = () => waiting;

/** Gives an answer; one to the same that still waits goes. @param {Draft} draft */
export function give(draft) {
  const bytes = crypto.getRandomValues(new Uint8Array(8));
  const id = [...bytes].map((byte) => byte.toString(16).padStart(2, "0")).join("");
  const answer = /** @type {Answer} */ ({ ...draft, id, turn: turn++ });
  waiting = waiting.filter(
    (old) => !(old.do === answer.do && old.stop === answer.stop && old.round === answer.round && old.twin === answer.twin),
  );
  waiting.push(answer);
  keep();
  send(answer);
  for (const look of onlookers) look("");
}

/** Forgets everything: the class is over. */
export function forgetAnswers() {
  waiting = [];
  keep();
}

/** Begins to say what waits, and to hear what was taken. */
export function openOutbox() {
  onMessage("taken", ({ ids, refused }) => {
    waiting = waiting.filter(({ id }) => !ids.includes(id));
    keep();
    for (const look of onlookers) look(refused);
  });
  onMessage("seat", (seat) => (turn = Math.max(turn, seat.turn)));
  const say = () => {
    if (pageState().page) for (const answer of waiting) send(answer);
  };
  setInterval(say, AGAIN_EVERY);
  let page = "";
  onMessage("pageState", () => {
    if (pageState().page === page) return;
    page = pageState().page ?? "";
    // After the page has said whose it is.
    setTimeout(say, 200);
  });
}
