// @ts-check
/**
 * Watches the connection to the server. viser's page has its WebSocket in a worker; messages to and from that worker pass
 * through here.
 *
 * A connection can die silently: the server hangs, a Wi-Fi roams, a proxy drops it. Neither end notices, and the socket
 * stays open. So the page asks the server for a sign of life whenever it has received nothing for a while, which costs
 * nothing while a body moves. The gate answers (`Gate`), whatever else the server does.
 *
 * A browser that was refused many times delays every further attempt by some seconds. viser begins another one every
 * second, which aborts the one that waits, so after half a minute it never reconnects. Here an attempt gets enough time.
 */

/** Divides all waiting times; browser tests may set it before the page begins. */
const HURRY = Number(/** @type {any} */ (globalThis).__softrodHurry) || 1;
/** Milliseconds before an attempt to connect may be replaced by another. */
const PATIENCE = 8000 / HURRY;
/** Milliseconds between two checks. */
const CHECK_EVERY = 1000 / HURRY;
/** Milliseconds between two checks that prove that the page itself was suspended: hidden, or on a sleeping machine. */
const STOOD = 2500;
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
  }

  /**
   * Checks the silence; call it at least several times a minute.
   *
   * @param {number} now ms
   * @returns {"well" | "ask" | "silent" | "dead"} in all cases but "well" ask for a sign of life
   */
  look(now) {
    const passed = now - this.looked;
    this.looked = now;
    // Messages that arrived while the page was suspended may be delivered after this call, so that time does not count.
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

/** Workers with connections of the page. @type {Set<Worker>} */
const workers = new Set();

/** Closes the connection for good: nobody uses this page any more. */
export function giveUpConnection() {
  for (const worker of workers) worker.terminate();
  workers.clear();
}

/** A name by which the server recognizes the page, to drop an older connection of it. */
function newName() {
  return [...crypto.getRandomValues(new Uint8Array(16))].map((byte) => byte.toString(16).padStart(2, "0")).join("");
}

/**
 * The part of the page's address that names a scene, its own or that of a class; empty without one.
 *
 * @param {string} search the query of the page's address
 */
export function askedScene(search) {
  const found = [...new URLSearchParams(search)].find(([field]) => ["s", "scene", "room"].includes(field));
  return found ? `${found[0]}=${encodeURIComponent(found[1])}` : "";
}

/**
 * The path of the connection: the page's name, and what the page's own address asks for.
 *
 * @param {string} name
 * @param {string} search the query of the page's address
 * @param {boolean} isNew the page has no stored state, and gets the scene of its address
 */
export function serverPath(name, search, isNew) {
  const asked = new URLSearchParams(search);
  const always = ["controls", "room", "as"].filter((field) => asked.has(field));
  const scene = isNew && !asked.has("room") ? askedScene(search) : "";
  const fields = [scene, ...always.map((field) => `${field}=${encodeURIComponent(asked.get(field) ?? "")}`)].filter(Boolean);
  return `/at/${name}${fields.length ? "?" : ""}${fields.join("&")}`;
}

/**
 * Watches all workers that the page makes from now on.
 *
 * @param {(line: Line) => void} changed called with each new state, if possible while messages can still be sent
 * @param {() => boolean} isNew returns true if the page has no stored state
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
      setInterval(() => this.look(), CHECK_EVERY);
      document.addEventListener("visibilitychange", () => this.look());
    }

    look() {
      if (!workers.has(this)) return;
      const found = pulse.look(performance.now());
      if (line === "closed") this.postMessage({ type: "retry" });
      if (line !== "connected" && line !== "silent") return;
      if (found === "dead") {
        // This makes viser's page begin a new attempt, which closes the old socket.
        this.dispatchEvent(new MessageEvent("message", { data: { type: "closed", closeReason: "silence" } }));
        return;
      }
      if (found === "silent") become("silent");
      if (found !== "well") super.postMessage({ type: "send", message: { type: "BeatMessage" } });
    }

    /** @param {any} message @param {any} [transfer] */
    postMessage(message, transfer) {
      // Messages on a silent connection would take effect late, when nobody expects it.
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
