// @ts-check
/**
 * Building and changing the body by the pointer. The page finds what is under the pointer and draws what is under way,
 * so that nothing lags; the server makes the edit.
 */
import { onPicture, shown } from "../../stage/canvas.js";
import { onMessage, pageState, send } from "../../wire/channel.js";
import {
  CORNER, directionTo, distanceTo, isNothing, isSelected, partAt, REACH, snapped, turnable, within, world,
} from "./places.js";
import { change, countSelected, editing, giveUp } from "./editing.js";
import { directionAt, restAt, restDirection } from "./joint_rest.js";
import { swallow } from "../../ui/hands/keys.js";
import { moveSelected } from "./move.js";
import { sight } from "../../stage/sight.js";
import * as pick from "./pick.js";
import { massAt } from "../../ui/hands/pointer.js";
import { nearest } from "../../stage/screen.js";
import { perform } from "../../wire/perform.js";
import { viserCanvas } from "../../ui/viser/viser.js";

/**
 * @typedef {import("./pick.js").Place} Place
 * @typedef {import("./pick.js").Parts} Parts
 */

/** Pixels within which a press counts as a click. */
const CLICK = 5;
/** Milliseconds after which a finger that rests selects what is under it. */
const LONG = 550;
/** Milliseconds between two presses that are a double click. */
const TWICE = 400;
/** Pixels around a knob. */
const KNOB = { mouse: 12, pen: 14, touch: 24 };
/** Corners that a stroke is told with. */
const MAX_POINTS = 48;

/** The press that is under way: its pointer, where it began and what was there. */
let press = {
  id: -1, kind: "mouse", start: { x: 0, y: 0 }, moved: false, shift: false, toggled: false, tool: editing.tool,
  /** The event, to give it back to viser. @type {PointerEvent | null} */
  event: null,
};
let longer = 0;
/** Where the second button was pressed. */
let second = { x: 0, y: 0 };
/** The last click on a joint. */
let last = { joint: -1, at: 0 };
/** Whether a press is given back to viser. */
let passing = false;

// ------------------------------------------------------------------------- presses
/** @param {PointerEvent} event @returns {Place} */
const placeOf = ({ clientX, clientY }) => ({ x: clientX, y: clientY });

/** @param {PointerEvent} event */
function down(event) {
  const canvas = viserCanvas();
  if (passing || !editing.on || event.target !== canvas || !canvas) return;
  if (press.id >= 0 && event.pointerType === "pen") drop(); // a hand that rests gives way to it
  if (press.id >= 0) {
    giveBack(canvas);
    return;
  }
  if (event.button === 2) second = placeOf(event);
  const { tool } = editing;
  const selects = tool === "select" || event.shiftKey;
  if (event.button !== 0 || (tool === "hand" && !selects)) return;
  swallow(event);
  const focused = document.activeElement;
  if (focused instanceof HTMLElement || focused instanceof SVGElement) focused.blur();
  canvas.setPointerCapture(event.pointerId);
  const start = placeOf(event);
  press = { id: event.pointerId, kind: event.pointerType, start, moved: false, shift: event.shiftKey, toggled: false, tool, event };
  if (event.pointerType === "touch") longer = setTimeout(rest, LONG);
  const knob = turnable();
  if (knob >= 0 && isOnKnob(knob, start)) change({ drag: { kind: "turn", joint: knob, angle: restDirection(knob) }, hover: start });
  else if (selects) takeParts(start);
  else if (tool === "build") beginLine(start, event.altKey);
  else if (tool === "cut") change({ drag: { kind: "stroke", points: [start] }, hover: start });
  else change({ hover: start });
}

/** A second finger is for the view: viser gets the first one, too. @param {HTMLCanvasElement} canvas */
function giveBack(canvas) {
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

/** A finger rests: what is under it is selected, and nothing else happens. */
function rest() {
  const parts = partAt(press.start, press.kind);
  drop();
  if (isNothing(parts)) return;
  navigator.vibrate?.(15);
  send({ do: "select", ...parts });
}

function drop() {
  clearTimeout(longer);
  press.id = -1;
  // A finger that is gone points at nothing.
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
  if (!press.moved && Math.hypot(at.x - press.start.x, at.y - press.start.y) <= CLICK) return;
  clearTimeout(longer);
  press.moved = true;
  change({ hover: at, drag: led(at, event) });
}

/** What the pointer does, once it is somewhere else. @param {Place} at @param {PointerEvent} event */
function led(at, { altKey, shiftKey }) {
  const { drag } = editing;
  switch (drag?.kind) {
    case "line": {
      const to = massAt(at, press.kind);
      return { ...drag, to: to === drag.from ? -1 : to, at: snapped(at, altKey) };
    }
    case "marquee":
      return { ...drag, at };
    case "move": {
      const end = snapped({ x: drag.start.x + at.x - press.start.x, y: drag.start.y + at.y - press.start.y }, altKey);
      return { ...drag, dx: end.x - drag.start.x, dy: end.y - drag.start.y, moved: true };
    }
    case "stroke":
      return { ...drag, points: pick.thinned([...drag.points, at], 4 * MAX_POINTS) };
    case "turn": {
      const tip = shown().pictured?.joints[4 * drag.joint + 2] ?? 0;
      const angle = restAt(drag.joint, directionTo(tip, at));
      return { ...drag, angle: directionAt(drag.joint, shiftKey ? pick.rounded(angle, 15) : angle) };
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
  const { moved } = press;
  drop();
  if (event.type === "pointercancel") return;
  switch (drag?.kind) {
    case "line":
      return endLine(drag, moved);
    case "marquee": {
      if (moved) {
        const [one, two] = [world(drag.start), world(at)];
        send({ do: "marquee", x: [one[0], two[0]], y: [one[1], two[1]], add: drag.add });
      } else if (!press.shift && countSelected()) send({ do: "select" });
      return;
    }
    case "move": {
      const step = sight()?.on.step ?? 1;
      if (drag.moved && (drag.dx || drag.dy)) moveSelected(drag.dx / step, -drag.dy / step);
      else if (!press.toggled && !drag.moved) {
        // One of several: it goes with Shift, and stays alone without.
        const parts = partAt(press.start, press.kind);
        if (press.shift || countSelected() > 1) send({ do: "select", ...parts, toggle: press.shift });
      }
      return;
    }
    case "stroke": {
      if (moved) send({ do: "stroke", points: pick.thinned(drag.points, MAX_POINTS).map(world) });
      return;
    }
    case "turn": {
      if (moved) send({ do: "turn", joint: drag.joint, angle: restAt(drag.joint, drag.angle) });
      else if (isTwice(drag.joint, event.timeStamp)) send({ do: "turn", joint: drag.joint });
      return;
    }
    default:
      if (editing.on && press.tool === "joint" && editing.tool === "joint" && !moved) clickCorner(at, event.timeStamp);
  }
}

/** @param {Place | null} at */
function hover(at) {
  if (!at) {
    change({ hover: null });
    return;
  }
  const { plan, places } = sight() ?? {};
  const corner = plan && places && editing.tool === "joint" ? nearest(places, plan.radius, at, CORNER) : -1;
  change({ hover: at, corner });
}

// ------------------------------------------------------------------------- select
/** A press of the select tool. @param {Place} at */
function takeParts(at) {
  const parts = partAt(at, press.kind);
  if (isNothing(parts)) {
    change({ drag: { kind: "marquee", start: at, at, add: press.shift }, hover: at });
    return;
  }
  if (!isSelected(parts)) {
    press.toggled = true;
    send({ do: "select", ...parts, toggle: press.shift });
    // So that it can be moved at once: the server says the same.
    change({ selected: press.shift ? joined(editing.selected, parts) : parts });
  }
  const { places } = sight() ?? {};
  const [mass] = parts.masses;
  const start = places && mass !== undefined ? { x: places[2 * mass], y: places[2 * mass + 1] } : at;
  change({ drag: { kind: "move", start, dx: 0, dy: 0, moved: false }, hover: at });
}

/** @param {Parts} one @param {Parts} two @returns {Parts} */
const joined = (one, two) => ({
  masses: [...one.masses, ...two.masses],
  springs: [...one.springs, ...two.springs],
  joints: [...one.joints, ...two.joints],
});

// ------------------------------------------------------------------------- build
/** @param {Place} at @param {boolean} free */
function beginLine(at, free) {
  const mass = massAt(at, press.kind);
  const start = mass >= 0 ? at : snapped(at, free);
  change({ drag: { kind: "line", from: mass, start, at: start, to: -1 }, hover: at });
}

/** @param {import("./editing.js").Line} line @param {boolean} moved */
function endLine({ from, start, at, to }, moved) {
  const { chain } = editing;
  if (moved) {
    if (from < 0 && to < 0 && Math.hypot(at.x - start.x, at.y - start.y) < 1) return;
    line(from, start, to, at);
  } else if (chain >= 0 && from === chain) change({ chain: -1 });
  else if (chain >= 0) line(chain, start, from, start);
  else if (from >= 0) change({ chain: from });
  else {
    const [x, y] = world(start);
    send({ do: "place", x, y });
  }
}

/**
 * A spring between two masses, each named or to be put down; the next one leads on from its end.
 *
 * @param {number} a @param {Place} start @param {number} b @param {Place} end
 */
export function line(a, start, b, end) {
  change(b >= 0 ? { chain: b } : { chaining: true });
  send({
    do: "line",
    ...(a >= 0 ? { a } : { start: world(start) }),
    ...(b >= 0 ? { b } : { end: world(end) }),
  });
}

// ------------------------------------------------------------------------- joints
/** @param {number} joint @param {Place} at */
function isOnKnob(joint, at) {
  const { pictured: plan } = shown();
  const { places } = sight() ?? {};
  if (!plan || !places) return false;
  const tip = plan.joints[4 * joint + 2];
  const t = (restDirection(joint) * Math.PI) / 180;
  const knob = { x: places[2 * tip] + CORNER * Math.cos(t), y: places[2 * tip + 1] - CORNER * Math.sin(t) };
  return Math.hypot(knob.x - at.x, knob.y - at.y) <= within(KNOB, press.kind);
}

/** Whether a click on a joint is the second of two. @param {number} joint @param {number} now when it was made, ms */
function isTwice(joint, now) {
  const twice = joint === last.joint && now - last.at < TWICE;
  last = { joint, at: now };
  return twice;
}

/** A click of the joint tool. @param {Place} at @param {number} now when it was made, ms */
function clickCorner(at, now) {
  const seen = sight();
  if (!seen) return;
  const { broken } = shown().damage;
  const mass = massAt(at, press.kind);
  if (mass >= 0) {
    change({ corner: mass, arm: -1 });
    return;
  }
  const { corner } = editing;
  if (corner >= 0 && distanceTo(corner, at) <= CORNER) {
    const direction = directionTo(corner, at);
    const corners = pick.cornersOf(seen.plan, seen.places, corner, broken);
    const hit = corners.find(({ from, turn }) => pick.turnTo(from, direction) <= turn);
    if (hit) {
      if (hit.joint < 0) send({ do: "hold", a: hit.a, b: hit.b });
      else chooseJoint(hit.joint, now);
      return;
    }
  }
  const joint = pick.jointAt(seen.plan, seen.places, at, seen.on.step);
  if (joint >= 0) {
    chooseJoint(joint, now);
    return;
  }
  // Any two springs that share a mass, one after the other.
  const spring = pick.springAt(seen.plan, seen.places, at, within(REACH, press.kind), broken);
  if (spring >= 0 && editing.arm >= 0 && spring !== editing.arm) {
    send({ do: "hold", a: editing.arm, b: spring });
    change({ arm: -1 });
  } else change({ arm: spring, corner: -1 });
}

/** @param {number} joint @param {number} now */
function chooseJoint(joint, now) {
  if (isTwice(joint, now)) send({ do: "turn", joint });
  else send({ do: "select", joints: [joint] });
}

/** Takes the last change back, or does it again: numbers of masses are then others. @param {"undo" | "redo"} what */
export function stepBack(what) {
  giveUp();
  perform(what);
}

// ------------------------------------------------------------------------- what the server tells
/** Begins to listen; before the pointer that takes hold of masses, and before the keys. */
export function listenToEdits() {
  window.addEventListener("pointerdown", down, true);
  window.addEventListener("pointermove", move, true);
  for (const kind of /** @type {const} */ (["pointerup", "pointercancel"])) window.addEventListener(kind, up, true);
  window.addEventListener("lostpointercapture", ({ pointerId }) => pointerId === press.id && drop(), true);
  document.addEventListener("pointerout", ({ relatedTarget }) => editing.hover && press.id < 0 && !relatedTarget && hover(null));
  window.addEventListener("contextmenu", (event) => {
    if (!editing.on || event.target !== viserCanvas()) return;
    if (press.id >= 0) {
      swallow(event);
      return;
    }
    // Some systems say so at the release, when the second button has moved the view.
    const dragged = event.pointerType === "mouse" && Math.hypot(event.clientX - second.x, event.clientY - second.y) > CLICK;
    if (dragged) return;
    const parts = partAt({ x: event.clientX, y: event.clientY }, "mouse");
    if (isNothing(parts)) return;
    swallow(event);
    send({ do: "select", ...parts });
  }, true);
  onMessage("selected", ({ masses, springs, joints }) => {
    const { chaining, chain } = editing;
    change({
      selected: { masses, springs, joints },
      chain: chaining && masses.length === 1 ? masses[0] : chain,
      chaining: false,
    });
  });
  onMessage("versions", ({ undo, redo, stiffen }) => {
    if (redo && redo !== editing.redo) giveUp(); // undone elsewhere: as in `stepBack`
    change({ undo, redo, stiffen });
  });
  // Where some are gone, the numbers of the others are different ones.
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
