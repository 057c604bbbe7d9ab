// @ts-check
/** What is drawn of an edit: what is selected, and what the pointer is doing. */
import { shown } from "../../stage/canvas.js";
import { CORNER, partAt, snapped, turnable } from "./places.js";
import { editing, onEditing } from "./editing.js";
import { wrapped } from "../../stage/draw.js";
import { restAt, restDirection } from "./joint_rest.js";
import { degrees } from "../../stage/measures.js";
import { insertMarksLayer, onMarksRedraw, sight } from "../../stage/sight.js";
import { makeSvg, set } from "../../stage/svg.js";
import { armsOf, cornersOf, crossed, turnTo } from "./pick.js";
import { massAt } from "../../ui/hands/pointer.js";

/**
 * @typedef {import("../../stage/sight.js").Sight} Sight
 * @typedef {import("./pick.js").Place} Place
 */

/** Pixels from a mass to the ring around it. */
const RING = 7;
/** From the back to the front. */
const KINDS = /** @type {const} */ (["springs", "joints", "masses", "moved", "corner", "corner-hover", "under", "rubber", "marquee", "stroke", "cut", "rest", "knob"]);
/** @typedef {typeof KINDS[number]} Kind */

/** @param {Place} at @param {number} radius */
export const circle = ({ x, y }, radius) => {
  const r = radius.toFixed(1);
  return `M${(x - radius).toFixed(1)} ${y.toFixed(1)}a${r} ${r} 0 1 0 ${(2 * radius).toFixed(1)} 0a${r} ${r} 0 1 0 ${(-2 * radius).toFixed(1)} 0`;
};

/** @param {Place} one @param {Place} two */
const lineTo = (one, two) => `M${one.x.toFixed(1)} ${one.y.toFixed(1)}L${two.x.toFixed(1)} ${two.y.toFixed(1)}`;

/** @param {Place} at @param {number} degrees anticlockwise @param {number} distance @returns {Place} */
const off = ({ x, y }, degrees, distance) => {
  const t = (degrees * Math.PI) / 180;
  return { x: x + distance * Math.cos(t), y: y - distance * Math.sin(t) };
};

/** A slice of a disc, anticlockwise from a direction. @param {Place} at @param {number} from @param {number} turn @param {number} radius */
function sector(at, from, turn, radius) {
  if (turn >= 359.9) return circle(at, radius);
  const [one, two] = [off(at, from, radius), off(at, from + turn, radius)];
  const large = turn > 180 ? 1 : 0;
  return `M${at.x.toFixed(1)} ${at.y.toFixed(1)}L${one.x.toFixed(1)} ${one.y.toFixed(1)}A${radius} ${radius} 0 ${large} 0 ${two.x.toFixed(1)} ${two.y.toFixed(1)}Z`;
}

/** Begins to draw. */
export function addEditMarks() {
  const svg = makeSvg("svg", "softrod-marks softrod-edit-marks");
  const paths = /** @type {Record<Kind, SVGPathElement>} */ (
    Object.fromEntries(KINDS.map((kind) => [kind, makeSvg("path", `softrod-edit-${kind}`, svg)]))
  );
  const words = makeSvg("text", "", svg);
  let empty = true;
  insertMarksLayer(svg);

  /** @param {Sight} seen */
  const draw = (seen) => {
    if (!editing.on && empty) return;
    const marks = editing.on ? { ...selection(seen), ...underWay(seen), ...jointMarks(seen) } : {};
    for (const kind of KINDS) set(paths[kind], { d: marks[kind] ?? "" });
    const said = editing.on ? knobText(seen) : null;
    words.textContent = said?.text ?? "";
    if (said) set(words, { x: said.at.x.toFixed(1), y: said.at.y.toFixed(1) });
    empty = !editing.on;
  };
  onMarksRedraw(draw);
  let asked = false;
  onEditing(() => {
    if (asked) return;
    asked = true;
    requestAnimationFrame(() => {
      asked = false;
      const seen = sight();
      if (seen) draw(seen);
    });
  });
}

/** @param {Sight} seen @param {number} mass @returns {Place} */
const placeOf = ({ places }, mass) => ({ x: places[2 * mass], y: places[2 * mass + 1] });
/** @param {Sight} seen @param {number} mass @param {number} [more] */
const ring = (seen, mass, more = RING) => circle(placeOf(seen, mass), seen.plan.radius[mass] * seen.on.step + more);
/** @param {Sight} seen @param {number} spring */
const bar = (seen, spring) => {
  const { springs } = seen.plan;
  return lineTo(placeOf(seen, springs[2 * spring]), placeOf(seen, springs[2 * spring + 1]));
};
/** @param {Sight} seen @param {number} joint */
function wedge(seen, joint) {
  const { tip, one, two } = armsOf(seen.plan, seen.places, joint);
  const turn = wrapped(two - one);
  return sector(placeOf(seen, tip), turn >= 0 ? one : two, Math.abs(turn), 2.6 * seen.plan.radius[tip] * seen.on.step + 4);
}

/** The parts of a kind that the picture has: what is told of another body may be a frame early. @param {Sight} seen */
function selectedIn({ plan }) {
  const { masses, springs, joints } = editing.selected;
  return {
    masses: masses.filter((i) => i < plan.radius.length),
    springs: springs.filter((s) => 2 * s < plan.springs.length),
    joints: joints.filter((j) => 4 * j < plan.joints.length),
  };
}

/** What marks the selection, and of which picture: it stays while only the pointer moves. */
const marked = { of: "", selected: editing.selected, frame: /** @type {import("../../stage/plan.js").Frame | null} */ (null), marks: {} };

/** @param {Sight} seen @returns {Partial<Record<Kind, string>>} */
function selection(seen) {
  const { selected } = editing;
  const of = [seen.on.x, seen.on.y, seen.on.step].join(" ");
  if (marked.of === of && marked.selected === selected && marked.frame === seen.frame) return marked.marks;
  const { masses, springs, joints } = selectedIn(seen);
  const marks = {
    masses: masses.map((mass) => ring(seen, mass)).join(""),
    springs: springs.map((spring) => bar(seen, spring)).join(""),
    joints: joints.map((joint) => wedge(seen, joint)).join(""),
  };
  Object.assign(marked, { of, selected, frame: seen.frame, marks });
  return marks;
}

/** @param {Sight} seen @returns {Partial<Record<Kind, string>>} */
function underWay(seen) {
  const { drag, hover, tool, chain } = editing;
  switch (drag?.kind) {
    case "marquee": {
      const { start, at } = drag;
      return { marquee: `M${start.x} ${start.y}H${at.x}V${at.y}H${start.x}Z` };
    }
    case "move":
      return drag.moved ? { moved: moved(seen, drag.dx, drag.dy) } : {};
    case "stroke": {
      const hit = crossed(seen.plan, seen.places, drag.points, shown().damage.broken);
      return {
        stroke: `M${drag.points.map(({ x, y }) => `${x.toFixed(1)} ${y.toFixed(1)}`).join("L")}`,
        cut: hit.map((spring) => bar(seen, spring)).join(""),
      };
    }
    case "line": {
      const from = drag.from >= 0 ? placeOf(seen, drag.from) : drag.start;
      const to = drag.to >= 0 ? placeOf(seen, drag.to) : drag.at;
      const end = drag.to >= 0 ? ring(seen, drag.to) : circle(to, 9);
      const begin = drag.from >= 0 ? ring(seen, drag.from) : circle(from, 9);
      return { rubber: lineTo(from, to), under: begin + end };
    }
    default:
      break;
  }
  const has = chain >= 0 && chain < seen.plan.radius.length;
  if (!hover) return has ? { under: ring(seen, chain) } : {};
  if (tool === "build") {
    const mass = massAt(hover, "mouse");
    const to = mass >= 0 ? placeOf(seen, mass) : snapped(hover, false);
    const under = mass >= 0 ? ring(seen, mass) : circle(to, 9);
    return has ? { under: under + ring(seen, chain), rubber: lineTo(placeOf(seen, chain), to) } : { under };
  }
  if (tool === "select") {
    const { masses, springs, joints } = partAt(hover, "mouse");
    return {
      under:
        masses.map((mass) => ring(seen, mass)).join("") +
        springs.map((spring) => bar(seen, spring)).join("") +
        joints.map((joint) => wedge(seen, joint)).join(""),
    };
  }
  return {};
}

/** Where the selected masses, and the springs among them, would be. @param {Sight} seen @param {number} dx @param {number} dy */
function moved(seen, dx, dy) {
  const { masses, springs, joints } = selectedIn(seen);
  const { plan } = seen;
  const all = new Set(masses);
  for (const joint of joints) springs.push(plan.joints[4 * joint], plan.joints[4 * joint + 1]);
  for (const spring of springs) all.add(plan.springs[2 * spring]).add(plan.springs[2 * spring + 1]);
  /** @param {number} mass */
  const place = (mass) => {
    const { x, y } = placeOf(seen, mass);
    return all.has(mass) ? { x: x + dx, y: y + dy } : { x, y };
  };
  let d = "";
  for (const mass of all) d += circle(place(mass), plan.radius[mass] * seen.on.step);
  for (let s = 0; 2 * s < plan.springs.length; s++) {
    const [a, b] = [plan.springs[2 * s], plan.springs[2 * s + 1]];
    if (all.has(a) || all.has(b)) d += lineTo(place(a), place(b));
  }
  return d;
}

/** @param {Sight} seen @returns {Partial<Record<Kind, string>>} */
function jointMarks(seen) {
  const { tool, corner, hover, arm, drag } = editing;
  if (tool !== "joint") return {};
  const { plan, places } = seen;
  /** @type {Partial<Record<Kind, string>>} */
  const marks = {};
  if (corner >= 0 && corner < plan.radius.length && !drag) {
    const at = placeOf(seen, corner);
    const direction = hover ? (Math.atan2(at.y - hover.y, hover.x - at.x) * 180) / Math.PI : 0;
    const near = hover && Math.hypot(hover.x - at.x, hover.y - at.y) <= CORNER;
    for (const { from, turn, joint } of cornersOf(plan, places, corner, shown().damage.broken)) {
      const on = near && turnTo(from, direction) <= turn;
      const kind = on ? "corner-hover" : "corner";
      // One that is there already shows only under the pointer.
      if (joint < 0 || on) marks[kind] = (marks[kind] ?? "") + sector(at, from + 4, Math.max(1, turn - 8), CORNER - 8);
    }
  }
  const springs = arm >= 0 && 2 * arm < plan.springs.length ? bar(seen, arm) : "";
  if (springs) marks.under = springs;
  const joint = turnable();
  if (joint >= 0) {
    const at = placeOf(seen, plan.joints[4 * joint + 2]);
    const direction = drag?.kind === "turn" ? drag.angle : restDirection(joint);
    const knob = off(at, direction, CORNER);
    marks.rest = lineTo(at, knob);
    marks.knob = circle(knob, 8);
  }
  return marks;
}

/** The rest angle beside its knob. @param {Sight} seen */
function knobText(seen) {
  const joint = turnable();
  if (joint < 0) return null;
  const { drag } = editing;
  const direction = drag?.kind === "turn" ? drag.angle : restDirection(joint);
  const at = off(placeOf(seen, seen.plan.joints[4 * joint + 2]), direction, CORNER + 34);
  return { at, text: `rests at ${degrees(restAt(joint, direction))}` };
}
