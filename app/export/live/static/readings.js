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
import { energies } from "./energy.js";

/** Fraction of real time below which the file says that it is slowed down. */
const SLOW = 0.95;
/** Fraction of the stability limit from which on the step is shown over the body. */
const NEAR = 0.8;
/** Fraction from which on its bar has the colour of a warning. */
const WARN = 0.7;

/** A number as it is read. @param {number} value */
export const said = (value) =>
  Math.abs(value) >= 1e6 || (value && Math.abs(value) < 1e-4) ? value.toExponential(2).replace("e+", "e") : String(Number(value.toPrecision(4)));

/** A number of springs in words. @param {number} count */
const springs = (count) => `${count} ${count === 1 ? "spring" : "springs"}`;

/** The time step as a part of the largest stable one; 0 where the file chooses its steps. @param {Clock} clock */
export const partOfLimit = ({ method, dt, meter }) => (method === "symplectic_euler" && meter.limit < 1 ? dt / meter.limit : 0);

/** A bar of the time step over the largest stable one, and what it says. @param {Clock} clock @param {number} part */
function bar({ dt }, part) {
  const box = make("div", "limit");
  const meter = make("meter", "");
  Object.assign(meter, { min: 0, max: 1, low: WARN, high: 0.99, optimum: 0, value: Math.min(part, 1) });
  const words = `time step ${said(1e3 * dt)} ms, ${Math.round(100 * part)} % of the limit${part >= 1 ? ": unstable" : ""}`;
  meter.ariaLabel = words;
  box.append(meter, make("span", "", words));
  return box;
}

/** What stands over the body. @param {About} about @param {Body} body @param {Clock} clock @param {boolean} playing @returns {HTMLElement[]} */
export function head(about, body, clock, playing) {
  const states = [];
  if (clock.exploded) states.push("stopped");
  else if (!playing) states.push("paused");
  else if (clock.rate < SLOW) states.push(`slowed down: ${clock.rate.toFixed(2)} × real time`);
  const broken = body.broken.reduce((sum, one) => sum + one, 0);
  if (broken) states.push(`${springs(broken)} broken`);
  const yielded = body.setLength.reduce((sum, moved, s) => sum + Number(Math.abs(moved) > YIELDED * body.restLength[s] && !body.broken[s]), 0);
  if (yielded) states.push(`${springs(yielded)} yielded`);
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
    all.push(table(`Joint ${about.joint}`, [
      ["angle", `${angle.toFixed(2)}°`],
      ["rest angle", `${body.restAngleOf(about.joint).toFixed(2)}°`],
      ["sine", Math.sin(radians).toFixed(4)],
      ["cosine", Math.cos(radians).toFixed(4)],
    ]));
  }
  all.push(table(`Energy, ${about.energyUnit}`, Object.entries(energies(body)).map(([name, value]) => [name, said(value)])));
  const part = partOfLimit(clock);
  if (part) all.push(bar(clock, part));
  return all;
}
