// Mice, pens and fingers that take hold of masses, and what of it viser's camera hears.
import assert from "node:assert/strict";
import { beforeEach, test } from "node:test";
import { become, canvas, heard, pass, point, put, show, showAt } from "./page.mjs";
import { setAccess } from "../../app/ui/access.js";
import { change } from "../../app/features/edit/editing.js";
import { listenToEdits } from "../../app/features/edit/gestures.js";
import { listenToPointer } from "../../app/ui/hands/pointer.js";
import { listenToPresses } from "../../app/ui/hands/presses.js";
import { MISSED } from "../../app/ui/hands/take.js";

listenToPresses();
listenToEdits();
listenToPointer();
/** What came to the canvas itself, as [what, pointer]. */
let viewed = [];
for (const what of ["down", "move", "up", "cancel"]) {
  canvas.addEventListener(`pointer${what}`, ({ pointerId }) => viewed.push([what, pointerId]));
}
const PLACES = [[100, 100], [200, 100], [300, 100], [300, 300]];
const [PAPER, FAR] = [{ x: 500, y: 500 }, { x: 600, y: 400 }];
const at = (mass, x = 0, y = 0) => ({ x: PLACES[mass][0] + x, y: PLACES[mass][1] + y });
const finger = (pointerId, more = {}) => ({ pointerType: "touch", pointerId, ...more });
const PEN = { pointerType: "pen", pointerId: 9 };
/** What was said, in short: ["grab 0 3", "drop 0"], with the hand and the mass. */
const done = () => heard().map(({ do: what, hand, mass }) => [what, hand, mass].filter((part) => part !== undefined).join(" "));
/** A touch for longer than it takes two fingers to come down together. */
const rested = () => pass(400);

beforeEach(() => {
  pass(10_000);
  change({ on: false, drag: null, chain: -1 });
  become({ follow: false });
  show(PLACES, [[0, 1], [1, 2]]);
  heard();
  viewed = [];
});

test("every finger has a mass of its own, and its own hand", () => {
  for (const mass of [0, 1, 2]) point("down", at(mass), finger(mass));
  assert.deepEqual(done(), ["grab 0 0", "grab 1 1", "grab 2 2"]);
  point("move", at(0, 0, 50), finger(0));
  point("move", at(2, 30), finger(2));
  pass();
  assert.deepEqual(heard(), [{ do: "at", hands: [[0, -3, 1.5], [2, -0.7, 2]] }]);
  point("up", at(1), finger(1));
  assert.deepEqual(done(), ["drop 1", "pick 1"], "it was not moved, so it was a click");
  for (const mass of [0, 2]) point("up", at(mass), finger(mass));
  assert.deepEqual(done(), ["drop 0", "drop 2"]);
  assert.deepEqual(viewed, []);
  // There is none for a second finger on the same mass.
  for (const id of [1, 2]) point("down", at(3), finger(id));
  assert.deepEqual(done(), ["grab 0 3"]);
  for (const id of [1, 2]) point("up", at(3), finger(id));
});

test("while the clock stands still, a click leaves a mass its velocity: it is grabbed once the pointer moves", () => {
  become({ playing: false });
  point("down", at(0));
  point("move", at(0, 2));
  point("up", at(0, 2));
  assert.deepEqual(done(), ["pick 0"]);
  point("down", at(0));
  point("move", at(0, 30));
  assert.deepEqual(done(), ["grab 0 0"]);
  pass();
  assert.deepEqual(done(), ["at"]);
  point("up", at(0, 30));
  assert.deepEqual(done(), ["drop 0"]);
  become({ playing: true });
});

test("a mass is taken hold of from beside it, by a finger from farther off than by a mouse", () => {
  for (const [pointerType, x, has] of [["mouse", 11, true], ["mouse", 13, false], ["pen", 15, true], ["pen", 17, false], ["touch", 25, true], ["touch", 27, false]]) {
    point("down", at(3, x), { pointerType });
    assert.deepEqual(done(), has ? ["grab 0 3"] : [], `${pointerType} ${x} px off`);
    point("up", at(3, x), { pointerType });
    heard();
    pass(10_000);
  }
  point("down", at(3), { button: 2 });
  assert.deepEqual(done(), []);
  point("up", at(3));
  // A mouse shows that it is near enough.
  for (const [x, near] of [[11, true], [13, false]]) {
    point("move", at(3, x), { buttons: 0 });
    assert.equal(document.documentElement.hasAttribute("data-softrod-near"), near);
  }
});

test("a tap instead of a drag takes what is near, from farther off while it moves, and else finds nothing", () => {
  let misses = 0;
  document.documentElement.addEventListener(MISSED, () => (misses += 1));
  const tap = (x) => {
    point("down", at(3, x));
    point("up", at(3, x));
    return done().map((one) => one.split(" ")[0]);
  };
  setAccess({ taps: true });
  show(PLACES, [[0, 1], [1, 2]]);
  assert.deepEqual([tap(23), tap(25), misses], [["grab", "drop", "pick"], [], 1]);
  const moved = (x) => PLACES.map(([px, py], i) => [i === 3 ? px + x : px, py]);
  for (const x of [0, 10, 20, 30, 40]) showAt(moved(x));
  assert.deepEqual([tap(75), tap(130), misses], [["grab", "drop", "pick"], [], 2]);
  setAccess({ taps: false });
  assert.deepEqual([tap(23), misses], [[], 2], "without taps nobody says so");
});

test("a press on the canvas gives the keys back to the body", () => {
  put("input").focus();
  point("down", PAPER);
  assert.equal(document.activeElement, document.body);
  point("up", PAPER);
});

test("a thumb that rests keeps no other finger from a mass, and two fingers that come together are for the view", () => {
  for (const on of [put("div", { role: "tab" }), put("div", { class: "softrod-dock" }), canvas]) {
    point("down", PAPER, finger(0, { on }));
    rested();
    point("down", at(3), finger(1));
    assert.deepEqual(done(), ["grab 0 3"]);
    for (const id of [1, 0]) point("up", at(3), finger(id, { on: id ? canvas : on }));
    heard();
  }
  viewed = [];
  point("down", PAPER, finger(0));
  point("down", at(3), finger(1));
  assert.deepEqual([done(), viewed], [[], [["down", 0], ["down", 1]]]);
  for (const id of [0, 1]) point("up", PAPER, finger(id));
  // A tap is over, however soon the next finger comes.
  point("down", PAPER, finger(0));
  point("up", PAPER, finger(0));
  point("down", at(3), finger(1));
  assert.deepEqual(done(), ["grab 0 3"]);
  point("up", at(3), finger(1));
});

test("a pen builds under a palm that rests, that comes before it and that comes beside it", () => {
  change({ on: true, tool: "build" });
  const palm = () => point("down", PAPER, finger(0));
  const stroke = (beside = () => {}) => {
    point("move", at(3), { ...PEN, buttons: 0 });
    point("down", at(3), PEN);
    beside();
    point("move", at(3, 60), PEN);
    point("up", at(3, 60), PEN);
    assert.deepEqual(done(), ["line"]);
    point("up", PAPER, finger(0));
    assert.deepEqual(done(), []);
    change({ chain: -1, chaining: false });
    pass(10_000);
  };
  palm();
  pass(800);
  heard();
  stroke();
  palm();
  stroke();
  viewed = [];
  stroke(() => {
    palm();
    point("move", at(0), finger(0));
  });
  assert.ok(viewed.every(([, id]) => id === PEN.pointerId), `the view hears nothing of the palm: ${viewed}`);
});

test("a palm that comes just before the pen lets go of its mass, and a finger that came long before keeps it", () => {
  for (const [before, has] of [[400, false], [600, true]]) {
    point("down", at(3), finger(0));
    pass(before);
    point("down", at(0), PEN);
    assert.deepEqual(done(), has ? ["grab 0 3", "grab 1 0"] : ["grab 0 3", "drop 0", "grab 0 0"], `${before} ms before`);
    point("move", FAR, finger(0));
    point("up", FAR, finger(0));
    assert.deepEqual([done(), viewed], [has ? ["at", "drop 0"] : [], []]);
    point("up", at(0), PEN);
    heard();
    pass(10_000);
  }
});

test("a palm beside a pen takes no mass, until the pen has been away for a while", () => {
  const button = put("button");
  let pressed = 0;
  button.addEventListener("pointerdown", () => (pressed += 1));
  point("down", at(0), PEN);
  point("down", at(3), finger(0));
  point("move", FAR, finger(0));
  pass();
  assert.deepEqual(done(), ["grab 0 0"]);
  point("up", at(0), PEN);
  point("up", FAR, finger(0));
  point("down", PAPER, finger(0, { on: button }));
  assert.equal(pressed, 1, "a finger beside the canvas is none");
  point("up", PAPER, finger(0, { on: button }));
  for (const [since, has] of [[400, false], [600, true]]) {
    heard();
    pass(10_000);
    point("move", at(0), { ...PEN, buttons: 0 });
    pass(since);
    point("down", at(3), finger(0));
    assert.deepEqual(done(), has ? ["grab 0 3"] : [], `${since} ms after the pen`);
    point("up", at(3), finger(0));
  }
  // A pen that is down and says nothing any more is gone.
  for (const [since, has] of [[4000, false], [6000, true]]) {
    heard();
    pass(10_000);
    point("down", at(0), PEN);
    pass(since);
    point("down", at(3), finger(0));
    assert.deepEqual(done(), ["grab 0 0", ...(has ? ["grab 1 3"] : [])], `${since} ms after the pen`);
    point("up", at(3), finger(0));
    point("up", at(0), PEN);
  }
});

test("a release that never reaches the page ends the drag where it was", () => {
  for (const pointerType of ["mouse", "pen"]) {
    for (const lose of [() => point("move", FAR, { pointerType, buttons: 0 }), () => window.dispatchEvent(new Event("blur"))]) {
      point("down", at(3), { pointerType });
      point("move", at(3, 40), { pointerType });
      lose();
      pass();
      const [, led, ...after] = heard();
      assert.deepEqual([led, after], [{ do: "at", hands: [[0, -0.6, 0]] }, [{ do: "drop", hand: 0 }]]);
      point("move", FAR, { pointerType, buttons: 0 });
      pass();
      assert.deepEqual(heard(), []);
      assert.ok(!canvas.hasPointerCapture(1));
    }
  }
  // A finger has no buttons to tell of.
  pass(10_000);
  point("down", at(3), finger(1));
  point("move", FAR, finger(1, { buttons: 0 }));
  assert.deepEqual(done(), ["grab 0 3"]);
  point("up", FAR, finger(1));
});

test("a release that never reaches the page ends the move of the view", () => {
  point("down", PAPER);
  point("move", FAR);
  point("move", FAR, { buttons: 0 });
  assert.deepEqual(viewed.map(([what]) => what), ["down", "move", "cancel", "move"]);
  assert.deepEqual(done(), []);
});

test("a press of a pointer that was never released ends what it held", () => {
  point("down", at(0));
  point("down", at(3));
  assert.deepEqual(done(), ["grab 0 0", "drop 0", "grab 0 3"]);
  point("up", at(3));
});

test("what follows the pointer needs no button, and stays where it left the canvas", () => {
  become({ follow: true });
  point("move", FAR, { buttons: 0 });
  pass();
  point("move", PAPER, { buttons: 0, on: document.body });
  pass();
  assert.deepEqual(heard(), [{ do: "at", hands: [[0, 2, -1]] }]);
  become({ follow: false });
  point("move", PAPER, { buttons: 0 });
  pass();
  assert.deepEqual(heard(), []);
});

test("the instruments give way to a mass under the pointer, and to nothing else", () => {
  const ruler = put("g", {}, put("svg", { class: "softrod-instruments" }));
  for (const [x, has] of [[0, true], [8, false]]) {
    point("down", at(3, x), { on: ruler });
    assert.deepEqual(done(), has ? ["grab 0 3"] : [], `${x} px off`);
    point("up", at(3, x), { on: ruler });
    heard();
  }
  change({ on: true, tool: "build" });
  point("down", at(3), { on: ruler });
  assert.deepEqual(done(), [], "with a tool no mass is taken");
  point("up", at(3), { on: ruler });
});
