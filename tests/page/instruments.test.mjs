// What ruler, protractor and stopwatch read, where they are, and what is kept of them.
import assert from "node:assert/strict";
import { test } from "node:test";
import * as shapes from "../../app/page/measure/instrument_shapes.js";

const on = { x: 400, y: 300, step: 100 };
const masses = new Float64Array([100, 100, 500, 400]);
const near = (a, b) => assert.ok(Math.abs(a - b) < 1e-9, `${a} is not ${b}`);

test("a point goes onto a mass within 12 px and then goes where that goes", () => {
  assert.equal(shapes.pointAt({ x: 108, y: 108 }, masses, on).mass, 0);
  assert.equal(shapes.pointAt({ x: 109, y: 109 }, masses, on).mass, -1);
  const point = shapes.pointAt({ x: 505, y: 403 }, masses, on);
  assert.deepEqual(shapes.placesOf([point], masses, on), [{ x: 500, y: 400 }]);
  assert.deepEqual(shapes.placesOf([point], new Float64Array([0, 0, 7, 8]), on), [{ x: 7, y: 8 }]);
  assert.deepEqual(shapes.placesOf([point], new Float64Array([0, 0]), on), [{ x: 7, y: 8 }], "without that mass it stays");
});

test("a free point stays where it is in the scene under zoom and pan", () => {
  const point = shapes.pointAt({ x: 300, y: 200 }, masses, on);
  const [place] = shapes.placesOf([point], masses, { x: 50, y: 60, step: 200 });
  near(place.x, 50 - 200);
  near(place.y, 60 - 200);
});

test("a ruler reads lengths of the scene, with y as the scene has it", () => {
  const [a, b] = [{ x: 100, y: 100 }, { x: 400, y: 500 }];
  const down = shapes.rulerReading(a, b, 2, -1);
  near(down.length, 250);
  near(down.dx, 150);
  near(down.dy, 200);
  near(shapes.rulerReading(a, b, 2, 1).dy, -200);
});

test("strokes of a ruler are at round lengths, and never too many", () => {
  const count = (path) => path.split("M").length - 1;
  const path = shapes.strokes({ x: 0, y: 0 }, { x: 100, y: 0 }, { x: 0, y: 1 }, 1);
  assert.equal(count(path), 11);
  assert.ok(path.includes("M10.0 0.0") && path.includes("M100.0 0.0"));
  for (const scale of [1e-6, 1, 1e6]) assert.ok(count(shapes.strokes({ x: 0, y: 0 }, { x: 1e5, y: 0 }, { x: 0, y: 1 }, scale)) <= 601);
  assert.equal(count(shapes.strokes({ x: 5, y: 5 }, { x: 5, y: 5 }, { x: 0, y: 1 }, 1)), 1);
});

test("a protractor reads the angle between its sides, in either order", () => {
  const [a, vertex, b] = [{ x: 10, y: 0 }, { x: 0, y: 0 }, { x: -7, y: 7 }];
  near(shapes.protractorReading(a, vertex, b).angle, 135);
  near(shapes.protractorReading(b, vertex, a).angle, 135);
  near(shapes.protractorReading(a, vertex, b).bend, 45);
  near(shapes.protractorReading(vertex, vertex, vertex).angle, 0);
});

test("a stopwatch counts simulated time while it runs, and has laps", () => {
  let watch = shapes.startOrStop(shapes.newWatch(), 10);
  near(shapes.watchReading(watch, 12.5), 2.5);
  watch = shapes.lapOrZero(watch, 12);
  watch = shapes.startOrStop(watch, 13);
  near(shapes.watchReading(watch, 99), 3);
  assert.deepEqual(watch.laps, [2]);
  watch = shapes.startOrStop(watch, 50);
  near(shapes.watchReading(watch, 51), 4);
  near(shapes.watchReading(watch, 20), 3, "time that was gone back on does not count");
  watch = shapes.lapOrZero(shapes.startOrStop(watch, 51), 52);
  assert.deepEqual([shapes.watchReading(watch, 60), watch.laps], [0, []]);
});

test("what is kept comes back, and what another version kept does not", () => {
  const ruler = { kind: "ruler", points: [{ x: 0, y: 1, mass: -1 }, { x: 2, y: 3, mass: 4 }] };
  const watch = { kind: "stopwatch", points: [{ x: 0, y: 0, mass: -1 }], watch: shapes.newWatch() };
  assert.deepEqual(shapes.restored(JSON.stringify([ruler, watch])), [ruler, watch]);
  assert.deepEqual(shapes.restored(JSON.stringify([{ ...ruler, kind: "axe" }, { ...ruler, points: [] }])), []);
  for (const text of [null, "", "{", "{}", "7", "null"]) assert.deepEqual(shapes.restored(text), []);
});
