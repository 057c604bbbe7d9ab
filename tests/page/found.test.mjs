// @ts-check
/** The class's plot. */
import assert from "node:assert/strict";
import test from "node:test";
import { axis } from "../../app/features/classroom/plot.js";

test("an axis has zero on it unless its numbers are close together beside it", () => {
  for (const [numbers, hasZero] of /** @type {[number[], boolean][]} */ ([[[500, 1000, 2000], true], [[-20, -5], true], [[70, 100], false], [[-9, -10], false]])) {
    const { part, marks } = axis(numbers, false);
    assert.equal(marks.includes(0), hasZero, String(numbers));
    assert.equal(part(0) >= 0 && part(0) <= 1, hasZero, String(numbers));
  }
});
