// @ts-check
/**
 * When a page connects, and how it notices that its connection has died.
 *
 * A connection can die silently: the server hangs, a Wi-Fi roams, a proxy drops it. Neither end notices, and the socket
 * stays open. So the page asks the server for a sign of life whenever it has received nothing for a while, which costs
 * nothing while a body moves. The gate answers (`Gate`), whatever else the server does.
 *
 * A browser that was refused many times delays every further attempt by some seconds. Another one, begun every second, would
 * abort the one that waits, and after half a minute nothing ever reconnects. Here an attempt gets enough time.
 */

/** Divides all waiting times; browser tests may set it before the page begins. */
const HURRY = Number(/** @type {any} */ (globalThis).__softrodHurry) || 1;
/** Milliseconds before an attempt to connect may be replaced by another. */
const PATIENCE = 8000 / HURRY;
/** Milliseconds between two checks. */
export const CHECK_EVERY = 1000 / HURRY;
/** Milliseconds between two checks that prove that the page itself was suspended: hidden, or on a sleeping machine. */
const STOOD = 2500;
/** Milliseconds of silence before a connection is replaced that may have ended while the page was suspended. */
const GIVE_UP_AFTER_STANDING = 5000 / HURRY;
/** Milliseconds of silence before the server is asked for a sign of life. */
const ASK_AFTER = 2000 / HURRY;
/** Milliseconds of silence before the page says so. */
const SILENT_AFTER = 7000 / HURRY;
/** Milliseconds of silence before the connection is replaced, at first. */
const GIVE_UP_AFTER = 14_000 / HURRY;
/** The longest such time, for slow connections. */
const GIVE_UP_LATEST = 56_000;

/** @typedef {"connected" | "silent" | "closed"} Line state of the connection */

/** Decides when an attempt to connect is made. */
export class Attempts {
  constructor() {
    this.under = -Infinity;
  }

  /** Begins an attempt and returns true, unless one is under way. @param {number} now ms */
  begin(now) {
    if (now - this.under < PATIENCE) return false;
    this.under = now;
    return true;
  }

  /** Ends the present attempt: it has failed, or the connection was lost. */
  end() {
    this.under = -Infinity;
  }
}

/** Measures the silence of a connection, and decides what to do about it. */
export class Pulse {
  constructor() {
    this.silence = 0;
    this.looked = -Infinity;
    /** Whether the page was suspended since it last heard something. Networks drop connections of devices that sleep, without a word. */
    this.stood = false;
    /**
     * Silence before it is replaced. While a large message arrives slowly there is silence, too, so this time grows, until a
     * connection has been well for the longest such time.
     */
    this.patience = GIVE_UP_AFTER;
    this.well = 0;
  }

  /** Notes that a message has arrived. */
  heard() {
    this.silence = 0;
    this.stood = false;
  }

  /**
   * Checks the silence; call it at least several times a minute.
   *
   * @param {number} now ms
   * @returns {"well" | "ask" | "silent" | "dead"} in all cases but "well" ask for a sign of life
   */
  look(now) {
    const passed = now - this.looked;
    // Messages that arrived while the page was suspended may be delivered after this call, so that time does not count.
    if (passed < STOOD) {
      this.silence += passed;
      this.well = this.silence < SILENT_AFTER ? this.well + passed : 0;
    } else if (this.looked > -Infinity) {
      this.stood = true;
      this.silence = 0;
    }
    this.looked = now;
    if (this.well >= GIVE_UP_LATEST) this.patience = GIVE_UP_AFTER;
    if (this.silence >= (this.stood ? Math.min(this.patience, GIVE_UP_AFTER_STANDING) : this.patience)) {
      if (!this.stood) this.patience = Math.min(2 * this.patience, GIVE_UP_LATEST);
      this.silence = 0;
      this.stood = false;
      return "dead";
    }
    if (this.silence >= SILENT_AFTER) return "silent";
    return this.silence >= ASK_AFTER || passed >= STOOD ? "ask" : "well";
  }
}

/** A name by which the server recognizes the page, to drop an older connection of it. */
export function newName() {
  return [...crypto.getRandomValues(new Uint8Array(16))].map((byte) => byte.toString(16).padStart(2, "0")).join("");
}
