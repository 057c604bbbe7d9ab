// @ts-check
/** The pointer over a plot of one quantity over another reads values: viser's plots do that by themselves. */

import { makeSvg } from "../../stage/svg.js";
import { decimal } from "../../words/words.js";

/** Pixels between the pointer and what is read. */
const AWAY = 14;

/** The numbers in a text. @param {string | undefined} text */
const numbers = (text) => (text ?? "").split(" ").map(Number);

/**
 * What a place in a plot stands for; null outside its axes.
 *
 * @param {number} x in units of the drawing
 * @param {number} y
 * @param {number[]} edges of the axes: left, right, bottom, top
 * @param {number[]} ends of the axes: from and to, to the right and upwards
 */
export function valuesAt(x, y, [left, right, bottom, top], [x0, x1, y0, y1]) {
  if (!(x >= left && x <= right && y >= top && y <= bottom)) return null;
  return [x0 + ((x - left) / (right - left)) * (x1 - x0), y0 + ((bottom - y) / (bottom - top)) * (y1 - y0)];
}

/**
 * Marks in a plot where its sound is: a place, or a line where there is no height; nothing without either.
 *
 * @param {HTMLElement} element that has the plot @param {number | null} right @param {number | null} up
 */
export function markPhase(element, right, up) {
  const svg = element.querySelector("svg.softrod-phase");
  const before = element.querySelector(".softrod-heard");
  if (!(svg instanceof SVGSVGElement) || right === null) {
    before?.remove();
    return;
  }
  // The server draws the plot anew while the body moves.
  const made = before ?? svg.appendChild(makeSvg("path", "softrod-heard"));
  const [left, end, bottom, top] = numbers(svg.dataset.edges);
  const [x0, x1, y0, y1] = numbers(svg.dataset.ends);
  const x = left + ((right - x0) / (x1 - x0)) * (end - left);
  const y = up === null ? 0 : bottom - ((up - y0) / (y1 - y0)) * (bottom - top);
  made.setAttribute("d", up === null ? `M${x} ${top}V${bottom}` : `M${x} ${top}V${bottom}M${left} ${y}H${end}`);
}

/** Begins to read. */
export function readPhases() {
  const box = document.createElement("div");
  box.className = "softrod-phase-values";
  box.hidden = true;
  document.body.append(box);
  document.addEventListener("pointermove", ({ target, clientX, clientY }) => {
    const svg = target instanceof Element ? target.closest("svg.softrod-phase") : null;
    if (!(svg instanceof SVGSVGElement)) {
      box.hidden = true;
      return;
    }
    const { left, top, width } = svg.getBoundingClientRect();
    const part = svg.viewBox.baseVal.width / width;
    const { edges, ends, right = "", up = "" } = svg.dataset;
    const found = valuesAt((clientX - left) * part, (clientY - top) * part, numbers(edges), numbers(ends));
    box.hidden = found === null;
    if (!found) return;
    const [x, y] = found.map((value) => decimal(String(Number(value.toPrecision(4)))));
    box.textContent = `${right}: ${x}\n${up}: ${y}`;
    // To the left of the pointer: at its right is the edge of the window.
    box.style.left = `${Math.max(clientX - box.offsetWidth - AWAY, 4)}px`;
    box.style.top = `${Math.max(clientY - box.offsetHeight - AWAY, 4)}px`;
  });
}
