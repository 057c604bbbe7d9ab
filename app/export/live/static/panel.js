// @ts-check
/**
 * The controls of a live file. They are made here: what comes from the scene is text in them.
 *
 * @typedef {import("./body.js").Body} Body
 * @typedef {import("./clock.js").Clock} Clock
 * @typedef {import("./live.js").About} About
 * @typedef {import("./settings.js").Setting} Setting
 * @typedef {import("./steps.js").Presses} Presses
 * @typedef {object} Does what the controls do
 * @property {() => void} play
 * @property {() => void} step
 * @property {() => void} reset
 * @property {() => void} back to before the body ran away
 * @property {() => void} follow
 * @property {(speed: number) => void} speed
 * @property {(setting: Setting, value: number | string) => void} changed
 */
import { make } from "../../../ui/dialog.js";
import { element } from "../../static/parts.js";
import { head, numbers, said } from "./readings.js";
import { addView } from "./view.js";

/** Positions of a slider. */
const PLACES = 1000;
/** Digits of a number that a slider sets. */
const DIGITS = 3;
/** Milliseconds between two updates of numbers; faster would only flicker. */
const EVERY = 100;
const ARROWS = /** @type {const} */ ({ ArrowUp: "up", ArrowDown: "down", ArrowRight: "right", ArrowLeft: "left" });

/** The number at a place of a slider. @param {Setting} setting @param {number} place 0 to PLACES */
function valueAt({ low, high, logarithmic }, place) {
  const part = place / PLACES;
  const value = logarithmic ? low * (high / low) ** part : low + (high - low) * part;
  return Number(value.toPrecision(DIGITS));
}

/** The place of a number on a slider. @param {Setting} setting @param {number} value */
function placeOf({ low, high, logarithmic }, value) {
  const part = logarithmic ? Math.log(Math.max(value, 1e-300) / low) / Math.log(high / low) : (value - low) / (high - low);
  return Math.round(PLACES * Math.min(Math.max(part, 0), 1));
}

/** @param {About} about @param {Does} does */
export function addPanel(about, does) {
  /** What was set, beside what the file has. @type {Map<Setting, number | string>} */
  const set = new Map();
  /** @type {Set<string>} */
  const held = new Set();
  const [play, step, reset, follow, back] = ["play", "step", "reset", "follow", "back"].map((id) => element(id, HTMLButtonElement));
  const speed = element("speed", HTMLSelectElement);
  const clock = element("clock", HTMLOutputElement);
  const [hud, stopped, cause, readings] = ["hud", "stopped", "cause", "numbers"].map((id) => element(id, HTMLElement));
  const [rows, others] = ["sliders", "others"].map((id) => element(id, HTMLElement));
  const view = addView({ arrows: Boolean(about.up || about.right), follow: !follow.hidden });
  play.addEventListener("click", does.play);
  step.addEventListener("click", does.step);
  reset.addEventListener("click", does.reset);
  back.addEventListener("click", does.back);
  follow.addEventListener("click", does.follow);
  speed.addEventListener("change", () => does.speed(Number(speed.value)));
  if (about.up || about.right) addArrows();

  /** @param {Setting} setting @param {number | string} value */
  function change(setting, value) {
    set.set(setting, value);
    does.changed(setting, value);
  }

  /** @param {Setting} setting */
  function slider(setting) {
    const row = make("div", "row");
    const label = make("label", "", setting.label);
    const input = make("input", "");
    const told = make("output", "");
    label.htmlFor = input.id = `setting-${setting.key}`;
    const unit = setting.unit && setting.unit !== "°" ? ` ${setting.unit}` : setting.unit;
    const first = Number(setting.value);
    Object.assign(input, { type: "range", min: "0", max: String(PLACES), value: String(placeOf(setting, first)) });
    const tell = (/** @type {number} */ value) => {
      told.textContent = said(value) + unit;
      input.setAttribute("aria-valuetext", told.textContent);
    };
    tell(first);
    input.addEventListener("input", () => {
      const value = valueAt(setting, Number(input.value));
      tell(value);
      change(setting, value);
    });
    row.append(label, told, input);
    return row;
  }

  /** @param {Setting} setting one that is chosen from a list @param {[number | string, string][]} options */
  function list(setting, options) {
    const row = make("div", "row");
    const label = make("label", "", setting.label);
    const choose = make("select", "");
    label.htmlFor = choose.id = `setting-${setting.key}`;
    options.forEach(([value, name]) => {
      const option = make("option", "", name);
      option.selected = value === setting.value;
      choose.append(option);
    });
    choose.addEventListener("change", () => change(setting, options[choose.selectedIndex][0]));
    row.append(label, choose);
    return row;
  }

  function addArrows() {
    const pad = element("pad", HTMLElement);
    pad.hidden = false;
    for (const button of pad.querySelectorAll("button")) {
      const key = button.value;
      const press = () => {
        held.add(key);
        button.classList.add("held");
      };
      const release = () => {
        held.delete(key);
        button.classList.remove("held");
      };
      button.addEventListener("pointerdown", (event) => {
        button.setPointerCapture(event.pointerId);
        press();
      });
      for (const kind of ["pointerup", "pointercancel", "lostpointercapture", "blur"]) button.addEventListener(kind, release);
      button.addEventListener("keydown", ({ key: pressed }) => (pressed === " " || pressed === "Enter") && press());
      button.addEventListener("keyup", release);
      // A long press on a touch screen is no wish for a menu.
      button.addEventListener("contextmenu", (event) => event.preventDefault());
    }
  }

  /** What single keys do. @type {Record<string, () => void>} */
  const keys = { " ": does.play, n: does.step, r: does.reset, d: view.dark, p: view.larger, "?": view.help };
  if (!follow.hidden) keys.f = does.follow;

  document.addEventListener("keydown", (event) => {
    const { target, key, ctrlKey, metaKey, altKey, repeat } = event;
    if (ctrlKey || metaKey || altKey || !(target instanceof Element) || target.closest("dialog[open]")) return;
    if (target.matches("select, textarea, input:not([type=range])")) return;
    const isSlider = target.matches("input");
    if (key in ARROWS && !isSlider && (about.up || about.right)) {
      held.add(ARROWS[/** @type {keyof typeof ARROWS} */ (key)]);
      event.preventDefault();
    }
    if (repeat || (key === " " && target.matches("button, summary"))) return;
    const does = keys[key.toLowerCase()];
    if (!does) return;
    event.preventDefault();
    does();
  });
  document.addEventListener("keyup", ({ key }) => held.delete(ARROWS[/** @type {keyof typeof ARROWS} */ (key)]));
  window.addEventListener("blur", () => held.clear());

  let due = 0;
  return {
    /**
     * Have controls of these settings, with what the file has of them.
     *
     * @param {Setting[]} settings @param {readonly string[]} foremost keys of those that are not folded
     */
    setUp(settings, foremost) {
      set.clear();
      const all = settings.map((setting) => ({ setting, row: setting.options ? list(setting, setting.options) : slider(setting) }));
      const [first, rest] = [true, false].map((is) => all.filter(({ setting }) => foremost.includes(setting.key) === is));
      rows.replaceChildren(...first.map(({ row }) => row));
      others.querySelectorAll(".row").forEach((row) => row.remove());
      others.append(...rest.map(({ row }) => row));
      others.hidden = rest.length === 0;
    },
    /** What held keys do in a second. @returns {Presses} */
    presses() {
      const { up, right } = about;
      return {
        factor: up ? (held.has("up") ? up.factor : 1) / (held.has("down") ? up.factor : 1) : 1,
        angle: right ? right.angle * (Number(held.has("right")) - Number(held.has("left"))) : 0,
      };
    },
    /** What was set. */
    values: () => [...set],
    /** Show how things are. @param {About} shown @param {{body: Body, clock: Clock}} now @param {boolean} playing @param {boolean} follows */
    show(shown, { body, clock: time }, playing, follows) {
      const icon = playing ? "pause" : "play";
      if (play.dataset.icon !== icon) {
        play.dataset.icon = icon;
        play.ariaLabel = playing ? "Pause" : "Play";
        due = 0;
      }
      follow.ariaPressed = String(follows);
      if (stopped.hidden === time.exploded) {
        stopped.hidden = !time.exploded;
        cause.textContent = time.cause && `${time.cause}.`;
      }
      const at = performance.now();
      if (at < due) return;
      due = at + EVERY;
      clock.value = `${body.time.toFixed(2)} s`;
      hud.replaceChildren(...head(shown, body, time, playing));
      readings.replaceChildren(...numbers(shown, body, time));
    },
  };
}
