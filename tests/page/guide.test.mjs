// @ts-check
/** What a teacher says in each phase, and that nothing of it tells too early what is right. */
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import test from "node:test";
import { guide, partsOf, sentencesOf } from "../../app/features/classroom/guide.js";

const LESSONS = new URL("../../presets/lessons/", import.meta.url);
const PHASES = /** @type {const} */ (["lobby", "show", "ask", "results", "run", "reveal", "explain", "try", "collect"]);

/** @param {Partial<import("../../app/features/classroom/guide.js").Asking>} more */
const asking = (more) => ({ stop: 0, phase: /** @type {const} */ ("ask"), round: 0, title: "", do: "", watch: "", question: "", choices: [], right: -1, because: "", predict: 0, masses: [], goal: "", collects: "", runs: "", ...more });

test("a question is what is so, then what is asked", () => {
  assert.deepEqual(partsOf("Gravity pulls it 0.5 px down. How far, if it is doubled?"), { given: "Gravity pulls it 0.5 px down.", asked: "How far, if it is doubled?" });
  assert.deepEqual(partsOf("Which way?"), { given: "", asked: "Which way?" });
  assert.deepEqual(partsOf(""), { given: "", asked: "" });
  assert.deepEqual(partsOf("ضوعفت الجاذبية. أي منحنى هو؟"), { given: "ضوعفت الجاذبية.", asked: "أي منحنى هو؟" });
  assert.deepEqual(sentencesOf("كم؟ ولماذا؟"), ["كم؟", "ولماذا؟"]);
  assert.deepEqual(sentencesOf("By 1.41 times. Or 2"), ["By 1.41 times.", "Or 2"]);
});

test("of every shipped step something is said and done in each phase, and why it is right is told once each has written a line, not before", () => {
  const files = readdirSync(LESSONS).filter((name) => name.endsWith(".json"));
  assert.ok(files.length >= 12);
  for (const file of files) {
    for (const step of JSON.parse(readFileSync(new URL(file, LESSONS), "utf8")).lesson.steps) {
      const { question } = step;
      const words = { question: question?.text ?? "", because: question?.because ?? "", do: step.do, watch: step.watch ?? "" };
      for (const phase of PHASES) {
        if (!question && ["ask", "results", "run", "reveal", "explain"].includes(phase)) continue; // a class does not come there
        for (const round of phase === "ask" || phase === "results" ? [0, 1] : [0]) {
          const { say, do: task } = guide(asking({ ...words, phase, round }));
          assert.ok(say && task, `${file}, ${step.title}, ${phase}`);
          const tells = question && `${say} ${task}`.includes(question.because);
          assert.equal(Boolean(tells), Boolean(question) && phase === "explain", `${file}, ${step.title}, ${phase}`);
        }
      }
    }
  }
});

test("who is to drag a prediction is told so, and where the run stands", () => {
  assert.match(guide(asking({ question: "It falls. Where will it be?", predict: 1.5 })).say, /^Where will it be\? Drag the pale body .* 1\.5 s after the start\.$/);
  assert.match(guide(asking({ phase: "run", predict: 1.5 })).do, /stops at 1\.5 s/);
  assert.equal(guide(asking({ phase: "collect", collects: "period of mass1.y" })).say, "Hand in the period of mass1.y.");
});
