// Arrows of forces, velocities and torques: their numbers, their scale, and their outlines.
import assert from "node:assert/strict";
import { test } from "node:test";
import { unitOf } from "../../app/features/instruments/arrow_marks.js";
import { unpack } from "../../app/wire/unpack.js";
import { arrow, loadArrows } from "../../app/stage/arrow_shapes.js";
import { drivenArrows } from "../../app/stage/driven_arrows.js";
import { largest, massesOf, Scale, Series, torqueArrows, turnArrow, vectorArrows } from "../../app/features/instruments/arrows.js";

const view = { left: 0, right: 800, top: 0, bottom: 600 };
const points = (path) => [...path.matchAll(/(-?[\d.]+) (-?[\d.]+)(?=[A-Z]|$)/g)].map(([, x, y]) => [Number(x), Number(y)]);
/** As arrows.py encodes them. */
const numbers = (time, force, generation = 1) =>
  unpack("arrows", new Float32Array([4, generation, time, 1, 1, 3, 5, 6, 7, 1, 1, 4, force, 0, 0, 8, 0, 0]));

test("the numbers are read as they were written", () => {
  const read = numbers(2.5, 3);
  assert.deepEqual([read.generation, read.time, read.step, read.jointStep], [1, 2.5, 1, 1]);
  assert.deepEqual([...read.least], [5, 6, 7]);
  assert.deepEqual([[...read.held], [...read.forces]], [[1], [3, 0, 0, 8]]);
  assert.equal(read.velocities.length + read.torques.length, 0);
  assert.deepEqual(massesOf(read, 3), [0, 1, 2]);
  assert.deepEqual(massesOf({ ...read, step: 4, held: [8, 9] }, 12), [0, 4, 8, 9]);
  assert.equal(largest(read.forces, 2), 8);
  assert.equal(largest([1, -3], 1), 3);
});

test("numbers glide between two moments, and those of a future that was gone back on are forgotten", () => {
  const series = new Series();
  assert.equal(series.at(0), null);
  for (const [time, force] of [[1, 10], [2, 20], [3, 30]]) series.take(numbers(time, force));
  assert.equal(series.at(1.5).forces[0], 15);
  assert.equal(series.at(0).forces[0], 10);
  assert.equal(series.at(9).forces[0], 30);
  series.take(numbers(2, 99)); // the same moment with other settings
  assert.equal(series.at(5).forces[0], 99);
  assert.ok(Math.abs(series.at(1.5).forces[0] - 54.5) < 1e-6);
  series.take(numbers(1.5, 4, 2)); // another body
  assert.equal(series.at(1).generation, 2);
});

test("the scale is round, grows at once, and shrinks only when all have been short for a while", () => {
  const scale = new Scale();
  assert.equal(scale.update(430, 1, 0), 500);
  assert.equal(scale.update(501, 1, 0.1), 1000);
  assert.equal(scale.update(430, 1, 5), 1000, "500 would be too near");
  assert.ok(!scale.settling);
  for (let t = 5; t < 20; t += 0.1) assert.equal(scale.update(t % 1 < 0.1 ? 900 : 10, 1, t), 1000, "it does not flicker");
  assert.equal(scale.update(150, 1, 20.2), 1000);
  assert.ok(scale.settling);
  assert.equal(scale.update(120, 1, 21.8), 200, "of the largest one meanwhile");
  assert.equal(new Scale().update(1e-9, 40, 0), 50, "noise stays small");
});

test("an arrow ends where it should, and one that cannot be seen is nothing", () => {
  const ends = points(arrow(100, 100, 30, -40));
  assert.deepEqual(ends[0], [100, 100]);
  assert.ok(ends.some(([x, y]) => x === 130 && y === 60));
  assert.equal(arrow(0, 0, 1, 1), "");
  assert.equal(arrow(0, 0, NaN, 1), "");
});

test("forces along +y point down where y grows downwards, and masses out of view have no arrow", () => {
  const places = new Float64Array([100, 100, 900, 100, 300, 300]);
  const values = new Float32Array([0, 50, 0, 50, 0, 0]);
  const down = points(vectorArrows([0, 1, 2], values, places, 1, -1, view));
  assert.ok(down.some(([x, y]) => x === 100 && y === 150));
  assert.ok(down.every(([x]) => x < 200));
  const up = points(vectorArrows([0, 1, 2], values, places, 1, 1, view));
  assert.ok(up.some(([x, y]) => x === 100 && y === 50));
  assert.equal(vectorArrows([0], values, places, 1, 1, view, { only: () => false }), "");
});

test("an arc turns clockwise for a positive turn, by as much", () => {
  for (const turn of [1, -1, 4.5]) {
    const ends = points(turnArrow(100, 100, 20, 0, turn));
    assert.deepEqual(ends[0], [120, 100]);
    const [x, y] = [100 + 20 * Math.cos(turn), 100 + 20 * Math.sin(turn)];
    assert.ok(ends.some(([px, py]) => Math.hypot(px - x, py - y) < 0.2), `${turn}`);
  }
  assert.equal(turnArrow(0, 0, 20, 0, 0.01), "");
});

test("a torque's arc begins at the first spring and goes the way in which that is turned", () => {
  const places = new Float64Array([100, 100, 200, 100, 300, 100]);
  for (const first of [[0, 1], [1, 0]]) {
    const plan = {
      flip: -1, radius: new Float32Array([0.1, 0.1, 0.1]),
      springs: new Float32Array([...first, 1, 2]), joints: new Float32Array([0, 1, 1, 1]),
    };
    const path = torqueArrows(plan, { torques: new Float32Array([10]), jointStep: 1 }, places, 30, 100, view);
    const [start, ...others] = points(path);
    assert.ok(start[0] < 200 && start[1] === 100, "towards the first mass");
    // +x towards +y is clockwise where y grows downwards; a third of the full 270 degrees ends above.
    assert.ok(others.some(([x, y]) => Math.abs(x - 200) < 0.2 && y < 90));
  }
});

test("constant forces are arrows at their masses, in the world's units, with y upwards there", () => {
  const places = new Float64Array([100, 200, 300, 400]);
  const plan = { loads: new Float32Array([1, 0.5, -0.25]) };
  const ends = points(loadArrows(plan, places, 100));
  assert.deepEqual(ends[0], [300, 400]);
  assert.deepEqual(ends[3], [350, 425]);
  assert.equal(loadArrows({ loads: new Float32Array() }, places, 100), "");
});

test("in metres units have their names", () => {
  const kinds = ["forces", "velocities", "torques"];
  assert.deepEqual(kinds.map((kind) => unitOf(kind, "m")), ["N", "m/s", "N m"]);
  assert.deepEqual(kinds.map((kind) => unitOf(kind, "px")), ["kg px/s²", "px/s", "kg px²/s²"]);
});

test("a motor has an arc that points where it turns, and a force that keys work an arrow; both turn round with their keys", () => {
  const plan = {
    flip: -1, radius: new Float32Array([0.1, 0.1, 0.1]), springs: new Float32Array([0, 1, 1, 2]),
    joints: new Float32Array([0, 1, 1, 1]), motors: new Float32Array([0, 1, 0]), pushes: new Float32Array([2, 0.5, 0.25, 1]),
  };
  const places = new Float64Array([100, 100, 200, 100, 300, 100]);
  const at = (...efforts) => drivenArrows(plan, { efforts: new Float32Array(efforts) }, places, 100);
  const held = at(1, -1);
  assert.equal(held.rests, "");
  const [curve, arrows] = [held.works.slice(0, held.works.indexOf("M", 1)), points(held.works)];
  // +x towards +y is clockwise where y grows downwards: from below the second spring round to above it.
  assert.match(curve, /^M2\d\d\.\d 1\d\d\.\d.*A17\.0 17\.0 0 1 1 2\d\d\.\d 8\d/);
  assert.deepEqual(arrows.slice(-5)[1], [250, 125], "the force is the opposite one while Down is held");
  assert.match(at(-1, 0).works, /A17\.0 17\.0 0 1 0 /, "the motor turns back while Left is held");
  for (const none of [at(), at(0, 0)]) {
    assert.equal(none.works, "");
    assert.deepEqual(points(none.rests).slice(-5)[1], [350, 75]);
  }
  plan.motors = new Float32Array([0, -1, -1]);
  assert.match(at().works, /0 1 0 /, "a motor without keys always works");
});
