// @ts-check
/** Thin marks over the body: the joint that is read out, the mass that is chosen, and a scale bar. */
import { onFit } from "./camera.js";
import { onPicture, shown } from "./canvas.js";
import { onTold, told } from "./channel.js";
import { wrapped } from "./draw.js";
import { onScreen, screen } from "./screen.js";
import { viser } from "./viser.js";

/**
 * @typedef {import("./plan.js").Plan} Plan
 * @typedef {import("./plan.js").Frame} Frame
 */

/** Pixels from the mass at which a joint's arc is drawn, beyond the mass's own radius. */
const ARC = 26;
/** Pixels from the arc to the middle of its angle's text. */
const LABEL = 22;
/** Pixels that the scale bar has at least. */
const BAR = 70;

/** Milliseconds for which the camera may go on moving after the last event. */
const CAMERA_MOVES = 1000;

const SVG = "http://www.w3.org/2000/svg";
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

/**
 * A round length: the next of 1, 2, 5, 10, 20, ... at or above.
 *
 * @param {number} least
 */
export function roundUp(least) {
  const power = 10 ** Math.floor(Math.log10(least));
  return power * (/** @type {number} */ ([1, 2, 5, 10].find((step) => step * power >= least * (1 - 1e-9))));
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
  const svg = document.createElementNS(SVG, "svg");
  svg.classList.add("softrod-overlay");
  svg.setAttribute("aria-hidden", "true");
  /** @template {keyof SVGElementTagNameMap} K @param {K} kind @param {string} name */
  const add = (kind, name) => {
    const element = document.createElementNS(SVG, kind);
    element.classList.add(name);
    svg.append(element);
    return element;
  };
  const arc = add("path", "softrod-arc");
  const angle = add("text", "softrod-angle");
  const ring = add("circle", "softrod-chosen");
  const hint = add("text", "softrod-hint");
  hint.textContent = "drag me";
  window.addEventListener("pointerdown", (event) => event.target === viser()?.canvas && hint.remove(), true);
  hint.addEventListener("animationend", () => hint.remove());
  const bar = add("path", "softrod-scale");
  const length = add("text", "softrod-scale-text");
  document.body.append(svg);

  let last = "";
  redraw = () => {
    const { plan, frame } = shown();
    const [on, canvas] = [screen(), viser()?.canvas];
    if (!plan || !frame || !on || !canvas) return;
    const places = onScreen(plan, frame.positions, on);
    const joint = Number(told().joint ?? -1);
    const has = joint >= 0 && 4 * joint < plan.joints.length && !plan.many;
    arc.style.display = angle.style.display = has ? "" : "none";
    if (has) {
      const { from, turn, mass } = jointAngles(plan, frame, joint);
      const radius = plan.radius[mass] * on.step + ARC;
      const [x, y] = [places[2 * mass], places[2 * mass + 1]];
      /** @param {number} degrees @param {number} [r] */
      const at = (degrees, r = radius) => {
        const t = (degrees * Math.PI) / 180;
        return `${(x + r * Math.cos(t)).toFixed(1)} ${(y - r * Math.sin(t)).toFixed(1)}`;
      };
      arc.setAttribute(
        "d",
        `M${x} ${y}L${at(from)}A${radius} ${radius} 0 ${Math.abs(turn) > 180 ? 1 : 0} ${turn > 0 ? 0 : 1} ${at(from + turn)}`,
      );
      // On the outside of the bend, where the body is not.
      const [tx, ty] = at(from + turn / 2 - (turn < 0 ? -90 : 90), radius + LABEL).split(" ");
      angle.setAttribute("x", tx);
      angle.setAttribute("y", ty);
      // As the panel has it: positive is anticlockwise where y grows upwards.
      angle.textContent = `${(turn * plan.flip).toFixed(1)}°`;
    }
    if (plan.driven >= 0) {
      hint.setAttribute("x", String(places[2 * plan.driven]));
      hint.setAttribute("y", String(places[2 * plan.driven + 1] - 2.2 * plan.radius[plan.driven] * on.step - 14));
    }
    hint.style.display = plan.driven >= 0 && !plan.many ? "" : "none";
    ring.style.display = chosen >= 0 && chosen < plan.radius.length ? "" : "none";
    if (ring.style.display === "") {
      ring.setAttribute("cx", String(places[2 * chosen]));
      ring.setAttribute("cy", String(places[2 * chosen + 1]));
      ring.setAttribute("r", String(plan.radius[chosen] * on.step + 8));
    }
    const perPixel = 1 / (plan.scale * on.step);
    const box = canvas.getBoundingClientRect();
    const size = roundUp(BAR * perPixel);
    const [end, low] = [box.right - 18, box.top + 28];
    const state = `${end} ${low} ${size} ${perPixel}`;
    if (state === last) return;
    last = state;
    const begin = end - size / perPixel;
    bar.setAttribute("d", `M${begin} ${low - 5}v10M${begin} ${low}H${end}M${end} ${low - 5}v10`);
    length.setAttribute("x", String((begin + end) / 2));
    length.setAttribute("y", String(low - 9));
    length.textContent = `${Number(size.toPrecision(1))} ${told().unit ?? ""}`;
  };
  onPicture(redraw);
  onTold(redraw);
  onFit(redraw);
  // The camera moves without a picture, too, and goes on a little by itself.
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
