// @ts-check
/** What is read of the numbers that say where the masses are, and in which part of their beat muscles are. */
import assert from "node:assert/strict";
import test from "node:test";
import { readFrame } from "../../app/stage/plan.js";
import { beatsAt } from "../../app/stage/swing.js";

/** Sections, each after its length. */
const joined = (/** @type {number[][]} */ ...sections) =>
  Float32Array.from(sections.flatMap((section) => [section.length, ...section]));

test("a second body has a time, a scale of lengths and a turn of angles of its own", () => {
  const { second, ...own } = readFrame(joined([1, 2, 1.5, 30], [10, 20], [], [3, 0.5, -45], [7, 8, 9, 10]));
  assert.deepEqual([own.time, own.lengthScale, own.angleShift, [...own.positions]], [2, 1.5, 30, [10, 20]]);
  assert.ok(second);
  assert.deepEqual([second.time, second.lengthScale, second.angleShift], [3, 0.5, -45]);
  assert.deepEqual([...second.positions], [7, 8, 9, 10]);
});

test("after a day the time still goes on by each step", () => {
  const day = 86400.0123;
  const { time } = readFrame(joined([1, day, 1, 0, day - Math.fround(day)], [], []));
  assert.ok(Math.abs(time - day) < 1e-6);
});

test("the beat of muscles is ahead by its phase", () => {
  assert.equal(beatsAt(/** @type {any} */ ({ muscles: [2, 90] }), 1), 2.25);
});
