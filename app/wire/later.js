// @ts-check
/** Listeners that are loaded once they are needed. */
import { onMessage } from "./channel.js";

/** @typedef {import("./wire.js").Received} Received */

/**
 * Loads what hears some kinds of messages at the first message that asks for it. It is told the last one of each kind
 * from before, in the order in which they came, and then all that come.
 *
 * @template {keyof Received} K
 * @param {readonly K[]} kinds
 * @param {(message: Received[K]) => boolean} asks
 * @param {() => Promise<(message: Received[K]) => void>} load gives what hears them
 */
export function hearLater(kinds, asks, load) {
  /** @type {Map<K, Received[K]>} */
  const before = new Map();
  /** @type {((message: Received[K]) => void) | null} */
  let hear = null;
  let isLoading = false;
  /** @param {Received[K]} message */
  const begin = async (message) => {
    if (isLoading || !asks(message)) return;
    isLoading = true;
    try {
      hear = await load();
    } catch {
      return; // The server cannot be reached; the next message tries again.
    } finally {
      isLoading = false;
    }
    // Each by itself, so that a fault with one is reported and costs no other.
    for (const each of before.values()) void Promise.resolve(each).then(hear);
    before.clear();
  };
  for (const kind of kinds) {
    onMessage(kind, (message) => {
      if (hear) hear(message);
      else {
        before.delete(kind); // so that it is the last one
        before.set(kind, message);
        void begin(message);
      }
    });
  }
}
