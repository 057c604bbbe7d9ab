// @ts-check
/** A race in words. Texts only, without a page. */
import { pageState } from "../../wire/channel.js";

/** @typedef {import("../../wire/wire.js").Race} Race */

/** A way that is none but for rounding, px. */
const LEAST = 0.005;
/** Part of the way to the finish below which neither is ahead. */
const CLOSE = 0.002;

/** All fields of a race; those that have their usual values are not sent. @param {Race} race @returns {Required<Race>} */
export const fullRace = (race) => ({
  on: false,
  names: [],
  ways: [],
  seconds: 0,
  fair: true,
  finish: 0,
  lines: [],
  arrived: [],
  outs: [],
  masses: [],
  more: false,
  ...race,
});

/** A distance in words. @param {number} way */
export function distance(way) {
  const exact = Math.abs(way);
  const size = exact < LEAST ? 0 : exact < 10 ? Number(exact.toPrecision(2)) : Math.round(exact);
  return `${way < 0 && size ? "−" : ""}${size} ${pageState().unit ?? ""}`;
}

/** The names of all, which are different even if their scenes' are the same. @param {Required<Race>} race @returns {string[]} */
export function namesOf({ names: [own, ...others] }) {
  const said = others.map((name, i) => {
    const before = others.slice(0, i).filter((other) => other === name).length;
    if (before || others.indexOf(name, i + 1) > 0) return `${name} ${before + 1}`;
    return name === own ? `${name} (the other)` : name;
  });
  return [`${own} (yours)`, ...said];
}

/** How far a body is ahead of the best of the others, towards the finish. @param {Required<Race>} race @param {number} [which] */
export function lead({ ways, finish }, which = 0) {
  const towards = ways.map((way) => way * Math.sign(finish));
  return towards[which] - Math.max(...towards.filter((_, i) => i !== which));
}

/** Whether the result is known. @param {Required<Race>} race */
export const isOver = ({ arrived, outs }) => arrived.every((time, i) => time !== null || outs[i]);

const YOURS = "Yours";
/** A name within a sentence. @param {string} who */
const inside = (who) => (who === YOURS ? "yours" : who);

/** Which is ahead or first, and what has become of the others. @param {Required<Race>} race */
export function verdict(race) {
  const { arrived, outs, finish, ways } = race;
  const who = [YOURS, ...namesOf(race).slice(1)];
  const all = who.map((_, i) => i);
  const isPair = all.length === 2;
  const there = all.filter((i) => arrived[i] !== null).sort((i, j) => Number(arrived[i]) - Number(arrived[j]));
  const dropped = all.filter((i) => arrived[i] === null && outs[i]);
  /** @param {number[]} some */
  const fates = (some) => some.map((i) => `${inside(who[i])} ${outs[i]}`).join(", ");
  if (there.length) {
    const [first, next] = there;
    const best = Number(arrived[first]);
    const equal = there.filter((i) => arrived[i] === best);
    const after = `after ${best.toFixed(2)} s`;
    if (equal.length > 1) return `${isPair ? "Both" : equal.map((i, k) => (k ? inside(who[i]) : who[i])).join(" and ")} at once, ${after}`;
    if (!isOver(race)) return `${who[first]} ${next === undefined ? "is" : "was"} first, ${after}`;
    if (next === undefined) return `${who[first]} was first; ${fates(dropped)}`;
    const by = `${(Number(arrived[next]) - best).toFixed(2)} s`;
    return `${who[first]} was first, ${isPair ? `by ${by}` : `${by} before ${inside(who[next])}`}`;
  }
  if (isOver(race)) {
    const isSame = outs.every((out) => out === outs[0]);
    return `Nobody was first: ${isSame ? `${isPair ? "both" : "all"} ${outs[0]}` : fates(all)}`;
  }
  // Whoever is alone on the way is not ahead of anybody.
  if (dropped.length && dropped.length === all.length - 1) return fates(dropped).replace(/^yours/, YOURS);
  const best = all.reduce((i, j) => (ways[j] * Math.sign(finish) > ways[i] * Math.sign(finish) ? j : i));
  const ahead = lead(race, best);
  if (ahead < CLOSE * Math.abs(finish)) return isPair ? "Neither is ahead" : "None is ahead";
  return `${who[best]} is ahead by ${distance(ahead)}`;
}
