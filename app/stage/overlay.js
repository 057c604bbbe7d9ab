// @ts-check
/** Thin marks over the body: the joint that is read out, the chosen mass, a hint, and a scale bar. */
import { overCanvas } from "../ui/dialog.js";
import { pageState } from "../wire/channel.js";
import { roundDown, roundUp } from "./axes.js";
import { RING } from "./looks.js";
import { degrees, jointAngles, lengthText } from "./measures.js";
import { freePlace } from "./label.js";
import { sidesOf, startsRight } from "./sides.js";
import { takenPaper, takePaper } from "./taken.js";
import { keepMarksDrawn, onMarksRedraw, redrawMarks } from "./sight.js";
import { makeSvg, set } from "./svg.js";
import { viserCanvas } from "../ui/viser/viser.js";
import { say } from "../words/words.js";

/** @typedef {import("./sight.js").Sight} Sight */

/** Pixels from the mass at which a joint's arc is drawn, beyond the mass's own radius. */
const ARC = 26;
/** Pixels from the arc to the middle of its angle's text. */
const LABEL = 22;
/** Places of the text, as degrees around the mass. */
const AROUND = [0, 180, 40, -40, 80, -80, 120, -120];
/** Half the height of the hint, and the room beside its words, px. */
const PILL = 14;
/** Least length of the scale bar, px. */
const BAR = 70;
/** Least length where there is little room, px. */
const SHORTEST = 36;
/** Half the width and height of an angle's text, px. */
const ANGLE = { x: 26, y: 10 };

/** A box around a point. @param {number} x @param {number} y @param {number} beside @param {number} above */
const around = (x, y, beside, above) => ({ left: x - beside, right: x + beside, top: y - above, bottom: y + above });

/** The mass that the keys have chosen, or -1. */
let chosen = -1;

/** Marks a mass, or none (-1). @param {number} mass */
export function choose(mass) {
  chosen = mass;
  redrawMarks();
}

/** The mass that is marked, or -1. */
export const chosenMass = () => chosen;

/** Adds the marks to the page, and keeps them and all others drawn. */
export function addOverlay() {
  const svg = makeSvg("svg", "softrod-overlay");
  /** @type {Add} */
  const add = (kind, name) => makeSvg(kind, name, svg);
  for (const mark of [jointMark, chosenMark, hintMark, scaleMark]) onMarksRedraw(mark(add));
  overCanvas().append(svg);
  keepMarksDrawn();
}

/** @typedef {<K extends keyof SVGElementTagNameMap>(kind: K, name: string) => SVGElementTagNameMap[K]} Add */

/** The arc and the degrees of the joint that is read out. @param {Add} add */
function jointMark(add) {
  const arc = add("path", "softrod-arc");
  const angle = add("text", "softrod-angle");
  let place = AROUND[0];
  /** @param {Sight} seen */
  return ({ plan, frame, on, places, box }) => {
    const joint = pageState().joint ?? -1;
    const has = joint >= 0 && 4 * joint < plan.joints.length && !plan.many;
    arc.style.display = angle.style.display = has ? "" : "none";
    if (!has) {
      takePaper("angle", null);
      return;
    }
    const { from, turn, mass } = jointAngles(plan, frame, joint);
    const radius = plan.radius[mass] * on.step + ARC;
    const [x, y] = [places[2 * mass], places[2 * mass + 1]];
    /** @param {number} degrees @param {number} distance */
    const at = (degrees, distance) => {
      const t = (degrees * Math.PI) / 180;
      return { x: (x + distance * Math.cos(t)).toFixed(1), y: (y - distance * Math.sin(t)).toFixed(1) };
    };
    const [begin, end] = [at(from, radius), at(from + turn, radius)];
    const curve = `A${radius} ${radius} 0 0 ${turn > 0 ? 0 : 1} ${end.x} ${end.y}`;
    set(arc, { d: `M${x} ${y}L${begin.x} ${begin.y}${curve}` });
    // On the outside of the bend, where the body seldom is, or else where it is not. It stays there while it can.
    const outside = from + turn / 2 - (turn < 0 ? -90 : 90);
    const order = [place, ...AROUND.filter((turned) => turned !== place)];
    const texts = order.map((turned) => at(outside + turned, radius + LABEL));
    const radii = plan.radius.map((size) => size * on.step);
    const middles = texts.map(({ x, y }) => ({ x: Number(x), y: Number(y) }));
    const inside = order.map((_, i) => i).filter((i) => middles[i].x - ANGLE.x > box.left && middles[i].x + ANGLE.x < box.right);
    const choices = inside.length ? inside : [0];
    const free = choices[freePlace(choices.map((i) => middles[i]), plan.springs, places, radii, takenPaper("angle"))];
    place = order[free];
    takePaper("angle", around(middles[free].x, middles[free].y, ANGLE.x, ANGLE.y));
    set(angle, texts[free]);
    // As in the panel: positive is anticlockwise where y grows upwards.
    angle.textContent = degrees(turn * plan.flip);
  };
}

/** A ring around the mass that the keys have chosen. @param {Add} add */
function chosenMark(add) {
  const ring = add("circle", "softrod-chosen");
  /** @param {Sight} seen */
  return ({ plan, on, places }) => {
    const has = chosen >= 0 && chosen < plan.radius.length;
    ring.style.display = has ? "" : "none";
    if (has) set(ring, { cx: places[2 * chosen], cy: places[2 * chosen + 1], r: plan.radius[chosen] * on.step + 8 });
  };
}

/** A hint for newcomers; it fades, and is removed at the first press on the canvas. @param {Add} add */
function hintMark(add) {
  const hint = add("g", "softrod-hint");
  const [pill, text] = [makeSvg("rect", "", hint), makeSvg("text", "", hint)];
  text.textContent = say("stage-drag");
  /** @param {Event} event */
  const pressed = (event) => event.target === viserCanvas() && done();
  const done = () => {
    hint.remove();
    window.removeEventListener("pointerdown", pressed, true);
  };
  window.addEventListener("pointerdown", pressed, true);
  hint.addEventListener("animationend", done);
  /** @param {Sight} seen */
  return ({ plan, on, places, box }) => {
    const { driven } = plan;
    hint.style.display = driven >= 0 && !plan.many ? "" : "none";
    if (driven < 0 || !hint.isConnected) {
      takePaper("hint", null);
      return;
    }
    const [width, height] = [text.getComputedTextLength() + 2 * PILL, 2 * PILL];
    // Beside the mass, at a side where there is room.
    const reach = RING * plan.radius[driven] * on.step + PILL + width / 2;
    const [x, y] = [places[2 * driven], places[2 * driven + 1]];
    const sides = [0, height, 2 * height]
      .flatMap((lower) => [x + reach, x - reach].map((middle) => ({ x: middle, y: y + lower })))
      .filter((spot) => spot.x - width / 2 > box.left && spot.x + width / 2 < box.right);
    const radii = plan.radius.map((size) => size * on.step);
    const half = { x: width / 2, y: height / 2 };
    const spot = sides[freePlace(sides, plan.springs, places, radii, takenPaper("hint"), half)] ?? { x: x + reach, y };
    set(pill, { x: spot.x - width / 2, y: spot.y - height / 2, width, height, rx: height / 2 });
    set(text, spot);
    takePaper("hint", around(spot.x, spot.y, width / 2, height / 2));
  };
}

/** A bar of a round length at the top, where lines end. @param {Add} add */
function scaleMark(add) {
  const bar = add("path", "softrod-scale");
  const length = add("text", "softrod-scale-text");
  let last = "";
  /** @param {Sight} seen */
  return ({ plan, on, box }) => {
    const perPixel = 1 / (plan.scale * on.step);
    const above = document.querySelector(".softrod-unfold")?.getBoundingClientRect();
    const edge = 18 + (above?.width ? Math.max(sidesOf(box).end, window.innerWidth - sidesOf(above).start) : sidesOf(box).end);
    // On a phone the head-up display reaches far to the other side: the bar is shorter there, or else below it.
    const hud = document.querySelector(".softrod-hud")?.getBoundingClientRect();
    const taken = hud ? window.innerWidth - sidesOf(hud).end : sidesOf(box).start;
    const room = window.innerWidth - edge - 10 - taken;
    const usual = roundUp(BAR * perPixel);
    const fits = room >= SHORTEST ? Math.min(usual, roundDown(room * perPixel)) : usual;
    const size = fits / perPixel >= SHORTEST ? fits : usual;
    const begin = startsRight ? edge : window.innerWidth - edge - size / perPixel;
    const end = begin + size / perPixel;
    const head = document.querySelector(".softrod-over")?.getBoundingClientRect();
    const free = hud && room < size / perPixel ? hud.bottom : Math.max(box.top, head?.bottom ?? 0);
    const low = free + 8 + parseFloat(getComputedStyle(length).fontSize) * 1.4;
    const state = [end, low, size, perPixel, pageState().unit].join(" ");
    if (state === last) return;
    last = state;
    set(bar, { d: `M${begin} ${low - 5}v10M${begin} ${low}H${end}M${end} ${low - 5}v10` });
    set(length, { x: (begin + end) / 2, y: low - 9 });
    length.textContent = lengthText(size, pageState().unit ?? "");
    document.documentElement.style.setProperty("--softrod-scale-foot", `${low + 5}px`);
    takePaper("scale", { left: begin, right: end, top: free, bottom: low + 5 });
  };
}
