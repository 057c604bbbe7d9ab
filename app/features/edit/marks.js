// @ts-check
/** The marks of an edit: what is selected, and what the pointer is doing. */
import { CORNER, WEDGE, armsOf, cornersOf, crossed, directionOf, distance, endsOf, knobOf, off, partAt, placeOf, restAt, snapped, springsOf, turnable, turnTo } from "./pick.js";
import { crossAt } from "./cross.js";
import { editing, onEditing } from "./editing.js";
import { wrapped } from "../../stage/draw.js";
import { insertMarksLayer, onMarksRedraw, sight } from "../../stage/sight.js";
import { makeSvg, set } from "../../stage/svg.js";
import { degrees } from "../../stage/measures.js";
import { massAt } from "../../ui/hands/pointer.js";
import { say } from "../../words/words.js";

/**
 * @typedef {import("../../stage/sight.js").Sight} Sight
 * @typedef {import("./pick.js").Parts} Parts
 * @typedef {import("./pick.js").Place} Place
 */

/** Pixels from a mass to the ring around it. */
const RING = 7;
/** Radius of the ring around a place where a mass would be created, pixels. */
const NEW_RING = 9;
/** Half the length of the arms of the cross of the keys, pixels. */
const CROSS = 16;
/** From the back to the front. */
const KINDS = /** @type {const} */ (["springs", "joints", "masses", "moved", "corner", "corner-hover", "under", "rubber", "marquee", "stroke", "cut", "rest", "knob", "cross"]);
/** Paths of marks. @typedef {Partial<Record<typeof KINDS[number], string>>} Marks */

/** @param {Place} at */
const text = ({ x, y }) => `${x.toFixed(1)} ${y.toFixed(1)}`;

/** @param {Place} at @param {number} radius */
const circle = ({ x, y }, radius) => {
  const r = radius.toFixed(1);
  return `M${text({ x: x - radius, y })}a${r} ${r} 0 1 0 ${(2 * radius).toFixed(1)} 0a${r} ${r} 0 1 0 ${(-2 * radius).toFixed(1)} 0`;
};

/** @param {Place} one @param {Place} two */
const line = (one, two) => `M${text(one)}L${text(two)}`;

/** A slice of a disc, anticlockwise from a direction. @param {Place} at @param {number} from @param {number} turn @param {number} radius */
function sector(at, from, turn, radius) {
  if (turn >= 359.9) return circle(at, radius);
  const arc = `A${radius} ${radius} 0 ${turn > 180 ? 1 : 0} 0 ${text(off(at, from + turn, radius))}`;
  return `${line(at, off(at, from, radius))}${arc}Z`;
}

/** Adds the marks. */
export function addEditMarks() {
  const svg = makeSvg("svg", "softrod-marks softrod-edit-marks");
  const paths = KINDS.map((kind) => makeSvg("path", `softrod-edit-${kind}`, svg));
  const words = makeSvg("text", "", svg);
  let empty = true;
  insertMarksLayer(svg);

  /** @param {Sight} seen */
  const draw = (seen) => {
    if (!editing.on && empty) return;
    const marks = editing.on ? { ...selection(seen), ...underWay(seen), ...jointMarks(seen), ...crossMark(seen) } : {};
    KINDS.forEach((kind, i) => set(paths[i], { d: marks[kind] ?? "" }));
    writeRestAngle(seen, words);
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

/** @param {Sight} seen @param {number} mass */
const ring = (seen, mass) => circle(placeOf(seen, mass), seen.plan.radius[mass] * seen.on.step + RING);
/** @param {Sight} seen @param {number} spring */
const bar = (seen, spring) => {
  const [a, b] = endsOf(seen, spring);
  return line(placeOf(seen, a), placeOf(seen, b));
};
/** @param {Sight} seen @param {number} joint */
function wedge(seen, joint) {
  const { tip, one, two } = armsOf(seen, joint);
  const turn = wrapped(two - one);
  return sector(placeOf(seen, tip), turn >= 0 ? one : two, Math.abs(turn), WEDGE * seen.plan.radius[tip] * seen.on.step + 4);
}

/** The selected parts that the picture has: a selection in another body may arrive a frame early. @param {Sight} seen @returns {Parts} */
function selectedIn({ plan }) {
  const { masses, springs, joints } = editing.selected;
  return {
    masses: masses.filter((i) => i < plan.radius.length),
    springs: springs.filter((s) => 2 * s < plan.springs.length),
    joints: joints.filter((j) => 4 * j < plan.joints.length),
  };
}

/** @param {Sight} seen @param {Parts} parts */
const marksOf = (seen, { masses, springs, joints }) => ({
  masses: masses.map((mass) => ring(seen, mass)).join(""),
  springs: springs.map((spring) => bar(seen, spring)).join(""),
  joints: joints.map((joint) => wedge(seen, joint)).join(""),
});

/** The marks of the selection, and what they were drawn for: they stay while only the pointer moves. */
const cached = { view: "", selected: editing.selected, frame: /** @type {import("../../stage/plan.js").Frame | null} */ (null), marks: {} };

/** @param {Sight} seen @returns {Marks} */
function selection(seen) {
  const { selected } = editing;
  const { on, frame } = seen;
  const view = [on.x, on.y, on.step].join(" ");
  if (cached.view !== view || cached.selected !== selected || cached.frame !== frame) {
    Object.assign(cached, { view, selected, frame, marks: marksOf(seen, selectedIn(seen)) });
  }
  return cached.marks;
}

/** @param {Sight} seen @returns {Marks} */
function underWay(seen) {
  const { drag, hover, tool, chain } = editing;
  /** An end of a line, on a mass or at a place. @param {number} mass @param {Place} place */
  const end = (mass, place) =>
    mass >= 0 ? { at: placeOf(seen, mass), under: ring(seen, mass) } : { at: place, under: circle(place, NEW_RING) };
  switch (drag?.kind) {
    case "marquee": {
      const { start, at } = drag;
      return { marquee: `M${start.x} ${start.y}H${at.x}V${at.y}H${start.x}Z` };
    }
    case "move":
      return drag.moved ? { moved: moved(seen, drag.dx, drag.dy) } : {};
    case "stroke":
      return {
        stroke: `M${drag.points.map(text).join("L")}`,
        cut: crossed(seen, drag.points).map((spring) => bar(seen, spring)).join(""),
      };
    case "line": {
      const [from, to] = [end(drag.from, drag.start), end(drag.to, drag.at)];
      return { rubber: line(from.at, to.at), under: from.under + to.under };
    }
    default:
      break;
  }
  const start = chain >= 0 && chain < seen.plan.radius.length ? end(chain, { x: 0, y: 0 }) : null;
  if (hover && tool === "build") {
    const to = end(massAt(hover, "mouse"), snapped(hover, false));
    return start ? { under: to.under + start.under, rubber: line(start.at, to.at) } : { under: to.under };
  }
  if (hover && tool === "select") return { under: Object.values(marksOf(seen, partAt(hover, "mouse"))).join("") };
  return start && !hover ? { under: start.under } : {};
}

/** Where the selected masses and their springs would be. @param {Sight} seen @param {number} dx @param {number} dy */
function moved(seen, dx, dy) {
  const { masses, springs, joints } = selectedIn(seen);
  const { plan, on } = seen;
  for (const joint of joints) springs.push(plan.joints[4 * joint], plan.joints[4 * joint + 1]);
  const all = new Set([...masses, ...springs.flatMap((spring) => endsOf(seen, spring))]);
  /** @param {number} mass */
  const place = (mass) => {
    const { x, y } = placeOf(seen, mass);
    return all.has(mass) ? { x: x + dx, y: y + dy } : { x, y };
  };
  const circles = [...all].map((mass) => circle(place(mass), plan.radius[mass] * on.step));
  const lines = springsOf(seen).filter(({ ends }) => ends.some((mass) => all.has(mass))).map(({ ends: [a, b] }) => line(place(a), place(b)));
  return [...circles, ...lines].join("");
}

/** @param {Sight} seen @returns {Marks} */
function jointMarks(seen) {
  const { tool, corner, hover, arm, drag } = editing;
  if (tool !== "joint") return {};
  const { plan } = seen;
  /** @type {Marks} */
  const marks = {};
  if (corner >= 0 && corner < plan.radius.length && !drag) {
    const at = placeOf(seen, corner);
    const direction = hover && distance(hover, at) <= CORNER ? directionOf(at, hover) : NaN;
    for (const { from, turn, joint } of cornersOf(seen, corner)) {
      const isUnder = turnTo(from, direction) <= turn;
      const kind = isUnder ? "corner-hover" : "corner";
      // A corner that has a joint is shown only under the pointer.
      if (joint < 0 || isUnder) marks[kind] = (marks[kind] ?? "") + sector(at, from + 4, Math.max(1, turn - 8), CORNER - 8);
    }
  }
  if (arm >= 0 && 2 * arm < plan.springs.length) marks.under = bar(seen, arm);
  const joint = turnable();
  if (joint >= 0) {
    const { tip, knob } = knobOf(seen, joint);
    marks.rest = line(tip, knob);
    marks.knob = circle(knob, 8);
  }
  return marks;
}

/** The cross of the keys. @param {Sight} seen @returns {Marks} */
function crossMark(seen) {
  const at = crossAt(seen);
  return at ? { cross: `M${text({ x: at.x - CROSS, y: at.y })}h${2 * CROSS}M${text({ x: at.x, y: at.y - CROSS })}v${2 * CROSS}` } : {};
}

/** Writes the rest angle next to its knob, if there is one. @param {Sight} seen @param {SVGTextElement} words */
function writeRestAngle(seen, words) {
  const joint = editing.on ? turnable() : -1;
  words.textContent = "";
  if (joint < 0) return;
  const { tip, direction } = knobOf(seen, joint);
  const { x, y } = off(tip, direction, CORNER + 34);
  words.textContent = say("edit-rests-at", { angle: degrees(restAt(joint, direction)) });
  set(words, { x: x.toFixed(1), y: y.toFixed(1) });
}
