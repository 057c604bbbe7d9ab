// @ts-check
/** A race in words. Texts only, without a page. */
import { pageState } from "../../wire/channel.js";
import { decimal, joined, listed, say } from "../../words/words.js";

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
  return `${way < 0 && size ? "−" : ""}${decimal(String(size))} ${pageState().unit ?? ""}`;
}

/** The names of all, which are different even if their scenes' are the same. @param {Required<Race>} race @returns {string[]} */
export function namesOf({ names: [own, ...others] }) {
  const said = others.map((name, i) => {
    const before = others.slice(0, i).filter((other) => other === name).length;
    if (before || others.indexOf(name, i + 1) > 0) return `${name} ${before + 1}`;
    return name === own ? say("race-other", { name }) : name;
  });
  return [say("race-own", { name: own }), ...said];
}

/** How far a body is ahead of the best of the others, towards the finish. @param {Required<Race>} race @param {number} [which] */
export function lead({ ways, finish }, which = 0) {
  const towards = ways.map((way) => way * Math.sign(finish));
  return towards[which] - Math.max(...towards.filter((_, i) => i !== which));
}

/** Whether the result is known. @param {Required<Race>} race */
export const isOver = ({ arrived, outs }) => arrived.every((time, i) => time !== null || outs[i]);

/** Simulated seconds after which a race ends; see `LIMIT` in rivals.py. */
const LIMIT = "30";

/**
 * What has kept a body from the finish.
 *
 * @param {Required<Race>["outs"][number]} out
 * @param {"first" | "own" | "other" | "both" | "all"} who one's own as the first word or later, another one, or all of them
 * @param {string} name of another one
 */
function fate(out, who, name) {
  switch (out) {
    case "exploded":
      return say("race-exploded", { who, name });
    case "fell":
      return say("race-fell", { who, name });
    case "away":
      return say("race-away", { who, name });
    case "misfit":
      return say("race-misfit", { who, name });
    case "late":
      return say("race-late", { who, name, limit: LIMIT });
    default:
      return "";
  }
}

/**
 * Which is ahead or first, and what has become of the others.
 *
 * @param {Required<Race>} race
 * @param {boolean} [exactly] whether it says by how much one is ahead
 */
export function verdict(race, exactly = true) {
  const { arrived, outs, finish, ways } = race;
  const names = namesOf(race);
  const all = names.map((_, i) => i);
  const isPair = all.length === 2;
  const there = all.filter((i) => arrived[i] !== null).sort((i, j) => Number(arrived[i]) - Number(arrived[j]));
  const dropped = all.filter((i) => arrived[i] === null && outs[i]);
  /** @param {number} i */
  const of = (i) => ({ own: i ? "no" : "yes", name: names[i] });
  /** @param {number[]} some @param {"first" | "own"} own */
  const fates = (some, own = "own") => joined(some.map((i) => fate(outs[i], i ? "other" : own, names[i])));
  if (there.length) {
    const [first, next] = there;
    const best = Number(arrived[first]);
    const equal = there.filter((i) => arrived[i] === best);
    const seconds = decimal(best.toFixed(2));
    if (equal.length > 1 && isPair) return say("race-both", { seconds });
    if (equal.length > 1) return say("race-several", { names: listed(equal.map((i) => (i ? names[i] : say("race-yours")))), seconds });
    if (!isOver(race)) return say(next === undefined ? "race-is-first" : "race-was-first", { ...of(first), seconds });
    if (next === undefined) return say("race-alone", { ...of(first), fates: fates(dropped) });
    const by = decimal((Number(arrived[next]) - best).toFixed(2));
    if (isPair) return say("race-won", { ...of(first), seconds: by });
    return say("race-won-before", { ...of(first), seconds: by, next: names[next], nextOwn: next ? "no" : "yes" });
  }
  if (isOver(race)) {
    const isSame = outs.every((out) => out === outs[0]);
    return say("race-nobody", { fates: isSame ? fate(outs[0], isPair ? "both" : "all", "") : fates(all) });
  }
  // Whoever is alone on the way is not ahead of anybody.
  if (dropped.length && dropped.length === all.length - 1) return fates(dropped, "first");
  const best = all.reduce((i, j) => (ways[j] * Math.sign(finish) > ways[i] * Math.sign(finish) ? j : i));
  const ahead = lead(race, best);
  if (ahead < CLOSE * Math.abs(finish)) return say(isPair ? "race-close" : "race-close.many");
  return exactly ? say("race-ahead-by", { ...of(best), distance: distance(ahead) }) : say("race-ahead", of(best));
}
