// @ts-check
/** What is found by its name, and which of it was searched for. */
import assert from "node:assert/strict";
import { folded } from "../../app/words/words.js";
import test from "node:test";
import { matching, partsOf } from "../../app/ui/gui/finder.js";

test("all words must be in a name, and names that begin with the first one come first", () => {
  const entries = ["Make it stiffer", "Stiff rod", "Bending stiffness", "Jelly"].map((name) => ({ name }));
  assert.deepEqual(matching(entries, "stiff").map(({ name }) => name), ["Stiff rod", "Make it stiffer", "Bending stiffness"]);
  assert.deepEqual(matching(entries, "ness bend").map(({ name }) => name), ["Bending stiffness"]);
});

test("what has a word only in its description or among its choices comes last, from the beginning of a word on", () => {
  const entries = [
    { name: "Masses touch", also: "as points as balls Whether they bounce off each other" },
    { name: "Buggy", also: "A car with two motors." },
    { name: "Cart", also: "" },
    { name: "Girder", also: "What scares engineers" },
  ];
  assert.deepEqual(matching(entries, "car").map(({ name }) => name), ["Cart", "Buggy"]);
  assert.deepEqual(matching(entries, "touch bounce").map(({ name }) => name), ["Masses touch"]);
  assert.deepEqual(matching(entries, "anchor"), []);
});

test("what was searched for is every second part, in the letters of the name", () => {
  assert.deepEqual(partsOf("Bending stiffness", "STIFF"), ["Bending ", "stiff", "ness"]);
  assert.deepEqual(partsOf("Bending stiffness", "st bend"), ["", "Bend", "ing ", "st", "iffness"]);
  assert.deepEqual(partsOf("stst", "st sts"), ["", "sts", "t"]);
  assert.deepEqual(partsOf("Jelly", ""), ["Jelly"]);
});

test("accents and capitals do not matter", () => {
  assert.equal(folded("Énergie Ångström l’été"), "energie angstrom l'ete");
  assert.equal(folded("ﬀ ß 🙂").length, "ﬀ ß 🙂".length);
});
