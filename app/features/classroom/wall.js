// @ts-check
/** The wall: what a class sees in front, large enough for the last row, and without a name. */
import { onMessage } from "../../wire/channel.js";
import { make } from "../../ui/dialog.js";
import { Ghosts } from "./ghost.js";
import { plot, power } from "./plot.js";

/** @typedef {import("../../wire/wire.js").Wall} Wall */

/** Milliseconds after which a wall to which nobody has come says what that may be due to. */
const ALONE_AFTER = 60_000;

/** Makes the wall. */
export function addWall() {
  const head = make("header", "softrod-class softrod-wall-head");
  const side = make("aside", "softrod-class softrod-wall-side");
  const corner = make("div", "softrod-class softrod-wall-corner");
  document.body.append(head, side, corner);
  const ghosts = new Ghosts();
  /** @type {Wall | null} */
  let last = null;
  let waited = false;
  /** @param {Wall} wall */
  const show = (wall) => {
    head.replaceChildren(make("h1", "", title(wall)));
    const parts = content(wall);
    side.replaceChildren(...parts);
    // With nothing beside it, the body has the room.
    document.documentElement.toggleAttribute("data-softrod-wide", !parts.length);
    if (waited && wall.asking.phase === "lobby" && !wall.seats) {
      side.append(make("p", "softrod-warning", "Nobody yet? Networks may keep devices apart: try this laptop's hotspot."));
    }
    corner.replaceChildren(`${host(wall.address)}   `, make("b", "", wall.code));
    corner.translate = false;
  };
  setTimeout(() => {
    waited = true;
    if (last) show(last);
  }, ALONE_AFTER);
  onMessage("predictions", ({ bodies }) => ghosts.show(bodies));
  onMessage("wall", (wall) => {
    last = wall;
    show(wall);
  });
  onMessage("classEnded", () => {
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
function content({ asking, bars, lines, code, address, qr, found, over, law, doing }) {
  const { phase, question, choices, right, because, predict } = asking;
  if (phase === "lobby") {
    const picture = make("img", "softrod-wall-qr");
    picture.src = qr;
    picture.alt = `QR code of ${address}?room=${code}`;
    const typed = make("p", "softrod-wall-address", host(address));
    const letters = make("p", "softrod-wall-code", code);
    typed.translate = letters.translate = false;
    return [picture, make("p", "", "Scan this, or type"), typed, make("p", "", "and the four letters"), letters];
  }
  /** @type {Element[]} */
  const parts = [];
  const asks = phase === "ask" || phase === "results" || phase === "run";
  if (phase === "ask" && predict > 0) parts.push(make("p", "", `Where will it be after ${predict} s?`));
  if (asks && question) {
    parts.push(make("h2", "", question));
    parts.push(voted(choices, phase === "ask" ? [] : bars, right));
  }
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
function counts(doing) {
  const list = make("ul", "softrod-counts");
  for (const [word, count] of Object.entries(doing)) {
    const item = make("li", "");
    item.append(make("b", "", String(count)), make("span", "", word));
    list.append(item);
  }
  return list;
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
