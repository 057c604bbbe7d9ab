// @ts-check
/** Which measured places are those of the time that is shown. */
import assert from "node:assert/strict";
import test from "node:test";
import { placesAt } from "../../app/page/measure/measured.js";

const numbers = [0, 1, 2, 0.1, 3, 4, 0.2, 5, 6, 0.1, 7, 8];

test("the places of the nearest time, of all masses", () => {
  assert.deepEqual(placesAt(numbers, 0.04), [0]);
  assert.deepEqual(placesAt(numbers, 0.13), [3, 9]);
});

test("none before the first and after the last", () => {
  assert.deepEqual(placesAt(numbers, -0.2), []);
  assert.deepEqual(placesAt(numbers, 0.35), []);
  assert.deepEqual(placesAt([], 0), []);
});
