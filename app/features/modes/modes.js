// @ts-check
/**
 * The strip of modes over the bar of time: a bar for each slow vibration of the body, and one for what is in none. A bar
 * that is pointed at shows its shape; one that is dragged puts the body into it; one that is pressed drives it.
 */
import { ShapeMarks } from "./shape_marks.js";
import { few, percent, readLevels, readShapes } from "./shapes.js";
import { addSound } from "./sound.js";
import { onMessage, pageState, send } from "../../wire/channel.js";
import { withKey } from "../../ui/hands/key_table.js";
import { PICKED_UP, takePointer } from "../../ui/hands/take.js";
import { make, makeButton } from "../../ui/dialog.js";
import { makeStrip } from "../../ui/strip.js";
import { perform } from "../../wire/perform.js";
import { say } from "../../words/words.js";

/**
 * @typedef {import("../../wire/wire.js").Modes} Modes
 * @typedef {import("./shapes.js").Shapes} Shapes
 * @typedef {import("./shapes.js").Levels} Levels
 * @typedef {{element: HTMLElement, box: HTMLElement, fill: HTMLElement, name: HTMLElement}} Bar
 * @typedef {{id: number, y: number, level: number, height: number, moved: boolean, timer: ReturnType<typeof setTimeout>}} Press
 */

/** Pixels that a pointer moves before it drags. */
const DRAG = 5;
/** Milliseconds that a pointer rests before it drives. */
const HOLD = 350;
/** Milliseconds between two reports of what is driven; the server forgets what it hears nothing of. */
const REPEAT = 150;
/** Part of a full bar by which an arrow key moves it, and by which it does with Shift. */
const STEP = 0.05;
const FAR = 0.2;
/** Milliseconds between two readings for a screen reader. */
const READ_EVERY = 500;

/** A frequency as it stands below a bar. @param {number} f Hz */
const hertz = (f) => few(f, f < 100 ? 2 : 3);
/** @param {KeyboardEvent} event */
const isPress = ({ code, key }) => code === "Space" || key === "Enter";

/** The strip, which is hidden while nobody looks at modes. */
class ModeStrip {
  strip = makeStrip("modes", say("modes-strip"));
  row = make("div", "softrod-modes-bars");
  sound = addSound();
  marks = new ShapeMarks(() => ({ shapes: this.shapes, frames: this.levels?.frames }));
  /** @type {Modes} */
  modes = { tell: "modes" };
  /** @type {Shapes | null} */
  shapes = null;
  /** @type {Levels | null} */
  levels = null;
  /** One for each mode, and one for what is in none. @type {Bar[]} */
  bars = [];
  /** The mode that is pointed at, has the focus, or was tapped; -1 for none. */
  looks = { over: -1, focused: -1, kept: -1 };
  dragged = -1;
  /** The part of a full bar to which it is dragged. */
  part = 0;
  driven = -1;
  isPutDue = false;
  readAt = 0;
  /** @type {Press | null} */
  press = null;

  constructor() {
    const close = makeButton("×", () => perform("modes"), "softrod-modes-close");
    close.ariaLabel = say("modes-close");
    close.title = withKey(say("modes-close.hint"), "modes");
    this.strip.says.textContent = say("modes-how");
    this.strip.head.append(...this.sound.controls, close);
    this.strip.strip.append(this.row);
    setInterval(() => this.driven >= 0 && send({ do: "driveMode", mode: this.driven }), REPEAT);
    window.addEventListener("blur", () => this.drive(-1));
    document.addEventListener("visibilitychange", () => this.drive(-1));
    onMessage("modes", (told) => this.take(told));
    onMessage("modeShapes", ({ numbers }) => {
      this.shapes = readShapes(numbers);
      this.look();
    });
    onMessage("modeLevels", ({ numbers }) => {
      this.levels = readLevels(numbers);
      this.sound.hear(this.levels);
      this.drawLevels();
    });
  }

  /** Frequencies of the modes, Hz. */
  get frequencies() {
    return this.modes.frequencies ?? [];
  }

  /** The mode that is looked at, or -1. */
  get looked() {
    const { over, focused, kept } = this.looks;
    return [this.dragged, this.driven, over, focused, kept].find((mode) => mode >= 0) ?? -1;
  }

  /** The level of a mode, in that of a full bar. @param {number} i */
  level(i) {
    return i === this.dragged ? this.part : (this.levels?.levels[i] ?? 0);
  }

  /** Turns the sound on or off, and shows the modes that sound. */
  mute() {
    this.sound.toggle();
    if (this.strip.strip.hidden) perform("modes");
  }

  /** @param {Modes} now */
  take(now) {
    this.modes = now;
    const { on = false, frequencies = [], damping = [] } = now;
    if (this.strip.strip.hidden === on) {
      this.strip.show(on);
      this.strip.live.textContent = on ? say("modes-shown") : "";
      if (!on) this.forget();
    }
    if (!on || now.trouble || !now.frequencies) this.levels = null;
    this.sound.use(on ? frequencies : [], damping);
    this.build();
    this.look();
    this.drawLevels();
  }

  forget() {
    this.looks = { over: -1, focused: -1, kept: -1 };
    this.dragged = -1;
  }

  // ----------------------------------------------------------------------- words
  /** The amplitude of a mode; 0 if it cannot be seen. @param {number} i */
  inUnits(i) {
    const level = this.level(i);
    return `${level < 1e-3 ? 0 : few(level * (this.modes.full?.[i] ?? 0), 2)} ${pageState().unit ?? ""}`;
  }

  /** @param {number} i */
  inWords(i) {
    const share = this.levels?.shares[i] ?? 0;
    if (i === this.bars.length - 1) return say(share < 0 ? "modes-others.lacks" : "modes-others", { share: percent(share) });
    const damping = this.modes.damping?.[i] ?? 0;
    const read = {
      number: String(i + 1),
      frequency: few(this.frequencies[i]),
      amplitude: this.inUnits(i),
      swings: damping < 1 ? "yes" : "no",
      damping: percent(damping),
    };
    return i === this.driven ? say("modes-reading-driven", read) : say("modes-reading", { ...read, share: percent(share) });
  }

  /** Says what is looked at. */
  tell() {
    const found = this.bars.length ? (this.looked >= 0 ? this.inWords(this.looked) : say("modes-how")) : say("modes-looking");
    const text = this.modes.trouble ? say("modes-none", { why: this.modes.trouble }) : found;
    if (this.strip.says.textContent !== text) this.strip.says.textContent = text;
  }

  /** Shows the shape of what is looked at. */
  look() {
    const mode = this.looked, isMode = mode >= 0 && mode < this.frequencies.length;
    this.marks.show(isMode ? mode : -1, isMode && mode === this.dragged ? this.part * (this.modes.full?.[mode] ?? 0) : 0);
    this.bars.forEach(({ element }, i) => element.classList.toggle("softrod-mode-seen", i === mode));
    this.tell();
  }

  /** @param {keyof ModeStrip["looks"]} how @param {number} mode */
  lookAt(how, mode) {
    this.looks[how] = mode;
    this.look();
  }

  /** Keeps looking at a bar, or no longer. @param {number} i */
  tap(i) {
    this.lookAt("kept", this.looks.kept === i ? -1 : i);
  }

  // ----------------------------------------------------------------------- what is done with a bar
  sendPut() {
    this.isPutDue = false;
    if (this.dragged >= 0) send({ do: "putMode", mode: this.dragged, part: this.part });
  }

  /** Puts the body into a mode. @param {number} i @param {number} part of a full bar */
  put(i, part) {
    this.dragged = i;
    this.part = Math.min(Math.max(part, 0), 1);
    if (!this.isPutDue) requestAnimationFrame(() => this.sendPut());
    this.isPutDue = true;
    this.look();
    this.drawLevels();
  }

  /** Drives a mode, or none (-1). @param {number} i */
  drive(i) {
    if (i === this.driven) return;
    this.driven = i;
    send({ do: "driveMode", mode: i });
    if (i >= 0) this.strip.live.textContent = say("modes-driven", { number: String(i + 1) });
    this.look();
  }

  /** @param {Bar} bar @param {number} i */
  listen({ element, box }, i) {
    element.addEventListener("pointerenter", ({ pointerType }) => this.lookAt("over", pointerType === "touch" ? this.looks.over : i));
    element.addEventListener("pointerleave", () => this.lookAt("over", this.looks.over === i ? -1 : this.looks.over));
    element.addEventListener("focus", () => this.lookAt("focused", element.matches(":focus-visible") ? i : -1));
    element.addEventListener("blur", () => {
      if (this.driven === i) this.drive(-1);
      this.lookAt("focused", this.looks.focused === i ? -1 : this.looks.focused);
    });
    if (i >= this.frequencies.length) {
      element.addEventListener("click", () => this.tap(i));
      return;
    }
    element.addEventListener("pointerdown", (event) => this.down(event, element, box, i));
    element.addEventListener("pointermove", (event) => this.move(event, i));
    for (const kind of /** @type {const} */ (["pointerup", "pointercancel"])) element.addEventListener(kind, (event) => this.up(event, i));
    element.addEventListener(PICKED_UP, () => clearTimeout(this.press?.timer)); // no long press
    element.addEventListener("contextmenu", (event) => event.preventDefault());
    element.addEventListener("keydown", (event) => this.key(event, i));
    element.addEventListener("keyup", (event) => {
      if (!isPress(event) || this.driven !== i) return;
      event.preventDefault();
      this.drive(-1);
    });
  }

  /** @param {PointerEvent} event @param {HTMLElement} element @param {HTMLElement} box @param {number} i */
  down(event, element, box, i) {
    if (event.button > 0 || this.press) return;
    event.preventDefault();
    // A move that waits for a slow page comes before its next picture.
    const timer = setTimeout(() => requestAnimationFrame(() => this.press && !this.press.moved && this.drive(i)), HOLD);
    const level = Math.min(this.level(i), 1);
    const height = box.clientHeight || 1;
    this.press = { id: event.pointerId, y: event.clientY, level, height, moved: false, timer };
    const { bottom, height: seen } = box.getBoundingClientRect();
    takePointer(element, event, { name: element.ariaLabel ?? "", at: { x: event.clientX, y: bottom - level * seen } });
  }

  /** @param {PointerEvent} event @param {number} i */
  move(event, i) {
    const { press } = this;
    if (press?.id !== event.pointerId || this.driven >= 0) return;
    const way = press.y - event.clientY;
    if (!press.moved && Math.abs(way) < DRAG) return;
    if (!press.moved) send({ do: "visit" });
    press.moved = true;
    clearTimeout(press.timer);
    this.put(i, press.level + way / press.height);
  }

  /** @param {PointerEvent} event @param {number} i */
  up(event, i) {
    const { press, driven } = this;
    if (press?.id !== event.pointerId) return;
    clearTimeout(press.timer);
    this.press = null;
    if (this.isPutDue) this.sendPut();
    this.dragged = -1;
    this.drive(-1);
    if (!press.moved && driven !== i && event.type === "pointerup") this.tap(i);
    else this.look();
  }

  /** @param {KeyboardEvent} event @param {number} i */
  key(event, i) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const level = Math.min(this.level(i), 1);
    const step = event.shiftKey ? FAR : STEP;
    const part = { ArrowUp: level + step, ArrowDown: level - step, Home: 0, End: 1, PageUp: level + FAR, PageDown: level - FAR }[event.key];
    const side = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (part !== undefined) {
      if (!event.repeat) send({ do: "visit" });
      this.put(i, part);
      this.sendPut();
      this.dragged = -1;
      this.strip.live.textContent = say("modes-level", { number: String(i + 1), percent: few(100 * this.part, 2) });
    } else if (side) this.bars[(i + side + this.bars.length) % this.bars.length].element.focus();
    else if (isPress(event)) this.drive(i);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  // ----------------------------------------------------------------------- bars
  build() {
    const names = this.frequencies.length ? [...this.frequencies.map(hertz), say("modes-others.word")] : [];
    if (this.bars.length !== names.length) {
      this.forget();
      this.bars = names.map((_, i) => this.newBar(i));
      this.row.replaceChildren(...this.bars.map(({ element }) => element));
    }
    this.bars.forEach(({ element, name }, i) => {
      if (name.textContent !== names[i]) name.textContent = names[i];
      const isMode = i < names.length - 1;
      element.ariaLabel = isMode ? say("modes-bar", { number: String(i + 1), frequency: few(this.frequencies[i]) }) : say("modes-bar.others");
    });
    this.readOut();
  }

  /** @param {number} i @returns {Bar} */
  newBar(i) {
    const isMode = i < this.frequencies.length;
    const element = make("div", isMode ? "softrod-mode" : "softrod-mode softrod-mode-others");
    const bar = { element, box: make("span", "softrod-mode-box"), fill: make("span", "softrod-mode-fill"), name: make("span", "softrod-mode-name") };
    bar.box.append(bar.fill);
    element.append(bar.box, bar.name);
    element.tabIndex = 0;
    element.setAttribute("role", isMode ? "slider" : "img");
    if (isMode) Object.assign(element, { ariaOrientation: "vertical", ariaValueMin: "0", ariaValueMax: "100" });
    this.listen(bar, i);
    return bar;
  }

  /** Updates what a screen reader reads of the bars. */
  readOut() {
    this.readAt = performance.now();
    this.bars.forEach(({ element }, i) => {
      if (i === this.bars.length - 1) element.ariaLabel = this.inWords(i);
      else {
        element.ariaValueNow = String(Math.round(100 * Math.min(this.levels?.levels[i] ?? 0, 1)));
        element.ariaValueText = say("modes-value", { amplitude: this.inUnits(i), share: percent(this.levels?.shares[i] ?? 0) });
      }
    });
  }

  drawLevels() {
    this.bars.forEach(({ fill, element }, i) => {
      const isLast = i === this.bars.length - 1;
      const level = isLast ? (this.levels?.other ?? 0) : this.level(i);
      fill.style.transform = `scaleY(${Math.min(Math.abs(level), 1).toFixed(4)})`;
      element.classList.toggle("softrod-mode-lacks", isLast && level < 0);
      element.classList.toggle("softrod-mode-over", Math.abs(level) > 1);
      element.classList.toggle("softrod-mode-driven", i === (this.modes.driven ?? -1));
    });
    if (performance.now() - this.readAt > READ_EVERY) this.readOut();
    this.tell();
  }
}

/** Puts up the strip, and begins to listen. */
function begin() {
  strip = new ModeStrip();
}

/** @type {ModeStrip} */
let strip;

/** @type {import("../../ui/feature.js").Feature<"modes">} */
export default { commands: { mute: () => strip.mute() }, begin };
