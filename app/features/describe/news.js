// @ts-check
/** What happens to a body, in few words: at most one sentence in a while, the newest of what weighs most. Without a page. */
import { say } from "../../words/words.js";

/** Milliseconds between two sentences, at least. */
export const APART = 2000;
/** Milliseconds for which the first of several events waits for the others. */
export const GATHER = 250;

/**
 * @typedef {{what: "running" | "paused" | "rest" | "exploded"}
 *   | {what: "grabbed" | "dropped", mass: number}
 *   | {what: "touched", by: "floor" | "wall" | "body"}
 *   | {what: "broke", count: number}
 *   | {what: "step", at: number, title: string}} Event
 */

/** What is said although something lighter has happened since. @type {Set<Event["what"]>} */
const HEAVY = new Set(["exploded", "broke", "step"]);

/** The sentence of an event. @param {Event} event */
function sentence(event) {
  switch (event.what) {
    case "broke":
      return say("news-broke", { count: event.count });
    case "touched":
      return say("news-touched", { by: event.by });
    case "grabbed":
      return say("news-grabbed", { mass: String(event.mass) });
    case "dropped":
      return say("news-dropped", { mass: String(event.mass) });
    case "step":
      return say("news-step", { number: String(event.at + 1), title: event.title });
    case "rest":
      return say("news-rest");
    case "exploded":
      return say("news-exploded");
    default:
      return say(event.what === "running" ? "news-running" : "news-running.paused");
  }
}

/** Gathers events until one of them is due. Times are ms. */
export class News {
  /** The event that is said next. @type {Event | null} */
  #next = null;
  /** When the first was heard that waits. */
  #since = 0;
  #said = -Infinity;

  /** Takes an event. @param {Event} event @param {number} now */
  hear(event, now) {
    const before = this.#next;
    if (!before) this.#since = now;
    if (before?.what === "broke" && event.what === "broke") this.#next = { what: "broke", count: before.count + event.count };
    else if (!before || HEAVY.has(event.what) || !HEAVY.has(before.what)) this.#next = event;
  }

  /** When something is due; infinite where nothing waits. */
  get due() {
    return this.#next ? Math.max(this.#since + GATHER, this.#said + APART) : Infinity;
  }

  /** The sentence that is due, which is then said; empty for none. @param {number} now */
  take(now) {
    if (!this.#next || now < this.due) return "";
    const said = sentence(this.#next);
    this.#next = null;
    this.#said = now;
    return said;
  }

  /** Forgets what waits. */
  clear() {
    this.#next = null;
  }
}
