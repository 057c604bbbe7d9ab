// Who is ahead in a race, who has won, and when it is over.
import assert from "node:assert/strict";
import test from "node:test";
import { become } from "./page.mjs";
import { isOver, verdict } from "../../app/features/race/race.js";

become({ unit: "px" });
const race = (more) => ({ tell: "race", names: ["Worm", "Walker"], ways: [120, -80], arrivals: [null, null], out: "", ...more });

test("on the way it says who is ahead, in either direction", () => {
  assert.equal(verdict(race({})), "Worm is ahead by 40 px");
  assert.equal(verdict(race({ ways: [10, -80] })), "Walker is ahead by 70 px");
  assert.equal(verdict(race({ ways: [80, -80.2] })), "Neither is ahead");
  assert.ok(!isOver(race({})));
});

test("at the finish it says who was first and by how much", () => {
  assert.equal(verdict(race({ arrivals: [4.25, null] })), "Worm is there, after 4.3 s");
  assert.ok(!isOver(race({ arrivals: [4.25, null] })));
  assert.equal(verdict(race({ arrivals: [4.25, 3.81] })), "Walker was first, by 0.4 s");
  assert.equal(verdict(race({ arrivals: [4.25, 4.27] })), "Both at once, after 4.3 s");
  assert.ok(isOver(race({ arrivals: [4.25, 3.81] })));
});

test("a race against a body that is out is won at the finish", () => {
  const out = race({ arrivals: [4.25, null], out: "it exploded" });
  assert.equal(verdict(out), "Worm has won: Walker is out, it exploded");
  assert.ok(isOver(out));
  assert.equal(verdict(race({ out: "it exploded" })), "Walker is out: it exploded");
});

test("of two bodies with one name the other is told apart", () => {
  assert.equal(verdict(race({ names: ["Worm", "Worm"], arrivals: [5, 4] })), "Worm (the other) was first, by 1.0 s");
});
