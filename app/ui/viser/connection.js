// @ts-check
/**
 * Watches the connection of viser's page to the server. That has its WebSocket in a worker; messages to and from that worker
 * pass through here. viser begins another attempt to connect every second, see `Attempts`.
 */
import { Attempts, CHECK_EVERY, newName, Pulse } from "../../wire/pulse.js";

/** @typedef {import("../../wire/pulse.js").Line} Line */

/** Workers with connections of the page. @type {Set<Worker>} */
const workers = new Set();

/** Closes the connection for good: nobody uses this page any more. */
export function giveUpConnection() {
  for (const worker of workers) worker.terminate();
  workers.clear();
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
  const always = ["controls", "room", "as", "lang"].filter((field) => asked.has(field));
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
