// @ts-check
/** The connection of a class's page to the server; `app/wire/line.py` says what travels by it. */
import { receive, sendBy, stopSending } from "../../wire/channel.js";
import { Attempts, CHECK_EVERY, newName, Pulse } from "../../wire/pulse.js";

/** Bytes before each letter. */
const HEAD = 8;

/** @typedef {import("../../wire/pulse.js").Line} Line */

/** The address of the connection, as the page's own address says. @param {string} name */
function address(name) {
  const asked = new URLSearchParams(location.search);
  const fields = ["room", "as", "lang"].filter((field) => asked.has(field)).map((field) => `${field}=${encodeURIComponent(asked.get(field) || "")}`);
  const folder = location.pathname.replace(/[^/]*$/, "");
  return `${location.protocol.replace("http", "ws")}//${location.host}${folder}line/${name}${fields.length ? "?" : ""}${fields.join("&")}`;
}

/** The letters of a batch. @param {ArrayBuffer} batch */
export function letters(batch) {
  const view = new DataView(batch), texts = new TextDecoder();
  const found = [];
  for (let at = 0; at < batch.byteLength; ) {
    const size = view.getUint32(at, true), count = view.getUint32(at + 4, true);
    const begin = at + HEAD, numbers = begin + 4 * Math.ceil(size / 4);
    found.push({ text: texts.decode(new Uint8Array(batch, begin, size)), numbers: count ? new Float32Array(batch, numbers, count) : undefined });
    at = numbers + 4 * count;
  }
  return found;
}

/** Whether this page is to have no connection any more. */
let isOver = false;
/** @type {WebSocket | null} */
let socket = null;

/** Closes the connection for good: nobody uses this page any more. */
export function hangUp() {
  isOver = true;
  if (socket) socket.close();
}

/** Connects, and again whenever the connection is lost. @param {(line: Line) => void} changed is told how the connection is */
export function openLine(changed) {
  const name = newName(), attempts = new Attempts();
  let pulse = new Pulse();
  /** @type {Line | null} */
  let line = null;
  /** @param {Line} now */
  const become = (now) => {
    if (line === now) return;
    line = now;
    if (now === "closed") stopSending();
    changed(now);
  };
  const connect = () => {
    if (isOver || !attempts.begin(performance.now())) return;
    const made = new WebSocket(address(name));
    socket = made;
    made.binaryType = "arraybuffer";
    made.onopen = () => {
      attempts.end();
      pulse = new Pulse();
      become("connected");
    };
    made.onmessage = ({ data }) => {
      pulse.heard();
      if (line === "silent") become("connected");
      for (const letter of letters(data)) receive({ type: "SoftrodMessage", ...letter });
    };
    made.onclose = () => {
      if (socket !== made) return;
      socket = null;
      attempts.end();
      become("closed");
    };
  };
  sendBy(({ text }) => {
    // Messages on a silent connection would take effect late, when nobody expects it.
    if (socket && socket.readyState === WebSocket.OPEN && line === "connected" && text) socket.send(text);
  });
  const look = () => {
    if (!socket) connect();
    if (!socket || socket.readyState !== WebSocket.OPEN) return;
    const found = pulse.look(performance.now());
    if (found === "dead") {
      const dead = socket;
      socket = null;
      dead.close();
      become("closed");
      connect();
    } else if (found !== "well") {
      if (found === "silent") become("silent");
      socket.send("");
    }
  };
  connect();
  setInterval(look, CHECK_EVERY);
  document.addEventListener("visibilitychange", look);
}
