// Plots as sound: which pitch a value has, that angles do not jump, and where clicks are.
import assert from "node:assert/strict";
import test from "node:test";
import "./page.mjs";
import { circularTones, COMPONENTS, Follower, HIGH, LOW, onward, panOf, passesZero, pitchOf, scoreOf, tonesAt } from "../../app/ui/pitch.js";

/** @param {number} a @param {number} b @param {number} [within] */
const close = (a, b, within = 1e-9) => assert.ok(Math.abs(a - b) <= within, `${a} is not ${b}`);

test("equal steps are equal intervals between the bounds of the plot, also downwards", () => {
  const bounds = { bottom: -2, top: 6, turns: false };
  close(pitchOf(-2, bounds), LOW);
  close(pitchOf(6, bounds), HIGH);
  close(pitchOf(2, bounds), Math.sqrt(LOW * HIGH));
  close(pitchOf(0, bounds) / pitchOf(-1, bounds), pitchOf(5, bounds) / pitchOf(4, bounds));
  assert.ok(pitchOf(3, { ...bounds, bottom: 6, top: -2 }) < pitchOf(1, { ...bounds, bottom: 6, top: -2 }));
  close(pitchOf(9, bounds), HIGH); // what goes beyond them
  close(pitchOf(5, { bottom: 5, top: 5, turns: false }), Math.sqrt(LOW * HIGH));
  assert.deepEqual(tonesAt(null, bounds), []);
});

/** What is heard of components: loudness by pitch, those without any left out. */
const spectrum = (tones) => tones.filter(({ gain }) => gain > 1e-6).map(({ pitch, gain }) => [pitch, gain]).sort(([a], [b]) => a - b);

test("a circular tone is the same after a turn, as loud at each angle, and goes up as the angle grows", () => {
  for (let angle = -720; angle < 720; angle += 7) {
    const [one, other] = [spectrum(circularTones(angle)), spectrum(circularTones(angle + 360))];
    assert.equal(one.length, other.length);
    one.forEach(([pitch, gain], i) => {
      close(pitch, other[i][0], 1e-6);
      close(gain, other[i][1]);
    });
    close(one.reduce((sum, [, gain]) => sum + gain, 0), 1, 1e-6);
  }
  const [before, after] = [circularTones(10), circularTones(20)];
  before.forEach(({ pitch }, i) => close(after[i].pitch / pitch, 2 ** (10 / 360)));
});

test("an angle that jumps at 180 degrees is followed without a jump of any tone that can be heard", () => {
  const follower = new Follower();
  let before = null;
  for (let angle = 0; angle < 1500; angle += 3) {
    const { tones } = follower.next(((angle + 180) % 360) - 180, { bottom: -180, top: 180, turns: true });
    assert.equal(tones.length, COMPONENTS);
    before?.forEach(({ pitch, gain }, i) => {
      if (gain > 0.01 || tones[i].gain > 0.01) close(Math.log2(tones[i].pitch / pitch), 3 / 360);
      assert.ok(Math.abs(tones[i].gain - gain) < 0.02);
    });
    before = tones;
  }
  close(onward(-179, 179), 181);
  close(onward(10, 720), 730);
});

test("there is a click at each passing of zero, and of an angle that goes round in each turn", () => {
  const line = { name: "a", unit: "px", bottom: -1, top: 1, turns: false, values: [1, 0, -1, -0.5, null, 0.5, 1] };
  assert.deepEqual(scoreOf(line, 7).filter(({ clicks }) => clicks).map(({ at }) => at), [1, 5]);
  assert.ok(!passesZero(0, 1, false) && !passesZero(1, 2, false));
  const turning = { ...line, unit: "°", turns: true, values: [-170, -50, 50, 170, -70, 60] };
  assert.deepEqual(scoreOf(turning, 6).filter(({ clicks }) => clicks).map(({ at }) => at), [2, 5]);
});

test("two lines are at the left and at the right, more between them", () => {
  assert.deepEqual([panOf(0, 1), panOf(0, 2), panOf(1, 2)], [0, -1, 1]);
  assert.deepEqual([0, 1, 2, 3, 4].map((i) => panOf(i, 5)), [-1, -0.5, 0, 0.5, 1]);
});

test("a plot can be read from its tones", () => {
  const values = Array.from({ length: 100 }, (_, i) => 20 * Math.sin(i / 9) + i / 5);
  const line = { name: "a", unit: "px", bottom: Math.min(...values), top: Math.max(...values), turns: false, values };
  scoreOf(line, 3).forEach(({ at, tones: [{ pitch }] }, i) => {
    close(at, (3 * i) / 100);
    close(line.bottom + (line.top - line.bottom) * (Math.log(pitch / LOW) / Math.log(HIGH / LOW)), values[i], 1e-9);
  });
});
