// Keys by what is printed on them, on keyboards of several countries, and for whom they are.
import assert from "node:assert/strict";
import { beforeEach, test } from "node:test";
import { become, heard, key, pass, point, put } from "./page.mjs";
import { COMMANDS } from "../../app/wire/commands.js";
import { commandOf, printed, withKey } from "../../app/ui/hands/key_table.js";
import { listenToKeys } from "../../app/ui/hands/keys.js";
import { provide } from "../../app/wire/perform.js";

let found = 0;
provide({ palette: () => (found += 1) });
listenToKeys();
beforeEach(() => {
  become();
  document.body.focus();
  pass(1000);
  heard();
});

/** A letter or a sign that no command has. */
const FREE = [..."yw;'#"].find((sign) => Object.values(COMMANDS).every((row) => !row.keys.includes(sign)));
assert.ok(FREE, "these tests press a key that does nothing: add to FREE a sign that no command has");

/** What a key at a place of the keyboard does, by what is printed on it. */
const does = (key, code) => commandOf({ key, code });

test("letters act where they are printed", () => {
  // Dvorak: P is where R is on an American keyboard, R where O is, O where S is, and the comma where W is.
  assert.equal(does("z", "KeyR"), "larger");
  assert.equal(does("r", "KeyO"), "reset");
  assert.equal(does("o", "KeyS"), "gallery");
  assert.equal(does(",", "KeyW"), "back");
  assert.equal(does(".", "KeyE"), "forward");
  assert.equal(does(FREE, "Comma"), undefined);
  // AZERTY: the comma is where M is, the semicolon where the comma is, the point above it, and zero above à.
  assert.equal(does(",", "KeyM"), "back");
  assert.equal(does(".", "Comma"), "forward");
  assert.ok(!["back", "forward"].includes(does(";", "Comma")), "neither by its place nor by what is above it");
  assert.equal(does("à", "Digit0"), "fit");
  assert.equal(does("0", "Digit0"), "fit");
});

test("capitals are letters, and the numbers beside the letters are numbers", () => {
  assert.equal(does("R", "KeyR"), "reset");
  assert.equal(does("0", "Numpad0"), "fit");
  assert.equal(does(" ", "Space"), "play");
  assert.equal(does("\u202f", "Space"), "play");
  assert.equal(does("Escape", "CapsLock"), "pause");
});

test("where no Latin letter is printed, the place counts", () => {
  assert.equal(does("к", "KeyR"), "reset");
  assert.equal(does("К", "KeyR"), "reset");
  assert.equal(does("б", "Comma"), "back");
  assert.equal(does("ρ", "KeyR"), "reset");
  assert.equal(does("ı", "KeyI"), "picture");
  assert.equal(does("Process", "KeyN"), "step");
  assert.equal(commandOf({ key: "и", code: "KeyB" }, "edit"), "build");
  // These have names, wherever they are.
  assert.equal(printed({ key: "ArrowLeft", code: "KeyJ" }), "ArrowLeft");
  assert.equal(printed({ key: "ш", code: "IntlBackslash" }), "ш");
});

test("with Shift and Ctrl a key may do something else", () => {
  assert.equal(commandOf({ key: "N", code: "KeyN", shiftKey: true }), "steps");
  assert.equal(commandOf({ key: "R", code: "KeyR", shiftKey: true }), "reset");
  assert.equal(commandOf({ key: "r", code: "KeyR", ctrlKey: true }), undefined);
  assert.equal(commandOf({ key: "z", code: "KeyZ", metaKey: true }), "undo");
  assert.equal(commandOf({ key: "p", code: "KeyP" }, "edit"), "pin");
});

test("no key does two things in one place", () => {
  for (const where of ["", "edit", "own"]) {
    const keys = Object.values(COMMANDS).flatMap((row) => ((row.where ?? "") === where ? row.keys : []));
    assert.deepEqual(keys, [...new Set(keys)]);
  }
});

test("tooltips name the keys of the table", () => {
  assert.equal(withKey("Play", "play"), "Play (Space)");
  assert.equal(withKey("Back", "back"), "Back (,)");
  assert.equal(withKey("Left becomes right", "mirror"), "Left becomes right");
});

/** What a key does with the focus on an element: the messages, and whether the browser may have it. */
function pressed(element, name, { clicked = true, ...init } = {}) {
  if (clicked) point("down", { x: 0, y: 0 }, { on: element });
  else key("Tab");
  element.focus();
  const event = key(name, init);
  key(name, init, "keyup");
  const done = heard().map(({ do: what, command, held }) => command ?? `${what} ${held}`);
  return [done, !event.defaultPrevented];
}
const PLAYS = [["play"], false];
const HOLDS = [["keys up", "keys "], false];
const NOT = [[], true];

test("Space pauses after a click wherever the focus is, presses what the Tab key has reached, and is typed into texts", () => {
  const cases = [
    ["button", { role: "tab" }, PLAYS, NOT],
    ["button", {}, PLAYS, NOT],
    ["input", { type: "checkbox" }, PLAYS, NOT],
    ["input", { type: "text", class: "softrod-number" }, PLAYS, PLAYS],
    ["input", { type: "text" }, NOT, NOT],
    ["input", {}, NOT, NOT],
    ["textarea", {}, NOT, NOT],
    ["select", {}, NOT, NOT],
    ["canvas", {}, PLAYS, PLAYS],
    ...["body", "grip", "muscle", "mode"].map((name) => ["div", { class: `softrod-${name}` }, NOT, NOT]),
  ];
  for (const [tag, attributes, afterClick, byTab] of cases) {
    const element = put(tag, attributes);
    assert.deepEqual(pressed(element, " "), afterClick, `${tag} ${JSON.stringify(attributes)}, clicked`);
    assert.deepEqual(pressed(element, " ", { clicked: false }), byTab, `${tag} ${JSON.stringify(attributes)}, by Tab`);
    element.remove();
  }
});

test("Space plays once, however long it is held, and its release presses nothing", () => {
  for (const repeat of [false, true]) assert.ok(key(" ", { repeat }).defaultPrevented);
  assert.deepEqual(heard(), [{ do: "perform", command: "play" }]);
  assert.ok(key(" ", {}, "keyup").defaultPrevented);
  assert.ok(!key(" ", {}, "keyup").defaultPrevented);
});

test("arrows are held, but not in a text nor on what takes them for itself", () => {
  const steps = put("div", { class: "softrod-steps" });
  const cases = [
    ["canvas", {}, HOLDS],
    ["button", {}, HOLDS],
    ["input", { type: "checkbox" }, HOLDS],
    ["button", {}, NOT, steps],
    ["input", { type: "text" }, NOT],
    ["textarea", {}, NOT],
    ["select", {}, NOT],
    ["div", { role: "slider" }, NOT],
    ["input", { type: "range" }, NOT],
    ...["body", "grip", "own-grip", "muscle", "mode"].map((name) => ["div", { class: `softrod-${name}` }, NOT]),
  ];
  for (const [tag, attributes, does, parent = document.body] of cases) {
    const element = put(tag, attributes, parent);
    assert.deepEqual(pressed(element, "ArrowUp", { clicked: false }), does, `${tag} ${JSON.stringify(attributes)}`);
    element.remove();
  }
  assert.deepEqual(pressed(put("button", {}, steps), "ArrowLeft"), [["keys left", "keys "], false]);
  const slider = put("div", { role: "slider" });
  assert.deepEqual(pressed(slider, "End", { clicked: false }), NOT);
  assert.deepEqual(pressed(slider, "Escape", { clicked: false }), [["pause"], false], "which moves no slider");
  slider.remove();
});

test("a dialog, a menu, a key of the browser and the open box of instruments have their keys to themselves", () => {
  for (const [tag, attributes] of [["dialog", { open: "" }], ["div", { role: "dialog" }], ["div", { role: "menu" }]]) {
    const element = put(tag, attributes);
    for (const name of ["ArrowUp", " ", "r", "Escape"]) assert.deepEqual(pressed(document.body, name), NOT, `${tag} ${name}`);
    element.remove();
  }
  put("div", { role: "menu", hidden: "" });
  for (const name of ["ArrowUp", " ", "r"]) {
    for (const more of ["ctrlKey", "metaKey", "altKey"]) assert.deepEqual(pressed(document.body, name, { [more]: true }), NOT, `${more} ${name}`);
  }
  const button = put("button", {}, put("div", { class: "softrod-box", "data-open": "" }));
  assert.deepEqual(pressed(button, "Escape"), NOT);
  button.parentElement.removeAttribute("data-open");
  assert.deepEqual(pressed(button, "Escape"), [["pause"], false]);
});

test("keys that are held are said again and again, and let go of where the window is left", () => {
  key("ArrowUp");
  for (const repeat of [true, true]) key("ArrowUp", { repeat });
  key("ArrowLeft");
  pass(160);
  assert.deepEqual(heard().map(({ held }) => held), [["up"], ["up", "left"], ["up", "left"]]);
  for (const [target, kind] of [[window, "blur"], [document, "visibilitychange"]]) {
    target.dispatchEvent(new Event(kind));
    assert.deepEqual(heard(), [{ do: "keys", held: [] }]);
    pass(500);
    key("ArrowLeft", {}, "keyup");
    assert.deepEqual(heard(), []);
    key("ArrowUp");
    heard();
  }
  // A release counts also where a text has the focus by now.
  put("input", { type: "text" }).focus();
  assert.ok(!key("ArrowUp", {}, "keyup").defaultPrevented);
  assert.deepEqual(heard(), [{ do: "keys", held: [] }]);
});

test("what a key does once it does once, and steps as long as it is held", () => {
  for (const [name, command, often] of [["r", "reset", 1], ["Escape", "pause", 1], ["n", "step", 3], [",", "back", 3]]) {
    for (const repeat of [false, true, true]) assert.ok(key(name, { repeat }).defaultPrevented);
    assert.deepEqual(heard(), Array(often).fill({ do: "perform", command }), name);
  }
  become({ scrubbed: true });
  key("n");
  assert.deepEqual(heard(), [{ do: "perform", command: "forward" }], "in the past there is no step, but a frame");
  become({ scrubbed: false });
});

test("viser hears no key with which it would move the camera, wherever its letter is printed", () => {
  let moved = 0;
  window.addEventListener("keydown", () => (moved += 1));
  for (const letter of "wasdqe") key(FREE, { code: `Key${letter.toUpperCase()}` });
  key("ArrowUp");
  key("ArrowUp", {}, "keyup");
  assert.equal(moved, 0);
  key(FREE, { code: "KeyY" });
  assert.equal(moved, 1, `${FREE} is of no command, so viser hears it`);
});

test("what finds anything opens from wherever the focus is, by the key that is printed or by its place", () => {
  const input = put("input", { type: "text" });
  const before = found;
  for (const [on, name, code] of [[input, "k", "KeyK"], [document.body, "л", "KeyK"], [document.body, "k", "KeyV"]]) {
    on.focus();
    assert.ok(key(name, { code, ctrlKey: true }).defaultPrevented);
  }
  assert.equal(found, before + 3);
  const dialog = put("dialog", { open: "" });
  dialog.focus();
  key("k", { ctrlKey: true });
  assert.equal(found, before + 3, "not over a dialog");
  dialog.remove();
});

test("the arrow pad holds a key while it is pressed, wherever the pointer is then, by several fingers and by Space", () => {
  const [up, left] = ["up", "left"].map((name) => put("button", { "data-softrod-key": name }));
  const holds = (wanted) => assert.deepEqual(heard().map(({ held }) => held.join()), wanted);
  const finger = (pointerId, on) => ({ pointerType: "touch", pointerId, on });
  const AWAY = { x: 700, y: 500 };
  point("down", { x: 0, y: 0 }, finger(1, up));
  point("down", { x: 0, y: 0 }, finger(2, left));
  assert.ok(up.hasPointerCapture(1) && left.hasPointerCapture(2));
  assert.ok(up.classList.contains("softrod-on"));
  point("up", AWAY, finger(1, document.body));
  point("cancel", AWAY, finger(2, left));
  holds(["up", "up,left", "left", ""]);
  assert.ok(!up.classList.contains("softrod-on"));
  key("Tab");
  up.focus();
  key(" ");
  key(" ", {}, "keyup");
  key("Enter");
  left.focus();
  holds(["up", "", "up", ""]);
});
