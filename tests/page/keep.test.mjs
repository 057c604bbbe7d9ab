// What the page keeps for a reload, and when a new connection is given it.
import assert from "node:assert/strict";
import { inflateSync } from "node:zlib";
import { test } from "node:test";
import { become, heard, tell } from "./page.mjs";

sessionStorage.setItem("softrod", "before");
const { hasKept, keepOnlyOf, lost, resume } = await import("../../app/ui/kept/keep.js");
const kept = () => sessionStorage.getItem("softrod");
let begun = 0;
resume(() => (begun += 1));
/** What the server is given by connections of these names, once the last one has begun. */
async function given(...pages) {
  const before = begun;
  for (const page of pages) become({ page });
  for (let tries = 0; begun === before && tries < 1e5; tries++) await new Promise(setImmediate);
  assert.equal(begun, before + 1);
  return heard().map(({ kind, letters }) => [kind, inflateSync(Buffer.from(letters, "base64")).toString()]);
}

test("what is kept is given to a connection, and is not lost before the server has it", async () => {
  const gives = given("b");
  tell("keepsake", { kept: "the server's new body" });
  assert.deepEqual([await gives, kept(), hasKept()], [[["resume", "before"]], "before", true]);
  tell("resumed");
  tell("keepsake", { kept: "what comes after it" });
  become({ playing: true });
  assert.deepEqual([kept(), hasKept(), begun], ["what comes after it", false, 1], "the same connection begins once");
});

test("a lost connection's work is given to the next one alone", async () => {
  lost();
  assert.deepEqual(await given("", "c", "d"), [["resume", "what comes after it"]]);
});

test("of another scene than the one that is asked for nothing is kept", () => {
  keepOnlyOf("scene=ring");
  assert.deepEqual([kept(), hasKept()], ["", false]);
  tell("keepsake", { kept: "a ring" });
  keepOnlyOf("scene=ring");
  assert.equal(kept(), "a ring");
  keepOnlyOf("");
  assert.equal(kept(), "a ring");
});
