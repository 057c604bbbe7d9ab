// What a game does with a body of the program in JavaScript. `tests/app/test_export_body.py` has what comes of it.
import assert from "node:assert/strict";
import { test } from "node:test";
import { SoftBody } from "../../app/export/live/static/game.js";

/** A mass that hangs on another one by a spring. */
const pendulum = (more = {}) => ({
  time: 0, law: "tutorial", gravity: [0, 900], down: 1, airFriction: 0, wind: [0, 0], waves: [], softening: 0,
  positions: [0, 0, 30, 40], velocities: [0, 0, 0, 0], mass: [1, 2], held: [1, 0], loads: [], circles: [],
  ends: [0, 1], stiffness: [5000], damping: [1], restLength: [50],
  joints: [], jointStiffness: [], jointDamping: [], restAngle: [], broken: [], walls: [], fillings: [],
  contact: null, limits: null, yielded: null, ...more,
});

test("time goes on by whole steps, and the rest is kept", () => {
  const body = new SoftBody(pendulum(), 0.01);
  for (let frame = 0; frame < 60; frame++) assert.ok(body.advance(1 / 60));
  assert.ok(Math.abs(body.time - 1) < 1e-9);
  assert.ok(body.advance(0.004));
  assert.ok(Math.abs(body.time - 1) < 1e-9);
  assert.ok(body.advance(0.006));
  assert.ok(Math.abs(body.time - 1.01) < 1e-9);
});

test("a free mass that is dragged is there, stays, and falls when it is let go", () => {
  const body = new SoftBody(pendulum(), 0.01);
  body.drag(1, 90, -20);
  body.advance(1 / 60);
  assert.deepEqual([...body.positions.slice(2)], [90, -20]);
  body.advance(1, 1);
  assert.deepEqual([...body.positions.slice(2)], [90, -20]);
  body.release(1);
  body.step();
  assert.notEqual(body.positions[3], -20);
});

test("the data of a body stay as they are", () => {
  const data = pendulum();
  const body = new SoftBody(data, 0.01);
  body.push(1, 3, 4);
  body.hold(1);
  body.stretch(2);
  body.advance(1, 1);
  assert.deepEqual(data, pendulum());
});

test("a body that loses nothing keeps its energy by velocity Verlet", () => {
  const body = new SoftBody(pendulum({ damping: [0] }), 0.001);
  body.method = "verlet";
  const sum = () => Object.values(body.energy()).reduce((total, part) => total + part, 0);
  const before = sum();
  body.advance(2, 2);
  assert.ok(Math.abs(sum() - before) < 1, `${sum() - before}`);
  assert.ok(body.energy().kinetic > 100);
});

test("a spring that is pulled too hard breaks, and the body falls", () => {
  const limits = { strength: [9000], yieldForce: [1e300], hardening: [0], yieldTorque: [] };
  const body = new SoftBody(pendulum({ limits }), 0.001);
  body.advance(0.5, 1);
  assert.equal(body.broken[0], 0);
  body.push(1, 0, 20000);
  body.advance(0.5, 1);
  assert.equal(body.broken[0], 1);
  assert.ok(body.positions[3] > 500);
});

test("what is cut holds nothing, and what it held in is out", () => {
  const loop = { masses: [0, 1, 2], isGas: true, strength: 9000, outside: 0, area: 600 };
  const body = new SoftBody(pendulum({
    positions: [0, 0, 30, 0, 0, 40], velocities: [0, 0, 0, 0, 0, 0], mass: [1, 1, 1], held: [1, 0, 0], fillings: [loop],
    ends: [0, 1, 1, 2, 2, 0], stiffness: [5000, 5000, 5000], damping: [1, 1, 1], restLength: [30, 50, 40],
  }), 0.001);
  body.cut(0);
  body.cut(1);
  assert.equal(body.fillings.length, 0);
  body.advance(1, 1);
  assert.equal(body.positions[2], 30);
  assert.ok(Math.abs(body.positions[3] - 450) < 1, `${body.positions[3]}`);
});

test("it says when a body has run away", () => {
  const body = new SoftBody(pendulum(), 0.1);
  assert.equal(body.advance(100, 100), false);
});

test("what is wrong is refused by name, and nothing happens", () => {
  const body = new SoftBody(pendulum(), 0.01);
  for (const [wrong, said] of [
    [() => body.drag(2, 0, 0), "drag: there is no mass 2, but 0 to 1"],
    [() => body.hold(0.5), "hold: there is no mass 0.5, but 0 to 1"],
    [() => body.cut(1), "cut: there is no spring 1, but 0 to 0"],
    [() => body.push(1, NaN, 0), "push: NaN is not a finite number"],
    [() => body.advance(Infinity), "advance: Infinity is not a finite number"],
    [() => body.stretch(0), "stretch: 0 is not greater than 0"],
    [() => body.bend(NaN), "bend: NaN is not a finite number"],
  ]) assert.throws(wrong, new RangeError(said));
  assert.deepEqual([...body.positions], [0, 0, 30, 40]);
});

const FLOOR = [0, 100, 0, -1, 8000, 0.5, 10, 0.0004, 0, 0, 0, 0];

test("what is shown goes on evenly where steps do not", () => {
  const body = new SoftBody(pendulum({ gravity: [0, 0], held: [0, 0], velocities: [60, 0, 60, 0] }), 0.01);
  const seen = [];
  for (let frame = 1; frame <= 30; frame++) {
    body.advance(1 / 144);
    seen.push(body.shown()[0]);
  }
  // Beside what is drawn, positions stand still in some frames and go a whole step in others.
  const ways = seen.slice(3).map((x, i) => x - seen[i + 2]);
  for (const way of ways) assert.ok(Math.abs(way - 60 / 144) < 1e-9, `${way}`);
  assert.ok(body.alpha >= 0 && body.alpha < 1);
  const into = new Float64Array(4);
  assert.equal(body.shown(into), into);
  assert.equal(into[0], seen.at(-1));
});

test("after a long pause a body goes on, and does not catch up", () => {
  const body = new SoftBody(pendulum(), 0.01);
  body.advance(3600);
  assert.ok(Math.abs(body.time - 0.25) < 1e-9);
  body.advance(1, 1);
  assert.ok(Math.abs(body.time - 1.25) < 1e-9);
});

test("something is done before each step", () => {
  const body = new SoftBody(pendulum(), 0.01);
  const plain = new SoftBody(pendulum(), 0.01);
  const times = [];
  body.beforeStep = (own) => times.push(own.time);
  body.advance(0.05);
  plain.advance(0.05);
  assert.deepEqual(times.map((time) => Math.round(100 * time)), [0, 1, 2, 3, 4]);
  assert.deepEqual([...body.positions], [...plain.positions]);
});

test("a body begins anew, with the arrays that it had", () => {
  const body = new SoftBody(pendulum({ walls: [FLOOR] }), 0.01);
  const { positions } = body;
  body.gravity = [0, 0];
  body.push(1, 3, 4);
  body.stretch(2);
  body.drag(1, 5, 5);
  body.setWall(0, { y: 70 });
  body.advance(0.2);
  body.cut(0);
  body.reset();
  assert.equal(body.positions, positions);
  const fresh = new SoftBody(pendulum({ walls: [FLOOR] }), 0.01);
  body.advance(0.2);
  fresh.advance(0.2);
  assert.deepEqual([...body.positions], [...fresh.positions]);
});

test("what makes no sense is refused", () => {
  const body = new SoftBody(pendulum(), 0.01);
  assert.throws(() => body.release(9), /there is no mass 9/);
  assert.throws(() => body.advance(-1), /-1 s is below 0/);
  // @ts-expect-error: which an editor says, too
  body.method = "rk4";
  assert.throws(() => body.step(), /no method rk4, but symplectic_euler and verlet/);
});

test("a clone goes its own way from the same state", () => {
  const body = new SoftBody(pendulum({ walls: [FLOOR] }), 0.01);
  body.push(1, 3, 4);
  body.advance(0.123);
  const other = body.clone();
  body.advance(0.2);
  const here = [...body.positions];
  other.advance(0.2);
  assert.deepEqual([...other.positions], here);
  other.impulse(1, 100, 0);
  other.advance(0.1);
  assert.deepEqual([...body.positions], here);
});

test("a blow changes a velocity at once, by the mass", () => {
  const body = new SoftBody(pendulum(), 0.01);
  body.impulse(1, 30, -10);
  assert.deepEqual([...body.velocities.slice(2)], [15, -5]);
  body.impulse(0, 30, 0); // which is held
  assert.equal(body.velocities[0], 0);
  assert.throws(() => body.impulse(2, 1, 1), /there is no mass 2, but 0 to 1/);
});

test("a wall is read by names and is moved", () => {
  const body = new SoftBody(pendulum({ walls: [FLOOR] }), 0.001);
  assert.deepEqual(body.wall(0), { x: 0, y: 100, nx: 0, ny: -1, hardness: 8000, friction: 0.5, slipSpeed: 10 });
  body.hold(0, false);
  for (let frame = 0; frame < 240; frame++) body.advance(1 / 60);
  assert.ok(Math.abs(body.positions[3] - 100) < 1, `${body.positions[3]}`);
  for (let y = 100; y > 60; y -= 1) {
    body.setWall(0, { y, ny: -3 });
    for (let frame = 0; frame < 6; frame++) body.advance(1 / 60);
  }
  assert.ok(Math.abs(body.positions[3] - 61) < 1, `${body.positions[3]}`);
  assert.equal(body.wall(0).ny, -1);
  assert.throws(() => body.setWall(0, { nx: 0, ny: 0 }), /has no direction/);
  // @ts-expect-error: which an editor says, too
  assert.throws(() => body.setWall(0, { bounciness: 0.1 }), /there is no bounciness, but x, y, nx/);
  assert.throws(() => body.wall(1), /there is no wall 1, but 0 to 0/);
});
