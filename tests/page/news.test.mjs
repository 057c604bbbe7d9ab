// What happens to a body, said in few words and not too often.
import assert from "node:assert/strict";
import { test } from "node:test";
import { APART, GATHER, News } from "../../app/features/describe/news.js";

/** What is said of events by their times, ms, and when. */
function spoken(events, until = 20000) {
  const news = new News();
  const said = [];
  for (let now = 0; now <= until; now += 50) {
    for (const [at, event] of events) if (at === now) news.hear(event, now);
    const text = news.take(now);
    if (text) said.push([now, text]);
  }
  return said;
}

test("several of a kind are one sentence with their number", () => {
  const broke = { what: "broke", count: 1 };
  assert.deepEqual(spoken([[0, broke], [50, broke], [100, { what: "broke", count: 2 }]]), [[GATHER, "4 springs broke."]]);
  assert.deepEqual(spoken([[0, broke]]), [[GATHER, "One spring broke."]]);
});

test("there is one sentence in two seconds at most, and it is of the newest", () => {
  const events = [];
  for (let at = 0; at < 10000; at += 200) events.push([at, { what: at % 400 ? "dropped" : "grabbed", mass: at / 200 }]);
  const said = spoken(events);
  assert.ok(said.length >= 4);
  for (let i = 1; i < said.length; i += 1) assert.ok(said[i][0] - said[i - 1][0] >= APART);
  assert.equal(said.at(-1)[1], "Mass 49 is let go.");
});

test("what weighs more is not lost behind what comes next", () => {
  assert.deepEqual(spoken([[0, { what: "exploded" }], [50, { what: "paused" }]]).map(([, text]) => text), ["The body exploded and is stopped."]);
  assert.deepEqual(spoken([[0, { what: "running" }], [50, { what: "step", at: 1, title: "Pull" }]]).map(([, text]) => text), ["Step 2: Pull"]);
  assert.deepEqual(spoken([[0, { what: "touched", by: "floor" }], [100, { what: "rest" }]]).map(([, text]) => text), ["The body has come to rest."]);
  const texts = [{ what: "touched", by: "floor" }, { what: "touched", by: "wall" }, { what: "touched", by: "body" }, { what: "running" }, { what: "paused" }];
  assert.equal(new Set(texts.map((event) => spoken([[0, event]])[0][1])).size, texts.length);
});
