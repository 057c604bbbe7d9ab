// @ts-check
/** The dots of the reveal. */
import assert from "node:assert/strict";
import test from "node:test";
import { columns } from "../../app/pages/classroom/reveal.js";

test("dots of predictions at one place stand in a row that fits", () => {
  assert.deepEqual(columns([100, 101, 300], 200), { size: 28, column: [0, 1, 0] });
  const many = columns(Array(20).fill(100), 200);
  assert.ok(20 * many.size <= 200);
  assert.deepEqual(many.column, [...Array(20).keys()]);
  assert.deepEqual(columns([], 200).column, []);
});

test("dots that would touch stand in different columns, and others in the first", () => {
  // They are drawn at their true places, so only these can be equal.
  assert.deepEqual(columns([130, 100, 127, 155, 102], 200), { size: 28, column: [0, 0, 2, 1, 1] });
});
