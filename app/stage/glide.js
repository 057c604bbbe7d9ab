// @ts-check
/**
 * Interpolates between frames of the server.
 *
 * Frames have times of the server's clock. They are shown one frame interval after their earliest possible arrival, so that
 * there are nearly always two to interpolate. When the network stutters the last one stays, and the picture then catches up
 * quickly, without a jump.
 *
 * @typedef {import("./plan.js").Frame} Frame
 */
import { between } from "./plan.js";

/** Seconds that a picture waits at most for the next frame. */
const LONGEST_WAIT = 0.05;
/** Seconds between two frames that show that the body was at rest, so that there is nothing to interpolate. */
const STOOD = 0.25;
/** Extra speed of a picture that catches up. */
const CATCH_UP = 0.5;
/** Seconds of delay beyond which the picture jumps instead. */
const TOO_LATE = 0.5;

/** @typedef {Frame & {at: number}} Timed a frame with its time on the server's clock */

export class Glide {
  constructor() {
    /** @type {Timed[]} */
    this.frames = [];
    /** Server's clock minus the screen's, by the fastest frame. */
    this.ahead = -Infinity;
    /** Smoothed seconds between frames. */
    this.interval = 1 / 60;
    /** Time of the last picture, on the server's clock. */
    this.shown = -Infinity;
    /** Time of the last call of `at`, on the screen's clock. */
    this.asked = -Infinity;
    /** The picture that was returned last. @type {Timed | null} */
    this.last = null;
  }

  /**
   * Adds a frame that has arrived.
   *
   * @param {Frame} frame
   * @param {number} at when it was made, seconds of the server's clock
   * @param {number} now seconds of the screen's clock
   */
  take(frame, at, now) {
    let before = this.frames.at(-1);
    // Another body, or another server: earlier frames are useless.
    if (before && (before.generation !== frame.generation || at < before.at)) {
      if (at < before.at) this.ahead = -Infinity;
      before = undefined;
      this.frames.length = 0;
      this.last = null;
    }
    const gap = before ? at - before.at : Infinity;
    // A body that was at rest begins to move now, not slowly over the whole pause.
    if (before && gap > STOOD) {
      this.shown = at - this.interval;
      this.frames = [{ ...before, at: this.shown }];
    } else if (gap < STOOD && gap > 0) {
      // It grows quickly and shrinks slowly: a late picture is worse than one that waits.
      this.interval += (gap > this.interval ? 0.5 : 0.05) * (gap - this.interval);
    }
    this.frames.push({ ...frame, at });
    // A page in the background shows none of them, and would keep all.
    while (this.frames.length > 2 && this.frames[1].at < at - TOO_LATE) this.frames.shift();
    // The fastest frame gives the difference of the clocks; forgotten slowly, since clocks drift.
    this.ahead = Math.max(this.ahead - 1e-4 * Math.min(gap, 1), at - now);
  }

  /**
   * The frame to show now, or null if it was returned last time.
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
    if (late > elapsed && late < TOO_LATE) this.shown = Math.min(wanted, this.shown + elapsed * (1 + CATCH_UP));
    else if (late > 0 || late < -TOO_LATE) this.shown = wanted;
    this.shown = Math.min(this.shown, /** @type {Timed} */ (frames.at(-1)).at);
    while (frames.length > 1 && frames[1].at <= this.shown) frames.shift();
    const [one, two] = frames;
    if (!two || this.shown <= one.at) return this.unlessShown(one);
    return this.unlessShown({ ...between(one, two, (this.shown - one.at) / (two.at - one.at)), at: this.shown });
  }

  /** True if the newest frame has not been shown yet. */
  get busy() {
    return this.last === null || this.last.at !== this.frames.at(-1)?.at;
  }

  /** The frame, or null if it was returned last time. @param {Timed} frame */
  unlessShown(frame) {
    if (this.last?.at === frame.at) return null;
    this.last = frame;
    return frame;
  }
}
