// @ts-check
/** Small still pictures of bodies, drawn from where their masses are. */
import { onMessage } from "../../wire/channel.js";
import { makeSvg, set } from "../../stage/svg.js";

/** @typedef {[number, number][]} Places thousandths of the scene's frame */

/** Where the seats' bodies are. @type {import("../../wire/wire.js").Posters} */
let posters = { tell: "posters", places: {}, start: [], springs: [] };

/** The smallest part of the scene's frame that a picture shows, thousandths. */
const MIN_SIZE = 300;
/** Sizes and places of that part are multiples of this, so that it seldom jumps. */
const STEP = 100;

/** The part of the frame where the bodies of all seats are, so that all pictures have one scale. */
function viewBox() {
  const predicted = [...shown].flatMap(({ dots }) => dots);
  const places = [posters.start, ...Object.values(posters.places), predicted].flat().filter((place) => place.every((c) => c >= 0 && c <= 1000));
  if (!places.length) return "0 0 1000 1000";
  const [low, high] = [Math.min, Math.max].map((end) => [0, 1].map((axis) => end(...places.map((place) => place[axis]))));
  const from = low.map((edge) => Math.floor((edge - STEP / 2) / STEP) * STEP);
  const size = high.map((edge, axis) => Math.max(MIN_SIZE, Math.ceil((edge - from[axis] + STEP / 2) / STEP) * STEP));
  return [...from, ...size].join(" ");
}

/**
 * @param {SVGSVGElement} svg
 * @param {Places} places of its masses
 * @param {Places} dots of what was predicted
 * @param {string} box what of the frame it shows
 */
function draw(svg, places, dots = [], box = viewBox()) {
  const lines = posters.springs.filter(([a, b]) => places[a] && places[b]);
  set(svg, { viewBox: box });
  set(svg.children[0], { d: lines.map(([a, b]) => `M${places[a].join(" ")}L${places[b].join(" ")}`).join("") });
  if (svg.children[1]) set(svg.children[1], { d: dots.map((dot) => `M${dot.join(" ")}h0`).join("") });
}

/** A picture of a body that stays as it is. @param {Places} places of its masses */
export function still(places) {
  const svg = makeSvg("svg", "softrod-poster");
  makeSvg("path", "", svg);
  draw(svg, places);
  return svg;
}

/** The pictures that are kept up to date, of which seat, and what it predicted. @type {Set<{svg: SVGSVGElement, seat: number, dots: Places}>} */
const shown = new Set();

/** @param {number} seat */
const bodyOf = (seat) => (seat ? posters.places[seat] : posters.start) ?? [];

/** Draws all that are still in the page. */
function drawAll() {
  isQueued = false;
  for (const one of shown) if (!one.svg.isConnected) shown.delete(one);
  const box = viewBox();
  for (const { svg, seat, dots } of shown) draw(svg, bodyOf(seat), dots, box);
}

/** Whether all will be drawn as soon as the card that is being made is in the page. */
let isQueued = false;

/**
 * A picture of the body of a seat as it is now, or of the step's body as it begins.
 *
 * @param {number} seat its number, or 0
 * @param {Places} dots where it will be, as the seat has predicted
 */
export function poster(seat, dots = []) {
  const svg = makeSvg("svg", "softrod-poster");
  makeSvg("path", "", svg);
  if (dots.length) makeSvg("path", "softrod-poster-dots", svg);
  shown.add({ svg, seat, dots });
  if (!isQueued) queueMicrotask(drawAll);
  isQueued = true;
  return svg;
}

/** Begins to listen for where the bodies are. */
export function keepPosters() {
  onMessage("posters", (told) => {
    posters = told;
    drawAll();
  });
}
