// @ts-check
/**
 * Building and changing the body by the pointer. The page finds what is under the pointer and draws what it does, so
 * that nothing lags; the server makes the edit.
 */
import { onPicture } from "../../stage/canvas.js";
import { onMessage, pageState, send } from "../../wire/channel.js";
import { change, countSelected, editing, giveUp } from "./editing.js";
import { swallow } from "../../ui/hands/keys.js";
import { moveSelected } from "./move.js";
import { sight } from "../../stage/sight.js";
import * as pick from "./pick.js";
import { massAt } from "../../ui/hands/pointer.js";
import { nearest } from "../../stage/screen.js";
import { perform } from "../../wire/perform.js";
import { PICKED_UP, takePointer } from "../../ui/hands/take.js";
import { viserCanvas } from "../../ui/viser/viser.js";
import { say } from "../../words/words.js";

/**
 * @typedef {import("./pick.js").Place} Place
 * @typedef {import("./pick.js").Parts} Parts
 */

/** Pixels within which a press counts as a click. */
const CLICK = 5;
/** Milliseconds after which a finger that rests selects what is under it. */
const LONG_PRESS = 550;
/** Milliseconds between the two presses of a double click, at most. */
const DOUBLE_CLICK = 400;
/** Corners of a stroke that is sent. */
const MAX_POINTS = 48;
/** Milliseconds of vibration when a long press selects. */
const VIBRATION = 15;

/** What taps call what is dragged; springs are built by clicks anyway. @type {Partial<Record<NonNullable<typeof editing.drag>["kind"], import("../../words/keys.js").Plain>>} */
const DRAGGED = { move: "taps-selection", marquee: "taps-frame", stroke: "taps-cut", turn: "taps-turn" };

/** The present press: its pointer, where it began and what was there. */
let press = {
  id: -1, kind: "mouse", start: { x: 0, y: 0 }, moved: false, shift: false, toggled: false, tool: editing.tool,
  /** The event, to pass it on to viser. @type {PointerEvent | null} */
  event: null,
};
/** The timer of a long press. */
let longPress = 0;
/** Where the second button was pressed. */
let second = { x: 0, y: 0 };
/** The last click on a joint. */
let lastClick = { joint: -1, at: 0 };
/** Whether an event is being passed on to viser. */
let passing = false;

// ------------------------------------------------------------------------- presses
/** @param {MouseEvent} event @returns {Place} */
const placeOf = ({ clientX, clientY }) => ({ x: clientX, y: clientY });

/** @param {PointerEvent} event */
function down(event) {
  const canvas = viserCanvas();
  if (passing || !editing.on || event.target !== canvas || !canvas) return;
  if (press.id >= 0 && event.pointerType === "pen") drop(); // a resting hand gives way to the pen
  if (press.id >= 0) {
    passOn(canvas);
    return;
  }
  if (event.button === 2) second = placeOf(event);
  const { tool } = editing;
  const selects = tool === "select" || event.shiftKey;
  if (event.button !== 0 || (tool === "hand" && !selects)) return;
  swallow(event);
  const focused = document.activeElement;
  if (focused instanceof HTMLElement || focused instanceof SVGElement) focused.blur();
  const start = placeOf(event);
  press = { id: event.pointerId, kind: event.pointerType, start, moved: false, shift: event.shiftKey, toggled: false, tool, event };
  if (press.kind === "touch") longPress = setTimeout(selectByLongPress, LONG_PRESS);
  const joint = pick.knobAt(start, press.kind);
  if (joint >= 0) change({ drag: { kind: "turn", joint, angle: pick.restDirection(joint) }, hover: start });
  else if (selects) takeParts(start);
  else if (tool === "build") beginLine(start, event.altKey);
  else if (tool === "cut") change({ drag: { kind: "stroke", points: [start] }, hover: start });
  else change({ hover: start });
  const name = editing.drag && DRAGGED[editing.drag.kind];
  if (name) takePointer(canvas, event, { name: say(name) });
  else canvas.setPointerCapture(event.pointerId);
}

/** A second finger moves the view: viser gets the first one, too. @param {HTMLCanvasElement} canvas */
function passOn(canvas) {
  const { event, id } = press;
  drop();
  if (!event || press.kind !== "touch") return;
  if (canvas.hasPointerCapture(id)) canvas.releasePointerCapture(id);
  const { pointerId, pointerType, clientX, clientY, pageX, pageY, button, buttons } = event;
  const init = { pointerId, pointerType, clientX, clientY, pageX, pageY, button, buttons, bubbles: true, cancelable: true };
  passing = true;
  canvas.dispatchEvent(new PointerEvent("pointerdown", init));
  passing = false;
}

/** Selects what is under a finger that rests, and ends the press. */
function selectByLongPress() {
  const canvas = viserCanvas();
  const parts = pick.partAt(press.start, press.kind);
  if (canvas?.hasPointerCapture(press.id)) canvas.releasePointerCapture(press.id);
  drop();
  if (pick.isNothing(parts)) return;
  navigator.vibrate?.(VIBRATION);
  send({ do: "select", ...parts });
}

function drop() {
  clearTimeout(longPress);
  press.id = -1;
  // A finger that was lifted points at nothing.
  change({ drag: null, hover: press.kind === "touch" ? null : editing.hover });
}

/** @param {PointerEvent} event */
function move(event) {
  if (!editing.on || passing) return;
  const at = placeOf(event);
  if (press.id < 0) {
    const over = event.target === viserCanvas() && event.pointerType !== "touch" && event.buttons === 0;
    if (over || editing.hover) hover(over ? at : null);
    return;
  }
  if (event.pointerId !== press.id) return;
  event.stopImmediatePropagation();
  if (!press.moved && pick.distance(at, press.start) <= CLICK) return;
  clearTimeout(longPress);
  press.moved = true;
  change({ hover: at, drag: dragged(at, event) });
}

/** The drag after a move of the pointer. @param {Place} at @param {PointerEvent} event */
function dragged(at, { altKey, shiftKey }) {
  const { drag } = editing;
  switch (drag?.kind) {
    case "line": {
      const to = massAt(at, press.kind);
      return { ...drag, to: to === drag.from ? -1 : to, at: pick.snapped(at, altKey) };
    }
    case "marquee":
      return { ...drag, at };
    case "move": {
      const end = pick.snapped({ x: drag.start.x + at.x - press.start.x, y: drag.start.y + at.y - press.start.y }, altKey);
      return { ...drag, dx: end.x - drag.start.x, dy: end.y - drag.start.y, moved: true };
    }
    case "stroke":
      return { ...drag, points: pick.thinned([...drag.points, at], 4 * MAX_POINTS) };
    case "turn": {
      const seen = sight();
      if (!seen) return drag;
      const angle = pick.restAt(drag.joint, pick.directionOf(pick.knobOf(seen, drag.joint).tip, at));
      return { ...drag, angle: pick.directionAt(drag.joint, shiftKey ? pick.rounded(angle, 15) : angle) };
    }
    default:
      return null;
  }
}

/** @param {PointerEvent} event */
function up(event) {
  if (press.id < 0 || event.pointerId !== press.id) return;
  event.stopImmediatePropagation();
  const { drag } = editing;
  const at = placeOf(event);
  const { moved, shift } = press;
  drop();
  if (event.type === "pointercancel") return;
  switch (drag?.kind) {
    case "line":
      endLine(drag, moved);
      break;
    case "marquee":
      if (moved) {
        const [one, two] = [pick.world(drag.start), pick.world(at)];
        send({ do: "marquee", x: [one[0], two[0]], y: [one[1], two[1]], add: drag.add });
      } else if (!shift && countSelected()) send({ do: "select" });
      break;
    case "move":
      endMove(drag);
      break;
    case "stroke":
      if (moved) send({ do: "stroke", points: pick.thinned(drag.points, MAX_POINTS).map(pick.world) });
      break;
    case "turn":
      if (moved) send({ do: "turn", joint: drag.joint, angle: pick.restAt(drag.joint, drag.angle) });
      else if (isDoubleClick(drag.joint, event.timeStamp)) send({ do: "turn", joint: drag.joint });
      break;
    default:
      if (editing.on && press.tool === "joint" && editing.tool === "joint" && !moved) clickCorner(at, event.timeStamp);
  }
}

/** Points at a place, or at none. @param {Place | null} at */
export function hover(at) {
  if (!at) {
    change({ hover: null });
    return;
  }
  const { plan, places } = sight() ?? {};
  const corner = plan && places && editing.tool === "joint" ? nearest(places, plan.radius, at, pick.CORNER) : -1;
  change({ hover: at, corner });
}

// ------------------------------------------------------------------------- select
/** A press of the select tool. @param {Place} at */
function takeParts(at) {
  const parts = pick.partAt(at, press.kind);
  if (pick.isNothing(parts)) {
    change({ drag: { kind: "marquee", start: at, at, add: press.shift }, hover: at });
    return;
  }
  if (!pick.isSelected(parts)) {
    press.toggled = true;
    send({ do: "select", ...parts, toggle: press.shift });
    // Selected at once, so that it can be moved; the server will report the same.
    change({ selected: press.shift ? joined(editing.selected, parts) : parts });
  }
  const seen = sight();
  const [mass] = parts.masses;
  const start = seen && mass !== undefined ? pick.placeOf(seen, mass) : at;
  change({ drag: { kind: "move", start, dx: 0, dy: 0, moved: false }, hover: at });
}

/** @param {Parts} one @param {Parts} two @returns {Parts} */
const joined = (one, two) => ({
  masses: [...one.masses, ...two.masses],
  springs: [...one.springs, ...two.springs],
  joints: [...one.joints, ...two.joints],
});

/** @param {import("./editing.js").Move} drag */
function endMove({ moved, dx, dy }) {
  const step = sight()?.on.step ?? 1;
  if (moved && (dx || dy)) moveSelected(dx / step, -dy / step);
  else if (!press.toggled && !moved) {
    // A click on one of several: Shift takes it out of the selection; otherwise it is selected alone.
    const parts = pick.partAt(press.start, press.kind);
    if (press.shift || countSelected() > 1) send({ do: "select", ...parts, toggle: press.shift });
  }
}

// ------------------------------------------------------------------------- build
/** @param {Place} at @param {boolean} isFree off the grid */
function beginLine(at, isFree) {
  const mass = massAt(at, press.kind);
  const start = mass >= 0 ? at : pick.snapped(at, isFree);
  change({ drag: { kind: "line", from: mass, start, at: start, to: -1 }, hover: at });
}

/** @param {import("./editing.js").Line} line @param {boolean} moved */
function endLine({ from, start, at, to }, moved) {
  const { chain } = editing;
  if (moved) {
    if (from < 0 && to < 0 && pick.distance(at, start) < 1) return;
    line(from, start, to, at);
  } else if (chain >= 0 && from === chain) change({ chain: -1 });
  else if (chain >= 0) line(chain, start, from, start);
  else if (from >= 0) change({ chain: from });
  else {
    const [x, y] = pick.world(start);
    send({ do: "place", x, y });
  }
}

/**
 * Adds a spring between two masses; a negative number stands for a new mass at a place. The next spring begins at its end.
 *
 * @param {number} a @param {Place} start @param {number} b @param {Place} end
 */
export function line(a, start, b, end) {
  change(b >= 0 ? { chain: b } : { chaining: true });
  send({
    do: "line",
    ...(a >= 0 ? { a } : { start: pick.world(start) }),
    ...(b >= 0 ? { b } : { end: pick.world(end) }),
  });
}

// ------------------------------------------------------------------------- the cross of the keys
/** Does what a click at a place does. @param {Place} at */
export function clickAt(at) {
  const { tool, drag } = editing;
  if (tool === "select") {
    const parts = pick.partAt(at, "mouse");
    send(pick.isNothing(parts) ? { do: "select" } : { do: "select", ...parts, toggle: true });
  } else if (tool === "build") {
    const start = pick.snapped(at, true);
    endLine({ kind: "line", from: massAt(at, "mouse"), start, at: start, to: -1 }, false);
  } else if (tool === "joint") clickCorner(at, performance.now());
  else if (tool === "cut" && drag?.kind === "stroke") {
    send({ do: "stroke", points: [...drag.points, at].map(pick.world) });
    change({ drag: null });
  } else if (tool === "cut") change({ drag: { kind: "stroke", points: [at] } });
}

// ------------------------------------------------------------------------- joints
/** Whether a click on a joint is the second of a double click. @param {number} joint @param {number} now ms */
function isDoubleClick(joint, now) {
  const twice = joint === lastClick.joint && now - lastClick.at < DOUBLE_CLICK;
  lastClick = { joint, at: now };
  return twice;
}

/** A click of the joint tool. @param {Place} at @param {number} now ms */
function clickCorner(at, now) {
  const seen = sight();
  if (!seen) return;
  const mass = massAt(at, press.kind);
  if (mass >= 0) {
    change({ corner: mass, arm: -1 });
    return;
  }
  const { corner, arm } = editing;
  const tip = pick.placeOf(seen, corner);
  if (corner >= 0 && pick.distance(tip, at) <= pick.CORNER) {
    const direction = pick.directionOf(tip, at);
    const hit = pick.cornersOf(seen, corner).find(({ from, turn }) => pick.turnTo(from, direction) <= turn);
    if (hit) {
      if (hit.joint < 0) send({ do: "hold", a: hit.a, b: hit.b });
      else chooseJoint(hit.joint, now);
      return;
    }
  }
  const joint = pick.jointAt(seen, at, press.kind);
  if (joint >= 0) {
    chooseJoint(joint, now);
    return;
  }
  // Any two springs that share a mass, one after the other.
  const spring = pick.springAt(seen, at, press.kind);
  if (spring >= 0 && arm >= 0 && spring !== arm) {
    send({ do: "hold", a: arm, b: spring });
    change({ arm: -1 });
  } else change({ arm: spring, corner: -1 });
}

/** @param {number} joint @param {number} now */
function chooseJoint(joint, now) {
  if (isDoubleClick(joint, now)) send({ do: "turn", joint });
  else send({ do: "select", joints: [joint] });
}

/** Undoes or redoes a change: masses may then have other numbers, so the present gesture ends. @param {"undo" | "redo"} what */
export function stepBack(what) {
  giveUp();
  perform(what);
}

// ------------------------------------------------------------------------- events
/** Selects what the second button is released over. @param {MouseEvent & {pointerType?: string}} event */
function openMenu(event) {
  if (!editing.on || event.target !== viserCanvas()) return;
  if (press.id >= 0) {
    swallow(event);
    return;
  }
  // Some systems send this at the release, after the second button has moved the view.
  if (event.pointerType === "mouse" && pick.distance(placeOf(event), second) > CLICK) return;
  const parts = pick.partAt(placeOf(event), "mouse");
  if (pick.isNothing(parts)) return;
  swallow(event);
  send({ do: "select", ...parts });
}

/** Begins to listen; before the pointer that grabs masses, and before the keys. */
export function listenToEdits() {
  window.addEventListener("pointerdown", down, true);
  window.addEventListener("pointermove", move, true);
  for (const kind of /** @type {const} */ (["pointerup", "pointercancel"])) window.addEventListener(kind, up, true);
  window.addEventListener("lostpointercapture", ({ pointerId }) => pointerId === press.id && drop(), true);
  document.addEventListener("pointerout", ({ relatedTarget }) => editing.hover && press.id < 0 && !relatedTarget && hover(null));
  window.addEventListener("contextmenu", openMenu, true);
  window.addEventListener(PICKED_UP, () => clearTimeout(longPress));
  onMessage("selected", ({ masses, springs, joints }) => {
    const { chaining, chain } = editing;
    change({
      selected: { masses, springs, joints },
      chain: chaining && masses.length === 1 ? masses[0] : chain,
      chaining: false,
    });
  });
  onMessage("versions", ({ undo, redo, count, stiffen }) => {
    if (redo && redo !== editing.redo) giveUp(); // undone elsewhere: as in `stepBack`
    change({ undo, redo, count, stiffen });
  });
  // Without some parts, the numbers of the others have changed.
  let [masses, springs] = [0, 0];
  onPicture((_, { radius, springs: ends }) => {
    if (radius.length < masses || ends.length < springs) giveUp();
    [masses, springs] = [radius.length, ends.length];
  });
  let { scene } = pageState();
  onMessage("pageState", () => {
    if (pageState().scene !== scene) giveUp();
    ({ scene } = pageState());
  });
}
