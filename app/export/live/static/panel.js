// @ts-check
/**
 * The controls and the numbers of a live file. They are made here: what comes from the scene is text in them.
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
 * @property {(speed: number) => void} speed
 * @property {(setting: Setting, value: number) => void} changed
 */
import { element } from "../../static/parts.js";
import { energies } from "./energy.js";
import { write } from "./settings.js";

/** Positions of a slider. */
const PLACES = 1000;
/** Digits of a number that a slider sets. */
const DIGITS = 3;
/** Milliseconds between two updates of numbers; faster would only flicker. */
const EVERY = 100;
/** Part of real time below which it is said that the browser does not keep up. */
const SLOW = 0.95;
const ARROWS = /** @type {const} */ ({ ArrowUp: "up", ArrowDown: "down", ArrowRight: "right", ArrowLeft: "left" });
const NONE = { factor: 1, angle: 0 };

/** @param {string} kind @param {string} [text] */
function make(kind, text = "") {
  const made = document.createElement(kind);
  made.textContent = text;
  return made;
}

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

/** A number as it is read. @param {number} value */
const said = (value) => (Math.abs(value) >= 1e5 || (value && Math.abs(value) < 1e-3) ? value.toExponential(2) : String(Number(value.toPrecision(4))));

/** @param {About} about @param {Does} does */
export function addPanel(about, does) {
  /** What was set, beside what the file has. @type {Map<Setting, number>} */
  const set = new Map();
  /** @type {Set<string>} */
  const held = new Set();
  const [play, step, reset] = ["play", "step", "reset"].map((id) => element(id, HTMLButtonElement));
  const speed = element("speed", HTMLSelectElement);
  const clock = element("clock", HTMLOutputElement);
  const hud = element("hud", HTMLElement);
  const rows = element("sliders", HTMLElement);
  const numbers = element("numbers", HTMLElement);
  play.addEventListener("click", does.play);
  step.addEventListener("click", does.step);
  reset.addEventListener("click", does.reset);
  speed.addEventListener("change", () => does.speed(Number(speed.value)));

  for (const setting of about.settings) rows.append(setting.stiffness ? templates(setting) : slider(setting));
  if (about.up || about.right) addArrows();

  /** @param {Setting} setting @param {number} value */
  function change(setting, value) {
    set.set(setting, value);
    does.changed(setting, value);
  }

  /** @param {Setting} setting */
  function slider(setting) {
    const row = make("div");
    const label = /** @type {HTMLLabelElement} */ (make("label", setting.label));
    const input = /** @type {HTMLInputElement} */ (make("input"));
    const told = make("output");
    label.htmlFor = input.id = `setting-${setting.key}`;
    const unit = setting.unit ? ` ${setting.unit}` : "";
    Object.assign(input, { type: "range", min: "0", max: String(PLACES), value: String(placeOf(setting, setting.value)) });
    const tell = (/** @type {number} */ value) => {
      told.textContent = said(value) + unit;
      input.setAttribute("aria-valuetext", told.textContent);
    };
    tell(setting.value);
    input.addEventListener("input", () => {
      const value = valueAt(setting, Number(input.value));
      tell(value);
      change(setting, value);
    });
    row.append(label, told, input);
    return row;
  }

  /** @param {Setting} setting the angles of the tutorial's templates */
  function templates(setting) {
    const row = make("div");
    const label = /** @type {HTMLLabelElement} */ (make("label", setting.label));
    const list = /** @type {HTMLSelectElement} */ (make("select"));
    label.htmlFor = list.id = `setting-${setting.key}`;
    for (const angle of Object.keys(setting.stiffness ?? {}).sort((a, b) => Number(a) - Number(b))) {
      const option = /** @type {HTMLOptionElement} */ (make("option", `${angle}°`));
      option.value = angle;
      option.selected = Number(angle) === setting.value;
      list.append(option);
    }
    list.addEventListener("change", () => change(setting, Number(list.value)));
    row.append(label, list);
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
    }
  }

  document.addEventListener("keydown", (event) => {
    const { target, key, ctrlKey, metaKey, altKey, repeat } = event;
    if (ctrlKey || metaKey || altKey) return;
    const isControl = target instanceof HTMLInputElement || target instanceof HTMLSelectElement;
    if (key in ARROWS && !isControl && (about.up || about.right)) {
      held.add(ARROWS[/** @type {keyof typeof ARROWS} */ (key)]);
      event.preventDefault();
    }
    if (isControl || repeat) return;
    if (key === " " && !(target instanceof HTMLButtonElement)) {
      does.play();
      event.preventDefault();
    } else if (key.toLowerCase() === "n") does.step();
    else if (key.toLowerCase() === "r") does.reset();
  });
  document.addEventListener("keyup", ({ key }) => held.delete(ARROWS[/** @type {keyof typeof ARROWS} */ (key)]));
  window.addEventListener("blur", () => held.clear());

  let due = 0;
  return {
    /** What held keys do in a second. @returns {Presses} */
    presses() {
      let { factor, angle } = NONE;
      const { up, right } = about;
      if (up) factor = (held.has("up") ? up.factor : 1) / (held.has("down") ? up.factor : 1);
      if (right) angle = right.angle * (Number(held.has("right")) - Number(held.has("left")));
      return { factor, angle };
    },
    /** What was set. */
    values: () => [...set],
    /** @param {Body} body @param {Setting} setting @param {number} value */
    write: (body, setting, value) => write(body, setting, value),
    /** Show how things are. @param {{body: Body, clock: Clock}} now @param {boolean} playing */
    show({ body, clock: time }, playing) {
      clock.value = `${body.time.toFixed(2)} s`;
      play.dataset.icon = playing ? "pause" : "play";
      play.ariaLabel = playing ? "Pause" : "Play";
      const at = performance.now();
      if (at < due) return;
      due = at + EVERY;
      hud.textContent = [...states(body, time, playing)].join(" · ");
      numbers.replaceChildren(...readings(body, time));
    },
  };

  /** @param {Body} body @param {Clock} time @param {boolean} playing */
  function* states(body, time, playing) {
    if (time.exploded) yield "exploded: Reset begins anew";
    else if (!playing) yield "paused";
    else if (time.rate < SLOW) yield `slowed down: ${time.rate.toFixed(2)} × real time`;
    const broken = body.broken.reduce((sum, one) => sum + one, 0);
    if (broken) yield `${broken} ${broken === 1 ? "spring" : "springs"} broken`;
    const yielded = body.setLength.reduce((sum, moved, s) => sum + Number(Math.abs(moved) > 0.002 * body.restLength[s] && !body.broken[s]), 0);
    if (yielded) yield `${yielded} ${yielded === 1 ? "spring" : "springs"} yielded`;
  }

  /** @param {Body} body @param {Clock} time */
  function* readings(body, time) {
    /** @param {string} name @param {string} value */
    const reading = (name, value) => {
      const row = make("div");
      row.append(make("dt", name), make("dd", value));
      return row;
    };
    if (about.joint >= 0) {
      const angle = body.angleOf(about.joint);
      const radians = (angle * Math.PI) / 180;
      yield reading(`angle of joint ${about.joint}`, `${angle.toFixed(2)}°`);
      yield reading("its sine", Math.sin(radians).toFixed(4));
      yield reading("its cosine", Math.cos(radians).toFixed(4));
      yield reading("its rest angle", `${body.restAngleOf(about.joint).toFixed(2)}°`);
    }
    for (const [name, value] of Object.entries(energies(body))) yield reading(`energy, ${name}`, said(value));
    if (about.method === "symplectic_euler" && time.meter.limit < 1) {
      const part = time.dt / time.meter.limit;
      const row = reading("time step of its limit", `${Math.round(100 * part)} %${part > 1 ? ": unstable" : ""}`);
      const bar = /** @type {HTMLMeterElement} */ (make("meter"));
      Object.assign(bar, { min: 0, max: 1, low: 0.7, high: 0.99, optimum: 0, value: Math.min(part, 1) });
      row.append(bar);
      yield row;
    }
  }
}
