// @ts-check
/**
 * The controls of a live file.
 *
 * @typedef {import("./live.js").About} About
 * @typedef {import("./live.js").Live} Live
 * @typedef {import("./settings.js").Setting} Setting
 * @typedef {import("./steps.js").Steering} Steering
 */
import { isMeantElsewhere } from "../../../ui/access.js";
import { heldArrow } from "../../../ui/hands/arrow_keys.js";
import { listenToPad, releasePad } from "../../../ui/hands/arrow_pad.js";
import { decimal, say } from "../../../words/words.js";
import { element } from "../../static/parts.js";
import { head, numbers } from "./readings.js";
import { settingRow } from "./sliders.js";
import { addView } from "./view.js";

/** Milliseconds between two updates of numbers; faster would only flicker. */
const UPDATE_EVERY = 100;

export class Panel {
  /** What was set since the file was opened, or its step begun. @type {Map<Setting, number | string>} */
  values = new Map();
  /** Arrow keys that are held. @type {Set<string>} */
  #held = new Set();
  /** When numbers are updated next, ms. */
  #due = 0;

  /** @param {About} about @param {Live} live what the controls act on */
  constructor(about, live) {
    this.about = about;
    this.live = live;
    const button = (/** @type {string} */ id) => element(id, HTMLButtonElement);
    const part = (/** @type {string} */ id) => element(id, HTMLElement);
    this.hud = part("hud");
    this.stopped = part("stopped");
    this.cause = part("cause");
    this.readings = part("numbers");
    this.rows = part("sliders");
    this.others = part("others");
    this.stands = part("stands");
    this.play = button("play");
    this.follow = button("follow");
    this.clock = element("clock", HTMLOutputElement);
    this.says = part("says");
    let hasArrows = Boolean(about.up || about.right);
    const view = addView({ arrows: hasArrows, follow: !this.follow.hidden });
    // ifdef HAS_STEERING
    hasArrows = true;
    // endif
    this.play.addEventListener("click", () => live.toggle());
    this.follow.addEventListener("click", () => live.follow());
    button("step").addEventListener("click", () => live.step());
    button("reset").addEventListener("click", () => live.restart());
    button("back").addEventListener("click", () => live.goBack());
    const speed = element("speed", HTMLSelectElement);
    speed.addEventListener("change", () => (live.speed = Number(speed.value)));
    /** What single keys do. @type {Record<string, () => void>} */
    this.keys = {
      " ": () => live.toggle(), n: () => live.step(), r: () => live.restart(), d: view.dark, z: view.larger, "?": view.help,
      ...(this.follow.hidden ? {} : { f: () => live.follow() }),
    };
    document.addEventListener("keydown", (event) => this.#press(event, hasArrows));
    document.addEventListener("keyup", (event) => this.#held.delete(heldArrow(event) ?? ""));
    window.addEventListener("blur", () => {
      this.#held.clear();
      releasePad();
    });
    if (!hasArrows) return;
    element("pad", HTMLElement).hidden = false;
    listenToPad((key) => this.#held.add(key), (key) => this.#held.delete(key));
  }

  /** @param {KeyboardEvent} event @param {boolean} hasArrows */
  #press(event, hasArrows) {
    const { target, key, ctrlKey, metaKey, altKey, repeat } = event;
    if (ctrlKey || metaKey || altKey || !(target instanceof Element) || target.closest("dialog[open]")) return;
    if (target.matches("select, textarea, input:not([type=range])")) return;
    const arrow = heldArrow(event);
    if (arrow && hasArrows && !target.matches("input")) {
      this.#held.add(arrow);
      event.preventDefault();
    }
    if (repeat || (key === " " && target.matches("button, summary"))) return;
    const does = this.keys[key.toLowerCase()];
    if (!does || isMeantElsewhere(event)) return;
    event.preventDefault();
    does();
  }

  /**
   * Have controls of these settings, with the values that the file has.
   *
   * @param {Setting[]} settings @param {readonly string[]} main keys of those that are not folded
   */
  setUp(settings, main) {
    this.values.clear();
    const rows = settings.map((setting) => {
      const row = settingRow(setting, (value) => {
        this.values.set(setting, value);
        this.live.change(setting, value);
      });
      return { row, isMain: main.includes(setting.key) };
    });
    const folded = rows.filter(({ isMain }) => !isMain);
    this.rows.replaceChildren(...rows.filter(({ isMain }) => isMain).map(({ row }) => row));
    this.others.querySelectorAll(".row").forEach((row) => row.remove());
    this.others.append(...folded.map(({ row }) => row));
    this.others.hidden = folded.length === 0;
  }

  /** What held keys do in a second. @returns {Steering} */
  get presses() {
    const { up, right } = this.about;
    const held = (/** @type {string} */ key) => this.#held.has(key);
    return {
      factor: up ? (held("up") ? up.factor : 1) / (held("down") ? up.factor : 1) : 1,
      angle: right ? right.angle * (Number(held("right")) - Number(held("left"))) : 0,
      // ifdef HAS_STEERING
      steered: [Number(held("right")) - Number(held("left")), Number(held("up")) - Number(held("down"))],
      // endif
    };
  }

  /** Show how things are. */
  show() {
    const { live: { shown, body, clock, playing, hands }, play, stopped } = this;
    const icon = playing ? "pause" : "play";
    if (play.dataset.icon !== icon) {
      this.says.textContent = say(playing ? "ui-running" : "ui-running.paused");
      play.dataset.icon = icon;
      play.ariaLabel = say(playing ? "live-pause" : "live-play");
      this.#due = 0;
    }
    this.follow.ariaPressed = String(hands.follows);
    this.stands.hidden = !this.live.stands;
    if (stopped.hidden === clock.exploded) {
      stopped.hidden = !clock.exploded;
      this.cause.textContent = clock.cause;
    }
    const now = performance.now();
    if (now < this.#due) return;
    this.#due = now + UPDATE_EVERY;
    this.clock.value = `${decimal(body.time.toFixed(2))} s`;
    this.hud.replaceChildren(...head(shown, body, clock, playing));
    this.readings.replaceChildren(...numbers(shown, body, clock));
  }
}
