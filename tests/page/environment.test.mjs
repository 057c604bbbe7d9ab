// Outlines of what surrounds a body, on the screen.
import assert from "node:assert/strict";
import { test } from "node:test";
import { airAt, gridLines, hatching, loops, resisting, streaks, uncovered, wallInView } from "../../app/stage/environment.js";
import { showWalls } from "../../app/stage/camera.js";

const view = { left: 0, right: 800, top: 0, bottom: 600 };
const on = { x: 400, y: 300, step: 100 };
/** A scene whose px are pixels, and whose middle is in the middle of the view. */
const plan = (changes) => ({
  scale: 0.01, x: 400, y: 300, flip: -1,
  walls: new Float32Array(), fillings: new Float32Array(), wind: new Float32Array(),
  ...changes,
});
const floor = plan({ walls: new Float32Array([0, 500, 0, -1]) });
const numbers = (path) => path.match(/-?\d+(\.\d+)?/g)?.map(Number) ?? [];

test("a wall reaches over all of the view, wherever that is", () => {
  const wall = wallInView(floor, floor.walls, 0, on, view);
  assert.deepEqual(wall.surface.map(({ y }) => y), [500, 500]);
  assert.deepEqual(wall.surface.map(({ x }) => x).sort((a, b) => a - b), [0, 800]);
  assert.equal(wall.corners.length, 4);
  // Moved up by far, and zoomed: the view is all wall, or none of it.
  assert.equal(wallInView(floor, floor.walls, 0, { ...on, y: -9e5 }, view).corners.length, 4);
  assert.equal(wallInView(floor, floor.walls, 0, { ...on, y: -9e5 }, view).surface.length, 0);
  assert.deepEqual(wallInView(floor, floor.walls, 0, { ...on, y: 9e5 }, view).corners, []);
});

test("strokes begin at the surface, go into the wall, and stay in place when the view moves", () => {
  const strokes = numbers(hatching(wallInView(floor, floor.walls, 0, on, view), 1));
  assert.ok(strokes.length / 4 > 40 && strokes.length / 4 < 120, `${strokes.length / 4}`);
  for (let i = 0; i < strokes.length; i += 4) assert.ok(strokes[i + 1] === 500 && strokes[i + 3] > 500);
  const moved = numbers(hatching(wallInView(floor, floor.walls, 0, { ...on, x: 416 }, view), 1));
  assert.ok(strokes.some((x, i) => i % 4 === 0 && Math.abs(x + 16 - moved[4]) < 0.2));
});

test("where walls meet, each surface ends", () => {
  const both = plan({ walls: new Float32Array([0, 500, 0, -1, 200, 0, 1, 0]) });
  const [ground, side] = [0, 1].map((i) => wallInView(both, both.walls, i, on, view));
  assert.deepEqual(uncovered(ground, [side]).map(({ x }) => x).sort((a, b) => a - b), [200, 800]);
  assert.deepEqual(uncovered(side, [ground]).map(({ y }) => y).sort((a, b) => a - b), [0, 500]);
  assert.deepEqual(uncovered(side, [{ at: { x: 400, y: 0 }, normal: { x: 1, y: 0 } }]), []);
});

test("air without gusts is the mean wind, and streaks are few, finite, and drift with it", () => {
  const steady = plan({ wind: new Float32Array([300, 0]) });
  assert.deepEqual(airAt(steady.wind, 12, 34), { u: 300, v: 0 });
  const [before, after] = [0, 0.01].map((time) => streaks(steady, time, on, view).split(/(?=M)/));
  assert.ok(before.length / 2 > 10 && before.length / 2 < 80, `${before.length}`);
  assert.ok(numbers(before.join("")).every(Number.isFinite));
  const [x, y] = numbers(before.find((line) => numbers(line)[0] > 300) ?? "");
  assert.ok(after.some((line) => Math.abs(numbers(line)[0] - x - 3) < 0.2 && Math.abs(numbers(line)[1] - y) < 0.2));
  assert.equal(streaks(plan({ wind: new Float32Array([0, 0]) }), 0, on, view), "");
});

test("streaks go on for hours and at any zoom", () => {
  const gusts = plan({ wind: new Float32Array([300, -50, 0.02, 0.01, -40, 80, 1]) });
  for (const step of [1, 10, 100, 5000]) {
    const lines = streaks(gusts, 1e5, { ...on, step }, view);
    assert.ok(lines.length < 60_000 && numbers(lines).every(Number.isFinite), `${step}: ${lines.length}`);
  }
});

test("a medium and the ground cover the view, and their marks stay in the scene when the view moves", () => {
  const around = plan({ medium: true, ground: true });
  const found = resisting(around, on, view);
  assert.deepEqual(numbers(found.medium), [0, 0, 800, 0, 800, 600, 0, 600]);
  assert.equal(found.ground, found.medium);
  const moved = resisting(around, { ...on, x: 430, y: 280 }, view);
  for (const kind of /** @type {const} */ (["ripple", "grain"])) {
    const places = (path) => path.split("M").slice(1).map((line) => numbers(line).slice(0, 2));
    const [before, after] = [places(found[kind]), places(moved[kind])];
    // In the view, which both have in common.
    const inside = before.filter(([x, y]) => x > 30 && x < 770 && y > 30 && y < 570);
    assert.ok(inside.length > 30 && inside.length < 800, `${kind}: ${inside.length}`);
    assert.ok(inside.every(([x, y]) => after.some(([u, v]) => Math.hypot(u - x - 30, v - y + 20) < 0.2)), kind);
  }
});

test("what does not resist is not drawn, and where wind moves a medium its streaks show that", () => {
  assert.deepEqual(resisting(plan({}), on, view), { medium: "", ripple: "", ground: "", grain: "" });
  const flows = resisting(plan({ medium: true, wind: new Float32Array([50, 0]) }), on, view);
  assert.ok(flows.medium && !flows.ripple);
  const calm = resisting(plan({ medium: true, wind: new Float32Array([0, 0]) }), on, view);
  assert.ok(calm.ripple);
  for (const step of [0.1, 10, 100, 50000]) {
    const { ripple, grain } = resisting(plan({ medium: true, ground: true }), { ...on, step }, view);
    assert.ok((ripple + grain).length < 200_000 && numbers(ripple + grain).every(Number.isFinite), `${step}`);
  }
});

test("the grid has round numbers, and fewer lines from far away", () => {
  const near = gridLines(plan({}), 600, on, view);
  assert.match(near.major, /M400\.0 0V600/);
  assert.equal(near.major.match(/M/g)?.length, 9 + 7);
  const far = gridLines(plan({}), 600, { ...on, step: 10 }, view);
  assert.equal(far.grid, "");
  assert.deepEqual(gridLines(plan({}), 600, { ...on, step: 1 }, view), { grid: "", major: "" });
});

test("walls just beyond the scene's frame are shown with it, far ones are not", () => {
  const frame = () => ({ left: -3, right: 3, low: -3, high: 3 });
  const fitted = (walls) => {
    const seen = frame();
    showWalls(seen, plan({ walls: new Float32Array(walls) }));
    return seen;
  };
  const below = fitted([0, 620, 0, -1]);
  assert.ok(Math.abs(below.low + 3.2 + 0.3) < 1e-5, `${below.low}`);
  assert.deepEqual({ ...below, low: -3 }, frame());
  assert.deepEqual(fitted([0, 900, 0, -1]), frame());
  assert.deepEqual(fitted([0, 500, 0, -1]), frame());
  assert.ok(fitted([95, 0, 1, 0]).left < -3.05);
});

test("a filling is drawn until a spring of its loop, and all beside it, are broken", () => {
  const ring = plan({ fillings: new Float32Array([1, 3, 0, 1, 2]), springs: new Float32Array([0, 1, 2, 1, 2, 0, 1, 0, 3, 0]) });
  const places = new Float64Array([0, 0, 10, 0, 0, 10, 5, 5]);
  const drawn = (/** @type {number[]} */ ...broken) => loops(ring, places, true, new Set(broken)) !== "";
  assert.ok(drawn() && drawn(0) && drawn(4));
  assert.ok(!drawn(0, 3) && !drawn(1) && !drawn(2));
});
