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
import { ARROWS } from "../../ui/hands/arrow_keys.js";
import { takePointer } from "../../ui/hands/take.js";
import { isSheet } from "../../ui/gui/panel.js";
import { floorOf } from "../../stage/dock.js";
import { makeSvg, set } from "../../stage/svg.js";
import { makeStrip } from "../../ui/strip.js";
import { across, clearest, inWords, markAt, marksOf, movedBy, nameOf, otherCrests, placeOf, singles, stepOf, wayOf, waveOf } from "./marks.js";
import { MuscleMarks } from "./body_marks.js";
import { timeNow } from "../../ui/clock.js";
import { tuning } from "./tuning.js";
import { canvasBox } from "../../ui/viser/viser.js";
import { say } from "../../words/words.js";

/**
 * @typedef {import("./marks.js").Mark} Mark
 * @typedef {import("./marks.js").Dot} Dot
 * @typedef {import("./marks.js").Way} Way
 * @typedef {{all: Mark[], way: Way}} Move marks as they were, and how far they are moved
 * @typedef {Move & {id: number, held: Dot, x: number, y: number, moved: boolean, along: {x: boolean, y: boolean}, toggles: boolean, alone: boolean}} Drag
 */

/** Pixels around a mark that are pressed as it is, by kinds of pointers. */
const REACH = { mouse: 14, pen: 18, touch: 30 };
/** Pixels that a drag has to go before it counts, in each direction; then all of it does. */
const SLACK = 5;
/** Milliseconds between two messages of a drag. */
const SEND_EVERY = 60;
/** Milliseconds after a drag for which marks stay where they were left: what the server sends may still be older. */
const SETTLES = 500;
/** Beats by which an arrow key moves a mark. */
const LATER = 1 / 36;
/** Part of the full height by which an arrow key moves a mark. */
const HIGHER = 0.05;
/** Part of both with Shift. */
const FINE = 0.2;
/** Waves that are drawn, in addition to those of selected marks. */
const MAX_WAVES = 60;
/** Bold waves above which they are drawn thinner. */
const FEW = 5;
/** Pixels of height below which the body needs the room more than the strip. */
const MIN_ROOM = 400;
/** Pixels of width for each muscle below which they are moved in groups, and about those between two groups. */
const CROWDED = 24;
const APART = 44;
/** Milliseconds between two looks at the clock while the body is at rest. */
const CLOCK_EVERY = 100;

const NOWHERE = { later: 0, stretch: 0, turn: 0 };
const DIAMOND = "M0 -9L9 0L0 9L-9 0Z";
const DISC = "M-7 0a7 7 0 1 0 14 0a7 7 0 1 0 -14 0";
const GROUP = "M-13 0a13 13 0 1 0 26 0a13 13 0 1 0 -26 0";

/** Whether a muscle is selected. @param {Mark} mark */
const isChosen = ({ joint, part }) => editing.selected[joint ? "joints" : "springs"].includes(part);
/** Whether all muscles of a dot are. @param {Dot} dot */
const isSelected = ({ members }) => members.every(isChosen);

/** Selects the muscles of a dot. @param {Dot} dot @param {boolean} toggle whether they are selected or deselected, and the others stay */
function select(dot, toggle) {
  const kind = dot.joint ? "joints" : "springs";
  const before = editing.selected[kind];
  const own = dot.members.map(({ part }) => part);
  const off = toggle && isSelected(dot);
  // Of a group that is selected in part, the rest is selected, too.
  const changed = toggle && !off ? own.filter((part) => !before.includes(part)) : own;
  send({ do: "select", [kind]: changed, ...(toggle && { toggle }) });
  // So that it can be moved at once: the server says the same.
  const others = toggle ? editing.selected : { masses: [], springs: [], joints: [] };
  const parts = !toggle ? own : off ? before.filter((one) => !own.includes(one)) : [...before, ...changed];
  change({ selected: { ...others, [kind]: parts } });
}

class MuscleStrip {
  strip = makeStrip("muscles", say("muscles-strip"));
  fold = makeButton(say("muscles-strip"), () => this.setOpen(!this.isOpen), "softrod-muscles-fold");
  kinds = make("div", "softrod-segments");
  grouped = makeButton("", () => this.setGrouped(true), "");
  alone = makeButton("", () => this.setGrouped(false), "");
  controls = tuning();
  onBody = new MuscleMarks();
  wave = makeSvg("svg", "softrod-muscles-wave");
  axis = makeSvg("path", "softrod-muscles-axis", this.wave);
  waves = makeSvg("path", "softrod-muscles-waves", this.wave);
  bold = makeSvg("path", "softrod-muscles-chosen", this.wave);
  now = makeSvg("path", "softrod-muscles-now", this.wave);
  others = makeSvg("path", "softrod-muscles-others", this.wave);
  group = makeSvg("g", "", this.wave);
  /** @type {Mark[]} */
  marks = [];
  /** Whether many muscles are shown in groups. */
  isGrouped = true;
  /** @type {Map<string, SVGGElement>} */
  elements = new Map();
  box = { width: 0, height: 0 };
  /** The mark under the pointer. */
  hovered = "";
  /** The mark that the Tab key comes to. */
  tabbed = "";
  /** @type {Drag | null} */
  drag = null;
  /** The last drag, where it was left. @type {Move | null} */
  left = null;
  /** How far the server knows of. */
  known = NOWHERE;
  /** Timers of messages, and of the marks that were left. */
  sending = 0;
  settling = 0;

  constructor() {
    const { wave, strip } = this;
    wave.removeAttribute("aria-hidden");
    strip.head.prepend(this.fold);
    strip.foldsBy(() => this.setOpen(false));
    this.kinds.setAttribute("role", "group");
    this.kinds.ariaLabel = say("muscles-kinds");
    this.kinds.append(this.grouped, this.alone);
    strip.head.append(this.kinds, ...this.controls.elements);
    strip.strip.append(wave);
    wave.addEventListener("pointerdown", (event) => this.down(event));
    wave.addEventListener("pointermove", (event) => (this.drag ? this.move(event, this.drag) : this.hover(event)));
    wave.addEventListener("pointerup", (event) => this.up(event));
    wave.addEventListener("pointercancel", (event) => this.up(event));
    wave.addEventListener("pointerleave", () => !this.drag && this.point(""));
    new ResizeObserver(() => {
      this.box = { width: wave.clientWidth, height: wave.clientHeight };
      this.drawMarks();
      this.drawNow();
    }).observe(wave);
    let { selected, on } = editing;
    onEditing(() => {
      if (editing.selected === selected && editing.on === on) return; // not at every move of the pointer
      ({ selected, on } = editing);
      this.drawMarks();
    });
    setInterval(() => pageState().rest && !strip.strip.hidden && this.drawNow(), CLOCK_EVERY);
  }

  /** Shows the muscles of another plan, or nothing. @param {import("../../stage/plan.js").Plan} plan */
  take(plan) {
    this.marks = marksOf(plan);
    const isShown = this.marks.length > 0 && has("edit");
    this.strip.show(isShown);
    this.strip.spread(isShown && this.isOpen);
    if (!this.fold.ariaExpanded) {
      const canvas = canvasBox();
      const isRoomy = !canvas || floorOf(canvas) - canvas.top + this.strip.strip.offsetHeight >= MIN_ROOM;
      this.setOpen(isRoomy && !isSheet());
    }
    this.controls.showTempo(plan.muscles[0] ?? 0);
    if (isShown) this.drawMarks();
    else this.onBody.show([]);
  }

  get isOpen() {
    return !this.wave.hasAttribute("hidden");
  }

  /** @param {boolean} open */
  setOpen(open) {
    this.wave.toggleAttribute("hidden", !open);
    this.fold.ariaExpanded = String(open);
    this.strip.spread(open);
    this.drawMarks();
  }

  /** @param {boolean} on */
  setGrouped(on) {
    this.isGrouped = on;
    send({ do: "visit" });
    this.drawMarks();
  }

  // ----------------------------------------------------------------------- what is drawn
  /** Dots for muscles: groups where there is too little room for each. @param {Mark[]} marks */
  dotsOf(marks) {
    const { width } = this.box;
    const groups = width && CROWDED * marks.length > width ? clearest(marks, Math.ceil((APART * marks.length) / width), this.box) : [];
    const isCrowded = groups.length > 0 && groups.length < marks.length;
    this.kinds.hidden = !isCrowded || !this.isOpen;
    if (!isCrowded) return singles(marks);
    this.grouped.textContent = say("muscles-kinds.groups", { count: String(groups.length) });
    this.alone.textContent = say("muscles-kinds.muscles", { count: String(marks.length) });
    this.grouped.ariaPressed = String(this.isGrouped);
    this.alone.ariaPressed = String(!this.isGrouped);
    return this.isGrouped ? groups : singles(marks);
  }

  /** The dots as they are shown: those that are dragged where they are dragged to. */
  present() {
    const move = this.drag ?? this.left;
    const moved = new Map(move?.all.map((mark) => [mark.key, movedBy(mark, move.way)]));
    return this.dotsOf(this.marks.map((mark) => moved.get(mark.key) ?? mark));
  }

  /** Removes the elements of dots that are gone. @param {Dot[]} all */
  clean(all) {
    const keys = new Set(all.map(({ key }) => key));
    for (const [key, element] of this.elements) {
      if (keys.has(key)) continue;
      element.remove();
      this.elements.delete(key);
    }
    if (!keys.has(this.hovered)) this.hovered = "";
  }

  drawMarks() {
    const all = this.present(), { box } = this;
    this.clean(all);
    const some = all.flatMap(({ members }) => members).filter(isChosen);
    const chosen = all.filter(isSelected);
    this.controls.show(some);
    const pointed = all.find(({ key }) => key === (this.drag?.held.key ?? this.hovered));
    const focused = all.find(({ key }) => this.elements.get(key) === document.activeElement);
    const named = pointed ?? focused ?? (chosen.length === 1 && chosen[0].members.length === some.length ? chosen[0] : null);
    const told = some.length ? say("muscles-selected", { count: some.length }) : say("muscles-how");
    const pointedAt = named && say("muscles-pointed", { muscle: nameOf(named), moves: inWords(named) });
    const words = this.isOpen ? (pointedAt ?? told) : "";
    if (this.strip.says.textContent !== words) this.strip.says.textContent = words;
    this.onBody.show([...(pointed?.members ?? []), ...(editing.on ? [] : some)]);
    if (!this.isOpen || !box.width) return;
    set(this.axis, { d: `M0 ${(box.height / 2).toFixed(1)}H${box.width}` });
    const bold = all.filter((mark) => mark === pointed || mark === focused || isSelected(mark));
    const faint = all.filter((mark) => !bold.includes(mark)).slice(0, MAX_WAVES);
    set(this.waves, { d: faint.map((mark) => waveOf(mark, box)).join("") });
    this.bold.classList.toggle("softrod-muscles-many", bold.length > FEW);
    set(this.bold, { d: bold.map((mark) => waveOf(mark, box)).join("") });
    const repeated = all.flatMap((mark) => otherCrests(mark, box).map((x) => `M${x.toFixed(1)} ${placeOf(mark, box).y.toFixed(1)}h0`));
    set(this.others, { d: repeated.join("") });
    if (!all.some(({ key }) => key === this.tabbed)) this.tabbed = all[0]?.key ?? "";
    for (const mark of all) this.drawMark(mark, mark === pointed);
  }

  /** @param {Dot} mark @param {boolean} isPointed */
  drawMark(mark, isPointed) {
    const element = this.elements.get(mark.key) ?? this.newMark(mark);
    const { x, y } = placeOf(mark, this.box);
    set(element, {
      transform: `translate(${x.toFixed(1)} ${y.toFixed(1)})`,
      tabindex: mark.key === this.tabbed ? 0 : -1,
      "aria-label": say(isSelected(mark) ? "muscles-mark.selected" : "muscles-mark", { muscle: nameOf(mark) }),
      "aria-valuenow": Math.round(100 * mark.crest),
      "aria-valuetext": inWords(mark),
    });
    element.classList.toggle("softrod-muscle-on", isSelected(mark));
    element.classList.toggle("softrod-muscle-seen", isPointed);
  }

  /** @param {Dot} dot */
  newMark({ key, joint, number }) {
    const element = makeSvg("g", "softrod-muscle", this.group);
    set(element, { role: "slider", "aria-valuemin": 0, "aria-valuemax": 100 });
    makeSvg("path", "", element).setAttribute("d", number ? GROUP : joint ? DIAMOND : DISC);
    if (number) makeSvg("text", "", element).textContent = number;
    element.addEventListener("keydown", (event) => this.press(key, event));
    for (const kind of ["focus", "blur"]) element.addEventListener(kind, () => this.drawMarks());
    this.elements.set(key, element);
    return element;
  }

  /** Draws the present moment. */
  drawNow() {
    const { pictured: plan } = shown();
    if (!plan || !this.isOpen || !this.box.width) return;
    const beats = beatsAt(plan, timeNow());
    set(this.now, { d: `M${across(beats - Math.floor(beats), this.box).toFixed(1)} 0V${this.box.height}` });
  }

  // ----------------------------------------------------------------------- pointers
  /** @param {PointerEvent} event */
  placeIn({ clientX, clientY }) {
    const { left, top } = this.wave.getBoundingClientRect();
    return { x: clientX - left, y: clientY - top };
  }

  /** @param {PointerEvent} event */
  under(event) {
    const reach = REACH[/** @type {keyof typeof REACH} */ (event.pointerType)] ?? REACH.mouse;
    const all = this.present(), at = this.placeIn(event);
    // Of marks in one place, one that is selected first.
    return markAt(all.filter(isSelected), this.box, at, reach / 2) ?? markAt(all, this.box, at, reach);
  }

  /** @param {string} key of the mark that is pointed at */
  point(key) {
    if (key === this.hovered) return;
    this.hovered = key;
    this.drawMarks();
  }

  /** @param {PointerEvent} event */
  hover(event) {
    const key = event.pointerType === "touch" ? "" : (this.under(event)?.key ?? "");
    this.wave.classList.toggle("softrod-muscles-grab", key !== "");
    this.point(key);
  }

  /** @param {PointerEvent} event */
  down(event) {
    if (event.button !== 0 || this.drag) return;
    event.preventDefault();
    const mark = this.under(event);
    if (!mark) {
      if (editing.selected.springs.length || editing.selected.joints.length) send({ do: "select" });
      return;
    }
    clearTimeout(this.settling);
    const was = isSelected(mark), { shiftKey, pointerId: id } = event;
    if (!was) select(mark, shiftKey);
    this.tabbed = mark.key;
    this.known = NOWHERE;
    this.left = null;
    const held = this.dotsOf(this.marks).find(({ key }) => key === mark.key) ?? mark;
    const along = { x: false, y: false };
    this.drag = { id, held, all: this.marks.filter(isChosen), ...this.placeIn(event), moved: false, along, toggles: was && shiftKey, alone: was && !shiftKey, way: NOWHERE };
    const { left, top } = this.wave.getBoundingClientRect(), at = placeOf(mark, this.box);
    takePointer(this.wave, event, { name: say("muscles-mark", { muscle: nameOf(mark) }), at: { x: left + at.x, y: top + at.y } });
    send({ do: "visit" });
    this.drawMarks();
  }

  /** @param {PointerEvent} event @param {Drag} drag */
  move(event, drag) {
    if (event.pointerId !== drag.id) return;
    const at = this.placeIn(event), { along } = drag;
    const dx = at.x - drag.x, dy = at.y - drag.y;
    // Once it counts in a direction, all of it does; in the other it stays until it leaves the slack there, too.
    along.x ||= Math.abs(dx) > SLACK;
    along.y ||= Math.abs(dy) > SLACK;
    if (!along.x && !along.y) return;
    drag.moved = true;
    drag.way = wayOf(drag.held, drag.all, this.box, along.x ? dx : 0, along.y ? dy : 0);
    this.sending ||= window.setTimeout(() => this.send(), SEND_EVERY);
    this.drawMarks();
  }

  /** @param {PointerEvent} event */
  up(event) {
    if (!this.drag || event.pointerId !== this.drag.id) return;
    const { held, moved, toggles, alone, all, way } = this.drag;
    if (moved) this.send();
    else if (toggles) select(held, true);
    else if (alone && all.length > held.members.length) select(held, false);
    this.left = moved ? { all, way } : null;
    this.drag = null;
    this.settling = window.setTimeout(() => {
      this.left = null;
      this.drawMarks();
    }, SETTLES);
    this.drawMarks();
  }

  /** Sends how far marks have come since the last message. */
  send() {
    clearTimeout(this.sending);
    this.sending = 0;
    const { known } = this, { way } = this.drag ?? this.left ?? { way: NOWHERE };
    const more = { later: way.later - known.later, stretch: way.stretch - known.stretch, turn: way.turn - known.turn };
    if (more.later || more.stretch || more.turn) send({ do: "moveMuscles", ...more });
    this.known = way;
  }

  // ----------------------------------------------------------------------- keys
  /** @param {string} key of a mark @param {KeyboardEvent} event */
  press(key, event) {
    const all = this.dotsOf(this.marks);
    const mark = all.find((one) => one.key === key);
    if (!mark || event.ctrlKey || event.metaKey || event.altKey) return;
    const arrow = ARROWS[event.key];
    if (arrow) {
      if (!isSelected(mark)) select(mark, false);
      const fine = event.shiftKey ? FINE : 1;
      const step = stepOf(this.marks.filter(isChosen), arrow[0] * LATER * fine, arrow[1] * HIGHER * fine);
      send({ do: "moveMuscles", ...step, keys: true });
    } else if (event.key === " " || event.key === "Enter") select(mark, event.key === " ");
    else {
      const order = all.sort((one, two) => one.crest - two.crest || (one.key < two.key ? -1 : 1));
      const at = order.indexOf(mark);
      const to = { PageDown: at + 1, PageUp: at - 1, Home: 0, End: order.length - 1 }[event.key];
      if (to === undefined) return;
      if (order[to]) {
        this.tabbed = order[to].key;
        this.elements.get(this.tabbed)?.focus();
      }
    }
    event.preventDefault();
    event.stopPropagation();
  }
}

/** Begins to look for muscles. */
function begin() {
  /** @type {MuscleStrip | null} */
  let strip = null;
  /** @type {import("../../stage/plan.js").Plan | null} */
  let taken = null;
  const look = () => {
    const { pictured: plan } = shown();
    if (!plan) return;
    if (plan !== taken) {
      if (!strip && !(countMuscles(plan) && has("edit"))) return;
      strip ??= new MuscleStrip();
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
