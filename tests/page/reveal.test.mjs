// @ts-check
/** The dots of the reveal. */
import assert from "node:assert/strict";
import test from "node:test";
import { rows } from "../../app/pages/classroom/reveal.js";

test("dots of predictions at one place stand in a row that fits", () => {
  const few = rows([100, 101, 300], 200);
  assert.equal(few.size, 28);
  assert.deepEqual(few.dots.map(({ count }) => count), [0, 1, 0]);
  const many = rows(Array(20).fill(100), 200);
  assert.ok(20 * many.size <= 200);
  assert.deepEqual(many.dots.map(({ count }) => count), [...Array(20).keys()]);
  assert.deepEqual(rows([], 200).dots, []);
});
