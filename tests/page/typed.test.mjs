// What somebody typed keeps its own direction, also in a page from left to right, where words isolate nothing themselves.
import assert from "node:assert/strict";
import { test } from "node:test";
import "./page.mjs";
import { present } from "../../app/features/classroom/present.js";

const LINE = "طاقة!";
const desk = {
  seats: [{ number: 1, name: "Red fox", color: "#f00", here: true, done: [] }],
  answers: [{ id: "a", seat: 1, kind: "line", text: LINE, choice: -1, late: false, doubt: "", starred: false, places: [] }],
  asking: { phase: "explain", question: "", choices: [], predict: 0 },
  bars: [], right: -1, on_wall: "", doing: {}, home: false,
};

test("a pupil's line is isolated among the words of the teacher's page", () => {
  const [list] = present(desk);
  assert.equal(list.querySelector("li span").textContent, `Red fox: \u2068${LINE}\u2069`);
});
