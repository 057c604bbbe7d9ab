// @ts-check
/** Muscles in groups, where a strip has no room for each. */
import assert from "node:assert/strict";
import test from "node:test";
import { clearest, groupsOf, nameOf, placeOf, singles } from "../../app/features/muscles/marks.js";

/** @param {number} part @param {Partial<import("../../app/features/muscles/marks.js").Mark>} [more] */
const mark = (part, more = {}) => ({ key: `j${part}`, joint: true, part, phase: 0, amplitude: 10, perBeat: 1, pulse: false, crest: 0.5, ...more });

test("neighbours of one kind are grouped evenly, and every muscle is in one group", () => {
  const marks = Array.from({ length: 28 }, (_, k) => mark(k));
  const groups = groupsOf(marks, 4);
  assert.deepEqual(groups.map(({ members }) => members.length), [4, 4, 4, 4, 4, 4, 4]);
  assert.deepEqual(groups.flatMap(({ members }) => members), marks);
  assert.deepEqual(groupsOf(marks, 5).map(({ members }) => members.length), [5, 4, 5, 5, 4, 5]);
  assert.equal(nameOf(groups[2]), "group 3, joints 8 to 11");
});

test("another kind, rhythm or place begins a group of its own", () => {
  const marks = [mark(0), mark(1, { perBeat: 2 }), mark(2, { perBeat: 2, pulse: true }), mark(5, { perBeat: 2, pulse: true }), mark(6, { joint: false })];
  assert.equal(groupsOf(marks, 4).length, 5);
  assert.equal(nameOf(singles(marks)[4]), "spring 6");
});

test("a group is at the mean of its crests, around the end of the beat, too", () => {
  const [group] = groupsOf([mark(0, { crest: 0.95, amplitude: 10 }), mark(1, { crest: 0.05, amplitude: 30 })], 2);
  assert.ok(Math.min(group.crest, 1 - group.crest) < 1e-9);
  assert.equal(group.amplitude, 20);
  const [twice] = groupsOf([mark(0, { crest: 0.49, perBeat: 2 }), mark(1, { crest: 0.01, perBeat: 2 })], 2);
  assert.ok(twice.crest < 1e-9 || twice.crest > 0.5 - 1e-9);
});

test("groups are as small as they can be without covering each other", () => {
  // A wave that runs along the body: with six groups, the fourth comes when the first does.
  const marks = Array.from({ length: 28 }, (_, k) => mark(k, { crest: ((k / 14) % 1 + 1) % 1 }));
  const box = { width: 300, height: 112 };
  const xs = clearest(marks, 5, box).map((dot) => placeOf(dot, box).x).sort((one, other) => one - other);
  assert.ok(Math.min(...xs.slice(1).map((x, i) => x - xs[i])) >= 20, String(xs));
  assert.deepEqual(clearest(marks, 4, { ...box, width: 360 }).length, 7);
});
