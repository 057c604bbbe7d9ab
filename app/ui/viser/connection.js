// @ts-check
/**
 * Whether the server is there. viser's page has its WebSocket in a worker; what goes to and from that worker is
 * seen here.
 *
 * A path can die without a word: the server stands still, a Wi-Fi roams, a proxy forgets. Neither end is told, and
 * the socket stays open. So the page asks the server for a sign of life whenever it has heard nothing for a
 * while, which is tiny and costs nothing while a body moves. The gate answers it (`Gate`), whatever else the
 * server does.
 *
 * A browser that was refused many times makes every further attempt wait for some seconds. viser begins another
 * one every second, which gives up the one that waits, so after half a minute it never comes back. Here an
 * attempt has its time.
 */

/** By what the times after which a page loses its patience are divided: a browser test may set it before the page begins. */
const HURRY = Number(/** @type {any} */ (globalThis).__softrodHurry) || 1;
/** Milliseconds that an attempt has before another may take its place. */
const PATIENCE = 8000 / HURRY;
/** Milliseconds between two looks, whether it is time for an attempt or for a sign of life. */
const LOOK_EVERY = 1000 / HURRY;
/** Milliseconds between two looks beyond which it was the page that stood still: a hidden page, a sleeping machine. */
const STOOD = 2500;
/** Milliseconds of silence after which the server is asked for a sign of life. */
const ASK_AFTER = 2000 / HURRY;
/** Milliseconds of silence after which the page says so. */
const SILENT_AFTER = 7000 / HURRY;
/** Milliseconds of silence after which the connection is given up for a new one; at first, and at most. */
const GIVE_UP_AFTER = 14_000 / HURRY;
const GIVE_UP_LATEST = 56_000;

/** @typedef {"connected" | "silent" | "closed"} Line how the connection is */

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

/** Measures how long a connection has been silent, and says what is to be done about it. */
export class Pulse {
  constructor() {
    this.silence = 0;
    this.looked = -Infinity;
    /**
     * Silence after which it is given up. A large message on a slow path is silent, too, so it grows, until a connection
     * has been well for as long as it can be.
     */
    this.patience = GIVE_UP_AFTER;
    this.well = 0;
  }

  /** Something came. */
  heard() {
    this.silence = 0;
  }

  /**
   * Looks at the clock, some times a minute or more.
   *
   * @param {number} now ms
   * @returns {"well" | "ask" | "silent" | "dead"} "silent" and "dead" want a sign of life, too
   */
  look(now) {
    const passed = now - this.looked;
    this.looked = now;
    // What came while the page stood still may wait behind this very look. So such a time proves nothing.
    if (passed < STOOD) {
      this.silence += passed;
      this.well = this.silence < SILENT_AFTER ? this.well + passed : 0;
    }
    if (this.well >= GIVE_UP_LATEST) this.patience = GIVE_UP_AFTER;
    if (this.silence >= this.patience) {
      this.patience = Math.min(2 * this.patience, GIVE_UP_LATEST);
      this.silence = 0;
      return "dead";
    }
    if (this.silence >= SILENT_AFTER) return "silent";
    return this.silence >= ASK_AFTER || passed >= STOOD ? "ask" : "well";
  }
}

/** The workers that hold the page's connection. @type {Set<Worker>} */
const workers = new Set();

/** Gives the connection up for good: nobody looks at this page any more. */
export function giveUpConnection() {
  for (const worker of workers) worker.terminate();
  workers.clear();
}

/** Names this page to the server, which drops an older connection of the same page that it still holds. */
function newName() {
  return [...crypto.getRandomValues(new Uint8Array(16))].map((byte) => byte.toString(16).padStart(2, "0")).join("");
}

/**
 * What of the page's address says which scene it shows, as one of its own or as a class's; empty if nothing does.
 *
 * @param {string} search the query of the page's address
 */
export function askedScene(search) {
  const found = [...new URLSearchParams(search)].find(([field]) => ["s", "scene", "room"].includes(field));
  return found ? `${found[0]}=${encodeURIComponent(found[1])}` : "";
}

/**
 * What is added to the server's address: the page's name, and what the page's own address asks for.
 *
 * @param {string} name
 * @param {string} search the query of the page's address
 * @param {boolean} isNew whether the page has nothing to go on with, and gets the scene that its address asks for
 */
export function serverPath(name, search, isNew) {
  const asked = new URLSearchParams(search);
  const always = ["controls", "room", "as"].filter((field) => asked.has(field));
  const scene = isNew && !asked.has("room") ? askedScene(search) : "";
  const fields = [scene, ...always.map((field) => `${field}=${encodeURIComponent(asked.get(field) ?? "")}`)].filter(Boolean);
  return `/at/${name}${fields.length ? "?" : ""}${fields.join("&")}`;
}

/**
 * Watches every worker that the page makes from now on.
 *
 * @param {(line: Line) => void} changed called while messages can still be sent, where they ever can
 * @param {() => boolean} isNew whether the page has nothing to go on with
 */
export function watchConnection(changed, isNew) {
  const attempts = new Attempts();
  const pulse = new Pulse();
  const name = newName();
  let server = "";
  /** @type {Line | null} */
  let line = null;
  /** @param {Line} now */
  const become = (now) => {
    if (line !== now) changed(now);
    line = now;
  };
  class Watched extends Worker {
    /** @param {string | URL} url @param {WorkerOptions} [options] */
    constructor(url, options) {
      super(url, options);
      workers.add(this);
      this.addEventListener("message", ({ data }) => {
        pulse.heard();
        if (data?.type === "connected" || data?.type === "closed") {
          attempts.end();
          become(data.type);
        } else if (line === "silent") {
          become("connected");
        }
      });
      setInterval(() => this.look(), LOOK_EVERY);
      document.addEventListener("visibilitychange", () => this.look());
    }

    look() {
      if (!workers.has(this)) return;
      const found = pulse.look(performance.now());
      if (line === "closed") this.postMessage({ type: "retry" });
      if (line !== "connected" && line !== "silent") return;
      if (found === "dead") {
        // viser's page believes it, and begins a new attempt, which closes the old socket.
        this.dispatchEvent(new MessageEvent("message", { data: { type: "closed", closeReason: "silence" } }));
        return;
      }
      if (found === "silent") become("silent");
      if (found !== "well") super.postMessage({ type: "send", message: { type: "BeatMessage" } });
    }

    /** @param {any} message @param {any} [transfer] */
    postMessage(message, transfer) {
      // Whatever is sent into a silent path would be done late, when nobody expects it.
      if (message?.type === "send" && line === "silent") return;
      if (message?.type === "set_server") server = message.server;
      if (message?.type === "set_server" || message?.type === "retry") {
        if (!attempts.begin(performance.now())) return;
        super.postMessage({ type: "set_server", server: server + serverPath(name, location.search, isNew()) });
        return;
      }
      super.postMessage(message, transfer);
    }
  }
  window.Worker = Watched;
}
