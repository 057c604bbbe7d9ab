import assert from "node:assert/strict";
import { test } from "node:test";
import { arrived, isFound, meant } from "../../app/features/gallery/finding.js";
import { caution, isOwnMachine } from "../../app/features/files/share.js";

// Two rows of three, and a last one of one.
const PLACES = [0, 1, 2, 3, 4, 5, 6].map((i) => ({ x: 100 * (i % 3), y: 80 * Math.floor(i / 3) }));

test("arrows go from card to card", () => {
  assert.equal(arrived("ArrowRight", 2, PLACES), 3);
  assert.equal(arrived("ArrowLeft", 3, PLACES), 2);
  assert.equal(arrived("ArrowLeft", 0, PLACES), 0);
  assert.equal(arrived("ArrowRight", 6, PLACES), 6);
  assert.equal(arrived("ArrowDown", 1, PLACES), 4);
  assert.equal(arrived("ArrowDown", 5, PLACES), 6);
  assert.equal(arrived("ArrowDown", 6, PLACES), 6);
  assert.equal(arrived("ArrowUp", 6, PLACES), 3);
  assert.equal(arrived("ArrowUp", 1, PLACES), 1);
  assert.equal(arrived("Home", 4, PLACES), 0);
  assert.equal(arrived("End", 0, PLACES), 6);
});

test("every word of a search is found somewhere", () => {
  const entry = { name: "flag-pole", title: "Flag and pole", line: "", text: "A flag in the Wind.", group: "Surroundings", own: false };
  for (const wanted of ["", "flag", "WIND flag", "surr", "pole-", " "]) assert.equal(isFound(entry, wanted), wanted !== "pole-");
  assert.ok(!isFound(entry, "flag water"));
});

test("the scene whose title is what was typed is meant, or else one whose title begins so", () => {
  const found = [["lesson-resonance", "Resonance of a pendulum"], ["pendulum-two", "Pendulum of two"], ["pendulum", "Pendulum"]].map(([name, title]) => ({ name, title }));
  assert.equal(meant(found, " pendulum "), "pendulum");
  assert.equal(meant(found, "PEND"), "pendulum-two");
  assert.equal(meant(found, "of"), "lesson-resonance");
  assert.equal(meant(found, ""), "lesson-resonance");
  assert.equal(meant([], "of"), undefined);
});

test("long links are warned of", () => {
  assert.equal(caution("x".repeat(2000)), "");
  assert.match(caution("x".repeat(2001)), /2,001 characters: some e-mail/);
  assert.match(caution("x".repeat(8001)), /8,001 characters: many messengers/);
  for (const host of ["127.0.0.1", "localhost", "[::1]", "127.8.8.8"]) assert.ok(isOwnMachine(host));
  for (const host of ["192.168.1.7", "localhost.evil.example", "school.example"]) assert.ok(!isOwnMachine(host));
});
