// @ts-check
/**
 * The strip of muscles over the bar of time: a beat from left to right, with a mark for every muscle, which is dragged
 * sideways for when and up or down for how far it moves. The present moment runs across it. It is made when a body has
 * muscles for the first time.
 */
import { onPicture, shown } from "../../stage/canvas.js";
import { has, onMessage, pageState, send } from "../../wire/channel.js";
import { change, editing, onEditing } from "../edit/editing.js";
import { beatsAt, countMuscles } from "../../stage/swing.js";
import { make, makeButton } from "../../ui/dialog.js";
import { floorOf } from "../../stage/sight.js";
import { makeSvg, set } from "../../stage/svg.js";
import { across, inWords, markAt, marksOf, movedBy, nameOf, otherCrests, placeOf, stepOf, wayOf, waveOf } from "./marks.js";
import { addMuscleMarks } from "./body_marks.js";
import { timeNow } from "../../ui/clock.js";
import { tuning } from "./tuning.js";
import { canvasBox } from "../../ui/viser/viser.js";

/**
 * @typedef {import("./marks.js").Mark} Mark
 * @typedef {import("./marks.js").Way} Way
 */

/** Pixels around a mark, for a mouse and for a finger. */
const REACH = { mouse: 14, pen: 18, touch: 30 };
/** Pixels that a drag has to go before it counts, along each way; then all of it does. */
const SLACK = 5;
/** Milliseconds between two things that a drag tells the server. */
const TELL_EVERY = 60;
/** Milliseconds after a drag for which marks stay where they were left: what the server tells may still be older. */
const SETTLES = 500;
/** Beats by which an arrow moves a mark, and parts of the full height; and how much less with Shift. */
const [LATER, HIGHER, FINE] = [1 / 36, 0.05, 0.2];
/** Waves that are drawn, beside those of marks that are selected. */
const MAX_WAVES = 60;
/** Waves of selected marks that are drawn boldly. */
const FEW = 5;
/** Pixels of height below which the body needs the room more than the strip. */
const LOW = 400;
/** Milliseconds between two looks at the clock while the body is at rest. */
const CLOCK_EVERY = 100;

const HOW = "Drag a mark sideways: when it moves. Up or down: how far.";
const NOWHERE = { later: 0, stretch: 0, turn: 0 };
/** @type {Record<string, [number, number]>} */
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

/** Whether a mark's part is selected. @param {Mark} mark */
const isSelected = ({ joint, part }) => editing.selected[joint ? "joints" : "springs"].includes(part);

/** Selects the part of a mark. @param {Mark} mark @param {boolean} toggle whether it changes sides, and the others stay */
function select({ joint, part }, toggle) {
  const kind = joint ? "joints" : "springs";
  const before = editing.selected[kind];
  send({ do: "select", [kind]: [part], ...(toggle && { toggle }) });
  // So that it can be moved at once: the server says the same.
  const others = toggle ? editing.selected : { masses: [], springs: [], joints: [] };
  const parts = toggle ? (before.includes(part) ? before.filter((one) => one !== part) : [...before, part]) : [part];
  change({ selected: { ...others, [kind]: parts } });
}

function makeStrip() {
  const strip = make("div", "softrod-strip softrod-muscles");
  strip.setAttribute("role", "group");
  strip.ariaLabel = "Muscles";
  const head = make("div", "softrod-strip-head softrod-muscles-head");
  const fold = makeButton("Muscles", () => setOpen(wave.hasAttribute("hidden")), "softrod-muscles-fold");
  const says = make("span", "softrod-strip-says softrod-muscles-says", HOW);
  const controls = tuning();
  head.append(fold, says, ...controls.elements);
  const wave = makeSvg("svg", "softrod-muscles-wave");
  wave.removeAttribute("aria-hidden");
  const axis = makeSvg("path", "softrod-muscles-axis", wave);
  const waves = makeSvg("path", "softrod-muscles-waves", wave);
  const chosen = makeSvg("path", "softrod-muscles-chosen", wave);
  const now = makeSvg("path", "softrod-muscles-now", wave);
  const others = makeSvg("path", "softrod-muscles-others", wave);
  const group = makeSvg("g", "", wave);
  strip.append(head, wave);
  document.querySelector(".softrod-transport")?.before(strip);
  const onBody = addMuscleMarks();

  /** @type {Mark[]} */
  let marks = [];
  /** @type {Map<string, SVGGElement>} */
  const elements = new Map();
  let box = { width: 0, height: 0 };
  /** The mark under the pointer. */
  let hovered = "";
  /** The mark that the Tab key comes to. */
  let reached = "";
  /** What is dragged, and how far. @type {{id: number, held: Mark, all: Mark[], x: number, y: number, moved: boolean, along: {x: boolean, y: boolean}, toggles: boolean, alone: boolean, way: Way} | null} */
  let drag = null;
  /** What was dragged, where it was left. @type {{all: Mark[], way: Way} | null} */
  let left = null;
  /** How far the server knows of. */
  let known = NOWHERE;
  let [telling, settling] = [0, 0];

  /** @param {boolean} open */
  const setOpen = (open) => {
    wave.toggleAttribute("hidden", !open);
    fold.ariaExpanded = String(open);
    drawMarks();
  };

  /** As marks are shown: those that are dragged where they are dragged to. @returns {Mark[]} */
  const present = () => {
    const moving = drag ?? left;
    if (!moving) return marks;
    const moved = new Map(moving.all.map((mark) => [mark.key, movedBy(mark, moving.way)]));
    return marks.map((mark) => moved.get(mark.key) ?? mark);
  };

  const drawMarks = () => {
    const all = present();
    const some = all.filter(isSelected);
    controls.show(some);
    const pointed = all.find(({ key }) => key === (drag?.held.key ?? hovered));
    const focused = all.find(({ key }) => elements.get(key) === document.activeElement);
    const named = pointed ?? focused ?? (some.length === 1 ? some[0] : null);
    const words = named ? `${nameOf(named)}: ${inWords(named)}` : some.length ? `${some.length} muscles selected` : HOW;
    if (says.textContent !== words) says.textContent = words;
    onBody.show([...(pointed ? [pointed] : []), ...(editing.on ? [] : some)]);
    if (wave.hasAttribute("hidden") || !box.width) return;
    const middle = (box.height / 2).toFixed(1);
    set(axis, { d: `M0 ${middle}H${box.width}` });
    const bold = all.filter((mark) => mark === pointed || mark === focused || isSelected(mark));
    const faint = all.filter((mark) => !bold.includes(mark)).slice(0, MAX_WAVES);
    set(waves, { d: faint.map((mark) => waveOf(mark, box)).join("") });
    chosen.classList.toggle("softrod-muscles-many", bold.length > FEW);
    set(chosen, { d: bold.map((mark) => waveOf(mark, box)).join("") });
    const repeated = all.flatMap((mark) => otherCrests(mark, box).map((x) => `M${x.toFixed(1)} ${placeOf(mark, box).y.toFixed(1)}h0`));
    set(others, { d: repeated.join("") });
    if (!all.some(({ key }) => key === reached)) reached = all[0]?.key ?? "";
    for (const mark of all) {
      const element = elementOf(mark);
      const { x, y } = placeOf(mark, box);
      set(element, {
        transform: `translate(${x.toFixed(1)} ${y.toFixed(1)})`,
        tabindex: mark.key === reached ? 0 : -1,
        "aria-label": `Muscle of ${nameOf(mark)}${isSelected(mark) ? ", selected" : ""}`,
        "aria-valuenow": Math.round(100 * mark.crest),
        "aria-valuetext": inWords(mark),
      });
      element.classList.toggle("softrod-muscle-on", isSelected(mark));
      element.classList.toggle("softrod-muscle-seen", mark === pointed);
    }
  };

  /** @param {Mark} mark */
  const elementOf = ({ key, joint }) => {
    const before = elements.get(key);
    if (before) return before;
    const element = makeSvg("g", "softrod-muscle", group);
    set(element, { role: "slider", "aria-valuemin": 0, "aria-valuemax": 100 });
    makeSvg("path", "", element).setAttribute("d", joint ? "M0 -9L9 0L0 9L-9 0Z" : "M-7 0a7 7 0 1 0 14 0a7 7 0 1 0 -14 0");
    element.addEventListener("keydown", (event) => press(key, event));
    for (const kind of ["focus", "blur"]) element.addEventListener(kind, drawMarks);
    elements.set(key, element);
    return element;
  };

  const drawNow = () => {
    const { pictured: plan } = shown();
    if (!plan || wave.hasAttribute("hidden") || !box.width) return;
    const beats = beatsAt(plan, timeNow());
    const x = across(beats - Math.floor(beats), box).toFixed(1);
    set(now, { d: `M${x} 0V${box.height}` });
  };

  /** Tells the server how far marks have come since it was told last. */
  const tell = () => {
    clearTimeout(telling);
    telling = 0;
    const { way } = drag ?? left ?? { way: NOWHERE };
    const more = { later: way.later - known.later, stretch: way.stretch - known.stretch, turn: way.turn - known.turn };
    if (more.later || more.stretch || more.turn) send({ do: "moveMuscles", ...more });
    known = way;
  };

  // ----------------------------------------------------------------------- pointers
  /** @param {PointerEvent} event */
  const placeIn = ({ clientX, clientY }) => {
    const { left: x, top: y } = wave.getBoundingClientRect();
    return { x: clientX - x, y: clientY - y };
  };
  /** @param {PointerEvent} event */
  const under = (event) => {
    const reach = REACH[/** @type {keyof typeof REACH} */ (event.pointerType)] ?? REACH.mouse;
    const all = present();
    // Of marks in one place, one that is selected first.
    const some = all.filter(isSelected);
    return markAt(some, box, placeIn(event), reach / 2) ?? markAt(all, box, placeIn(event), reach);
  };

  wave.addEventListener("pointerdown", (event) => {
    if (event.button !== 0 || drag) return;
    event.preventDefault();
    const mark = under(event);
    if (!mark) {
      if (editing.selected.springs.length || editing.selected.joints.length) send({ do: "select" });
      return;
    }
    clearTimeout(settling);
    left = null;
    const was = isSelected(mark);
    if (!was) select(mark, event.shiftKey);
    reached = mark.key;
    const held = marks.find(({ key }) => key === mark.key) ?? mark;
    const toggles = was && event.shiftKey;
    known = NOWHERE;
    drag = {
      id: event.pointerId, held, all: marks.filter(isSelected), ...placeIn(event), moved: false,
      along: { x: false, y: false }, toggles, alone: was && !event.shiftKey, way: NOWHERE,
    };
    wave.setPointerCapture(event.pointerId);
    send({ do: "visit" });
    drawMarks();
  });
  wave.addEventListener("pointermove", (event) => {
    if (!drag) {
      const key = event.pointerType === "touch" ? "" : (under(event)?.key ?? "");
      wave.classList.toggle("softrod-muscles-grab", key !== "");
      if (key === hovered) return;
      hovered = key;
      drawMarks();
      return;
    }
    if (event.pointerId !== drag.id) return;
    const at = placeIn(event);
    const ways = { x: at.x - drag.x, y: at.y - drag.y };
    // Whichever way it goes, it goes whole; along the other one it stays until it leaves the slack there, too.
    drag.along.x ||= Math.abs(ways.x) > SLACK;
    drag.along.y ||= Math.abs(ways.y) > SLACK;
    if (!drag.along.x && !drag.along.y) return;
    drag.moved = true;
    drag.way = wayOf(drag.held, drag.all, box, drag.along.x ? ways.x : 0, drag.along.y ? ways.y : 0);
    telling ||= setTimeout(tell, TELL_EVERY);
    drawMarks();
  });
  /** @param {PointerEvent} event */
  const up = (event) => {
    if (!drag || event.pointerId !== drag.id) return;
    const { held, moved, toggles, alone, all, way } = drag;
    if (moved) tell();
    else if (toggles) select(held, true);
    else if (alone && all.length > 1) select(held, false);
    left = moved ? { all, way } : null;
    drag = null;
    settling = setTimeout(() => {
      left = null;
      drawMarks();
    }, SETTLES);
    drawMarks();
  };
  wave.addEventListener("pointerup", up);
  wave.addEventListener("pointercancel", up);
  wave.addEventListener("pointerleave", () => {
    if (drag || !hovered) return;
    hovered = "";
    drawMarks();
  });

  // ----------------------------------------------------------------------- keys
  /** @param {string} key of a mark @param {KeyboardEvent} event */
  const press = (key, event) => {
    const { ctrlKey, metaKey, altKey, shiftKey } = event;
    const mark = marks.find((one) => one.key === key);
    if (!mark || ctrlKey || metaKey || altKey) return;
    const arrow = ARROWS[event.key];
    if (arrow) {
      if (!isSelected(mark)) select(mark, false);
      const fine = shiftKey ? FINE : 1;
      send({ do: "moveMuscles", ...stepOf(marks.filter(isSelected), arrow[0] * LATER * fine, arrow[1] * HIGHER * fine), keys: true });
    } else if (event.key === " " || event.key === "Enter") select(mark, event.key === " ");
    else {
      const order = [...marks].sort((one, two) => one.crest - two.crest || (one.key < two.key ? -1 : 1));
      const at = order.indexOf(mark);
      const to = { PageDown: at + 1, PageUp: at - 1, Home: 0, End: order.length - 1 }[event.key];
      const next = to === undefined ? undefined : order[to];
      if (to === undefined) return;
      if (next) {
        reached = next.key;
        elements.get(reached)?.focus();
      }
    }
    event.preventDefault();
    event.stopPropagation();
  };

  new ResizeObserver(() => {
    box = { width: wave.clientWidth, height: wave.clientHeight };
    drawMarks();
    drawNow();
  }).observe(wave);
  let { selected } = editing;
  let { on } = editing;
  onEditing(() => {
    if (editing.selected === selected && editing.on === on) return; // not at every move of the pointer
    ({ selected, on } = editing);
    drawMarks();
  });
  setInterval(() => pageState().rest && !strip.hidden && drawNow(), CLOCK_EVERY);
  const canvas = canvasBox();
  setOpen(!canvas || floorOf(canvas) - canvas.top + strip.offsetHeight >= LOW);
  return {
    /** Shows the muscles of another plan, or nothing. @param {import("../../stage/plan.js").Plan} plan */
    take: (plan) => {
      marks = marksOf(plan);
      strip.hidden = !marks.length || !has("edit");
      const keys = new Set(marks.map(({ key }) => key));
      for (const [key, element] of elements) {
        if (keys.has(key)) continue;
        element.remove();
        elements.delete(key);
      }
      if (!keys.has(hovered)) hovered = "";
      controls.showTempo(plan.muscles[0] ?? 0);
      if (strip.hidden) onBody.show([]);
      else drawMarks();
    },
    drawNow,
  };
}

/** Begins to look for muscles. */
function begin() {
  /** @type {ReturnType<typeof makeStrip> | null} */
  let strip = null;
  /** @type {import("../../stage/plan.js").Plan | null} */
  let taken = null;
  const look = () => {
    const { pictured: plan } = shown();
    if (!plan) return;
    if (plan !== taken) {
      if (!strip && !(countMuscles(plan) && has("edit"))) return;
      strip ??= makeStrip();
      strip.take(plan);
      taken = plan;
    }
    strip?.drawNow();
  };
  onPicture(look);
  onMessage("pageState", look);
}

/** @type {import("../../ui/feature.js").Feature<"muscles">} */
export default { commands: {}, begin };
