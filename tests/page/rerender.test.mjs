// A card is remade after a press on it, however late the click of that press comes.
import assert from "node:assert/strict";
import { mock, test } from "node:test";
import { deferWhilePressed } from "../../app/features/classroom/rerender.js";

/** A card, its window, and what has become of the card so far. */
function opened(t) {
  mock.timers.enable({ apis: ["setTimeout"] });
  t.after(() => mock.timers.reset());
  const window = Object.assign(new EventTarget(), { setTimeout });
  globalThis.window = window;
  const card = new EventTarget();
  const anew = deferWhilePressed(card);
  const made = [];
  return {
    made,
    tell: (what) => anew(() => made.push(what)),
    press: () => card.dispatchEvent(new Event("pointerdown")),
    release: () => window.dispatchEvent(new Event("pointerup")),
    click: () => card.dispatchEvent(new Event("click")),
  };
}

test("without a press it is remade at once", (t) => {
  const { made, tell } = opened(t);
  tell("one");
  assert.deepEqual(made, ["one"]);
});

test("a click that comes late still finds its button, and then the last of what was told is shown", (t) => {
  const { made, tell, press, release, click } = opened(t);
  press();
  tell("one");
  release();
  mock.timers.tick(500);
  tell("two");
  assert.deepEqual(made, []);
  click();
  assert.deepEqual(made, [], "all hear of the click first");
  mock.timers.tick(1);
  assert.deepEqual(made, ["two"]);
});

test("a second press is waited for like the first", (t) => {
  const { made, tell, press, release } = opened(t);
  press();
  release();
  press();
  tell("one");
  mock.timers.tick(5000);
  assert.deepEqual(made, []);
});

test("a press that becomes no click holds nothing up for long", (t) => {
  const { made, tell, press, release } = opened(t);
  press();
  tell("one");
  release();
  mock.timers.tick(1000);
  assert.deepEqual(made, ["one"]);
});
