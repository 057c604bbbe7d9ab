// @ts-check
/** The wall: what a class sees on the projector, large enough for the last row, and without names. */
import { element } from "../../export/static/parts.js";
import { box, qrCode, sayWith, typedAddress, voteBars } from "../../features/classroom/elements.js";
import { partsOf } from "../../features/classroom/guide.js";
import { OWN_BODY } from "../../features/classroom/phases.js";
import { plot, power } from "../../features/classroom/plot.js";
import { Predictions } from "../../features/classroom/prediction.js";
import { make, untranslated } from "../../ui/dialog.js";
import { onMessage } from "../../wire/channel.js";
import { say } from "../../words/words.js";
import { keepAwake } from "./awake.js";
import { Bench } from "./bench.js";
import { hangUp } from "./line.js";
import { Reveal } from "./reveal.js";

/** @typedef {import("../../wire/wire.js").Wall} Wall */

/** Milliseconds after which a wall that nobody has come to names a possible reason. */
const EMPTY_AFTER = 60_000;
/** How many have done it, in a phase that waits for all. */
const WAITS = /** @type {const} */ ({ ask: "class-answered", explain: "class-wrote", collect: "class-handed-in" });
/** How many bodies do what; the number stands over it. @type {Record<string, "wall-trying" | "wall-exploded" | "wall-untouched" | "wall-at-goal">} */
const DOING = { trying: "wall-trying", exploded: "wall-exploded", untouched: "wall-untouched", "at the goal": "wall-at-goal" };
/** Size of the letters of the class's plot, in its units: on a slide, 1/30 of its height. */
const PLOT_LETTERS = 20;
/** Letters of an answer that stands as large as a number. */
const SHORT = 9;
/** How many lines as high as its letters the wall has: the first of these with which all that stands at its side is seen. */
const LINES = [22, 24, 26, 28, 30, 32, 34, 36, 40, 44];
/** Width of a slide by its height. */
const SLIDE = 16 / 9;
/** Most pupils who have a ring each that fills when they have answered. */
const MAX_RINGS = 40;

/**
 * Makes the wall.
 *
 * @param {import("./picture.js").Picture} picture
 * @returns {{lineChanged: (away: boolean) => string}} see `addSeat`
 */
export function addWall(picture) {
  const side = make("aside", "softrod-class softrod-wall-side");
  const corner = untranslated(make("div", "softrod-class softrod-wall-corner"));
  document.body.append(side);
  element("stage", HTMLElement).prepend(make("h1", "softrod-tell", say("class-title")));
  element("stage", HTMLElement).append(corner);
  keepAwake(true);
  const bench = new Bench(make("div", ""), () => false);
  const predictions = new Predictions(picture);
  const reveal = new Reveal(picture);
  /** @type {Wall | null} */
  let wall = null;
  /** @type {import("../../features/classroom/prediction.js").Place[][]} */
  let bodies = [];
  let shown = "";
  let hasWaited = false;
  const draw = () => {
    if (!wall) return;
    const isReveal = wall.asking.phase === "reveal";
    // Where a moment was asked for, the body stands at it.
    const start = isReveal && wall.asking.predict > 0 ? wall.start : [];
    reveal.show(start, bodies, wall.unit, wall.asking.masses);
    predictions.show(start.length ? [] : bodies, wall.asking.masses);
  };
  const show = () => {
    if (!wall) return;
    const { phase } = wall.asking;
    const now = JSON.stringify([wall, hasWaited]);
    if (now === shown) return;
    shown = now;
    document.documentElement.dataset.softrodClass = phase === "lobby" ? "wall lobby" : "wall";
    document.documentElement.dataset.softrodPhase = phase;
    const parts = content(wall);
    // With nothing beside it, the body has the whole width.
    document.documentElement.toggleAttribute("data-softrod-wide", !parts.length);
    if (hasWaited && phase === "lobby" && !wall.seats) {
      parts.push(make("p", "softrod-warning", say("wall-nobody")));
    }
    if (phase === "run") parts.push(bench.plots);
    side.replaceChildren(...parts);
    fit(0);
    corner.replaceChildren(...wayIn(wall));
    draw();
  };
  let lines = 0;
  /** Makes the letters at the side as large as there is room for. @param {number} first of `LINES` */
  const fit = (first) => {
    for (lines = first; lines < LINES.length; lines++) {
      side.style.fontSize = `${Math.min(innerHeight, innerWidth / SLIDE) / LINES[lines]}px`;
      if (side.scrollHeight <= side.clientHeight && side.scrollWidth <= side.clientWidth) return;
    }
  };
  addEventListener("resize", () => fit(0));
  // Readings that have become longer; letters do not grow again while they change.
  new ResizeObserver(() => fit(lines)).observe(bench.plots);
  setTimeout(() => {
    hasWaited = true;
    show();
  }, EMPTY_AFTER);
  onMessage("predictions", (told) => {
    bodies = told.bodies;
    picture.include(bodies.reduce((all, places) => all.concat(places), []));
    draw();
  });
  onMessage("wall", (told) => {
    wall = told;
    show();
  });
  onMessage("classEnded", () => {
    predictions.show([]);
    reveal.show([], [], "", []);
    wall = null;
    keepAwake(false);
    side.replaceChildren(make("h2", "", say("class-over")));
    corner.replaceChildren();
    hangUp();
  });
  return { lineChanged: () => "" };
}

/** How one comes in, while it may be wanted: with a QR code while pupils answer. @param {Wall} wall @returns {Node[]} */
function wayIn({ asking: { phase }, address, code, qr }) {
  if (phase === "lobby") return [];
  const words = box("p", "", ...sayWith("wall-way-in", { address: make("b", "", typedAddress(address)), code: make("b", "softrod-wall-letters", code) }));
  return phase === "ask" ? [qrCode(qr, `${address}?room=${code}`), words] : [words];
}

/** How many of those who are here have done what is asked. @param {Wall} wall @returns {Element[]} */
function count({ asking: { phase }, seats, answered }) {
  const waits = WAITS[/** @type {keyof typeof WAITS} */ (phase)];
  if (!waits) return [];
  const rings = box("div", "softrod-rings", ...Array.from({ length: seats <= MAX_RINGS ? seats : 0 }, (_, i) => make("i", i < answered ? "softrod-done" : "")));
  // Said as a number it chooses the form of the sentence; it is made bold after that.
  const parts = say(waits, { done: answered, all: "\0" }).split(/(\d+|\0)/);
  const words = parts.map((part) => (part === "\0" ? String(seats) : /\d/.test(part) ? make("b", "", part) : part));
  return [box("p", "softrod-wall-count", ...words), rings];
}

/** @param {Wall} wall @returns {Element[]} */
function content(wall) {
  const { asking, bars, lines, code, address, qr, found, axes, law, doing, seats, steps } = wall;
  const { phase, stop, question, choices, right, because, predict, runs } = asking;
  if (phase === "lobby") {
    const scanned = qrCode(qr, `${address}?room=${code}`, "softrod-wall-qr");
    const typed = box("p", "softrod-wall-address", ...sayWith("wall-scan", { address: untranslated(make("b", "", typedAddress(address))) }));
    return [scanned, typed, untranslated(make("p", "softrod-wall-code", code)), make("p", "softrod-wall-count", say("wall-here", { count: seats }))];
  }
  if (phase === "show") return [];
  const { given, asked } = partsOf(question);
  const head = make("p", "softrod-wall-step", steps > 1 ? say("wall-step", { number: stop + 1, steps }) : "");
  /** @type {Element[]} */
  const parts = [head];
  if (phase === "ask" || phase === "results" || phase === "run") {
    // The run has its plot here.
    if (given && phase !== "run") parts.push(make("p", "softrod-wall-given", given));
    if (asked) parts.push(make("h2", "", asked));
    if (phase === "run" && runs) parts.push(make("p", "softrod-wall-given", say("wall-now", { runs })));
    if (predict > 0) parts.push(make(asked ? "p" : "h2", "", say("wall-where", { seconds: String(predict) })));
    if (question) {
      const voted = voteBars(choices, phase === "ask" ? [] : bars, -1);
      voted.style.setProperty("--softrod-letters", String(Math.max(...choices.map((choice) => choice.length))));
      parts.push(voted);
    }
  }
  if (phase === "reveal") {
    if (right >= 0) parts.push(make("p", choices[right].length <= SHORT ? "softrod-wall-number" : "softrod-wall-number softrod-long", choices[right]));
    if (because) parts.push(make("h2", "softrod-wall-because", because));
    if (question && bars.length) parts.push(voteBars(choices, bars, right));
    parts.push(make("p", "softrod-wall-rest", say("wall-next")));
  }
  if (phase === "explain") parts.push(make("h2", "", say("class-why")));
  if (OWN_BODY.has(phase)) {
    // The plot needs the room.
    if (!found.length) parts.push(make("p", "", asking.do));
    if (asking.goal) parts.push(make("p", "", say("class-goal", { goal: asking.goal })));
    parts.push(counts(doing));
    if (found.length) parts.push(plot(found, axes, { law, letters: PLOT_LETTERS }));
    if (law) parts.push(make("p", "", power(law, axes)));
  }
  for (const { text, color } of found.length || phase === "reveal" ? [] : lines) {
    const quoted = make("blockquote", "", text);
    quoted.dir = "auto";
    quoted.style.setProperty("--softrod-seat", color);
    parts.push(quoted);
  }
  return [...parts, ...count(wall)];
}

/** How many bodies do what, in large numbers. @param {Record<string, number>} doing */
const counts = (doing) =>
  box("ul", "softrod-counts", ...Object.entries(doing).filter(([, count]) => count).map(([word, count]) => box("li", "", make("b", "", String(count)), make("span", "", say(DOING[word], { count })))));
