// @ts-check
/** The wall: what a class sees in front, large enough for the last row, and without a name. */
import { onTold } from "../../wire/channel.js";
import { make } from "../looks/dialog.js";
import { SVG } from "../body/overlay.js";
import { Ghosts } from "./ghost.js";

/** @typedef {import("../../wire/wire.js").Wall} Wall */

/** Makes the wall. */
export function addWall() {
  const head = make("header", "softrod-class softrod-wall-head");
  const side = make("aside", "softrod-class softrod-wall-side");
  const corner = make("div", "softrod-class softrod-wall-corner");
  document.body.append(head, side, corner);
  const ghosts = new Ghosts();
  onTold("predictions", ({ bodies }) => ghosts.show(bodies));
  onTold("wall", (wall) => {
    head.replaceChildren(make("h1", "", title(wall)));
    side.replaceChildren(...content(wall));
    corner.replaceChildren(...(wall.asking.phase === "lobby" ? [] : [`${host(wall.address)}   `, make("b", "", wall.code)]));
  });
  onTold("classEnded", () => {
    ghosts.show([]);
    head.replaceChildren(make("h1", "", "The class is over."));
    side.replaceChildren();
    corner.replaceChildren();
  });
}

/** An address as one types it. @param {string} address */
const host = (address) => address.replace(/^http:\/\//, "").replace(/\/$/, "");

/** @param {Wall} wall */
function title({ asking, seats, answered }) {
  const { phase } = asking;
  if (phase === "lobby") return `${seats} ${seats === 1 ? "is" : "are"} here`;
  if (phase === "ask" || phase === "explain" || phase === "collect") {
    const what = { ask: "have answered", explain: "have written a line", collect: "have handed in" }[phase];
    return `${answered} of ${seats} ${what}`;
  }
  return asking.title;
}

/** @param {Wall} wall @returns {Element[]} */
function content({ asking, bars, lines, code, address, qr, found, over, doing }) {
  const { phase, question, choices, right, because, predict } = asking;
  if (phase === "lobby") {
    const picture = make("img", "softrod-wall-qr");
    picture.src = qr;
    picture.alt = `QR code of ${address}?room=${code}`;
    return [
      picture,
      make("p", "softrod-wall-address", host(address)),
      make("p", "softrod-wall-code", code),
    ];
  }
  /** @type {Element[]} */
  const parts = [];
  const asks = phase === "ask" || phase === "results" || phase === "run";
  if (phase === "ask" && predict > 0) parts.push(make("p", "", `Where will it be after ${predict} s?`));
  if (asks && question) {
    parts.push(make("h2", "", question));
    parts.push(voted(choices, phase === "ask" ? [] : bars, right));
  }
  if (right >= 0 && phase !== "ask") parts.push(make("p", "softrod-verdict", because));
  if (phase === "explain") parts.push(make("h2", "", "Why did it do that? One line."));
  if (phase === "try" || phase === "collect") {
    parts.push(make("p", "", asking.do));
    if (asking.goal) parts.push(make("p", "", `Goal: ${asking.goal}`));
    for (const [word, count] of Object.entries(doing)) parts.push(make("p", "softrod-count", `${count} ${word}`));
    if (found.length) parts.push(plot(found, over, asking.collects));
  }
  for (const { text, color } of lines) {
    const quoted = make("blockquote", "", text);
    quoted.style.setProperty("--softrod-seat", color);
    parts.push(quoted);
  }
  return parts;
}

/**
 * The choices, and how many have chosen each; which is right is seen only when it is told.
 *
 * @param {string[]} choices
 * @param {number[]} bars
 * @param {number} right
 */
export function voted(choices, bars, right) {
  const list = make("ol", "softrod-bars");
  const most = Math.max(1, ...bars);
  choices.forEach((choice, i) => {
    const item = make("li", "");
    item.append(make("span", "", choice));
    if (bars.length) {
      const bar = make("i", "");
      bar.style.setProperty("--softrod-part", String(bars[i] / most));
      item.append(bar, make("b", "", String(bars[i])));
    }
    if (i === right) item.dataset.right = "";
    list.append(item);
  });
  return list;
}

/** Sizes of the class's plot, in its own units. */
const [WIDE, HIGH, LEFT, BELOW] = [400, 260, 56, 44];

/**
 * What each seat found, a point a seat. Both axes go by powers of ten where the numbers do, so that a law of powers is
 * a straight line.
 *
 * @param {import("../../wire/wire.js").Found[]} found
 * @param {string} over
 * @param {string} what
 */
export function plot(found, over, what) {
  const svg = document.createElementNS(SVG, "svg");
  svg.setAttribute("viewBox", `0 0 ${WIDE} ${HIGH}`);
  svg.classList.add("softrod-class-plot");
  svg.setAttribute("role", "img");
  svg.setAttribute("aria-label", `${what} over ${over}: ${found.length} points`);
  const x = axis(found.map(({ setting }) => setting));
  const y = axis(found.map((one) => one.found));
  /** @param {keyof SVGElementTagNameMap} kind @param {Record<string, number | string>} attributes @param {string} [text] */
  const add = (kind, attributes, text = "") => {
    const element = document.createElementNS(SVG, kind);
    for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
    element.textContent = text;
    svg.append(element);
  };
  const [right, low] = [WIDE - 12, HIGH - BELOW];
  add("path", { d: `M${LEFT} 8V${low}H${right}` });
  for (const { setting, found: value } of found) {
    add("circle", { cx: LEFT + x.part(setting) * (right - LEFT), cy: low - y.part(value) * (low - 8), r: 6 });
  }
  const bottom = low + 18;
  add("text", { x: LEFT, y: bottom }, x.low);
  add("text", { x: right, y: bottom, "text-anchor": "end" }, x.high);
  add("text", { x: LEFT - 6, y: low, "text-anchor": "end" }, y.low);
  add("text", { x: LEFT - 6, y: 18, "text-anchor": "end" }, y.high);
  add("text", { x: (LEFT + right) / 2, y: HIGH - 6, "text-anchor": "middle" }, over);
  add("text", { x: LEFT + 8, y: 18 }, what);
  return svg;
}

/**
 * Where numbers lie between the least and the largest, from 0 to 1.
 *
 * @param {number[]} numbers
 */
function axis(numbers) {
  const [least, most] = [Math.min(...numbers), Math.max(...numbers)];
  // Beyond a factor of five, a straight line is no way to see them all.
  const scale = least > 0 && most > 5 * least ? Math.log : (/** @type {number} */ number) => number;
  const [low, high] = [scale(least), scale(most)];
  const margin = high > low ? 0.06 * (high - low) : 1;
  return {
    part: (/** @type {number} */ number) => (scale(number) - low + margin) / (high - low + 2 * margin),
    low: String(Number(least.toPrecision(3))),
    high: String(Number(most.toPrecision(3))),
  };
}
