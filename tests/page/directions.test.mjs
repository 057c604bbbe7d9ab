// Numbers keep their direction in a page from right to left.
import assert from "node:assert/strict";
import { test } from "node:test";
import "./page.mjs";

globalThis.softrodWords = { language: "ar", direction: "rtl", text: "" };
const { settingRow } = await import("../../app/export/live/static/sliders.js");

test("a slider's number stands before its unit", () => {
  const setting = { key: "gravity", label: "g", low: 0, high: 4000, value: 2000, unit: "px/s²", logarithmic: false };
  const row = settingRow(setting, () => {});
  assert.equal(row.querySelector("output").textContent, "\u20662000 px/s²\u2069");
});
