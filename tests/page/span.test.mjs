/** The bar of time: where on it the times of a run are. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { FINE, barOf } from "../../app/features/time/span.js";

test("of a run of up to a minute, positions are seconds", () => {
  for (const end of [0.5, 20, FINE]) {
    const bar = barOf(0, end);
    assert.equal(bar.low, 0);
    for (const time of [0, 0.3 * end, end]) {
      assert.equal(bar.position(time), time);
      assert.equal(bar.time(time), time);
    }
  }
});

test("of a longer one the last minute has half of it, and all else the rest", () => {
  const bar = barOf(0, 3600);
  assert.deepEqual([bar.low, bar.turn], [3480, 3540]);
  assert.equal(bar.position(0), 3480);
  assert.equal(bar.position(1770), 3510);
  assert.equal(bar.position(3550), 3550);
});

for (const [start, end] of [[0, 61], [0, 119], [0, 121], [30, 3600], [3570, 3600]]) {
  test(`positions lead back to times, from ${start} to ${end} s`, () => {
    const bar = barOf(start, end);
    let before = -Infinity;
    for (let i = 0; i <= 100; i++) {
      const time = start + ((end - start) * i) / 100;
      const position = bar.position(time);
      assert.ok(position > before && position >= bar.low - 1e-9 && position <= end);
      assert.ok(Math.abs(bar.time(position) - time) < 1e-6);
      before = position;
    }
    assert.equal(bar.time(bar.low), start);
  });
}

test("a run that grows beyond a minute moves nothing by a jump", () => {
  for (const end of [FINE, 2 * FINE]) {
    for (const time of [0, 10, 50]) {
      const [one, other] = [barOf(0, end), barOf(0, end + 1e-6)];
      const part = (/** @type {ReturnType<typeof barOf>} */ bar) => (bar.position(time) - bar.low) / (end - bar.low);
      assert.ok(Math.abs(part(one) - part(other)) < 1e-6);
    }
  }
});
