// @ts-check
/** Thin marks over the body: the joint that is read out, the mass that is chosen, and a scale bar. */
import { onFit } from "./camera.js";
import { onPicture, shown } from "./canvas.js";
import { onTold, told } from "../wire/channel.js";
import { wrapped } from "./draw.js";
import { addEdgeArrow } from "./edge.js";
import { freePlace } from "./label.js";
import { roundDown, roundUp } from "./axes.js";
import { onScreen } from "./screen.js";
import { screen } from "../ui/viser/screen.js";
import { viser } from "../ui/viser/viser.js";

/**
 * @typedef {import("./plan.js").Plan} Plan
 * @typedef {import("./plan.js").Frame} Frame
 * @typedef {import("./screen.js").Screen} Screen
 * @typedef {object} Sight a picture, and where it is on the screen
 * @property {Plan} plan
 * @property {Frame} frame
 * @property {Screen} on
 * @property {Float64Array} places of the masses, x and y of each
 * @property {DOMRect} box of the canvas
 * @property {number} floor where the canvas ends that can be seen: at its lower edge, or at the bar of time
 */

/** Pixels from the mass at which a joint's arc is drawn, beyond the mass's own radius. */
const ARC = 26;
/** Pixels from the arc to the middle of its angle's text. */
const LABEL = 22;
/** Where else that may be: degrees by which it is turned around the mass. */
const AROUND = [0, 180, 40, -40, 80, -80, 120, -120];
/** Pixels that the scale bar has at least. */
const BAR = 70;
/** And how long at least where it has little room. */
const SHORTEST = 36;
/** Milliseconds for which the camera may go on moving after the last event. */
const CAMERA_MOVES = 1000;

export const SVG = "http://www.w3.org/2000/svg";

/**
 * Makes an SVG element.
 *
 * @template {keyof SVGElementTagNameMap} K
 * @param {K} kind @param {string} names of its classes @param {Element} [parent] to which it is added
 * @returns {SVGElementTagNameMap[K]}
 */
export function makeSvg(kind, names, parent) {
  const element = document.createElementNS(SVG, kind);
  element.setAttribute("class", names);
  if (kind === "svg") element.setAttribute("aria-hidden", "true");
  parent?.append(element);
  return element;
}

/** Sets what is not set already. @param {Element} element @param {Record<string, number | string>} attributes */
export function set(element, attributes) {
  for (const [name, value] of Object.entries(attributes)) {
    if (element.getAttribute(name) !== String(value)) element.setAttribute(name, String(value));
  }
}

/** The mass that the keys have chosen, or -1. */
let chosen = -1;

/** Marks a mass, or none (-1). @param {number} mass */
export function choose(mass) {
  chosen = mass;
  redraw();
}
/** The mass that is marked. */
export const chosenMass = () => chosen;

let redraw = () => {};
/** @type {((seen: Sight) => void)[]} */
const onlookers = [];

/** Has other marks drawn whenever these are. @param {(seen: Sight) => void} draw */
export const onSight = (draw) => onlookers.push(draw);
/** Puts up other marks, under the instruments. @param {SVGSVGElement} svg */
export const putUp = (svg) => document.body.insertBefore(svg, document.querySelector(".softrod-instruments"));
/** Draws all marks anew. */
export const redrawMarks = () => redraw();

/** Whether the page is on its way to paper, where the canvas has another size and nothing is drawn anew. */
let printing = false;
/** Where the canvas was when the marks were drawn last. @type {DOMRect | null} */
let drawnOver = null;

/** Has the marks shrink or grow with the canvas, as they were drawn last; or lets them be. @param {boolean} on */
export function frameMarks(on) {
  printing = on;
  for (const svg of document.querySelectorAll(".softrod-overlay, .softrod-marks")) {
    if (on && drawnOver) {
      const { left, top, width, height } = drawnOver;
      svg.setAttribute("viewBox", `${left} ${top} ${width} ${height}`);
    } else svg.removeAttribute("viewBox");
  }
  if (!on) redraw();
}

/** Where the canvas ends that can be seen. @param {DOMRect} box of the canvas */
export function floorOf(box) {
  const dock = document.querySelector(".softrod-dock")?.getBoundingClientRect();
  return Math.min(box.bottom, dock?.top ?? Infinity);
}

/**
 * What is on the screen now; null while it is on its way to paper.
 *
 * @param {Frame | null} frame the picture
 * @returns {Sight | null}
 */
export function sight(frame = shown().frame) {
  if (printing || matchMedia("print").matches) return null;
  const { pictured: plan } = shown();
  const [on, canvas] = [screen(), viser()?.canvas];
  if (!plan || frame?.generation !== plan.generation || !on || !canvas) return null;
  const box = canvas.getBoundingClientRect();
  return { plan, frame, on, places: onScreen(plan, frame.positions, on), box, floor: floorOf(box) };
}

/** A round length in words; of a metre, parts are in cm. @param {number} size @param {string} unit */
export function lengthText(size, unit) {
  const inCm = unit === "m" && size < 1 && size >= 0.01;
  return `${Number((inCm ? 100 * size : size).toPrecision(1))} ${inCm ? "cm" : unit}`;
}

/**
 * The angles of a joint's two springs and how it turns from its rest angle, as they are on the screen: degrees,
 * anticlockwise from the right.
 *
 * @param {Plan} plan
 * @param {Frame} frame
 * @param {number} joint
 */
export function jointAngles(plan, frame, joint) {
  const { springs, joints } = plan;
  /** @param {number} spring @param {number} sense */
  const direction = (spring, sense) => {
    const [a, b] = [2 * springs[2 * spring], 2 * springs[2 * spring + 1]];
    const { positions } = frame;
    const [dx, dy] = [positions[b] - positions[a], (positions[b + 1] - positions[a + 1]) * plan.flip];
    return (Math.atan2(dy * sense, dx * sense) * 180) / Math.PI;
  };
  const sense = joints[4 * joint + 3];
  // Spring a goes on through the mass where it meets b; where b is reversed, so is what a is compared with.
  const from = direction(joints[4 * joint], sense);
  const turn = wrapped(direction(joints[4 * joint + 1], sense) - from);
  return { from, turn, mass: joints[4 * joint + 2] };
}

/** Puts up the marks. */
export function addOverlay() {
  const svg = makeSvg("svg", "softrod-overlay");
  /** @type {Add} */
  const add = (kind, name) => makeSvg(kind, name, svg);
  const marks = [jointMark(add), chosenMark(add), hintMark(add), scaleMark(add)];
  document.body.append(svg);
  const point = addEdgeArrow();
  redraw = () => {
    const seen = sight();
    if (!seen) return;
    drawnOver = seen.box;
    for (const mark of marks) mark(seen);
    const { left, right, top } = seen.box;
    for (const draw of onlookers) draw(seen);
    point(seen.places, { left, right, top, bottom: seen.floor });
  };
  onPicture(redraw);
  onTold("pageState", redraw);
  onFit(redraw);
  followCamera();
}

/** @typedef {<K extends keyof SVGElementTagNameMap>(kind: K, name: string) => SVGElementTagNameMap[K]} Add */

/** An angle as it is shown; zero has no sign. @param {number} angle degrees */
export const degrees = (angle) => `${(Number(angle.toFixed(1)) + 0).toFixed(1)}°`;

/** The arc and the degrees of the joint that is read out. @param {Add} add */
function jointMark(add) {
  const arc = add("path", "softrod-arc");
  const angle = add("text", "softrod-angle");
  let kept = AROUND[0];
  /** @param {Sight} seen */
  return ({ plan, frame, on, places }) => {
    const joint = told().joint ?? -1;
    const has = joint >= 0 && 4 * joint < plan.joints.length && !plan.many;
    arc.style.display = angle.style.display = has ? "" : "none";
    if (!has) return;
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
    // On the outside of the bend, where the body is seldom; or else where it is not. It stays while it can.
    const outside = from + turn / 2 - (turn < 0 ? -90 : 90);
    const order = [kept, ...AROUND.filter((turned) => turned !== kept)];
    const texts = order.map((turned) => at(outside + turned, radius + LABEL));
    const hud = document.querySelector(".softrod-hud")?.getBoundingClientRect();
    const free = freePlace(texts.map(({ x, y }) => ({ x: Number(x), y: Number(y) })), plan.springs, places, hud ? [hud] : []);
    kept = order[free];
    set(angle, texts[free]);
    // As the panel has it: positive is anticlockwise where y grows upwards.
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

/** What a newcomer can do; it fades, and goes with the first press on the canvas. @param {Add} add */
function hintMark(add) {
  const hint = add("text", "softrod-hint");
  hint.textContent = "drag me";
  /** @param {Event} event */
  const pressed = (event) => event.target === viser()?.canvas && done();
  const done = () => {
    hint.remove();
    window.removeEventListener("pointerdown", pressed, true);
  };
  window.addEventListener("pointerdown", pressed, true);
  hint.addEventListener("animationend", done);
  /** @param {Sight} seen */
  return ({ plan, on, places }) => {
    const { driven } = plan;
    hint.style.display = driven >= 0 && !plan.many ? "" : "none";
    if (driven < 0) return;
    set(hint, { x: places[2 * driven], y: places[2 * driven + 1] - 2.2 * plan.radius[driven] * on.step - 14 });
  };
}

/** A bar of a round length at the top right. @param {Add} add */
function scaleMark(add) {
  const bar = add("path", "softrod-scale");
  const length = add("text", "softrod-scale-text");
  let last = "";
  /** @param {Sight} seen */
  return ({ plan, on, box }) => {
    const perPixel = 1 / (plan.scale * on.step);
    const end = box.right - 18;
    // On a phone the head-up display reaches far to the right: it is shorter there, or else below.
    const hud = document.querySelector(".softrod-hud")?.getBoundingClientRect();
    const room = end - 10 - (hud?.right ?? box.left);
    const usual = roundUp(BAR * perPixel);
    const fits = room >= SHORTEST ? Math.min(usual, roundDown(room * perPixel)) : usual;
    const size = fits / perPixel >= SHORTEST ? fits : usual;
    const begin = end - size / perPixel;
    const free = hud && hud.right > begin - 10 ? hud.bottom : box.top;
    const low = free + 8 + parseFloat(getComputedStyle(length).fontSize) * 1.4;
    const state = [end, low, size, perPixel, told().unit].join(" ");
    if (state === last) return;
    last = state;
    set(bar, { d: `M${begin} ${low - 5}v10M${begin} ${low}H${end}M${end} ${low - 5}v10` });
    set(length, { x: (begin + end) / 2, y: low - 9 });
    length.textContent = lengthText(size, told().unit ?? "");
  };
}

/** The camera moves without a picture, too, and goes on a little by itself. */
function followCamera() {
  let until = 0;
  let tracking = false;
  const track = () => {
    redraw();
    tracking = performance.now() < until;
    if (tracking) requestAnimationFrame(track);
  };
  /** @param {Event} event */
  const follow = (event) => {
    if (event instanceof PointerEvent && event.buttons === 0) return;
    until = performance.now() + CAMERA_MOVES;
    if (!tracking) requestAnimationFrame(track);
    tracking = true;
  };
  for (const kind of ["wheel", "pointermove", "pointerup", "keydown", "resize"]) {
    window.addEventListener(kind, follow, { capture: true, passive: true });
  }
}
