// @ts-check
/**
 * Whether the server is there. viser's page has its WebSocket in a worker; what that worker says is heard here.
 *
 * A browser that was refused many times makes every further attempt wait for some seconds. viser begins another
 * one every second, which gives up the one that waits, so after half a minute it never comes back. Here an
 * attempt has its time.
 */
import { lost } from "./keep.js";

/** Milliseconds that an attempt has before another may take its place. */
const PATIENCE = 8000;
/** Milliseconds between two looks whether it is time for an attempt, also where the window has no focus. */
const RETRY_EVERY = 1000;

/** Decides which attempts to connect are made. */
export class Attempts {
  constructor() {
    this.under = -Infinity;
  }

  /** Whether one may begin; then it is under way. @param {number} now ms */
  begin(now) {
    if (now - this.under < PATIENCE) return false;
    this.under = now;
    return true;
  }

  /** The one under way has failed, or the connection is lost. */
  end() {
    this.under = -Infinity;
  }
}

/**
 * What is added to the server's address, for it to know which controls the page's address asks for.
 *
 * @param {string} search the query of the page's address
 */
export function wantedControls(search) {
  const controls = new URLSearchParams(search).get("controls");
  return controls === null ? "" : `/?controls=${encodeURIComponent(controls)}`;
}

/**
 * Watches every worker that the page makes from now on.
 *
 * @param {(connected: boolean) => void} changed
 */
export function watchConnection(changed) {
  const attempts = new Attempts();
  /** @type {ReturnType<typeof setInterval> | undefined} */
  let retrying;
  class Watched extends Worker {
    /** @param {string | URL} url @param {WorkerOptions} [options] */
    constructor(url, options) {
      super(url, options);
      this.addEventListener("message", ({ data }) => {
        if (data?.type === "connected") {
          attempts.end();
          clearInterval(retrying);
          retrying = undefined;
          changed(true);
        } else if (data?.type === "closed") {
          attempts.end();
          retrying ??= setInterval(() => this.postMessage({ type: "retry" }), RETRY_EVERY);
          changed(false);
        }
      });
    }
    /** @param {any} message @param {any} [transfer] */
    postMessage(message, transfer) {
      if (message?.type === "retry" && !attempts.begin(performance.now())) return;
      const named = message?.type === "set_server" && { ...message, server: message.server + wantedControls(location.search) };
      super.postMessage(named || message, transfer);
    }
  }
  window.Worker = Watched;
}

/** A line over the canvas while the connection is lost. */
export function showConnection() {
  /** @type {HTMLElement | null} */
  let banner = null;
  /** @param {boolean} connected */
  return (connected) => {
    if (connected) {
      banner?.remove();
      banner = null;
      return;
    }
    lost();
    if (!banner) {
      banner = document.createElement("div");
      banner.className = "softrod-banner";
      banner.setAttribute("role", "status");
      banner.textContent = "The connection is lost. Reconnecting…";
      document.body.append(banner);
    }
  };
}
