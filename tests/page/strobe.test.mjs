// The images that the stroboscope leaves.
import assert from "node:assert/strict";
import { test } from "node:test";
import { become, pass, show, tell } from "./page.mjs";
import { addOverlay } from "../../app/stage/overlay.js";
import { addStrobe, flashes, image, mostOf } from "../../app/features/instruments/strobe.js";
import { hearTools } from "../../app/features/instruments/tools.js";

const frame = (time, x = 100 * time, masses = 1) => ({ time, generation: 1, lengthScale: 1, angleShift: 0, positions: new Float64Array(2 * masses).fill(x), ghost: null });
const near = (a, b) => assert.ok(Math.abs(a - b) < 1e-9, `${a} is not ${b}`);

test("images are at multiples of the interval, with places between those of frames", () => {
  const times = [];
  for (let k = 1; k <= 60; k += 1) {
    for (const flash of flashes(frame((k - 1) / 60), frame(k / 60), 0.1)) {
      near(flash.positions[0], 100 * flash.time);
      times.push(flash.time);
    }
  }
  assert.equal(times.length, 10);
  times.forEach((time, i) => near(time, 0.1 * (i + 1)));
  assert.deepEqual(flashes(frame(0), frame(0.25), 0.1).map(({ time }) => Math.round(10 * time)), [1, 2], "several, if frames are few");
});

test("none is made up in a gap, of another body, or before the first frame", () => {
  assert.deepEqual(flashes(frame(0), frame(0.95), 0.1), []);
  assert.deepEqual(flashes(frame(0), frame(0.15, 5, 2), 0.1), []);
  assert.deepEqual(flashes(null, frame(0.15), 0.1), []);
  assert.equal(flashes(null, frame(0.2), 0.1).length, 1);
  assert.equal(flashes(null, frame(0), 0.1).length, 1);
});

test("an image has lines and discs in the world, without broken springs", () => {
  const plan = { x: 10, y: 20, scale: 0.5, flip: -1, radius: [2, 3], springs: [0, 1, 1, 0] };
  const { lines, discs } = image(plan, [10, 20, 30, 40], new Set([1]));
  assert.equal(lines, "M0 0L10 -10");
  assert.equal(discs, "M-2 0a2 2 0 1 0 4 0a2 2 0 1 0 -4 0M7 -10a3 3 0 1 0 6 0a3 3 0 1 0 -6 0");
});

test("fewer images stay of a body with many parts", () => {
  assert.deepEqual([1, 80, 200, 5000].map(mostOf), [100, 100, 40, 4]);
});

test("it is on the canvas while it is on, and goes back with the time", () => {
  addOverlay();
  hearTools();
  addStrobe();
  show([[100, 100], [200, 100]], [[0, 1]]);
  const strobe = () => document.querySelector(".softrod-strobe");
  const count = () => strobe()?.querySelectorAll(".softrod-strobe-masses").length ?? 0;
  const generation = 1;
  const send = (time) => tell("frame", { wall: time }, new Float32Array([4, generation, time, 1, 0, 4, 100, 100, 200, 100, 0]));
  for (const time of [0, 0.1]) send(time);
  assert.equal(strobe(), null, "nothing while it is off");
  const tools = { traced: [], seconds: 5, chosen: -1, coordinates: false };
  tell("tools", { ...tools, strobe: 0.1 });
  for (let k = 0; k <= 10; k += 1) send(k / 20);
  pass();
  assert.equal(count(), 6);
  send(0.25);
  assert.equal(count(), 3, "gone back in time");
  become({ scene: 99 });
  assert.equal(count(), 0, "another scene");
  tell("tools", { ...tools, strobe: 0 });
  assert.equal(strobe(), null);
});
