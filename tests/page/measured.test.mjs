// @ts-check
/** Which measured places are those of the time that is shown, and where the bodies of a fan are. */
import assert from "node:assert/strict";
import test from "node:test";
import { fanAt, placesAt } from "../../app/features/fit/fit.js";

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

test("the bodies of a fan are between two frames, and gone after the last", () => {
  const fan = { numbers: [0, 10, 100, 0, 2, 20, 100, 8], draws: 2, masses: 1, rate: 4 };
  assert.deepEqual(fanAt(fan, 0.125), [1, 15, 100, 4]);
  assert.deepEqual(fanAt(fan, 0.25), [2, 20, 100, 8]);
  assert.deepEqual(fanAt(fan, 0.26), []);
  assert.deepEqual(fanAt({ numbers: [], draws: 0, masses: 0, rate: 0 }, 0), []);
});
