// What is loaded once a message asks for it: it hears the last ones from before, and a load that fails is tried again.
import assert from "node:assert/strict";
import { test } from "node:test";
import { tell } from "./page.mjs";
import { hearLater } from "../../app/wire/later.js";

const settled = () => new Promise(setImmediate);

test("it is loaded at the first message that asks for it, and hears all that matters from before", async () => {
  const heard = [];
  let loads = 0;
  const load = async () => {
    loads += 1;
    if (loads === 1) throw new Error("no network");
    return ({ tell: kind, text }) => heard.push(`${kind} ${text}`);
  };
  hearLater(["described", "remark"], ({ text }) => text.includes("!"), load);
  for (const [kind, text] of [["described", "a"], ["remark", "b"], ["described", "c"]]) tell(kind, { text });
  await settled();
  assert.equal(loads, 0, "nobody asked");
  tell("remark", { text: "d!" });
  await settled();
  assert.deepEqual([loads, heard], [1, []], "it did not arrive");
  tell("remark", { text: "e!" });
  tell("described", { text: "f" });
  await settled();
  assert.deepEqual([loads, heard], [2, ["remark e!", "described f"]]);
  tell("remark", { text: "g" });
  assert.deepEqual(heard.at(-1), "remark g", "at once from then on");
});

test("a fault with one message is reported, and no other is lost for it", async () => {
  const heard = [];
  const faults = [];
  const reporters = process.listeners("unhandledRejection");
  process.removeAllListeners("unhandledRejection");
  process.on("unhandledRejection", (error) => faults.push(error.message));
  hearLater(["described", "remark"], ({ text }) => text.includes("!"), async () => ({ text }) => {
    heard.push(text);
    if (text === "a") throw new Error("a fault");
  });
  tell("described", { text: "a" });
  tell("remark", { text: "b!" });
  await settled();
  tell("remark", { text: "c" });
  await settled();
  process.removeAllListeners("unhandledRejection");
  for (const report of reporters) process.on("unhandledRejection", report);
  assert.deepEqual([heard, faults], [["a", "b!", "c"], ["a fault"]]);
});
