// One run through a lesson, as the page and live files have it.
import assert from "node:assert/strict";
import { test } from "node:test";
import "./page.mjs";
import { LessonRun } from "../../app/features/lesson/run.js";

const QUESTION = { text: "Which?", choices: ["one", "two"], answer: 1, because: "so" };
const blank = () => ({ choice: null, known: false, places: null, line: "" });

/** A run, and what it had its host do. @param {object[]} steps */
function runOf(...steps) {
  const done = [];
  const run = new LessonRun(document.createElement("section"), steps, 0, steps.map(blank), {
    blank,
    begin: (waits) => done.push(waits ? "waits" : "runs"),
    run: () => done.push("run"),
    store: (isAnswer) => done.push(isAnswer ? "answer" : "step"),
  });
  return { run, since: () => done.splice(0) };
}
const step = (more) => ({ title: "", do: "", watch: "", question: null, ...more });

test("a body waits for an answer, and another choice does not start it again", () => {
  const { run, since } = runOf(step({ question: QUESTION }), step({}));
  run.begin();
  assert.deepEqual(since(), ["waits"]);
  run.answer(0);
  assert.deepEqual(since(), ["answer", "run"]);
  run.answer(1);
  assert.deepEqual(since(), ["answer"]);
  run.reveal();
  assert.deepEqual([run.present.choice, run.present.known], [1, true]);
  run.enter(1);
  assert.deepEqual(since(), ["answer", "step", "runs"]);
});

test("a body waits for a prediction as well", () => {
  const { run, since } = runOf(step({ question: QUESTION, predict: 2 }));
  run.answer(1);
  assert.deepEqual([run.waits, since()], [true, ["answer"]]);
  run.present.places = [[0, 0]];
  assert.ok(!run.waits && !run.isToPredict);
});

test("a step begins again without its answers, and a lesson without anything", () => {
  const { run, since } = runOf(step({ question: QUESTION }), step({}));
  run.answer(1);
  run.present.line = "because";
  since();
  run.again();
  assert.deepEqual([run.present, since()], [{ ...blank(), line: "because" }, ["answer", "step", "waits"]]);
  run.enter(1);
  run.startOver();
  assert.deepEqual([run.at, run.given], [0, [blank(), blank()]]);
});
