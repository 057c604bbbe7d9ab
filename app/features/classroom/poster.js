// @ts-check
/** Small still pictures of bodies, drawn from where their masses are. */
import { onMessage } from "../../wire/channel.js";
import { SVG } from "../../stage/svg.js";

/** Where the seats' bodies are. @type {import("../../wire/wire.js").Posters} */
let posters = { tell: "posters", places: {}, springs: [] };

/** How much of the scene's frame a picture shows at least, thousandths; and what it goes by, so that it seldom jumps. */
const [LEAST, STEP] = [300, 100];

/** The part of the frame where the bodies of all seats are, so that all pictures have one scale. */
function part() {
  let [left, top, right, bottom] = [1000, 1000, 0, 0];
  for (const places of Object.values(posters.places)) {
    for (const [x, y] of places) {
      if (x < 0 || y < 0 || x > 1000 || y > 1000) continue;
      [left, top, right, bottom] = [Math.min(left, x), Math.min(top, y), Math.max(right, x), Math.max(bottom, y)];
    }
  }
  if (left > right) return "0 0 1000 1000";
  const [x, y] = [left, top].map((edge) => Math.floor((edge - STEP / 2) / STEP) * STEP);
  const [width, height] = [right - x, bottom - y].map((size) => Math.max(LEAST, Math.ceil((size + STEP / 2) / STEP) * STEP));
  return `${x} ${y} ${width} ${height}`;
}

/** @param {SVGSVGElement} svg @param {[number, number][]} places */
function draw(svg, places) {
  svg.setAttribute("viewBox", part());
  let path = "";
  for (const [a, b] of posters.springs) {
    if (places[a] && places[b]) path += `M${places[a].join(" ")}L${places[b].join(" ")}`;
  }
  svg.firstElementChild?.setAttribute("d", path);
}

function blank() {
  const svg = document.createElementNS(SVG, "svg");
  svg.setAttribute("aria-hidden", "true");
  svg.classList.add("softrod-poster");
  svg.append(document.createElementNS(SVG, "path"));
  return svg;
}

/** A picture of the body of a seat, as it is now. @param {number} seat */
export function poster(seat) {
  const svg = blank();
  svg.dataset.seat = String(seat);
  draw(svg, posters.places[seat] ?? []);
  return svg;
}

/** A picture of a body that stays as it is. @param {[number, number][]} places of its masses, as of the seats' bodies */
export function still(places) {
  const svg = blank();
  draw(svg, places);
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
