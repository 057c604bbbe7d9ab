// @ts-check
/**
 * Printing, on one page: the scene's title and the time over the body, and below it the step of the lesson and the open plots,
 * one below the other, as many as there is room for. looks.css hides everything else.
 */
import { pageState } from "../wire/channel.js";
import { make } from "../ui/dialog.js";
import { copyAt } from "../ui/gui/plot.js";
import { frameMarks } from "./sight.js";
import { timeNow } from "../ui/clock.js";
import { decimal } from "../words/words.js";

/** Width and height of a plot over time on paper, px. */
const PLOT = /** @type {const} */ ([700, 130]);

/** The text of the lesson's present step, without its buttons. */
function lessonWords() {
  const words = make("div", "softrod-paper-lesson");
  const card = document.querySelector(".softrod-lesson:not([hidden])");
  for (const part of card?.querySelectorAll("h2, p, legend, .softrod-choice") ?? []) {
    words.append(make(part.matches("h2") ? "h2" : "p", "", part.textContent ?? ""));
  }
  return words;
}

/** Pictures of the open plots, each with its title and readings. */
function plots() {
  const all = make("div", "softrod-paper-plots");
  const parts = document.querySelectorAll(".softrod-panel :is(.softrod-plot-title, svg.softrod-chart, svg.softrod-phase, .softrod-reading)");
  for (const part of parts) {
    if (part.closest("[role=tabpanel][hidden]") && part.closest(".softrod-lesson-page")) continue; // Measure has it, too
    if (part.matches(".softrod-plot-title")) all.append(make("figure", ""));
    all.lastElementChild?.append(copyAt(part, ...PLOT));
  }
  return all;
}

/** Adds the heading to the page, and fills it before the page is printed. */
export function addPaper() {
  const heading = make("div", "softrod-paper");
  const title = make("h1", "");
  const time = make("p", "");
  heading.append(title, time);
  const below = make("div", "softrod-paper-below");
  document.body.append(heading, below);
  const fill = () => {
    const [words, curves] = [lessonWords(), plots()];
    below.replaceChildren(...[words, curves].filter((part) => part.childElementCount));
    const { style } = document.documentElement;
    style.setProperty("--softrod-words", String(Math.min(words.childElementCount, 1)));
    style.setProperty("--softrod-plots", String(curves.childElementCount));
    style.setProperty("--softrod-pairs", String(Math.ceil(curves.childElementCount / 2)));
    title.textContent = pageState().title ?? "";
    time.textContent = `t = ${decimal(timeNow().toFixed(2))} s`;
    frameMarks(true);
  };
  matchMedia("print").addEventListener("change", ({ matches }) => (matches ? fill() : frameMarks(false)));
  window.addEventListener("beforeprint", fill);
  window.addEventListener("afterprint", () => frameMarks(false));
}
