// @ts-check
/**
 * Keeps the screen on while nobody touches it and it is needed all the same. Where the browser cannot, as on pages without
 * TLS, the screen goes dark as usual.
 */

/** @type {WakeLockSentinel | null} */
let lock = null;
let isWanted = false;
let isAsking = false;

async function look() {
  if (!navigator.wakeLock || isAsking || isWanted === Boolean(lock && !lock.released)) return;
  if (lock && !isWanted) {
    lock.release();
    lock = null;
  }
  // The browser takes it back whenever the page is hidden.
  if (!isWanted || document.visibilityState !== "visible") return;
  isAsking = true;
  try {
    lock = await navigator.wakeLock.request("screen");
  } catch {
    // The battery is low, or the page is hidden by now.
  }
  isAsking = false;
  if (!isWanted) look();
}

/** Keeps the screen on from now on, or no longer. @param {boolean} on */
export function keepAwake(on) {
  isWanted = on;
  look();
}

document.addEventListener("visibilitychange", look);
