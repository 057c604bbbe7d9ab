// @ts-check
/**
 * Shows the Measure tab when the server asks for it, and reports to the server whether the plots are visible: they are
 * not sent otherwise.
 */
import { onMessage, pageState, send } from "../../wire/channel.js";
import { hearLater } from "../../wire/later.js";
import { addTeller } from "../../ui/dialog.js";
import { readPhases } from "./phase.js";
import { showTab } from "../../ui/gui/gui.js";
import { say } from "../../words/words.js";

/** Milliseconds between two checks whether plots are visible. */
const CHECK_EVERY = 250;
/** Milliseconds between two checks for a new plot. */
const POLL_EVERY = 50;
const MAX_POLLS = 20;

const titles = () => [...document.querySelectorAll(".softrod-plot-title")];

/** Whether a message is to be heard: only then the sound is loaded. @param {import("../../wire/wire.js").Received["melody" | "tones" | "pageState"]} message */
const isHeard = (message) => message.tell === "melody" || (message.tell === "tones" && Boolean(message.plot));

function begin() {
  readPhases();
  hearLater(["melody", "tones", "pageState"], isHeard, async () => (await import("./sound.js")).hear);
  const tell = addTeller();
  onMessage("showMeasures", () => {
    const { measuring = "" } = pageState();
    const count = titles().length;
    if (!measuring) return;
    showTab(measuring);
    showNew(count, tell);
  });
  reportVisibility();
  beginWithPlot();
}

/** Asks for a plot when the tab is shown for the first time. */
function beginWithPlot() {
  let asked = false;
  document.addEventListener("softrod-tab", (event) => {
    if (asked || /** @type {CustomEvent} */ (event).detail !== pageState().measuring) return;
    asked = true;
    send({ do: "firstPlot" });
  });
}

/** Scrolls to the newest plot, once it exists, and says of what it is. @param {number} count of plots before @param {(text: string) => void} tell */
function showNew(count, tell) {
  let tries = 0;
  const poll = setInterval(() => {
    const present = titles();
    if (present.length <= count && ++tries < MAX_POLLS) return;
    clearInterval(poll);
    const newest = present.at(-1);
    newest?.scrollIntoView({ block: "start" });
    if (newest && present.length > count) tell(say("measure-opened", { plot: (newest.textContent ?? "").trim() }));
  }, POLL_EVERY);
}

function reportVisibility() {
  /** @type {string | undefined} */
  let page;
  /** @type {"measure" | "lesson" | "" | null} */
  let reported = null;
  setInterval(() => {
    if (pageState().page !== page) {
      page = pageState().page;
      reported = null;
    }
    // What is in a hidden tab or a folded panel has no box on the screen.
    const seen = document.visibilityState === "visible" && titles().some((title) => title.getClientRects().length);
    const tab = !seen ? "" : document.getElementById("softrod-lesson")?.getClientRects().length ? "lesson" : "measure";
    if (!page || tab === reported) return;
    reported = tab;
    send({ do: "seen", tab });
  }, CHECK_EVERY);
}

/** @type {import("../../ui/feature.js").Feature<"measure">} */
export default { commands: {}, begin };
