// What ruler, protractor and stopwatch read, where they are, how they are moved, and what is kept of them.
import assert from "node:assert/strict";
import { test } from "node:test";
import { heard, key, pass, point, show, tell } from "./page.mjs";
import { addOverlay } from "../../app/stage/overlay.js";
import * as shapes from "../../app/features/instruments/shapes.js";
import { addInstruments } from "../../app/features/instruments/toolbox.js";

addOverlay();
addInstruments();
const box = document.querySelector(".softrod-box");
box.box = { left: 0, top: 400, right: 150, bottom: 600, width: 150, height: 200 };
const [lid, tools] = [document.querySelector(".softrod-box-lid"), document.querySelector(".softrod-box-tools").children];
/** The buttons in the box. */
const [RULER, PROTRACTOR, STOPWATCH] = tools;
const IN_BOX = { x: 20, y: 500 };
const click = (element) => element.dispatchEvent(new PointerEvent("click", { bubbles: true }));
/** What an instrument on the canvas says that it reads; empty if it is in the box. */
const read = (kind) => document.querySelectorAll(".softrod-instrument").map((one) => one.ariaLabel).find((text) => text.startsWith(kind)) ?? "";
const grips = (kind) => document.querySelectorAll(".softrod-instrument").find((one) => one.ariaLabel.startsWith(kind)).querySelectorAll(".softrod-grip");
const says = () => pass(400) ?? document.querySelector(".softrod-tell").textContent;
const keptKinds = () => JSON.parse(sessionStorage.getItem("softrod-instruments")).map(({ kind }) => kind);

const on = { x: 400, y: 300, step: 100 };
const masses = new Float64Array([100, 100, 500, 400]);
const near = (a, b) => assert.ok(Math.abs(a - b) < 1e-9, `${a} is not ${b}`);

test("a point goes onto a mass within 12 px and then goes where that goes", () => {
  assert.equal(shapes.pointAt({ x: 108, y: 108 }, masses, on).mass, 0);
  assert.equal(shapes.pointAt({ x: 109, y: 109 }, masses, on).mass, -1);
  const point = shapes.pointAt({ x: 505, y: 403 }, masses, on);
  assert.deepEqual(shapes.placesOf([point], masses, on), [{ x: 500, y: 400 }]);
  assert.deepEqual(shapes.placesOf([point], new Float64Array([0, 0, 7, 8]), on), [{ x: 7, y: 8 }]);
  assert.deepEqual(shapes.placesOf([point], new Float64Array([0, 0]), on), [{ x: 7, y: 8 }], "without that mass it stays");
});

test("a free point stays where it is in the scene under zoom and pan", () => {
  const point = shapes.pointAt({ x: 300, y: 200 }, masses, on);
  const [place] = shapes.placesOf([point], masses, { x: 50, y: 60, step: 200 });
  near(place.x, 50 - 200);
  near(place.y, 60 - 200);
});

test("a ruler reads lengths of the scene, with y as the scene has it", () => {
  const [a, b] = [{ x: 100, y: 100 }, { x: 400, y: 500 }];
  const down = shapes.rulerReading(a, b, 2, -1);
  near(down.length, 250);
  near(down.dx, 150);
  near(down.dy, 200);
  near(shapes.rulerReading(a, b, 2, 1).dy, -200);
});

test("strokes of a ruler are at round lengths, and never too many", () => {
  const count = (path) => path.split("M").length - 1;
  const path = shapes.ticks({ x: 0, y: 0 }, { x: 100, y: 0 }, { x: 0, y: 1 }, 1);
  assert.equal(count(path), 11);
  assert.ok(path.includes("M10.0 0.0") && path.includes("M100.0 0.0"));
  for (const scale of [1e-6, 1, 1e6]) assert.ok(count(shapes.ticks({ x: 0, y: 0 }, { x: 1e5, y: 0 }, { x: 0, y: 1 }, scale)) <= 601);
  assert.equal(count(shapes.ticks({ x: 5, y: 5 }, { x: 5, y: 5 }, { x: 0, y: 1 }, 1)), 1);
});

test("a protractor reads the angle between its sides, in either order", () => {
  const [a, vertex, b] = [{ x: 10, y: 0 }, { x: 0, y: 0 }, { x: -7, y: 7 }];
  near(shapes.protractorReading(a, vertex, b).angle, 135);
  near(shapes.protractorReading(b, vertex, a).angle, 135);
  near(shapes.protractorReading(a, vertex, b).bend, 45);
  near(shapes.protractorReading(vertex, vertex, vertex).angle, 0);
});

test("a stopwatch counts simulated time while it runs, and has laps", () => {
  let watch = shapes.startOrStop(shapes.newWatch(), 10);
  near(shapes.watchReading(watch, 12.5), 2.5);
  watch = shapes.lapOrZero(watch, 12);
  watch = shapes.startOrStop(watch, 13);
  near(shapes.watchReading(watch, 99), 3);
  assert.deepEqual(watch.laps, [2]);
  watch = shapes.startOrStop(watch, 50);
  near(shapes.watchReading(watch, 51), 4);
  near(shapes.watchReading(watch, 20), 3, "time that was gone back on does not count");
  watch = shapes.lapOrZero(shapes.startOrStop(watch, 51), 52);
  assert.deepEqual([shapes.watchReading(watch, 60), watch.laps], [0, []]);
});

test("what is kept comes back, and what another version kept does not", () => {
  const ruler = { kind: "ruler", points: [{ x: 0, y: 1, mass: -1 }, { x: 2, y: 3, mass: 4 }] };
  const watch = { kind: "stopwatch", points: [{ x: 0, y: 0, mass: -1 }], watch: shapes.newWatch() };
  assert.deepEqual(shapes.restored(JSON.stringify([ruler, watch])), [ruler, watch]);
  assert.deepEqual(shapes.restored(JSON.stringify([{ ...ruler, kind: "axe" }, { ...ruler, points: [] }])), []);
  for (const text of [null, "", "{", "{}", "7", "null"]) assert.deepEqual(shapes.restored(text), []);
});

test("a stopwatch counts simulated time by click and key", () => {
  show([[100, 100], [500, 400]]);
  assert.ok(!key("t").defaultPrevented, "nothing, without a stopwatch");
  click(lid);
  click(STOPWATCH);
  assert.deepEqual([read("Stopwatch"), STOPWATCH.ariaPressed, keptKinds()], ["Stopwatch: 0.00 s", "true", ["stopwatch"]]);
  assert.ok(key("t").defaultPrevented);
  for (const more of [{ repeat: true }, { shiftKey: true }, { ctrlKey: true }]) assert.ok(!key("t", more).defaultPrevented);
  pass(1000);
  pass(500);
  const [start, lap] = document.querySelectorAll(".softrod-watch-button");
  assert.deepEqual([read("Stopwatch"), start.ariaLabel, lap.ariaLabel], ["Stopwatch: 1.50 s", "Stop (T)", "Lap (L)"]);
  click(lap);
  pass(500);
  click(start);
  pass(800);
  assert.equal(read("Stopwatch"), "Stopwatch: 2.00 s", "it stands");
  assert.equal(document.querySelector(".softrod-watch").querySelector(".softrod-instrument-small").textContent, "1.50");
  start.focus();
  for (const repeat of [false, true]) key(" ", { repeat });
  pass(250);
  key("Enter");
  assert.equal(says(), "Stopwatch: 2.25 s");
  document.body.focus();
  key("l");
  assert.deepEqual([read("Stopwatch"), start.ariaLabel], ["Stopwatch: 0.00 s", "Start (T)"]);
  click(STOPWATCH);
  assert.deepEqual([read("Stopwatch"), says(), keptKinds()], ["", "Stopwatch back in the box", []]);
  assert.ok(!key("t").defaultPrevented);
});

test("a protractor measures a joint by keys alone, and keys move it by pixels", () => {
  show([[100, 100], [500, 400], [600, 400], [600, 300]]);
  key("Tab");
  PROTRACTOR.focus();
  click(PROTRACTOR);
  const [first, corner, second] = grips("Protractor");
  assert.equal(document.activeElement, first, "who goes by keys goes on with it");
  for (const [grip, mass] of [[first, 1], [corner, 2], [second, 3]]) {
    grip.focus();
    key("Enter");
    while (!grip.ariaLabel.includes(`At mass ${mass}.`)) key(mass > 1 ? "ArrowRight" : "ArrowUp");
  }
  assert.equal(says(), "Protractor: 90.0°, bend 90.0°");
  for (const [name, mass] of [["ArrowRight", 0], ["ArrowLeft", 3], ["ArrowUp", 2], ["ArrowDown", 3]]) {
    assert.ok(key(name).defaultPrevented);
    assert.match(second.ariaLabel, new RegExp(`At mass ${mass}\\.`), name);
  }
  second.focus();
  key("Enter");
  assert.ok(!second.ariaLabel.includes("At mass"), "Enter frees it");
  key("ArrowRight");
  key("ArrowLeft", { shiftKey: true });
  key("ArrowRight", { shiftKey: true });
  for (let i = 0; i < 10; i++) key("ArrowUp", { shiftKey: true });
  for (let i = 0; i < 99; i++) key("ArrowRight");
  assert.equal(read("Protractor"), "Protractor: 116.6°, bend 63.4°");
  assert.deepEqual(heard(), [], "Enter and arrows are the instrument's");
  assert.ok(!key("r").defaultPrevented && !key("Delete", { ctrlKey: true }).defaultPrevented);
  key("Delete");
  assert.deepEqual([read("Protractor"), document.activeElement], ["", PROTRACTOR]);
});

test("an instrument is dragged out of the box, by its end onto a mass, and thrown back", () => {
  show([[100, 100], [500, 400]]);
  const drag = (on, from, to) => {
    point("down", from, { on });
    for (const part of [0.01, 0.5, 1]) {
      point("move", { x: from.x + part * (to.x - from.x), y: from.y + part * (to.y - from.y) }, { on });
    }
    point("up", to, { on });
  };
  point("down", IN_BOX, { on: RULER });
  for (const [x, out] of [[25, false], [26, true]]) {
    point("move", { x, y: 500 }, { on: RULER });
    assert.equal(read("Ruler") !== "", out, `${x - IN_BOX.x} px`);
  }
  point("up", IN_BOX, { on: RULER });
  point("down", IN_BOX, { on: RULER });
  point("cancel", IN_BOX, { on: RULER });
  point("move", { x: 300, y: 200 }, { on: RULER, buttons: 0 });
  point("up", { x: 300, y: 200 }, { on: RULER });
  assert.deepEqual([read("Ruler"), RULER.ariaPressed], ["", "false"], "nor does it come after a pointer whose press was lost");
  drag(RULER, IN_BOX, { x: 300, y: 200 });
  point("move", { x: 400, y: 300 }, { on: RULER, buttons: 0 });
  assert.match(read("Ruler"), /^Ruler: 140.0/);
  assert.equal(says(), read("Ruler"));
  const [one, two] = grips("Ruler");
  drag(one, { x: 206, y: 200 }, { x: 82, y: 106 });
  assert.match(one.ariaLabel, /At mass 0/);
  assert.match(read("Ruler"), /^Ruler: 287.9.*Δx 270.0, Δy 100.0/);
  show([[100, 200], [500, 400]]);
  assert.match(read("Ruler"), /^Ruler: 270.0/, "it follows the mass");
  point("down", { x: 0, y: 0 }, { on: two, button: 2 });
  point("move", { x: 90, y: 0 }, { on: two });
  point("up", { x: 90, y: 0 }, { on: two });
  point("down", { x: 0, y: 0 }, { on: two });
  point("move", { x: 90, y: 0 }, { on: two, pointerId: 2 });
  point("up", { x: 0, y: 0 }, { on: two });
  assert.match(read("Ruler"), /^Ruler: 270.0/, "neither by the second button nor by another pointer");
  drag(document.querySelector(".softrod-instrument-body"), { x: 300, y: 200 }, IN_BOX);
  assert.deepEqual([read("Ruler"), RULER.ariaPressed, keptKinds()], ["", "false", []]);
});

test("another scene finds all instruments in the box", () => {
  show([[100, 100], [500, 400]]);
  click(STOPWATCH);
  assert.deepEqual(keptKinds(), ["stopwatch"]);
  tell("putBack");
  assert.deepEqual([keptKinds(), read("Stopwatch"), STOPWATCH.ariaPressed], [[], "", "false"]);
});
