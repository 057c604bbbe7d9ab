// Places in a video: following a piece of the picture over drawn frames, and the table.
import assert from "node:assert/strict";
import { test } from "node:test";
import { cutOut, find, greyOf } from "../../app/pages/video/follow.js";
import { measured, tableOf } from "../../app/pages/video/table.js";

const WIDTH = 320, HEIGHT = 200;

/** A frame with soft discs on a slanted background, in a light of its own. */
function frame(discs, light = 1, noise = 0) {
  const pixels = new Uint8ClampedArray(4 * WIDTH * HEIGHT);
  let seed = 1;
  const random = () => (seed = (seed * 16807) % 2147483647) / 2147483647 - 0.5;
  for (let j = 0; j < HEIGHT; j++) {
    for (let i = 0; i < WIDTH; i++) {
      let value = 60 + 0.2 * i + 0.1 * j;
      for (const { x, y, r = 6 } of discs) {
        const inside = Math.max(0, Math.min(1, r - Math.hypot(i + 0.5 - x, j + 0.5 - y) + 0.5));
        value += inside * (220 - value);
      }
      pixels.fill(light * value + noise * random(), 4 * (j * WIDTH + i), 4 * (j * WIDTH + i) + 3);
    }
  }
  return greyOf(pixels, WIDTH, HEIGHT);
}

test("a disc is followed within a small part of a pixel, whatever the light", () => {
  const at = (k) => ({ x: 100.3 + 60 * Math.sin(0.3 * k), y: 90.7 + 30 * Math.cos(0.3 * k) });
  const template = cutOut(frame([at(0)]), at(0).x, at(0).y);
  let seen = at(0);
  for (let k = 1; k < 25; k++) {
    seen = find(frame([at(k)], 0.7 + 0.02 * k, 6), template, seen.x, seen.y);
    assert.ok(Math.hypot(seen.x - at(k).x, seen.y - at(k).y) < 0.15, `frame ${k}: ${seen.x}, ${seen.y}`);
  }
});

test("the marked point may be anywhere on the disc, and keeps its place on it", () => {
  const template = cutOut(frame([{ x: 100, y: 90 }]), 103.2, 88.4);
  const seen = find(frame([{ x: 112.5, y: 84 }]), template, 103.2, 88.4);
  assert.ok(Math.hypot(seen.x - 115.7, seen.y - 82.4) < 0.15);
});

test("what is gone is lost, and neither a plain piece nor one at the edge can be followed", () => {
  const grey = frame([{ x: 100, y: 90 }]);
  const template = cutOut(grey, 100, 90);
  assert.equal(find(frame([]), template, 100, 90), null);
  assert.equal(find(frame([{ x: 200, y: 90 }]), template, 100, 90), null);
  assert.equal(cutOut(greyOf(new Uint8ClampedArray(4 * WIDTH * HEIGHT).fill(90), WIDTH, HEIGHT), 100, 90), null);
  assert.equal(cutOut(grey, 4, 90), null);
  assert.equal(cutOut(grey, 100, HEIGHT - 3), null);
});

test("at the edge of the picture it is found as far as it can be", () => {
  const seen = find(frame([{ x: 10.5, y: 90.5 }]), cutOut(frame([{ x: 30.5, y: 90.5 }]), 30.5, 90.5), 30.5, 90.5);
  assert.ok(Math.abs(seen.x - 10.5) < 0.15 && Math.abs(seen.y - 90.5) < 0.15);
});

test("the table has the scale, the origin, either direction, and gaps", () => {
  const scale = { origin: { x: 50, y: 150 }, pixels: 200, unit: "m", down: false };
  assert.deepEqual(measured({ x: 150, y: 50 }, scale), { x: 0.5, y: 0.5 });
  assert.deepEqual(measured({ x: 150, y: 50 }, { ...scale, down: true }), { x: 0.5, y: -0.5 });
  const points = [
    { name: "mass1", places: new Map([[0, { x: 50, y: 150 }], [2, { x: 250, y: 110 }], [3, { x: 250, y: 110 }]]) },
    { name: "mass2", places: new Map([[1, { x: 0, y: 150 }]]) },
    { name: "mass3", places: new Map() },
  ];
  const times = new Map([[0, 0], [1, 1 / 30], [2, 2 / 30], [3, 2 / 30]]);
  assert.equal(
    tableOf(points, times, scale),
    "time [s],mass1.x [m],mass1.y [m],mass2.x [m],mass2.y [m]\n0,0,0,,\n0.03333333,,,-0.25,0\n0.06666667,1,0.2,,\n",
  );
});
