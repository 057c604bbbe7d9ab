// @ts-check
/**
 * The numbers that a live file shows: an angle, energies, and how near the time step is to its limit.
 *
 * @typedef {import("./body.js").Body} Body
 * @typedef {import("./clock.js").Clock} Clock
 * @typedef {import("./live.js").About} About
 */
import { make } from "../../../ui/dialog.js";
import { YIELDED } from "../../../stage/looks.js";
import { decimal, say } from "../../../words/words.js";
import { energies } from "./energy.js";

/** Fraction of real time below which the file says that it is slowed down. */
const SLOW = 0.95;
/** Fraction of the stability limit from which on the step is shown over the body. */
const NEAR = 0.8;
/** Fraction from which on its bar has the colour of a warning. */
const WARN = 0.7;

/** A number as it is read. @param {number} value */
export const said = (value) =>
  decimal(Math.abs(value) >= 1e6 || (value && Math.abs(value) < 1e-4) ? value.toExponential(2).replace("e+", "e") : String(Number(value.toPrecision(4))));

/** What energies are called. */
const ENERGIES = /** @type {const} */ ({
  kinetic: "live-energy.kinetic", height: "live-energy.height", linear: "live-energy.linear", angular: "live-energy.angular",
});

/** The time step as a part of the largest stable one; 0 where the file chooses its steps. @param {Clock} clock */
export const partOfLimit = ({ method, dt, meter }) => (method === "symplectic_euler" && meter.limit < 1 ? dt / meter.limit : 0);

/** A bar of the time step over the largest stable one, and what it says. @param {Clock} clock @param {number} part */
function bar({ dt }, part) {
  const box = make("div", "limit");
  const meter = make("meter", "");
  Object.assign(meter, { min: 0, max: 1, low: WARN, high: 0.99, optimum: 0, value: Math.min(part, 1) });
  const words = say(part >= 1 ? "live-limit.over" : "live-limit", { step: said(1e3 * dt), part: String(Math.round(100 * part)) });
  meter.ariaLabel = words;
  box.append(meter, make("span", "", words));
  return box;
}

/** What stands over the body. @param {About} about @param {Body} body @param {Clock} clock @param {boolean} playing @returns {HTMLElement[]} */
export function head(about, body, clock, playing) {
  const states = [];
  if (clock.exploded) states.push(say("live-stopped"));
  else if (!playing) states.push(say("live-paused"));
  else if (clock.rate < SLOW) states.push(say("live-slowed", { rate: decimal(clock.rate.toFixed(2)) }));
  const broken = body.broken.reduce((sum, one) => sum + one, 0);
  if (broken) states.push(say("live-broken", { count: broken }));
  const yielded = body.setLength.reduce((sum, moved, s) => sum + Number(Math.abs(moved) > YIELDED * body.restLength[s] && !body.broken[s]), 0);
  if (yielded) states.push(say("live-yielded", { count: yielded }));
  const part = partOfLimit(clock);
  return [make("b", "", states.join(" · ")), ...(part >= (about.lesson ? Number.MIN_VALUE : NEAR) ? [bar(clock, part)] : [])];
}

/** The numbers in the panel. @param {About} about @param {Body} body @param {Clock} clock @returns {HTMLElement[]} */
export function numbers(about, body, clock) {
  /** @param {string} title @param {[string, string][]} rows */
  const table = (title, rows) => {
    const box = make("section", "");
    const list = make("dl", "");
    for (const [name, value] of rows) {
      const row = make("div", "");
      row.append(make("dt", "", name), make("dd", "", value));
      list.append(row);
    }
    box.append(make("h2", "", title), list);
    return box;
  };
  const all = [];
  if (about.joint >= 0) {
    const angle = body.angleOf(about.joint);
    const radians = (angle * Math.PI) / 180;
    all.push(table(say("live-joint", { joint: String(about.joint) }), [
      [say("live-joint.angle"), decimal(`${angle.toFixed(2)}°`)],
      [say("live-joint.rest"), decimal(`${body.restAngleOf(about.joint).toFixed(2)}°`)],
      [say("live-joint.sine"), decimal(Math.sin(radians).toFixed(4))],
      [say("live-joint.cosine"), decimal(Math.cos(radians).toFixed(4))],
    ]));
  }
  const parts = Object.entries(energies(body)).map(([name, value]) => {
    const key = ENERGIES[/** @type {keyof typeof ENERGIES} */ (name)];
    return /** @type {[string, string]} */ ([say(key), said(value)]);
  });
  all.push(table(say("live-energy", { unit: about.energyUnit }), parts));
  const part = partOfLimit(clock);
  if (part) all.push(bar(clock, part));
  return all;
}
