// @ts-check
/** The finish of a race over the bodies, and arrows towards what is out of view. */
import { insertMarksLayer, onMarksRedraw } from "../../stage/sight.js";
import { isSheet } from "../../ui/gui/panel.js";
import { distance, lead, namesOf } from "./words.js";
import { makeSvg, set } from "../../stage/svg.js";
import { edgeArrow } from "../../stage/edge.js";
import { onScreen } from "../../stage/screen.js";
import { secondIn } from "../../stage/canvas.js";
import { say } from "../../words/words.js";

/**
 * @typedef {import("../../wire/wire.js").Race} Race
 * @typedef {import("../../stage/sight.js").Sight} Sight
 */

/** Pixels between the finishes of two bodies below which they are one. */
const APART = 8;
/** Pixels between two finishes below which their words would lie over each other. */
const WORDS = 130;
/** Pixels above a flag, for the words over it and the head-up display; on a phone there are buttons, too. */
const ABOVE = 92;
const ABOVE_ON_PHONE = 152;
/** Side of a square of a flag, px. */
const SQUARE = 6;
/** The dark squares of a flag, from the top of its pole. */
const CHEQUERED = [0, 1, 2, 3, 4, 5, 6, 7].filter((i) => (i + (i >> 2)) % 2 === 0)
  .map((i) => `M${(i % 4) * SQUARE} ${(i >> 2) * SQUARE}h${SQUARE}v${SQUARE}h${-SQUARE}z`)
  .join("");
/** Pixels between an arrow and its words. */
const OVER = 32;
/** Pixels between a body and its name. */
const TAG = 14;
/** Half the width of a letter, and pixels between words and the edge. */
const [HALF, MARGIN] = [4.4, 6];

/** How far a body is ahead of the other one, in words. @param {number} way px towards the finish */
export const aheadText = (way) => say(way < 0 ? "race-to.behind" : "race-to", { distance: distance(Math.abs(way)) });

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

/** Where the flags are. @param {{top: number}} box of the canvas */
const flagTop = ({ top }) => top + (isSheet() ? ABOVE_ON_PHONE : ABOVE);

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
    const top = flagTop(box);
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
  const draw = (places, text, { box, floor }) => {
    const { left, right, top } = box;
    const at = edgeArrow(places, { left, right, top, bottom: floor });
    all.style.display = at ? "" : "none";
    if (!at) return;
    set(arrow, { transform: `translate(${at.x.toFixed(1)} ${at.y.toFixed(1)}) rotate(${at.turn.toFixed(0)})` });
    const y = at.y - OVER < top + ABOVE / 2 ? at.y + OVER : at.y - OVER;
    set(words, { x: middleOfWords(at.x, text, box).toFixed(1), y: y.toFixed(1) });
    if (words.textContent !== text) words.textContent = text;
  };
  return { element: all, draw };
}

/** The middle and the upper end of a body, px. @param {ArrayLike<number>} places */
function topOf(places) {
  let [x, y] = [0, Infinity];
  for (let i = 0; i < places.length; i += 2) {
    x += places[i] / (places.length / 2);
    y = Math.min(y, places[i + 1]);
  }
  return { x, y };
}

/** Adds the marks to the page, which are shown in a race. @param {() => Required<Race>} read */
export function addRaceMarks(read) {
  const svg = makeSvg("svg", "softrod-marks softrod-race-marks");
  const toFinish = awayMark(svg, "softrod-race-finish");
  /** Of each body. @type {{finish: ReturnType<typeof finishMark>, away: ReturnType<typeof awayMark>, tag: SVGTextElement}[]} */
  let marks = [];
  /** @param {number} count */
  const makeMarks = (count) => {
    svg.replaceChildren();
    marks = Array.from({ length: count }, (_, i) => {
      const name = i ? "softrod-race-theirs" : "softrod-race-mine";
      return { finish: finishMark(svg, name), away: awayMark(svg, name), tag: makeSvg("text", "softrod-race-tag", svg) };
    });
    svg.append(toFinish.element);
  };
  onMarksRedraw((seen) => {
    const race = read();
    if (race.on !== svg.isConnected) race.on ? insertMarksLayer(svg) : svg.remove();
    if (!race.on) return;
    const { plan, frame, on, places, box } = seen;
    if (marks.length !== race.lines.length) makeMarks(race.lines.length);
    const xs = race.lines.map((line) => on.x + (line - plan.x) * plan.scale * on.step);
    const isOne = Math.max(...xs) - Math.min(...xs) < APART;
    svg.classList.toggle("softrod-race-apart", !isOne);
    marks.forEach(({ finish }, i) => {
      // Of lines at about one place, the first is shown.
      const isShown = xs[i] > box.left && xs[i] < box.right && !xs.slice(0, i).some((x) => Math.abs(x - xs[i]) < APART);
      const isAlone = !xs.slice(0, i).some((x) => Math.abs(x - xs[i]) < WORDS);
      finish(isShown ? xs[i] : null, isAlone ? say("race-finish", { way: distance(Math.abs(race.finish)) }) : "", seen);
    });
    const left = Math.abs(race.finish) - race.ways[0] * Math.sign(race.finish);
    toFinish.draw([xs[0], flagTop(box)], say("race-finish", { way: aheadText(left) }), seen);
    const second = secondIn(frame);
    const theirs = second ? onScreen(second.plan, second.frame.positions, on) : [];
    const names = namesOf(race), isPair = marks.length === 2;
    let from = 0;
    marks.forEach(({ away, tag }, i) => {
      const end = from + (i ? 2 * (race.masses[i - 1] ?? theirs.length) : 0);
      const own = i ? theirs.slice(from, end) : places;
      from = end;
      // One's own is told apart from the best of the others, each of these from one's own.
      const ahead = i ? (race.ways[i] - race.ways[0]) * Math.sign(race.finish) : lead(race);
      const way = aheadText(ahead);
      away.draw(own, i && !isPair ? say("race-named", { name: names[i], way }) : way, seen);
      // The others are of one colour.
      const isTagged = i > 0 && !isPair && own.length > 0;
      tag.style.display = isTagged ? "" : "none";
      if (!isTagged) return;
      const { x, y } = topOf(own);
      set(tag, { x: middleOfWords(x, names[i], box).toFixed(1), y: (y - TAG).toFixed(1) });
      if (tag.textContent !== names[i]) tag.textContent = names[i];
    });
  });
}
