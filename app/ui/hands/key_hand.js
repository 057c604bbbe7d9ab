// @ts-check
/**
 * A body by keys alone, for those who have no pointer: the arrows choose a mass, Space takes hold of it and lets go, and the
 * arrows then move it.
 */
import { ARROWS } from "./arrow_keys.js";
import { say } from "../../words/words.js";

/** How far an arrow moves a mass, in units of the world: a hundredth of the scene's frame. */
const STEP = 0.06;
/** How many times farther with Shift. */
const FAR = 5;

/**
 * @typedef {object} Body what the keys act on
 * @property {() => number} count of its masses
 * @property {() => number} chosen the mass that is marked, or -1
 * @property {(mass: number) => void} choose marks a mass, or none by -1
 * @property {(mass: number) => boolean} grab takes hold of a mass; false where that cannot be done
 * @property {(x: number, y: number) => void} move moves the mass in hand by so much, in units of the world, y upwards
 * @property {() => void} drop
 * @property {(mass: number) => string} where says where a mass is
 * @property {() => "ui-mass.first" | "ui-mass.tools"} hint what keys do, for who comes to the body
 * @property {(text: string) => void} say says something to a screen reader
 */
export class KeyHand {
  #holds = false;
  /** The mass that was chosen when the focus went, for when a dialog gives it back; -1 at first. */
  #last = -1;

  /** @param {Body} body */
  constructor(body) {
    this.body = body;
  }

  /** Says something of the mass that is marked. @param {"ui-mass" | "ui-mass.first" | "ui-mass.tools" | "ui-mass.held" | "ui-mass.free"} key */
  #say(key) {
    const mass = this.body.chosen();
    this.body.say(this.body.count() ? say(key, { mass: String(mass), place: this.body.where(mass) }) : say("ui-mass.none"));
  }

  /** The body gets the focus. @param {number} first the mass to begin with */
  focus(first) {
    this.body.choose(this.#last < 0 ? Math.max(first, 0) : this.#last);
    this.#say(this.body.hint());
  }

  blur() {
    this.letGo();
    this.#last = this.body.chosen();
    this.body.choose(-1);
  }

  letGo() {
    if (!this.#holds) return;
    this.#holds = false;
    this.body.drop();
    this.#say("ui-mass.free");
  }

  /** Begin with the first mass again, as for another scene. */
  forget() {
    this.letGo();
    this.#last = -1;
  }

  /** The body may have lost masses. */
  recount() {
    const end = this.body.count() - 1;
    this.#last = Math.min(this.#last, end);
    if (this.body.chosen() <= end) return;
    this.body.choose(end);
    this.#say("ui-mass");
  }

  /** @param {KeyboardEvent} event with the focus on the body */
  press(event) {
    if (event.ctrlKey || event.metaKey || event.altKey || this.body.chosen() < 0) return;
    const arrow = ARROWS[event.key];
    if (event.code === "Space" || event.key === "Enter") {
      if (!event.repeat) this.#toggle();
    } else if (arrow && this.#holds) {
      const step = STEP * (event.shiftKey ? FAR : 1);
      this.body.move(step * arrow[0], step * arrow[1]);
      this.body.say(this.body.where(this.body.chosen()));
    } else if (arrow) {
      const count = this.body.count();
      this.body.choose((this.body.chosen() + (arrow[0] - arrow[1] > 0 ? 1 : count - 1)) % count);
      this.#say("ui-mass");
    } else if (event.key === "Escape" && this.#holds) this.letGo();
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  #toggle() {
    if (this.#holds) return this.letGo();
    this.#holds = this.body.grab(this.body.chosen());
    if (this.#holds) this.#say("ui-mass.held");
  }
}
