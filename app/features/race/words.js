// @ts-check
/** A race in words. Texts only, without a page. */
import { pageState } from "../../wire/channel.js";

/** @typedef {import("../../wire/wire.js").Race} Race */

/** Part of the way to the finish below which neither is ahead. */
const CLOSE = 0.002;

/** All fields of a race; those that have their usual values are not sent. @param {Race} race @returns {Required<Race>} */
export const fullRace = (race) => ({
  on: false,
  names: ["", ""],
  ways: [0, 0],
  seconds: 0,
  fair: true,
  finish: 0,
  lines: [0, 0],
  arrived: [null, null],
  outs: ["", ""],
  ...race,
});

/** A distance in words. @param {number} way */
export function distance(way) {
  const size = Math.abs(way) < 10 ? Number(Math.abs(way).toPrecision(2)) : Math.round(Math.abs(way));
  return `${way < 0 && size ? "−" : ""}${size} ${pageState().unit ?? ""}`;
}

/** The names of both, which are different even if their scenes' are the same. @param {Required<Race>} race @returns {[string, string]} */
export const namesOf = ({ names: [one, other] }) => [`${one} (yours)`, one === other ? `${other} (the other)` : other];

/** How far the first is ahead of the other, towards the finish. @param {Required<Race>} race */
export const lead = ({ ways: [one, other], finish }) => (one - other) * Math.sign(finish);

/** Whether the result is known. @param {Required<Race>} race */
export const isOver = ({ arrived, outs }) => arrived.every((time, i) => time !== null || outs[i]);

/** Which is ahead or first, and what has become of the other. @param {Required<Race>} race */
export function verdict(race) {
  const { arrived, outs, finish } = race;
  const who = ["Yours", namesOf(race)[1]];
  const [mine, theirs] = arrived;
  if (mine !== null && theirs !== null) {
    if (mine === theirs) return `Both at once, after ${mine.toFixed(2)} s`;
    return `${who[mine < theirs ? 0 : 1]} was first, by ${Math.abs(mine - theirs).toFixed(2)} s`;
  }
  const first = mine ?? theirs;
  if (first !== null) {
    const [winner, left] = mine === null ? [1, 0] : [0, 1];
    if (!outs[left]) return `${who[winner]} is first, after ${first.toFixed(2)} s`;
    return `${who[winner]} was first; ${left ? who[1] : "yours"} ${outs[left]}`;
  }
  if (isOver(race)) {
    if (outs[0] === outs[1]) return `Nobody was first: both ${outs[0]}`;
    return `Nobody was first: yours ${outs[0]}, ${who[1]} ${outs[1]}`;
  }
  const out = outs[0] ? 0 : 1;
  if (outs[out]) return `${who[out]} ${outs[out]}`;
  const ahead = lead(race);
  if (Math.abs(ahead) < CLOSE * Math.abs(finish)) return "Neither is ahead";
  return `${who[ahead > 0 ? 0 : 1]} is ahead by ${distance(Math.abs(ahead))}`;
}
