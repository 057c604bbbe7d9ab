// What is shown between two frames of the server.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Glide } from "../../app/stage/glide.js";

const SCREEN = 1 / 144;
/** A body that moves at 1 px/s, seen at a moment of the server's clock. */
const frame = (wall, generation = 1) => ({
  generation,
  time: wall,
  lengthScale: 1,
  angleShift: 0,
  positions: new Float32Array([wall, 0]),
  ghost: null,
});
/** Takes a frame that was made then. */
const take = (glide, wall, now) => glide.take(frame(wall), wall, now);

/** Plays frames, given as [made, arrived], and returns [now, shown time] at every refresh of the screen. */
function play(frames, end, skew = 0) {
  const glide = new Glide();
  const waiting = [...frames];
  const seen = [];
  for (let now = 0; now < end; now += SCREEN) {
    while (waiting.length && waiting[0][1] <= now) take(glide, waiting.shift()[0] + skew, now);
    const shown = glide.at(now);
    if (shown) seen.push([now, shown.time - skew]);
  }
  return { seen, glide };
}
const even = (count, rate, delay = 0.004) => Array.from({ length: count }, (_, i) => [i / rate, i / rate + delay]);

for (const rate of [60, 25]) {
  test(`${rate} frames a second are shown at the screen's own rate, one frame late at most`, () => {
    const { seen } = play(even(3 * rate, rate), 2.5);
    const steady = seen.filter(([now]) => now > 0.5);
    assert.ok(steady.length > 0.98 * 2.0 * 144, `${steady.length}`);
    for (let i = 1; i < steady.length; i++) {
      const speed = (steady[i][1] - steady[i - 1][1]) / (steady[i][0] - steady[i - 1][0]);
      assert.ok(Math.abs(speed - 1) < 0.1, `speed ${speed}`);
      const late = steady[i][0] - 0.004 - steady[i][1];
      assert.ok(late < 1 / rate + 0.003 && late > -0.001, `late ${late}`);
    }
  });
}

test("a stutter of the network is caught up with quickly, and never goes back", () => {
  const frames = even(180, 60).map(([made, arrived]) => [made, made > 1 && made < 1.15 ? 1.154 : arrived]);
  const { seen } = play(frames, 2.5);
  for (let i = 1; i < seen.length; i++) {
    const step = seen[i][1] - seen[i - 1][1];
    assert.ok(step >= 0 && step < 2 * 1.5 * SCREEN + 1e-6, `step ${step}`);
  }
  const [now, shown] = seen.filter(([at]) => at < 1.7).at(-1);
  assert.ok(now - shown < 0.004 + 1.5 / 60 + 0.02, `${now - shown}`);
});

test("a body that stood begins to move at once", () => {
  const frames = [...even(30, 60), ...even(60, 60).map(([made, arrived]) => [made + 2, arrived + 2])];
  const { seen } = play(frames, 2.5);
  const first = seen.find(([, time]) => time > 1.9);
  assert.ok(first && first[0] < 2.004 + 2 / 60, `${first}`);
});

test("the last frame is shown exactly, and then nothing is left to do", () => {
  const { seen, glide } = play(even(30, 60), 2);
  assert.equal(seen.at(-1)[1], 29 / 60);
  assert.equal(glide.busy, false);
});

test("another body is never mixed with the one before", () => {
  const glide = new Glide();
  take(glide, 0, 0);
  take(glide, 1 / 60, 1 / 60);
  glide.at(1 / 60);
  glide.take({ ...frame(2 / 60, 2), positions: new Float32Array([9, 9, 9, 9]) }, 2 / 60, 2 / 60);
  const shown = glide.at(2 / 60);
  assert.equal(shown?.generation, 2);
  assert.deepEqual([...(shown?.positions ?? [])], [9, 9, 9, 9]);
});

test("another body after a pause is not mixed with the one before either", () => {
  const glide = new Glide();
  take(glide, 0, 0);
  glide.at(0);
  glide.take({ ...frame(5, 2), positions: new Float32Array([9]) }, 5, 5);
  assert.deepEqual([...(glide.at(5)?.positions ?? [])], [9]);
});

test("a server that is started anew has another clock", () => {
  const glide = new Glide();
  for (const i of [0, 1, 2]) take(glide, 900 + i / 60, i / 60);
  for (let now = 1; now < 2; now += 1 / 60) take(glide, 100 + now, now + 0.004);
  assert.ok(Math.abs(/** @type {any} */ (glide.at(2)).time - 101.98) < 0.03);
});

test("a page in the background keeps no more frames than it may still show", () => {
  const { glide } = play(even(60, 60), 1);
  for (let i = 60; i < 60 * 3600; i++) take(glide, i / 60, i / 60);
  assert.ok(glide.frames.length < 60, `${glide.frames.length} frames`);
  assert.ok(Math.abs(glide.at(3600).time - 3600) < 0.1);
});
