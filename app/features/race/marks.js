// @ts-check
/** The finish of a race over the bodies, and arrows towards what is out of view. */
import { insertMarksLayer, onMarksRedraw } from "../../stage/sight.js";
import { distance, lead } from "./words.js";
import { makeSvg, set } from "../../stage/svg.js";
import { edgeArrow } from "../../stage/edge.js";
import { onScreen } from "../../stage/screen.js";
import { secondIn } from "../../stage/canvas.js";

/**
 * @typedef {import("../../wire/wire.js").Race} Race
 * @typedef {import("../../stage/sight.js").Sight} Sight
 */

/** Pixels between the finishes of both bodies below which they are one. */
const APART = 8;
/** Pixels above a flag, for the words over it and the head-up display. */
const ABOVE = 92;
/** Side of a square of a flag, px. */
const SQUARE = 6;
/** The dark squares of a flag, from the top of its pole. */
const CHEQUERED = [0, 1, 2, 3, 4, 5, 6, 7].filter((i) => (i + (i >> 2)) % 2 === 0)
  .map((i) => `M${(i % 4) * SQUARE} ${(i >> 2) * SQUARE}h${SQUARE}v${SQUARE}h${-SQUARE}z`)
  .join("");
/** Pixels between an arrow and its words. */
const OVER = 32;
/** Half the width of a letter, and pixels between words and the edge. */
const [HALF, MARGIN] = [4.4, 6];

/** How far a body is ahead of the other one, in words. @param {number} way px towards the finish */
export const aheadText = (way) => `${distance(Math.abs(way))} ${way < 0 ? "behind" : "ahead"}`;

/**
 * Where the middle of words is that belong to a place, but do not go beyond the edges.
 *
 * @param {number} x of the place
 * @param {string} text
 * @param {{left: number, right: number}} view
 */
export function middleOfWords(x, text, { left, right }) {
  const room = HALF * text.length + MARGIN;
  return Math.max(left + room, Math.min(right - room, x));
}

/** A line with a flag, and its distance from the start. @param {SVGSVGElement} svg @param {string} name */
function finishMark(svg, name) {
  const all = makeSvg("g", `softrod-finish ${name}`, svg);
  const line = makeSvg("path", "softrod-finish-line", all);
  const flag = makeSvg("g", "softrod-finish-flag", all);
  set(makeSvg("rect", "", flag), { width: 4 * SQUARE, height: 2 * SQUARE });
  set(makeSvg("path", "", flag), { d: CHEQUERED });
  const words = makeSvg("text", "", all);
  /** @param {number | null} x null while it is not shown @param {string} text @param {Sight} seen */
  return (x, text, { box, floor }) => {
    all.style.display = x === null ? "none" : "";
    if (x === null) return;
    const top = box.top + ABOVE;
    set(line, { d: `M${x.toFixed(1)} ${top.toFixed(1)}V${floor.toFixed(1)}` });
    set(flag, { transform: `translate(${x.toFixed(1)} ${top.toFixed(1)})` });
    set(words, { x: middleOfWords(x, text, box).toFixed(1), y: (top - 12).toFixed(1) });
    if (words.textContent !== text) words.textContent = text;
  };
}

/** An arrow at the edge with words. @param {SVGSVGElement} svg @param {string} name */
function awayMark(svg, name) {
  const all = makeSvg("g", `softrod-away ${name}`, svg);
  const arrow = makeSvg("path", "", all);
  set(arrow, { d: "M-12 -11L13 0L-12 11L-7 0z" });
  const words = makeSvg("text", "", all);
  /** @param {ArrayLike<number>} places of its masses, px of the window @param {string} text @param {Sight} seen */
  return (places, text, { box, floor }) => {
    const { left, right, top } = box;
    const at = edgeArrow(places, { left, right, top, bottom: floor });
    all.style.display = at ? "" : "none";
    if (!at) return;
    set(arrow, { transform: `translate(${at.x.toFixed(1)} ${at.y.toFixed(1)}) rotate(${at.turn.toFixed(0)})` });
    const y = at.y - OVER < top + ABOVE / 2 ? at.y + OVER : at.y - OVER;
    set(words, { x: middleOfWords(at.x, text, box).toFixed(1), y: y.toFixed(1) });
    if (words.textContent !== text) words.textContent = text;
  };
}

/** Adds the marks to the page, which are shown in a race. @param {() => Required<Race>} read */
export function addRaceMarks(read) {
  const svg = makeSvg("svg", "softrod-marks softrod-race-marks");
  const finishes = ["softrod-race-mine", "softrod-race-theirs"].map((name) => finishMark(svg, name));
  const [toFinish, toMine, toTheirs] = ["finish", "mine", "theirs"].map((name) => awayMark(svg, `softrod-race-${name}`));
  onMarksRedraw((seen) => {
    const race = read();
    if (race.on !== svg.isConnected) race.on ? insertMarksLayer(svg) : svg.remove();
    if (!race.on) return;
    const { plan, frame, on, places, box } = seen;
    const xs = race.lines.map((line) => on.x + (line - plan.x) * plan.scale * on.step);
    const isOne = Math.abs(xs[0] - xs[1]) < APART;
    svg.classList.toggle("softrod-race-apart", !isOne);
    finishes.forEach((mark, i) => {
      const isShown = xs[i] > box.left && xs[i] < box.right && !(i && isOne);
      mark(isShown ? xs[i] : null, `Finish, ${distance(Math.abs(race.finish))}`, seen);
    });
    const left = Math.abs(race.finish) - race.ways[0] * Math.sign(race.finish);
    toFinish([xs[0], box.top + ABOVE], `Finish, ${aheadText(left)}`, seen);
    toMine(places, aheadText(lead(race)), seen);
    const second = secondIn(frame);
    const theirs = second ? onScreen(second.plan, second.frame.positions, on) : [];
    toTheirs(theirs, aheadText(-lead(race)), seen);
  });
}
