// The path of a mass during the last seconds.
import assert from "node:assert/strict";
import { test } from "node:test";
import { BANDS, Trail } from "../../app/features/instruments/trace.js";
import { speedOf } from "../../app/features/instruments/coordinates.js";

const place = ({ x, y }) => `${x} ${y}`;
const shownAt = (t) => ({ t, x: 10 * t, y: 0 });
const trail = (from, to, seconds = 5) => {
  const result = new Trail();
  for (let k = Math.round(60 * from); k <= Math.round(60 * to); k++) result.add(k / 60, k / 6, 0, seconds);
  return result;
};
const places = (paths) => paths.join("").match(/-?[\d.]+ /g)?.map(Number) ?? [];

test("a path has the last seconds only, ends where the mass is shown, and the oldest part is the palest", () => {
  const paths = trail(0, 10).bands(10, 5, shownAt(10), place);
  assert.equal(paths.length, BANDS);
  const xs = places(paths);
  assert.ok(Math.min(...xs) >= 49.8 && Math.max(...xs) === 100);
  assert.ok(Math.max(...places([paths[0]])) <= Math.min(...places([paths[BANDS - 1]])) + 1e-9 + 10);
  assert.ok(places([paths[0]]).every((x) => x < 60));
});

test("frames that are not shown yet are not drawn yet", () => {
  assert.equal(Math.max(...places(trail(0, 2).bands(1.9, 5, shownAt(1.9), place))), 19);
});

test("gone back in time, what came after is gone; after a reset all is", () => {
  const one = trail(0, 4);
  one.add(2, 20, 0, 5);
  const xs = places(one.bands(2, 5, shownAt(2), place));
  assert.ok(Math.max(...xs) === 20 && Math.min(...xs) === 0);
  one.add(0, 0, 0, 5);
  assert.equal(one.steps.length, 1);
  assert.deepEqual(places(one.bands(0, 5, shownAt(0), place)), []);
});

test("a path whose beginning was given up begins with a move", () => {
  // Gone back in time: the oldest place that is left is no longer too old.
  const one = trail(0, 8);
  assert.equal(one.steps[0].cut, false);
  for (const path of one.bands(6, 5, shownAt(6), place)) assert.match(path, /^(M|$)/);
});

test("there is no line over a leap in time", () => {
  const one = trail(0, 1);
  one.add(3, 500, 0, 5);
  one.add(3.1, 510, 0, 5);
  const path = one.bands(3.2, 5, { t: 3.2, x: 520, y: 0 }, place).join("");
  assert.ok(!/M10 0L500/.test(path) && !/L500/.test(path));
  assert.ok(/M500 0L510 0/.test(path) && /L520 0/.test(path));
});

test("a path of half a minute has a bounded number of points", () => {
  assert.ok(trail(0, 120, 30).steps.length < 1400);
});

test("a speed is told of two pictures of one motion only", () => {
  const at = (time, x) => ({ time, positions: new Float32Array([0, 0, x, 0]) });
  assert.ok(Math.abs(speedOf(at(1, 10), at(1.0625, 20), 1) - 160) < 1e-3);
  assert.ok(Math.abs(speedOf(at(1.0625, 20), at(1, 10), 1) - 160) < 1e-3, "backwards, too");
  assert.ok(Number.isNaN(speedOf(at(1, 10), at(5, 20), 1)));
  assert.ok(Number.isNaN(speedOf(null, at(5, 20), 1)));
});
