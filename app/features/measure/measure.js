// @ts-check
/**
 * Shows the Measure tab when the server asks for it, since viser has no way to turn to a tab, and tells the server
 * whether anybody sees the plots, which are not sent otherwise.
 */
import { onMessage, pageState, send } from "../../wire/channel.js";
import { readPhases } from "./phase.js";
import { tabOf } from "../../ui/viser/widgets.js";

/** Milliseconds between two looks whether plots can be seen. */
const LOOK_EVERY = 250;
/** Milliseconds between two looks whether a new plot is there, and how many. */
const [SOON, TRIES] = [50, 20];

const titles = () => [...document.querySelectorAll(".softrod-plot-title")];

function begin() {
  readPhases();
  // Legends of plots then read what is ahead, too.
  onMessage("pageState", ({ scrubbed = false }) => document.documentElement.toggleAttribute("data-softrod-past", scrubbed));
  onMessage("showMeasures", () => {
    const { measuring = "" } = pageState();
    const count = titles().length;
    const tab = measuring && tabOf(measuring);
    if (!(tab instanceof HTMLElement)) return;
    // The panel beside the canvas hears of no click, that of a phone of nothing else.
    tab.dispatchEvent(new KeyboardEvent("keydown", { key: "Enter", bubbles: true, cancelable: true }));
    tab.click();
    scrollToNew(count);
  });
  tellWhetherSeen();
}

/** Scrolls to the newest plot, once it is there. @param {number} count of plots before */
function scrollToNew(count) {
  let tries = 0;
  const look = setInterval(() => {
    const present = titles();
    if (present.length <= count && ++tries < TRIES) return;
    clearInterval(look);
    present.at(-1)?.scrollIntoView({ block: "start" });
  }, SOON);
}

function tellWhetherSeen() {
  /** @type {string | undefined} */
  let page;
  /** @type {"measure" | "lesson" | "" | null} */
  let said = null;
  setInterval(() => {
    if (pageState().page !== page) {
      page = pageState().page;
      said = null;
    }
    // What is in a tab that is not shown, or in a folded panel, has no place on the screen.
    const seen = document.visibilityState === "visible" && titles().some((title) => title.getClientRects().length);
    const tab = !seen ? "" : document.getElementById("softrod-lesson")?.getClientRects().length ? "lesson" : "measure";
    if (!page || tab === said) return;
    said = tab;
    send({ do: "seen", tab });
  }, LOOK_EVERY);
}

/** @type {import("../../ui/feature.js").Feature<"measure">} */
export default { commands: {}, begin };
