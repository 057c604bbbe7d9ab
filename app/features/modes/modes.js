// @ts-check
/**
 * The strip of modes over the bar of time: a bar for each slow vibration of the body, and one for what is in none. A bar
 * that is pointed at shows its shape; one that is dragged puts the body into it; one that is pressed drives it.
 */
import { addGhost } from "./ghost.js";
import { listenToMelodies } from "./melody.js";
import { few, percent, readLevels, readShapes } from "./shapes.js";
import { addSound, toggleSound } from "./sound.js";
import { onMessage, pageState, send } from "../../wire/channel.js";
import { withKey } from "../../ui/hands/key_table.js";
import { make, makeButton } from "../../ui/dialog.js";
import { makeStrip } from "../../ui/strip.js";
import { perform } from "../../wire/perform.js";

/**
 * @typedef {import("../../wire/wire.js").Modes} Modes
 * @typedef {import("./shapes.js").Shapes} Shapes
 * @typedef {import("./shapes.js").Levels} Levels
 * @typedef {object} Bar
 * @property {HTMLElement} element
 * @property {HTMLElement} fill
 * @property {HTMLElement} name
 */

/** Pixels that a pointer moves before it drags, and milliseconds that it rests before it drives. */
const [DRAG, HOLD] = [5, 350];
/** Milliseconds between two reports of what is driven; the server forgets what it hears nothing of. */
const REPEAT = 150;
/** By how much of a full bar a key moves it, and with Shift. */
const [STEP, FAR] = [0.05, 0.2];
/** Milliseconds between two readings for a screen reader. */
const READ_EVERY = 500;

const HOW = "Point at a bar for its shape. Drag it: the body swings so. Press and hold it: it is driven.";
const OTHERS = "In none of these: faster modes, and what a large motion has beyond small ones";

/** As it stands below a bar. @param {number} f Hz */
const hertz = (f) => few(f, f < 100 ? 2 : 3);

/** Puts up the strip, which is hidden while nobody looks at modes. */
function begin() {
  listenToMelodies();
  const { strip, head, says, live, show } = makeStrip("modes", "Modes");
  says.textContent = HOW;
  const close = makeButton("×", () => perform("modes"), "softrod-modes-close");
  close.ariaLabel = "Close the modes";
  close.title = withKey("Close", "modes");
  const bars = make("div", "softrod-modes-bars");
  const sound = addSound();
  head.append(...sound.controls, close);
  strip.append(bars);
  const ghost = addGhost();

  /** @type {Modes} */
  let modes = { tell: "modes" };
  /** @type {Shapes | null} */
  let shapes = null;
  /** @type {Levels | null} */
  let levels = null;
  /** @type {Bar[]} */
  let shown = [];
  /** The mode that is pointed at, has the focus, is dragged, or was tapped; -1 for none. */
  let [over, focused, dragged, kept] = [-1, -1, -1, -1];
  /** The part of a full bar to which it is dragged. */
  let to = 0;
  let driven = -1;
  let read = 0;
  ghost.from(() => ({ shapes, frames: levels?.frames }));

  const looked = () => [dragged, driven, over, focused, kept].find((mode) => mode >= 0) ?? -1;
  const frequencies = () => modes.frequencies ?? [];
  /** Its amplitude, px. @param {number} i */
  const amplitude = (i) => (i === dragged ? to : (levels?.levels[i] ?? 0)) * (modes.full?.[i] ?? 0);
  /** Its amplitude; what cannot be seen is none. @param {number} i */
  const inUnits = (i) => {
    const full = modes.full?.[i] ?? 0;
    return `${amplitude(i) < 1e-3 * full ? 0 : few(amplitude(i), 2)} ${pageState().unit ?? ""}`;
  };
  /** @param {number} i */
  const inWords = (i) => {
    const share = levels?.shares[i] ?? 0;
    if (i === shown.length - 1) {
      const none = share < 0 ? `; the modes alone would have ${percent(share)} more` : `: ${percent(share)} of the energy`;
      return OTHERS + none;
    }
    const damping = modes.damping?.[i] ?? 0;
    const dies = damping >= 1 ? "does not swing" : `damping ${percent(damping)}`;
    const doing = i === driven ? "driven" : `${percent(share)} of the energy`;
    return `Mode ${i + 1}: ${few(frequencies()[i])} Hz, ${inUnits(i)}, ${dies}, ${doing}`;
  };
  const tellLooked = () => {
    const mode = looked();
    const text = modes.trouble
      ? `No modes: ${modes.trouble}.`
      : !shown.length
        ? "The modes are being looked for."
        : mode >= 0
          ? inWords(mode)
          : HOW;
    if (says.textContent !== text) says.textContent = text;
  };
  const look = () => {
    const mode = looked();
    const has = mode >= 0 && mode < frequencies().length;
    ghost.show(has ? mode : -1, has && mode === dragged ? amplitude(mode) : 0);
    shown.forEach(({ element }, i) => element.classList.toggle("softrod-mode-seen", i === mode));
    tellLooked();
  };

  // ----------------------------------------------------------------------- what is done with a bar
  let asked = false;
  const sendPut = () => {
    asked = false;
    if (dragged >= 0) send({ do: "putMode", mode: dragged, part: to });
  };
  /** @param {number} i @param {number} part */
  const put = (i, part) => {
    [dragged, to] = [i, Math.min(Math.max(part, 0), 1)];
    if (!asked) requestAnimationFrame(sendPut);
    asked = true;
    look();
    drawLevels();
  };
  const drive = (/** @type {number} */ i) => {
    if (i === driven) return;
    driven = i;
    send({ do: "driveMode", mode: i });
    if (i >= 0) live.textContent = `Mode ${i + 1} is driven`;
    look();
  };
  setInterval(() => driven >= 0 && send({ do: "driveMode", mode: driven }), REPEAT);
  const stop = () => drive(-1);
  window.addEventListener("blur", stop);
  document.addEventListener("visibilitychange", stop);

  /** @param {Bar} bar @param {number} i */
  const listen = ({ element }, i) => {
    element.addEventListener("pointerenter", ({ pointerType }) => {
      if (pointerType !== "touch") over = i;
      look();
    });
    element.addEventListener("pointerleave", () => {
      if (over === i) over = -1;
      look();
    });
    element.addEventListener("focus", () => {
      focused = element.matches(":focus-visible") ? i : -1;
      look();
    });
    element.addEventListener("blur", () => {
      if (focused === i) focused = -1;
      if (driven === i) stop();
      look();
    });
    if (i >= frequencies().length) {
      element.addEventListener("click", () => {
        kept = kept === i ? -1 : i;
        look();
      });
      return;
    }
    /** @type {{id: number, y: number, level: number, height: number} | null} */
    let begun = null;
    let moved = false;
    /** @type {ReturnType<typeof setTimeout> | undefined} */
    let rests;
    element.addEventListener("pointerdown", (event) => {
      if (event.button > 0 || begun) return;
      event.preventDefault();
      element.setPointerCapture(event.pointerId);
      const height = element.querySelector(".softrod-mode-box")?.clientHeight || 1;
      begun = { id: event.pointerId, y: event.clientY, level: Math.min(levels?.levels[i] ?? 0, 1), height };
      moved = false;
      // A move that waits for a slow page comes before its next picture.
      rests = setTimeout(() => requestAnimationFrame(() => !moved && begun && drive(i)), HOLD);
    });
    element.addEventListener("pointermove", (event) => {
      if (begun?.id !== event.pointerId || driven >= 0) return;
      const way = begun.y - event.clientY;
      if (!moved && Math.abs(way) < DRAG) return;
      if (!moved) send({ do: "visit" });
      moved = true;
      clearTimeout(rests);
      put(i, begun.level + way / begun.height);
    });
    for (const kind of /** @type {const} */ (["pointerup", "pointercancel"])) {
      element.addEventListener(kind, (event) => {
        if (begun?.id !== event.pointerId) return;
        clearTimeout(rests);
        const drove = driven === i;
        begun = null;
        if (asked) sendPut();
        dragged = -1;
        stop();
        if (!moved && !drove && kind === "pointerup") kept = kept === i ? -1 : i;
        look();
      });
    }
    element.addEventListener("contextmenu", (event) => event.preventDefault());
    element.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      const level = Math.min(levels?.levels[i] ?? 0, 1);
      const step = event.shiftKey ? FAR : STEP;
      const part = { ArrowUp: level + step, ArrowDown: level - step, Home: 0, End: 1, PageUp: level + FAR, PageDown: level - FAR }[event.key];
      const beside = { ArrowLeft: i - 1, ArrowRight: i + 1 }[event.key];
      if (part !== undefined) {
        if (!event.repeat) send({ do: "visit" });
        put(i, part);
        sendPut();
        dragged = -1;
        live.textContent = `Mode ${i + 1}: ${few(100 * to, 2)} percent of a full bar`;
      } else if (beside !== undefined) shown[(beside + shown.length) % shown.length].element.focus();
      else if (event.code === "Space" || event.key === "Enter") drive(i);
      else return;
      event.preventDefault();
      event.stopPropagation();
    });
    element.addEventListener("keyup", (event) => {
      if ((event.code === "Space" || event.key === "Enter") && driven === i) {
        event.preventDefault();
        stop();
      }
    });
  };

  // ----------------------------------------------------------------------- what is shown
  /** @param {string} text below it @returns {Bar} */
  const newBar = (text) => {
    const element = make("div", "softrod-mode");
    const [box, fill] = [make("span", "softrod-mode-box"), make("span", "softrod-mode-fill")];
    const name = make("span", "softrod-mode-name", text);
    box.append(fill);
    element.append(box, name);
    element.tabIndex = 0;
    return { element, fill, name };
  };
  const build = () => {
    const count = frequencies().length;
    if (shown.length === (count ? count + 1 : 0)) {
      shown.forEach(({ name }, i) => {
        const text = i < count ? hertz(frequencies()[i]) : "else";
        if (name.textContent !== text) name.textContent = text;
      });
    } else {
      shown = count ? [...frequencies().map((f) => newBar(hertz(f))), newBar("else")] : [];
      bars.replaceChildren(...shown.map(({ element }) => element));
      shown.forEach((bar, i) => {
        listen(bar, i);
        if (i === count) {
          bar.element.classList.add("softrod-mode-others");
          bar.element.setAttribute("role", "img");
        } else {
          bar.element.setAttribute("role", "slider");
          bar.element.ariaOrientation = "vertical";
          Object.assign(bar.element, { ariaValueMin: "0", ariaValueMax: "100" });
        }
      });
      [over, focused, dragged, kept] = [-1, -1, -1, -1];
    }
    shown.forEach(({ element }, i) => {
      element.ariaLabel = i < count ? `Mode ${i + 1}, ${few(frequencies()[i])} hertz` : "In no mode";
    });
    readOut();
  };
  const readOut = () => {
    read = performance.now();
    shown.forEach(({ element }, i) => {
      if (i === shown.length - 1) {
        element.ariaLabel = inWords(i);
        return;
      }
      element.ariaValueNow = String(Math.round(100 * Math.min(levels?.levels[i] ?? 0, 1)));
      element.ariaValueText = `${inUnits(i)}, ${percent(levels?.shares[i] ?? 0)} of the energy`;
    });
  };
  const drawLevels = () => {
    shown.forEach(({ fill, element }, i) => {
      const isLast = i === shown.length - 1;
      const level = i === dragged ? to : isLast ? (levels?.other ?? 0) : (levels?.levels[i] ?? 0);
      fill.style.transform = `scaleY(${Math.min(Math.abs(level), 1).toFixed(4)})`;
      element.classList.toggle("softrod-mode-lacks", isLast && level < 0);
      element.classList.toggle("softrod-mode-over", Math.abs(level) > 1);
      element.classList.toggle("softrod-mode-driven", i === (modes.driven ?? -1));
    });
    if (performance.now() - read > READ_EVERY) readOut();
    tellLooked();
  };

  onMessage("modes", (now) => {
    modes = now;
    const on = now.on ?? false;
    if (strip.hidden === on) {
      show(on);
      live.textContent = on ? "Modes are shown over the bar of time" : "";
      if (!on) [over, focused, dragged, kept] = [-1, -1, -1, -1];
    }
    if (!on || now.trouble || !now.frequencies) levels = null;
    sound.use(on ? (now.frequencies ?? []) : [], now.damping ?? []);
    build();
    look();
    drawLevels();
  });
  onMessage("modeShapes", ({ numbers }) => {
    shapes = readShapes(numbers);
    look();
  });
  onMessage("modeLevels", ({ numbers }) => {
    levels = readLevels(numbers);
    sound.hear(levels);
    drawLevels();
  });
}

/** @type {import("../../ui/feature.js").Feature<"modes">} */
export default { commands: { mute: toggleSound }, begin };
