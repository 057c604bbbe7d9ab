// @ts-check
/** Small still pictures of bodies, drawn from where their masses are. */
import { onMessage } from "../../wire/channel.js";
import { makeSvg, set } from "../../stage/svg.js";

/** @typedef {[number, number][]} Places thousandths of the scene's frame */

/** Where the seats' bodies are. @type {import("../../wire/wire.js").Posters} */
let posters = { tell: "posters", places: {}, springs: [] };

/** The smallest part of the scene's frame that a picture shows, thousandths. */
const MIN_SIZE = 300;
/** Sizes and places of that part are multiples of this, so that it seldom jumps. */
const STEP = 100;

/** The part of the frame where the bodies of all seats are, so that all pictures have one scale. */
function viewBox() {
  const places = Object.values(posters.places).flat().filter((place) => place.every((c) => c >= 0 && c <= 1000));
  if (!places.length) return "0 0 1000 1000";
  const [low, high] = [Math.min, Math.max].map((end) => [0, 1].map((axis) => end(...places.map((place) => place[axis]))));
  const from = low.map((edge) => Math.floor((edge - STEP / 2) / STEP) * STEP);
  const size = high.map((edge, axis) => Math.max(MIN_SIZE, Math.ceil((edge - from[axis] + STEP / 2) / STEP) * STEP));
  return [...from, ...size].join(" ");
}

/** @param {SVGSVGElement} svg @param {Places} places */
function draw(svg, places) {
  const lines = posters.springs.filter(([a, b]) => places[a] && places[b]);
  set(svg, { viewBox: viewBox() });
  set(svg.children[0], { d: lines.map(([a, b]) => `M${places[a].join(" ")}L${places[b].join(" ")}`).join("") });
}

/** A picture of a body that stays as it is. @param {Places} places of its masses */
export function still(places) {
  const svg = makeSvg("svg", "softrod-poster");
  makeSvg("path", "", svg);
  draw(svg, places);
  return svg;
}

/** A picture of the body of a seat, as it is now. @param {number} seat */
export function poster(seat) {
  const svg = still(posters.places[seat] ?? []);
  svg.dataset.seat = String(seat);
  return svg;
}

/** Keeps the pictures in an element up to date. @param {HTMLElement} box */
export function keepPosters(box) {
  onMessage("posters", (told) => {
    posters = told;
    for (const svg of /** @type {NodeListOf<SVGSVGElement>} */ (box.querySelectorAll("svg[data-seat]"))) {
      draw(svg, posters.places[svg.dataset.seat ?? ""] ?? []);
    }
  });
}
