// @ts-check
/** How a body follows a mass that a pupil drags in a prediction. */
import assert from "node:assert/strict";
import test from "node:test";
import { drag } from "../../app/features/classroom/prediction.js";

test("springs keep their lengths, and masses that are held stay", () => {
  const places = /** @type {[number, number][]} */ ([[0, 0], [1, 0], [2, 0]]);
  drag(places, 2, [1.5, 1], [[0, 1, 1], [1, 2, 1]], new Set([0]));
  assert.deepEqual(places[0], [0, 0]);
  assert.deepEqual(places[2], [1.5, 1]);
  for (const [a, b] of [[0, 1], [1, 2]]) {
    assert.ok(Math.abs(Math.hypot(places[a][0] - places[b][0], places[a][1] - places[b][1]) - 1) < 1e-3);
  }
});
