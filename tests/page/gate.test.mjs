// When masses cross a light gate.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Gate, endsOf, whenZero } from "../../app/features/instruments/gate.js";

const PLAN = { x: 100, y: 50, scale: 2, flip: -1 };
/** A point of the gate at a place of the scene. */
const at = (x, y, mass = -1) => ({ x: (x - PLAN.x) * PLAN.scale, y: (y - PLAN.y) * PLAN.scale * PLAN.flip, mass });
const UPRIGHT = [at(0, -20), at(0, 20)];
const run = (gate, place, from, to, points = UPRIGHT, rate = 60) => {
  for (let k = Math.round(from * rate); k <= Math.round(to * rate); k += 1) {
    gate.add({ time: k / rate, positions: Float64Array.from(place(k / rate)) }, PLAN, points);
  }
  return gate;
};
const near = (a, b, by) => assert.ok(Math.abs(a - b) < by, `${a} is not ${b}`);

test("ends are in the scene, and one on a mass is where that is", () => {
  assert.deepEqual(endsOf([at(30, 70), at(1, 2, 1), at(5, 6, 9)], PLAN, [7, 8, 9, 10]), [30, 70, 9, 10, 5, 6]);
});

test("a swinging mass crosses twice a period, at the times of its closed form, and each tells the interval", () => {
  const [period, start] = [1.37, 0.3];
  const swing = (t) => [80 * Math.sin((2 * Math.PI * (t - start)) / period), 3];
  const { crossings } = run(new Gate(), swing, 0, 6);
  assert.equal(crossings.length, 9);
  crossings.forEach(({ mass, time, since }, k) => {
    assert.equal(mass, 0);
    near(time, start + (k * period) / 2, 1e-4);
    if (k) near(since, period / 2, 1e-4);
    else assert.equal(since, null);
  });
});

test("a falling mass is timed between frames to its acceleration", () => {
  const { crossings } = run(new Gate(), (t) => [3, -15 + 500 * t * t], 0, 1, [at(-20, 0), at(20, 0)], 30);
  assert.equal(crossings.length, 1);
  near(crossings[0].time, Math.sqrt(15 / 500), 1e-9);
  near(whenZero(NaN, -1, 3, NaN), 0.25, 1e-12);
});

test("who passes beside the gate, rests on it, or holds it does not cross", () => {
  assert.equal(run(new Gate(), (t) => [100 * (t - 0.5), 21], 0, 1).crossings.length, 0);
  assert.equal(run(new Gate(), (t) => [1e-9 * Math.sin(100 * t), 0], 0, 1).crossings.length, 0);
  const moving = run(new Gate(), (t) => [100 * (t - 0.5), -20, 0, 0], 0, 1, [at(0, -20, 0), at(0, 20)]);
  assert.deepEqual(moving.crossings.map(({ mass }) => mass), [1], "it moves over the mass at rest");
});

test("gone back in time, what came after is void; intervals are of the same mass", () => {
  const two = (t) => [100 * (t - 0.5), 0, 100 * (t - 0.71), 5];
  const gate = run(new Gate(), two, 0, 1);
  assert.deepEqual(gate.crossings.map(({ mass, since }) => [mass, since]), [[0, null], [1, null]]);
  gate.add({ time: 0.6, positions: Float64Array.from(two(0.6)) }, PLAN, UPRIGHT);
  assert.equal(gate.crossings.length, 1);
  run(gate, two, 37 / 60, 1);
  assert.equal(gate.crossings.length, 2, "once more");
  gate.add({ time: 1.1, positions: Float64Array.from([0, 0]) }, PLAN, UPRIGHT);
  assert.deepEqual(gate.crossings, [], "another body");
  run(gate, () => [-5, 0], 2, 2.1);
  gate.add({ time: 9, positions: Float64Array.from([5, 0]) }, PLAN, UPRIGHT);
  assert.deepEqual(gate.crossings, [], "nobody knows when, in a gap");
});

test("it does not keep more than the last crossings", () => {
  const { crossings } = run(new Gate(), (t) => [Math.sin(40 * t), 0], 0, 10);
  assert.equal(crossings.length, 50);
  assert.ok(crossings[0].time > 5);
});
