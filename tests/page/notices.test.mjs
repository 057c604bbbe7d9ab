// How long a notice of the server stays.
import assert from "node:assert/strict";
import { test } from "node:test";
import { pass } from "./page.mjs";
import { receive } from "../../app/wire/channel.js";
import { takeNotices } from "../../app/ui/gui/notices.js";

takeNotices();
const show = (title, seconds) =>
  receive({ type: "NotificationShowMessage", uuid: title, props: { title, body: "", color: "red", auto_close_seconds: seconds } });
const said = () => document.querySelector(".softrod-tell").textContent;
const shown = () => document.querySelectorAll(".softrod-notice-title").map((title) => title.textContent);

test("a notice goes after its time, one with none only when its subject is over", () => {
  show("A", 10);
  show("B", null);
  pass(9990);
  assert.deepEqual(shown(), ["A", "B"]);
  pass(20);
  assert.deepEqual(shown(), ["B"]);
  pass(600e3);
  assert.equal(said(), "B. ", "and is not taken away with another one");
  receive({ type: "RemoveNotificationMessage", uuid: "B" });
  assert.deepEqual(shown(), []);
  assert.equal(said(), "", "nor is it read any more");
});

test("a notice stays while the focus is on it", () => {
  show("A", 10);
  document.querySelector(".softrod-notice .softrod-close").focus();
  for (let i = 0; i < 7; i += 1) pass(5e3);
  document.body.focus();
  pass(4990);
  assert.deepEqual(shown(), ["A"]);
  pass(20);
  assert.deepEqual(shown(), []);
});
