// What a plot of one quantity over another stands for at a place.
import assert from "node:assert/strict";
import { test } from "node:test";
import { valuesAt } from "../../app/features/measure/phase.js";

const EDGES = [58, 298, 200, 10];
const ENDS = [-1, 1, 100, 300];

test("corners and middle have the ends of the axes and what is between them", () => {
  assert.deepEqual(valuesAt(58, 200, EDGES, ENDS), [-1, 100]);
  assert.deepEqual(valuesAt(298, 10, EDGES, ENDS), [1, 300]);
  assert.deepEqual(valuesAt(178, 105, EDGES, ENDS), [0, 200]);
});

test("beside the axes there is nothing", () => {
  for (const [x, y] of [[57, 100], [299, 100], [100, 201], [100, 9], [NaN, 100]]) {
    assert.equal(valuesAt(x, y, EDGES, ENDS), null);
  }
});
