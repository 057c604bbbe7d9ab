// @ts-check
/** The wall: what a class sees on the projector, large enough for the last row, and without names. */
import { onMessage } from "../../wire/channel.js";
import { make } from "../../ui/dialog.js";
import { box, qrCode, typedAddress, untranslated, voteBars } from "./elements.js";
import { plot, power } from "./plot.js";
import { Predictions } from "./prediction.js";

/** @typedef {import("../../wire/wire.js").Wall} Wall */

/** Milliseconds after which a wall that nobody has come to names a possible reason. */
const EMPTY_AFTER = 60_000;
/** What the class has to do in a phase that waits for all. */
const WAITS = { ask: "have answered", explain: "have written a line", collect: "have handed in" };

/** Makes the wall. */
export function addWall() {
  const head = make("header", "softrod-class softrod-wall-head");
  const side = make("aside", "softrod-class softrod-wall-side");
  const corner = untranslated(make("div", "softrod-class softrod-wall-corner"));
  document.body.append(head, side, corner);
  const predictions = new Predictions();
  /** @type {Wall | null} */
  let wall = null;
  let hasWaited = false;
  const show = () => {
    if (!wall) return;
    head.replaceChildren(make("h1", "", title(wall)));
    const parts = content(wall);
    // With nothing beside it, the body has the whole width.
    document.documentElement.toggleAttribute("data-softrod-wide", !parts.length);
    if (hasWaited && wall.asking.phase === "lobby" && !wall.seats) {
      parts.push(make("p", "softrod-warning", "Nobody yet? Networks may keep devices apart: try this laptop's hotspot."));
    }
    side.replaceChildren(...parts);
    corner.replaceChildren(`${typedAddress(wall.address)}   `, make("b", "", wall.code));
  };
  setTimeout(() => {
    hasWaited = true;
    show();
  }, EMPTY_AFTER);
  onMessage("predictions", ({ bodies }) => predictions.show(bodies));
  onMessage("wall", (told) => {
    wall = told;
    show();
  });
  onMessage("classEnded", () => {
    predictions.show([]);
    head.replaceChildren(make("h1", "", "The class is over."));
    side.replaceChildren();
    corner.replaceChildren();
  });
}

/** @param {Wall} wall */
function title({ asking: { phase, title }, seats, answered }) {
  if (phase === "lobby") return `${seats} ${seats === 1 ? "is" : "are"} here`;
  const waits = WAITS[/** @type {keyof typeof WAITS} */ (phase)];
  return waits ? `${answered} of ${seats} ${waits}` : title;
}

/** @param {Wall} wall @returns {Element[]} */
function content({ asking, bars, lines, code, address, qr, found, over, law, doing }) {
  const { phase, question, choices, right, because, predict } = asking;
  if (phase === "lobby") {
    const typed = untranslated(make("p", "softrod-wall-address", typedAddress(address)));
    const letters = untranslated(make("p", "softrod-wall-code", code));
    const scanned = qrCode(qr, `${address}?room=${code}`, "softrod-wall-qr");
    return [scanned, make("p", "", "Scan this, or type"), typed, make("p", "", "and the four letters"), letters];
  }
  /** @type {Element[]} */
  const parts = [];
  const asks = phase === "ask" || phase === "results" || phase === "run";
  if (phase === "ask" && predict > 0) parts.push(make("p", "", `Where will it be after ${predict} s?`));
  if (asks && question) parts.push(make("h2", "", question), voteBars(choices, phase === "ask" ? [] : bars, right));
  if (right >= 0 && phase === "results") parts.push(make("p", "softrod-verdict", because));
  if (phase === "explain") parts.push(make("h2", "", "Why did it do that? One line."));
  if (phase === "try" || phase === "collect") {
    // The plot needs the room.
    if (!found.length) parts.push(make("p", "", asking.do));
    if (asking.goal) parts.push(make("p", "", `Goal: ${asking.goal}`));
    parts.push(counts(doing));
    if (found.length) parts.push(plot(found, over, asking.collects, law));
    if (law) parts.push(make("p", "", power(law, asking.collects, over)));
  }
  for (const { text, color } of found.length ? [] : lines) {
    const quoted = make("blockquote", "", text);
    quoted.style.setProperty("--softrod-seat", color);
    parts.push(quoted);
  }
  return parts;
}

/** How many bodies do what, in large numbers. @param {Record<string, number>} doing */
const counts = (doing) =>
  box("ul", "softrod-counts", ...Object.entries(doing).map(([word, count]) => box("li", "", make("b", "", String(count)), make("span", "", word))));
