// @ts-check
/**
 * Between the frames of the server: which state to show at this moment of the screen.
 *
 * Frames carry the server's clock. They are shown one frame's time after they could be here at the earliest, so
 * that there are nearly always two to glide between. When the network stutters the last one stays; what comes
 * then is caught up with quickly, not in a leap.
 *
 * @typedef {import("./plan.js").Frame} Frame
 */
import { between } from "./plan.js";

/** Seconds that a picture waits at most for the frame after it. */
const LONGEST_WAIT = 0.05;
/** Seconds between two frames beyond which the body stood in between: there is nothing to glide over. */
const STOOD = 0.25;
/** How much faster than the clock late pictures are caught up with. */
const HURRY = 0.5;
/** Seconds behind from which on it does not pay to catch up: the picture leaps. */
const TOO_LATE = 0.5;

/** @typedef {Frame & {at: number}} Timed a frame with its time on the server's clock */

export class Glide {
  constructor() {
    /** @type {Timed[]} */
    this.frames = [];
    /** Server's clock minus the screen's, as of the fastest frame. */
    this.ahead = -Infinity;
    /** Smoothed seconds between frames. */
    this.interval = 1 / 60;
    /** Where on the server's clock the last picture was. */
    this.shown = -Infinity;
    /** When `at` was asked last, on the screen's clock. */
    this.asked = -Infinity;
    /** The picture that was returned last. @type {Timed | null} */
    this.last = null;
  }

  /**
   * Takes a frame that came.
   *
   * @param {Frame} frame
   * @param {number} at when it was made, seconds of the server's clock
   * @param {number} now seconds of the screen's clock
   */
  take(frame, at, now) {
    let before = this.frames.at(-1);
    // Another body, or another server: nothing of the one before is of any use.
    if (before && (before.generation !== frame.generation || at < before.at)) {
      if (at < before.at) this.ahead = -Infinity;
      before = undefined;
      this.frames.length = 0;
      this.last = null;
    }
    const gap = before ? at - before.at : Infinity;
    // What stood still a while ago moves now: from then on, not slowly over the whole pause.
    if (before && gap > STOOD) {
      this.shown = at - this.interval;
      this.frames = [{ ...before, at: this.shown }];
    } else if (gap < STOOD && gap > 0) {
      // Soon longer, slowly shorter: a picture too late is worse than one that waits.
      this.interval += (gap > this.interval ? 0.5 : 0.05) * (gap - this.interval);
    }
    this.frames.push({ ...frame, at });
    // The fastest frame tells how far the clocks are apart; slowly forgotten, since clocks drift.
    this.ahead = Math.max(this.ahead - 1e-4 * Math.min(gap, 1), at - now);
  }

  /**
   * The state to show now, or null when it is the one that was shown last.
   *
   * @param {number} now seconds of the screen's clock
   * @returns {Frame | null}
   */
  at(now) {
    const { frames } = this;
    if (!frames.length) return null;
    const wanted = now + this.ahead - Math.min(this.interval, LONGEST_WAIT);
    const elapsed = now - this.asked;
    this.asked = now;
    const late = wanted - this.shown;
    if (late > elapsed && late < TOO_LATE) this.shown = Math.min(wanted, this.shown + elapsed * (1 + HURRY));
    else if (late > 0 || late < -TOO_LATE) this.shown = wanted;
    this.shown = Math.min(this.shown, /** @type {Timed} */ (frames.at(-1)).at);
    while (frames.length > 1 && frames[1].at <= this.shown) frames.shift();
    const [one, two] = frames;
    if (!two || this.shown <= one.at) return this.unlessShown(one);
    return this.unlessShown({ ...between(one, two, (this.shown - one.at) / (two.at - one.at)), at: this.shown });
  }

  /** Whether the newest frame has not been shown yet. */
  get busy() {
    return this.last === null || this.last.at !== this.frames.at(-1)?.at;
  }

  /** The frame, or null if it is the one that was shown last. @param {Timed} frame */
  unlessShown(frame) {
    if (this.last?.at === frame.at) return null;
    this.last = frame;
    return frame;
  }
}
