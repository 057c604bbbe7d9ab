import assert from "node:assert/strict";
import test from "node:test";
import { plainText, readNumber, whyNot } from "../../app/ui/gui/numbers.js";
import { tied } from "../../app/words/words.js";

const READ = {
  "9.81": 9.81, "9,81": 9.81, " -350 ": -350, "\u2212350": -350, "+7": 7, ".5": 0.5, ",5": 0.5, "5.": 5,
  "2e4": 20000, "2E+4": 20000, "1,5e-3": 0.0015, "1e-12": 1e-12,
  "1,234.5": 1234.5, "1.234,5": 1234.5, "1,234,567": 1234567, "1.234.567": 1234567, "1.234.567,8": 1234567.8,
  "1 234,5": 1234.5, "1\u202f234\u202f567": 1234567, "1'234.5": 1234.5, "0,125": 0.125, "1234,567": 1234.567,
  "1.234": 1.234, "2.50": 2.5, "0.500": 0.5, "2.0": 2,
};

test("a number and its unit stay on one line", () => {
  assert.equal(tied("at 2000 px/s² for 4 s, 12,5 % of 3 masses"), "at 2000\u00a0px/s² for 4\u00a0s, 12,5\u00a0% of 3 masses");
});

test("numbers are read with a decimal point or comma, an exponent, and groups of three digits", () => {
  for (const [text, number] of Object.entries(READ)) assert.equal(readNumber(text), number, text);
});

test("what is no number is not read, nor what may be two", () => {
  const bad = ["", " ", "-", "e4", "2e", "1.2.3", "1,23,456.7", "1.2,3.4", "12 34", "2x4", "1e999", "NaN", "Infinity", "0x10", "1,234", "-20,000", "12,34,5", "2.000", "-1.500"];
  for (const text of bad) assert.ok(Number.isNaN(readNumber(text)), text);
});

test("of two numbers that may be meant, both are said", () => {
  const range = { low: null, high: null, unit: "" };
  assert.equal(whyNot("2.000", range), "2.000 could be 2 or 2000. Write one of these.");
  assert.equal(whyNot("1,234", range), "1,234 could be 1.234 or 1234. Write one of these.");
  assert.equal(whyNot("-1.500", range), "-1.500 could be -1.5 or -1500. Write one of these.");
});

test("a box gets no exponent, and all digits", () => {
  assert.equal(plainText(1e-12), "0.000000000001");
  assert.equal(plainText(2.5e21), "2500000000000000000000");
  assert.equal(plainText(-0.1), "-0.1");
  assert.equal(plainText(1234.5678901234), "1234.5678901234");
});
