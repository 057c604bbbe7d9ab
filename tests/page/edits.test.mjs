// What goes wrong while one edits by hand: a press that is lost, a body that changes meanwhile, keys meant for something else.
import assert from "node:assert/strict";
import { beforeEach, test } from "node:test";
import { become, canvas, heard, key, pass, point, put, show, tell } from "./page.mjs";
import { listenToEdits } from "../../app/features/edit/gestures.js";
import { listenToEditKeys } from "../../app/features/edit/keys.js";
import { addEditMarks } from "../../app/features/edit/marks.js";
import { crossAt, raiseCross } from "../../app/features/edit/cross.js";
import { addSpeech } from "../../app/features/edit/speech.js";
import { editing, setEditing, setTool } from "../../app/features/edit/editing.js";
import { choose } from "../../app/stage/overlay.js";
import { listenToPresses } from "../../app/ui/hands/presses.js";

listenToPresses();
listenToEditKeys();
listenToEdits();
addEditMarks();
addSpeech();
const body = put("div", { class: "softrod-body", tabindex: "0" });
const live = document.querySelector(".softrod-tell");
const PLACES = [[100, 100], [200, 100], [300, 100], [400, 100]];
const SPRINGS = [[0, 1], [1, 2], [2, 3]];
const JOINTS = [[0, 1, 1, 1], [1, 2, 2, 1]];
const at = (mass, x = 0, y = 0) => ({ x: PLACES[mass][0] + x, y: PLACES[mass][1] + y });
const BESIDE = { x: 200, y: 400 };
const click = (where, more) => ["down", "up"].forEach((what) => point(what, where, more));
const hover = (where) => point("move", where, { buttons: 0 });
const askForMenu = (where) => point("", where, { type: "contextmenu" });
const select = (masses = [], joints = []) => tell("selected", { masses, springs: [], joints });
/** What is drawn of one kind of marks. */
const mark = (kind) => pass() ?? document.querySelector(`.softrod-edit-${kind}`).getAttribute("d");

beforeEach(() => {
  setEditing(true);
  become();
  show(PLACES, SPRINGS, JOINTS);
  tell("versions", { undo: "", redo: "", stiffen: 0 });
  select();
  pass(10_000);
  heard();
});

test("a press that is lost leaves nothing behind, and the next one works", () => {
  setTool("build");
  const losses = {
    blur: () => window.dispatchEvent(new Event("blur")),
    capture: () => canvas.releasePointerCapture(1),
    "released elsewhere": () => hover(at(3, 70, 20)),
  };
  for (const [name, lose] of Object.entries(losses)) {
    point("down", at(3));
    point("move", at(3, 60, 20));
    assert.ok(mark("rubber"), "a line is drawn");
    lose();
    assert.equal(mark("rubber"), "", name);
    point("up", at(3, 60, 20));
    assert.deepEqual(heard(), [], name);
  }
  point("down", at(3));
  point("move", at(3, 60));
  point("up", at(3, 60));
  assert.deepEqual(heard(), [{ do: "line", a: 3, end: [0.6, 2] }]);
});

test("the second button selects what is under it, but not during a press nor after it has moved the view", () => {
  setTool("select");
  click(at(2), { button: 2 });
  askForMenu(at(2));
  assert.deepEqual(heard(), [{ do: "select", masses: [2], springs: [], joints: [] }]);
  point("down", at(1));
  askForMenu(at(2));
  point("up", at(1));
  point("down", at(2, 60), { button: 2 });
  point("up", at(2), { button: 2 });
  askForMenu(at(2));
  assert.deepEqual(heard().filter(({ masses }) => masses?.includes(2)), []);
});

test("what is under way ends when parts are gone: their numbers would be those of others", () => {
  setTool("build");
  click(at(3));
  hover(BESIDE);
  assert.ok(mark("rubber"), "a chain begins");
  show(PLACES.slice(1), SPRINGS.slice(1));
  assert.equal(mark("rubber"), "");
  click(BESIDE);
  assert.deepEqual(heard().map(({ do: what }) => what), ["place"]);
  setTool("select");
  point("down", at(2));
  point("move", at(2, 50));
  heard();
  show(PLACES.slice(2));
  point("up", at(2, 50));
  assert.deepEqual(heard(), []);
});

test("corners and chains go with an undo, here or elsewhere, and with another scene", () => {
  const undo = () => {
    key("z", { ctrlKey: true });
    assert.deepEqual(heard(), [{ do: "perform", command: "undo" }]);
  };
  for (const end of [undo, () => tell("versions", { undo: "", redo: "a mass", stiffen: 0 }), () => become({ scene: 2 })]) {
    tell("versions", { undo: "a mass", redo: "", stiffen: 0 });
    setTool("joint");
    hover(at(1, 20));
    assert.ok(mark("corner") || mark("corner-hover"));
    end();
    assert.equal(mark("corner") + mark("corner-hover"), "");
    setTool("build");
    click(at(3));
    assert.equal(editing.chain, 3);
    become({ scene: 1 });
    tell("versions", { undo: "a mass", redo: "", stiffen: 0 });
  }
});

test("a click on one of several leaves it alone selected, and with Shift takes it out", () => {
  setTool("select");
  for (const shiftKey of [false, true]) {
    select([1, 2, 3]);
    click(at(2), { shiftKey });
    assert.deepEqual(heard(), [{ do: "select", masses: [2], springs: [], joints: [], toggle: shiftKey }]);
  }
});

test("marks of what is under the pointer go when it leaves", () => {
  setTool("build");
  hover(BESIDE);
  assert.ok(mark("under"));
  canvas.dispatchEvent(new PointerEvent("pointerout", { bubbles: true }));
  assert.equal(mark("under"), "");
});

test("keys are as they are written on the keyboard, or by their places where that is no Latin letter", () => {
  for (const [name, code, command] of [["z", "KeyY", "undo"], ["y", "KeyZ", "redo"], ["я", "KeyZ", "undo"]]) {
    key(name, { code, ctrlKey: true });
    assert.deepEqual(heard(), [{ do: "perform", command }], name);
  }
  key("Z", { ctrlKey: true, shiftKey: true });
  assert.deepEqual(heard(), [{ do: "perform", command: "redo" }]);
});

test("keys of the browser, of marked text, of an instrument and of a text are let through", () => {
  select([2]);
  const passes = (event) => assert.deepEqual([event.defaultPrevented, heard()], [false, []], event.key);
  for (const name of ["D", "A", "C"]) passes(key(name, { ctrlKey: true, shiftKey: true }));
  key("c", { ctrlKey: true });
  assert.deepEqual(heard(), [{ do: "act", what: "copy" }]);
  globalThis.getSelection = () => ({ isCollapsed: false });
  passes(key("c", { ctrlKey: true }));
  globalThis.getSelection = () => ({ isCollapsed: true });
  for (const [tag, attributes] of [["g", { class: "softrod-grip" }], ["input", { type: "text" }], ["textarea"]]) {
    const element = put(tag, attributes);
    element.focus();
    passes(key("Delete"));
    if (tag !== "g") passes(key("a", { ctrlKey: true }));
    element.remove();
  }
  document.body.focus();
});

test("a key that is held deletes and duplicates once", () => {
  for (const [name, more] of [["Delete", {}], ["d", { ctrlKey: true }]]) {
    for (const repeat of [false, true, true]) assert.ok(key(name, { ...more, repeat }).defaultPrevented);
    assert.equal(heard().length, 1, name);
  }
});

test("a cross that arrows move stands for a pointer, and says where it is and what is there", () => {
  const said = () => pass(100) ?? live.textContent;
  setTool("build");
  raiseCross();
  assert.equal(document.activeElement, body);
  assert.match(said(), /^Cross at x \d+, y \d+\./);
  const before = crossAt();
  key("ArrowRight");
  assert.ok(crossAt().x > before.x && crossAt().y === before.y);
  heard();
  key("Enter");
  assert.deepEqual(heard().map((message) => message.do), ["place"], "an empty place gets a mass");
  key("Escape");
  assert.equal(crossAt(), null);
  // From a mass on, Enter begins a spring there.
  raiseCross();
  for (let i = 0; i < 100 && !/mass/.test(said()); i += 1) key(crossAt().y > 100 ? "ArrowUp" : "ArrowLeft");
  key("Enter");
  assert.ok(editing.chain >= 0);
  setEditing(false);
  assert.equal(crossAt(), null, "it goes with the tools");
});

test("what keys have chosen is removed and pinned, though what was built last is still selected", () => {
  setTool("build");
  select([3]);
  body.focus();
  choose(1);
  heard();
  key("p");
  key("Delete");
  assert.deepEqual(heard(), [{ do: "act", what: "pin", mass: 1 }, { do: "act", what: "remove", mass: 1 }]);
  setTool("select");
  key("p");
  assert.deepEqual(heard(), [{ do: "act", what: "pin", under: 1 }]);
  key("ArrowRight", { shiftKey: true });
  assert.deepEqual(heard(), [{ do: "select", springs: [0] }], "with Shift, arrows go through its springs and joints");
  choose(-1);
});
