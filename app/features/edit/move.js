// @ts-check
/** Moves the selection. Whether its springs take their new lengths as rest lengths is asked once per tab. */
import { onMessage, pageState, send } from "../../wire/channel.js";
import { wireNumber } from "../../stage/screen.js";
import { make, makeButton, makeDialog } from "../../ui/dialog.js";
import { change } from "./editing.js";
import { kept, store } from "../../ui/kept/storage.js";
import { say } from "../../words/words.js";

const STORED = "softrod-moved-rest";

/** The answer: "1" for new rest lengths, "0" for the old ones, null if the question was not asked. */
let chosen = kept(STORED);
/** The question. @type {HTMLDialogElement | null} */
let question = null;
/** The move that waits for the answer, in the page's world. @type {{x: number, y: number, under?: number, keys?: boolean}} */
let waiting = { x: 0, y: 0 };

/** Whether moved springs take their new lengths as rest lengths. */
export const takesNewLengths = () => chosen === "1";

/** @param {boolean} on */
export function setTakesNewLengths(on) {
  chosen = on ? "1" : "0";
  store(STORED, chosen);
  change({});
}

/**
 * Moves the selection, or one mass.
 *
 * @param {number} x in the page's world @param {number} y
 * @param {{under?: number, keys?: boolean}} [how]
 */
export function moveSelected(x, y, how = {}) {
  waiting = { x: wireNumber(x), y: wireNumber(y), ...how };
  if (chosen === null) (question ??= makeQuestion()).showModal();
  else send({ do: "move", ...waiting, rest: takesNewLengths() });
}

function makeQuestion() {
  const { dialog, body } = makeDialog(say("edit-moved"), "softrod-moved");
  let { scene } = pageState();
  onMessage("pageState", () => {
    if (pageState().scene !== scene) dialog.close(); // it is about another body
    ({ scene } = pageState());
  });
  /** @param {string} text @param {boolean} rest @param {string} [name] of its class */
  const answer = (text, rest, name) =>
    makeButton(text, () => {
      setTakesNewLengths(rest);
      dialog.close();
      send({ do: "move", ...waiting, rest });
    }, name);
  const first = answer(say("edit-moved.take"), true, "softrod-button softrod-first");
  first.autofocus = true;
  const line = make("div", "softrod-dialog-line");
  line.append(first, answer(say("edit-moved.keep"), false));
  body.append(
    make("p", "", say("edit-moved.text")),
    line,
    make("p", "", say("edit-moved.once")),
  );
  return dialog;
}
