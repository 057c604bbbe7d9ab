// The clock of a live file, and what it reads off a run. The physics is tested by tests/app/test_live.py.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Body } from "../../app/export/live/static/body.js";
import { Clock } from "../../app/export/live/static/clock.js";
import { energies } from "../../app/export/live/static/energy.js";
import { Recording } from "../../app/export/live/static/quantities.js";
import { swings } from "../../app/export/live/static/swings.js";

const STILL = { factor: 1, angle: 0 };

/** A chain of masses, 20 px apart, of which the first one is held. */
function chain(masses, stiffness) {
  const all = (value) => Array(masses).fill(value);
  const springs = Array.from({ length: masses - 1 }, (_, s) => s);
  return {
    time: 0, law: "conservative", gravity: [0, 0], down: 1, airFriction: 0, wind: [0, 0], waves: [], softening: 0,
    positions: all(0).flatMap((_, m) => [20 * m, 0]), velocities: all(0).flatMap(() => [0, 0]), mass: all(1),
    held: all(0).map((_, m) => Number(m === 0)), loads: [], circles: [], ends: springs.flatMap((s) => [s, s + 1]),
    stiffness: springs.map(() => stiffness), damping: springs.map(() => 0), restLength: springs.map(() => 20),
    joints: [], jointStiffness: [], jointDamping: [], restAngle: [], broken: [], walls: [], fillings: [], contact: null,
    limits: null, yielded: null,
  };
}

test("a hand leads a mass no faster than a pull travels, and gets there", () => {
  const clock = new Clock(new Body(chain(4, 400)), "verlet", 0);
  const hand = [{ mass: 2, x: 240, y: 0 }];
  const fastest = 20 * Math.sqrt(400);
  let before = clock.body.positions[4];
  for (let frame = 0; frame < 60; frame++) {
    const began = clock.body.time;
    clock.go(1 / 60, hand, STILL);
    const passed = clock.body.time - began;
    assert.ok(Math.abs(clock.body.positions[4] - before) <= fastest * passed + 1e-9);
    before = clock.body.positions[4];
  }
  assert.ok(Math.abs(before - 240) < 1e-9);
  assert.ok(!clock.exploded);
});

test("a rope that is slack limits steps as if it were taut", () => {
  const rope = { ...chain(2, 1e6), gravity: [0, 1000], restLength: [60], sides: { springs: [1], joints: [] } };
  const clock = new Clock(new Body(rope), "verlet", 0);
  let farthest = 0;
  for (let frame = 0; frame < 60; frame++) {
    clock.go(1 / 60, [], STILL);
    farthest = Math.max(farthest, Math.hypot(clock.body.positions[2], clock.body.positions[3]));
  }
  assert.ok(Math.abs(clock.meter.limit - 2 / Math.sqrt(1e6)) < 1e-6);
  assert.ok(farthest > 50 && farthest < 61, String(farthest));
  assert.deepEqual([...clock.body.sides.springs], [1]);
});

test("masses that are held have no energy of height", () => {
  const body = new Body({ ...chain(2, 400), gravity: [0, 10], positions: [0, 50, 20, 5] });
  assert.equal(energies(body).height, -50);
});

test("a body that runs away stands, says why, and goes back to before it", () => {
  const body = new Body(chain(4, 400));
  body.velocities[7] = 30;
  const clock = new Clock(body, "symplectic_euler", 0.01);
  for (let frame = 0; frame < 60; frame++) clock.go(1 / 60, [], STILL);
  assert.ok(!clock.exploded);
  const [time, sound] = [body.time, body.positions.slice()];
  body.stiffness.fill(1e6);
  clock.changed();
  for (let frame = 0; frame < 600 && !clock.exploded; frame++) clock.go(1 / 60, [], STILL);
  assert.ok(clock.exploded);
  assert.match(clock.cause, /^The time step of 0\.01 s is above the stability limit of 0\.00\d+ s, which the linear springs set\.$/);
  assert.ok(body.positions.every(Number.isFinite));
  body.stiffness.fill(400);
  clock.goBack();
  assert.ok(!clock.exploded && body.time <= time + 0.02);
  assert.ok(body.positions.every((value, i) => Math.abs(value - sound[i]) < 60));
  for (let frame = 0; frame < 60; frame++) clock.go(1 / 60, [], STILL);
  assert.ok(!clock.exploded);
});

test("the period of a damped swing is read off, and noise has none", () => {
  const time = Array.from({ length: 600 }, (_, i) => i / 60);
  const found = swings(time, time.map((t) => 5 + 3 * Math.exp(-0.1 * t) * Math.cos((2 * Math.PI * t) / 1.4)));
  assert.ok(found && Math.abs(found.period - 1.4) < 0.005);
  assert.equal(swings(time, time.map((t) => t * t)), null);
  assert.equal(swings(time, time.map(() => 1)), null);
});

test("an angle goes on beyond half a turn while it is followed", () => {
  const body = new Body(chain(2, 400));
  const record = new Recording({ goal: null, names: ["spring0.direction", "spring0.wrapped_direction"] });
  for (let step = 0; step <= 10; step++) {
    const turn = (100 * step * Math.PI) / 180;
    body.time = step;
    [body.positions[2], body.positions[3]] = [body.positions[0] + 5 * Math.cos(turn), body.positions[1] + 5 * Math.sin(turn)];
    record.take(body, true, 0);
  }
  const [free, wrapped] = [...record.values.values()];
  assert.ok(free.every((angle, step) => Math.abs(angle - 100 * step) < 1e-9));
  assert.ok(wrapped.every((angle) => Math.abs(angle) <= 180));
});

test("a goal is reached once it has held for its seconds in one go", () => {
  const body = new Body(chain(2, 400));
  const goal = { quantity: "mass1.x", of: "value", low: 30, high: null, seconds: 1 };
  const record = new Recording({ goal, names: [] });
  const at = (time, x, runs = true) => {
    body.time = time;
    body.positions[2] = x;
    record.take(body, runs, 0);
    return record.reached;
  };
  assert.deepEqual([at(0, 31), at(0.9, 31), at(0.95, 29), at(1.2, 31), at(2, 31), at(2.1, 31, false)], Array(6).fill(false));
  assert.deepEqual([at(2.2, 40), at(3.3, 40), at(3.4, 0)], [false, true, true]);
});
