// Ticks, marks and ranges of plots.
import assert from "node:assert/strict";
import test from "node:test";
import "./page.mjs";
import { markText, rangeOf, ticks } from "../../app/ui/gui/plot.js";

test("the marks of an axis are round numbers that can be told apart", () => {
  for (const [low, high] of [[0.267, 0.2673], [331.2, 331.2008], [0, 3e-6], [-2e5, 3e5], [-1, 1]]) {
    const marks = ticks(low, high);
    assert.ok(marks.length > 2 && marks.length < 12, String(marks));
    assert.ok(marks.every((mark) => mark >= low - 1e-9 && mark <= high + 1e-9));
    assert.equal(new Set(marks.map(markText)).size, marks.length, marks.map(markText).join());
  }
  assert.deepEqual(ticks(0, 10), [0, 2, 4, 6, 8, 10]);
});

test("a range is a little more than that of the numbers, and some range where there is none", () => {
  const [low, high] = rangeOf([NaN, 1, 3, Infinity]);
  assert.ok(low < 1 && low > 0.8 && high > 3 && high < 3.2);
  assert.deepEqual(rangeOf([]), [0, 1]);
  const [under, over] = rangeOf([5, 5]);
  assert.ok(under < 5 && over > 5);
});
