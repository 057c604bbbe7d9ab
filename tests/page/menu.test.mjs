// The View menu and the open box of instruments have their keys to themselves.
import assert from "node:assert/strict";
import { beforeEach, test } from "node:test";
import { become, canvas, heard, key, point, show } from "./page.mjs";
import { listenToKeys } from "../../app/ui/hands/keys.js";
import { listenToPointer } from "../../app/ui/hands/pointer.js";
import view from "../../app/features/view/view.js";
import { addInstruments } from "../../app/features/instruments/toolbox.js";

listenToKeys();
listenToPointer();
view.begin();
addInstruments();
const [menu, lid] = [document.querySelector(".softrod-menu-list"), document.querySelector(".softrod-menu-lid")];
const [tools, box] = [document.querySelector(".softrod-box-tools"), document.querySelector(".softrod-box-lid")];
const click = (element) => element.focus() ?? element.dispatchEvent(new PointerEvent("click", { bubbles: true }));
const at = () => document.activeElement.children[1]?.textContent ?? document.activeElement.ariaLabel;

beforeEach(() => {
  become({ controls: ["view", "help", "tools", "play"] });
  show([[100, 100]]);
  heard();
});

test("arrows, Home and End go round what is offered, Esc and Tab close it and give the focus back", () => {
  click(lid);
  assert.deepEqual([at(), lid.ariaExpanded, menu.hidden], ["Dark", "true", false]);
  assert.deepEqual(menu.children.filter(({ hidden }) => hidden).map((item) => item.children[1].textContent), ["Modes"]);
  const ways = [["ArrowDown", "Larger"], ["ArrowUp", "Dark"], ["ArrowUp", "Help"], ["ArrowDown", "Dark"], ["End", "Help"], ["Home", "Dark"]];
  for (const [name, entry] of ways) {
    assert.ok(key(name).defaultPrevented);
    assert.ok(at().startsWith(entry), `${name}: ${at()}`);
  }
  for (const name of ["Escape", "Tab"]) {
    key(name);
    assert.deepEqual([at(), menu.hidden, lid.ariaExpanded], ["View", true, "false"]);
    click(lid);
  }
  key("Escape");
  assert.deepEqual(heard(), [], "none of it is the body's");
});

test("an entry is done once it is pressed, and the focus stays with who goes by keys", () => {
  for (const [press, focused] of [[() => key("Home"), lid], [() => point("down", { x: 0, y: 0 }, { on: menu }), menu.children[0]]]) {
    click(lid);
    press();
    click(menu.children[0]);
    assert.deepEqual([heard(), menu.hidden, document.activeElement], [[{ do: "perform", command: "dark" }], true, focused]);
  }
});

test("a press anywhere else closes it, also on a mass", () => {
  click(lid);
  point("down", { x: 100, y: 100 });
  assert.deepEqual([menu.hidden, heard().map(({ do: what }) => what)], [true, ["grab"]]);
  point("up", { x: 100, y: 100 });
  assert.ok(!canvas.hasPointerCapture(1));
});

test("Esc closes the box of instruments, and the next one pauses", () => {
  click(box);
  tools.children[0].focus();
  heard();
  key("Escape");
  assert.deepEqual([tools.hidden, document.activeElement, heard()], [true, box, []]);
  key("Escape");
  assert.deepEqual(heard(), [{ do: "perform", command: "pause" }]);
});
