// What is under the pointer, what is marked, and when the page tries to connect.
import assert from "node:assert/strict";
import { test } from "node:test";
import { become, show } from "./page.mjs";
import { edgeArrow } from "../../app/stage/edge.js";
import { axisMarks, rangeOf, roundDown, roundUp } from "../../app/stage/axes.js";
import { degrees, jointAngles, lengthText } from "../../app/stage/measures.js";
import { addOverlay } from "../../app/stage/overlay.js";
import { nearest, onScreen, worldAt } from "../../app/stage/screen.js";

const plan = (flip) => ({
  scale: 0.01, x: 300, y: 200, flip,
  springs: new Float32Array([0, 1, 1, 2]),
  joints: new Float32Array([0, 1, 1, 1]),
  radius: new Float32Array([0.1, 0.1, 0.1]),
});
const on = { x: 400, y: 300, step: 100 };

test("masses are on the screen where the camera has them, whichever way y grows", () => {
  for (const flip of [1, -1]) {
    const places = onScreen(plan(flip), new Float32Array([310, 220]), on);
    assert.ok(Math.abs(places[0] - 410) < 1e-3 && Math.abs(places[1] - (300 - 20 * flip)) < 1e-3, `${places}`);
    const world = worldAt({ x: places[0], y: places[1] }, on);
    assert.ok(Math.abs(world.x - 0.1) < 1e-5 && Math.abs(world.y - 0.2 * flip) < 1e-5);
  }
});

test("the nearest mass within reach is taken, or the one whose disc it is", () => {
  const places = new Float64Array([0, 0, 30, 0, 100, 0]);
  const radii = [5, 5, 40];
  assert.equal(nearest(places, radii, { x: 12, y: 0 }, 14), 0);
  assert.equal(nearest(places, radii, { x: 18, y: 0 }, 14), 1);
  assert.equal(nearest(places, radii, { x: 15, y: 14 }, 14), -1);
  assert.equal(nearest(places, radii, { x: 138, y: 0 }, 14), 2);
});

test("an axis is marked at round numbers, and has room beyond its values", () => {
  assert.deepEqual(axisMarks(-0.31, 0.72, 4), [0, 0.5]);
  assert.deepEqual(axisMarks(3, 47, 5), [10, 20, 30, 40]);
  assert.deepEqual(axisMarks(-0.3, 0.3, 3), [-0.2, 0, 0.2]);
  assert.deepEqual(rangeOf([]), [0, 1]);
  const [low, high] = rangeOf([[0, 10], [20]]);
  assert.ok(low < 0 && low > -2 && high > 20 && high < 22);
  // Values that are nearly equal have an axis all the same.
  const [from, to] = rangeOf([[500, 500]]);
  assert.ok(axisMarks(from, to, 4).length >= 2);
});

test("a joint's arc turns as the joint does", () => {
  // From left to right, then up on the screen.
  for (const flip of [1, -1]) {
    const positions = new Float32Array([0, 0, 10, 0, 10, 10 * flip]);
    const { from, turn, mass } = jointAngles(plan(flip), { positions }, 0);
    assert.deepEqual([Math.abs(Math.round(from)), Math.round(turn), mass], [0, 90, 1]);
  }
});

test("the arc of the joint that is read out is at its mass and tells its angle, where no spring crosses it", () => {
  addOverlay();
  show([[200, 300], [300, 300], [400, 250]], [[0, 1], [1, 2]], [[0, 1, 1, 1]]);
  const [arc, label] = ["arc", "angle"].map((name) => document.querySelector(`.softrod-${name}`));
  assert.equal(label.style.display, "none");
  become({ joint: 0 });
  assert.deepEqual([label.style.display, label.textContent], ["", "−26.6°"]);
  assert.deepEqual(arc.getAttribute("d").match(/[\d.]+/g).slice(0, 2).map(parseFloat).map(Math.round), [300, 300]);
  const [x, y] = ["x", "y"].map((name) => Number(label.getAttribute(name)));
  assert.ok(Math.hypot(x - 300, y - 300) < 90 && y > 300, `${x} ${y}`);
  become({ joint: 1 });
  assert.equal(label.style.display, "none", "a joint that the picture does not have yet");
});

test("scale bars are round", () => {
  assert.deepEqual([0.7, 1, 1.2, 30, 51, 4e5].map(roundUp), [1, 1, 2, 50, 100, 500000]);
  assert.deepEqual([0.2, 0.01, 0.005, 2].map((size) => lengthText(size, "m")), ["20 cm", "1 cm", "0.005 m", "2 m"]);
  assert.equal(lengthText(0.2, "px"), "0.2 px");
  assert.deepEqual([0.75, 1, 1.2, 30, 51, 99, 4e5].map(roundDown), [0.5, 1, 1, 20, 50, 50, 200000]);
});

test("an arrow at the edge points to a body that is out of view, and there is none while a mass is in view", () => {
  const view = { left: 0, right: 800, top: 0, bottom: 600 };
  assert.equal(edgeArrow([2000, 300, 400, 300], view), null);
  assert.equal(edgeArrow([], view), null);
  assert.equal(edgeArrow([NaN, NaN], view), null);
  const right = edgeArrow([2000, 300, 9000, 100], view);
  assert.ok(right && right.x < 800 && right.x > 700 && right.y === 300 && right.turn === 0, JSON.stringify(right));
  const corner = edgeArrow([-100, 700], view);
  assert.ok(corner && corner.x > 0 && corner.y < 600 && Math.abs(corner.turn - 135) < 1e-9, JSON.stringify(corner));
});

test("an angle of zero has no sign", () => {
  assert.deepEqual([-0.04, -0, 0.04, -0.06, 12, -179.96].map(degrees), ["0.0°", "0.0°", "0.0°", "−0.1°", "12.0°", "−180.0°"]);
});
