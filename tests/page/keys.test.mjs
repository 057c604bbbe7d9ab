// Keys by what is printed on them, on keyboards of several countries.
import assert from "node:assert/strict";
import test from "node:test";
import { COMMANDS } from "../../app/wire/commands.js";
import { commandOf, printed, withKey } from "../../app/page/hands/key_table.js";

/** What a key at a place of the keyboard does, by what is printed on it. */
const does = (key, code) => commandOf({ key, code });

test("letters act where they are printed", () => {
  // Dvorak: P is where R is on an American keyboard, R where O is, O where S is, and the comma where W is.
  assert.equal(does("p", "KeyR"), "larger");
  assert.equal(does("r", "KeyO"), "reset");
  assert.equal(does("o", "KeyS"), "gallery");
  assert.equal(does(",", "KeyW"), "back");
  assert.equal(does(".", "KeyE"), "forward");
  assert.equal(does("w", "Comma"), undefined);
  // AZERTY: the comma is where M is, the point is above the semicolon, and zero above à.
  assert.equal(does(",", "KeyM"), "back");
  assert.equal(does(".", "Comma"), "forward");
  assert.equal(does(";", "Comma"), undefined);
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
