// @ts-check
/**
 * The places of muscles in their strip, and what a drag does to them. Arithmetic and words, without a page.
 *
 * A mark is the crest of its muscle's wave: its x is when in the beat the wave is largest, its y the amplitude.
 *
 * @typedef {import("../../stage/plan.js").Plan} Plan
 * @typedef {import("../../stage/swing.js").Muscle} Muscle
 * @typedef {Muscle & {key: string, crest: number}} Mark crest: 0 to 1, a part of the beat
 * @typedef {Mark & {members: Mark[], number: string}} Dot what is dragged: one muscle, or a numbered group that moves together
 * @typedef {{width: number, height: number}} Box pixels
 * @typedef {{later: number, stretch: number, turn: number}} Way beats, a fraction, degrees
 */
import { countMuscles, muscleAt, waveAt } from "../../stage/swing.js";
import { decimal, say } from "../../words/words.js";

/** Amplitude of a spring that reaches the edge of the strip, a fraction of its length, and the largest that there can be. */
const FULL_STRETCH = 0.4;
const MAX_STRETCH = 0.9;
/** The same of a joint, degrees. */
const FULL_TURN = 60;
const MAX_TURN = 180;
/** Pixels around the wave. */
export const EDGE = 15;
/** Parts of a beat to which a drag snaps. */
const GRID = 72;
/** Points of a drawn wave per crest. */
const POINTS = 48;

/** @param {number} value */
const inTurn = (value) => value - Math.floor(value);

/** All muscles of a body that follow the beat. @param {Plan} plan @returns {Mark[]} */
export const marksOf = (plan) =>
  Array.from({ length: countMuscles(plan) }, (_, k) => muscleAt(plan, k)).filter(({ steady }) => !steady).map((muscle) => {
    // The server's values, which have double precision.
    muscle.phase = Number(muscle.phase.toPrecision(7));
    muscle.amplitude = Number(muscle.amplitude.toPrecision(7));
    const crest = inTurn((90 - muscle.phase) / 360) / muscle.perBeat;
    return { ...muscle, key: `${muscle.joint ? "j" : "s"}${muscle.part}`, crest };
  });

/** Every muscle alone. @param {Mark[]} marks @returns {Dot[]} */
export const singles = (marks) => marks.map((mark) => ({ ...mark, members: [mark], number: "" }));

/** Whether two muscles can be in one group: neighbours of one kind. @param {Mark} one @param {Mark} next */
const isNext = (one, next) =>
  next.part === one.part + 1 && one.joint === next.joint && one.perBeat === next.perBeat && one.pulse === next.pulse;

/**
 * Neighbours in groups of about equal size, each at the mean of its crests and amplitudes.
 *
 * @param {Mark[]} marks @param {number} most in a group
 * @returns {Dot[]}
 */
export function groupsOf(marks, most) {
  /** @type {Mark[][]} */
  const runs = [];
  for (const mark of marks) {
    const run = runs.at(-1), last = run?.at(-1);
    if (run && last && isNext(last, mark)) run.push(mark);
    else runs.push([mark]);
  }
  const groups = runs.flatMap((run) => {
    const count = Math.ceil(run.length / most);
    return Array.from({ length: count }, (_, k) => run.slice(Math.round((k * run.length) / count), Math.round(((k + 1) * run.length) / count)));
  });
  return groups.map((members, i) => ({ ...mean(members), key: `g${i + 1}`, members, number: String(i + 1) }));
}

/** Sizes of groups that are tried. */
const TRIED = 3;
/** Pixels between two groups that can be told apart. */
const CLEAR = 22;

/**
 * The smallest groups that lie clearly apart: with some sizes the waves of several come at the same time, and cover each other.
 *
 * @param {Mark[]} marks @param {number} most in a group, at least @param {Box} box
 */
export function clearest(marks, most, box) {
  const found = Array.from({ length: TRIED }, (_, k) => groupsOf(marks, most + k));
  /** @param {Dot[]} dots */
  const gap = (dots) => {
    const places = dots.map((dot) => placeOf(dot, box)).sort((one, other) => one.x - other.x);
    return Math.min(...places.slice(1).map(({ x, y }, i) => Math.hypot(x - places[i].x, y - places[i].y)));
  };
  return found.find((dots) => gap(dots) >= CLEAR) ?? found.reduce((best, next) => (gap(next) > gap(best) ? next : best));
}

/** One mark for many of one kind. @param {Mark[]} members */
function mean(members) {
  const [first] = members;
  let x = 0, y = 0, amplitude = 0;
  for (const mark of members) {
    const angle = 2 * Math.PI * mark.crest * mark.perBeat;
    x += Math.cos(angle);
    y += Math.sin(angle);
    amplitude += mark.amplitude / members.length;
  }
  return { ...first, amplitude, crest: inTurn(Math.atan2(y, x) / (2 * Math.PI)) / first.perBeat };
}

/** Height of a mark, from the middle to the edges: -1 to 1. @param {Mark} mark */
const heightOf = ({ joint, amplitude }) => Math.max(-1, Math.min(1, amplitude / (joint ? FULL_TURN : FULL_STRETCH)));

/** @param {number} part of the beat @param {Box} box */
export const across = (part, { width }) => EDGE + part * (width - 2 * EDGE);
/** @param {number} height -1 to 1 @param {Box} box */
const up = (height, { height: all }) => all / 2 - height * (all / 2 - EDGE);

/** The place of a mark. @param {Mark} mark @param {Box} box */
export const placeOf = (mark, box) => ({ x: across(mark.crest, box), y: up(heightOf(mark), box) });

/** The other crests of its wave in the beat, px. @param {Mark} mark @param {Box} box */
export const otherCrests = (mark, box) =>
  Array.from({ length: mark.perBeat - 1 }, (_, k) => across(mark.crest + (k + 1) / mark.perBeat, box));

/** The wave of a muscle over a beat, as the path of a line. @param {Mark} mark @param {Box} box */
export function waveOf(mark, box) {
  const count = POINTS * mark.perBeat;
  const height = heightOf(mark);
  const phase = 90 - 360 * mark.perBeat * mark.crest;
  let path = "";
  for (let k = 0; k <= count; k++) {
    const size = waveAt({ ...mark, phase }, k / count);
    path += `${k ? "L" : "M"}${across(k / count, box).toFixed(1)} ${up(height * size, box).toFixed(1)}`;
  }
  return path;
}

/** The nearest mark within reach; of equally near ones, the last one drawn. @param {Dot[]} marks @param {Box} box @param {{x: number, y: number}} at @param {number} reach */
export function markAt(marks, box, at, reach) {
  let [found, least] = [/** @type {Dot | null} */ (null), reach];
  for (const mark of marks) {
    const { x, y } = placeOf(mark, box);
    const distance = Math.hypot(x - at.x, y - at.y);
    if (distance <= least) [found, least] = [mark, distance];
  }
  return found;
}

/**
 * How far a drag moves marks: all by the same amount, the dragged one on a grid, and none out of its range.
 *
 * @param {Mark} held the mark that is dragged, as it was
 * @param {Mark[]} all that move with it, as they were
 * @param {Box} box
 * @param {number} dx pixels
 * @param {number} dy
 * @returns {Way}
 */
export function wayOf(held, all, box, dx, dy) {
  const crest = held.crest + dx / (box.width - 2 * EDGE);
  const part = within(all, -dy / (box.height / 2 - EDGE));
  const full = held.joint ? FULL_TURN : FULL_STRETCH;
  const finest = held.joint ? 1 : 0.01;
  // A mark that is moved up or down snaps to round numbers; any other keeps its amplitude.
  const higher = dy ? within(all, (Math.round((held.amplitude + part * full) / finest) * finest - held.amplitude) / full) : 0;
  return {
    later: dx ? Math.round(crest * GRID) / GRID - held.crest : 0,
    stretch: higher * FULL_STRETCH,
    turn: higher * FULL_TURN,
  };
}

/** A step by keys. @param {Mark[]} all that move @param {number} later beats @param {number} higher -1 to 1 @returns {Way} */
export function stepOf(all, later, higher) {
  const part = within(all, higher);
  return { later, stretch: part * FULL_STRETCH, turn: part * FULL_TURN };
}

/** By how much all amplitudes can grow, in full heights, without leaving their ranges. @param {Mark[]} all @param {number} wanted */
function within(all, wanted) {
  let part = wanted;
  for (const { joint, amplitude } of all) {
    const [full, most] = joint ? [FULL_TURN, MAX_TURN] : [FULL_STRETCH, MAX_STRETCH];
    part = Math.max((-most - amplitude) / full, Math.min((most - amplitude) / full, part));
  }
  return part;
}

/** A mark after it was moved. @param {Mark} mark @param {Way} way @returns {Mark} */
export const movedBy = (mark, { later, stretch, turn }) => ({
  ...mark,
  crest: inTurn((mark.crest + later) * mark.perBeat) / mark.perBeat,
  amplitude: mark.amplitude + (mark.joint ? turn : stretch),
});

/** The name of what is dragged. @param {Dot} dot */
export function nameOf({ joint, part, members, number }) {
  if (members.length === 1) return say(joint ? "muscles-joint" : "muscles-spring", { number: String(part) });
  const group = { group: number, from: String(part), to: String(members[members.length - 1].part) };
  return say(joint ? "muscles-joints" : "muscles-springs", group);
}

/** Amplitude and time of a muscle in words. @param {Mark} mark */
export function inWords({ joint, amplitude, crest }) {
  const size = joint ? `${Math.round(amplitude)}°` : `${Math.round(100 * amplitude)} %`;
  return say("muscles-moves", { size: `${amplitude > 0 ? "+" : ""}${size.replace("-", "−")}`, crest: decimal(crest.toFixed(2)) });
}
