// @ts-check
/** What is read of the numbers that say how a body is, and which colours it gets by them. */
import assert from "node:assert/strict";
import test from "node:test";
import { springs } from "../../app/drawing/static/draw.js";
import { readFrame } from "../../app/drawing/static/plan.js";
import { beatsAt } from "../../app/drawing/static/swing.js";

/** Sections, each after its length. */
const joined = (/** @type {number[][]} */ ...sections) =>
  Float32Array.from(sections.flatMap((section) => [section.length, ...section]));

test("a rival has a time, a scale of lengths and a turn of angles of its own", () => {
  const { rival, ...own } = readFrame(joined([1, 2, 1.5, 30], [10, 20], [], [3, 0.5, -45], [7, 8, 9, 10]));
  assert.deepEqual([own.time, own.lengthScale, own.angleShift, [...own.positions]], [2, 1.5, 30, [10, 20]]);
  assert.ok(rival);
  assert.deepEqual([rival.time, rival.lengthScale, rival.angleShift], [3, 0.5, -45]);
  assert.deepEqual([...rival.positions], [7, 8, 9, 10]);
});

test("a spring that has yielded has no colour at its new length", () => {
  const plan = /** @type {any} */ ({
    springs: [0, 1], restLength: [10], restAngle: [], fullStrain: [0.5], thickness: [1], bars: true, scale: 1, muscles: [],
    strainColors: [0, 0, 255, 9, 9, 9, 255, 0, 0],
  });
  const colors = (/** @type {number} */ moved) => {
    const damage = /** @type {any} */ ({ setLength: [moved], broken: new Set() });
    return [...springs(plan, /** @type {any} */ ({ time: 0, lengthScale: 1 }), new Float64Array([0, 0, 15, 0]), damage).batched_colors];
  };
  assert.deepEqual(colors(0), [255, 0, 0]);
  assert.deepEqual(colors(5), [9, 9, 9]);
});

test("the beat of muscles is ahead by its phase", () => {
  assert.equal(beatsAt(/** @type {any} */ ({ muscles: [2, 90] }), 1), 2.25);
});
