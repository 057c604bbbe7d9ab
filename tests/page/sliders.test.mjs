// A slider of a live file or of a pupil's page: a finger that scrolls the page sets nothing.
import assert from "node:assert/strict";
import { test } from "node:test";
import { point } from "./page.mjs";
import { settingRow } from "../../app/export/live/static/sliders.js";

const SETTING = { key: "gravity", label: "g", low: 0, high: 4000, value: 2000, unit: "px/s²", logarithmic: false };

/** A slider that is pressed and moved to its beginning, and the values that it has set. */
function slid(pointerType) {
  const set = [];
  const row = settingRow(SETTING, (value) => set.push(value));
  const input = row.querySelector("input");
  point("down", { x: 0, y: 0 }, { on: input, pointerType });
  input.value = "0";
  input.dispatchEvent(new Event("input"));
  return { row, input, set };
}

test("a finger that the browser takes for a scroll puts the value back", () => {
  const { row, input, set } = slid("touch");
  point("cancel", { x: 0, y: 0 }, { on: input, pointerType: "touch" });
  assert.deepEqual(set, [0, 2000]);
  assert.equal(row.querySelector("output").textContent, "2000 px/s²");
  assert.equal(input.value, "500");
});

test("a finger that slides and is lifted sets it, and so does a mouse whatever becomes of it", () => {
  for (const kind of ["touch", "mouse"]) {
    const { input, set } = slid(kind);
    point(kind === "touch" ? "up" : "cancel", { x: 0, y: 0 }, { on: input, pointerType: kind });
    assert.deepEqual(set, [0]);
  }
});
