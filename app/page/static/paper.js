// @ts-check
/** On paper: the scene's title and the time over the body. looks.css leaves out everything else. */
import { told } from "./channel.js";
import { frameMarks } from "./overlay.js";
import { timeNow } from "./transport.js";

/** Puts up the heading, and fills it in before the page is printed. */
export function addHeading() {
  const heading = document.createElement("div");
  heading.className = "softrod-paper";
  const title = document.createElement("h1");
  const time = document.createElement("p");
  heading.append(title, time);
  document.body.append(heading);
  const fill = () => {
    title.textContent = told().title ?? "";
    time.textContent = `t = ${timeNow().toFixed(2)} s`;
    frameMarks(true);
  };
  matchMedia("print").addEventListener("change", ({ matches }) => (matches ? fill() : frameMarks(false)));
  window.addEventListener("beforeprint", fill);
  window.addEventListener("afterprint", () => frameMarks(false));
}
