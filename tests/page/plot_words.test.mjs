// Plots in words: a sentence about a curve.
import assert from "node:assert/strict";
import test from "node:test";
import "./page.mjs";
import { sentenceOf, told } from "../../app/ui/plot_words.js";

const time = { label: "time, s", values: [0, 1, 2, 3], isTime: true };

test("a curve is said by its value now and by its range, without what is missing", () => {
  const said = sentenceOf({ label: "mass1.y, px", values: [null, 5, -2, 3.00004] }, time);
  assert.equal(said, "mass1.y, px: now 3; lowest −2 at 2 s, highest 5 at 1 s.");
  assert.equal(sentenceOf({ label: "mass1.y, px", values: [4, 4, 4 + 1e-9, NaN] }, time), "mass1.y, px: 4 all the time.");
  assert.equal(sentenceOf({ label: "mass1.y, px", values: [null, NaN] }, time), "mass1.y, px: no values yet.");
});

test("over another quantity its range is said by that", () => {
  const along = { label: "spring0.length, px", values: [10, 20, 30], isTime: false };
  const said = sentenceOf({ label: "spring0.force, N", values: [1, 3, 2] }, along);
  assert.equal(said, "spring0.force, N: now 2; lowest 1 where spring0.length, px is 10, highest 3 where it is 20.");
});

test("numbers are said with four digits", () => {
  assert.deepEqual([told(1 / 3), told(-12345), told(2e-7)], ["0.3333", "−12350", "2e−7"]);
});
