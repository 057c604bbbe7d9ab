// @ts-check
/** Moving what is selected: whether its springs rest as they are then is asked once, and the tab remembers. */
import { onMessage, pageState, send } from "../../wire/channel.js";
import { wireNumber } from "../../stage/screen.js";
import { make, makeButton, makeDialog } from "../../ui/dialog.js";
import { change } from "./editing.js";
import { kept, store } from "../../ui/kept/storage.js";

const STORED = "softrod-moved-rest";

/** What was chosen: "1" for new rest lengths, "0" for the old ones, null if it was not asked. */
let chosen = kept(STORED);
/** @type {{dialog: HTMLDialogElement} | null} */
let question = null;
/** The move that waits for the answer, in the world. @type {{x: number, y: number, under?: number, keys?: boolean}} */
let waiting = { x: 0, y: 0 };

/** Whether moved springs take their new lengths. */
export const takesNew = () => chosen === "1";

/** @param {boolean} rest */
export function setTakesNew(rest) {
  chosen = rest ? "1" : "0";
  store(STORED, chosen);
  change({});
}

/**
 * Moves what is selected, or one mass.
 *
 * @param {number} x in the world @param {number} y
 * @param {{under?: number, keys?: boolean}} [how]
 */
export function moveSelected(x, y, how = {}) {
  waiting = { x: wireNumber(x), y: wireNumber(y), ...how };
  if (chosen === null) offer();
  else send({ do: "move", ...waiting, rest: takesNew() });
}

function offer() {
  if (!question) {
    const { dialog, body } = makeDialog("Moved masses", "softrod-moved");
    question = { dialog };
    let { scene } = pageState();
    onMessage("pageState", () => {
      if (pageState().scene !== scene) dialog.close(); // it is about another body
      ({ scene } = pageState());
    });
    const line = make("div", "softrod-dialog-line");
    /** @param {boolean} rest */
    const answer = (rest) => () => {
      setTakesNew(rest);
      dialog.close();
      send({ do: "move", ...waiting, rest });
    };
    const rests = makeButton("Take the new lengths", answer(true));
    rests.classList.add("softrod-first");
    rests.autofocus = true;
    line.append(rests, makeButton("Keep the rest lengths", answer(false)));
    body.append(
      make("p", "", "Springs and joints of what you moved can rest as they are now, or keep their rest lengths and angles: then they pull back as soon as the clock runs."),
      line,
      make("p", "", "This is asked once. The button Moved rest changes it."),
    );
  }
  question.dialog.showModal();
}
