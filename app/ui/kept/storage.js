// @ts-check
/**
 * The storage of the tab, and that of the browser for all pages of one origin. What the browser forbids to store, or has no
 * room for, lasts as long as the page is open.
 */

/** @param {"sessionStorage" | "localStorage"} where */
function storage(where) {
  /** Instead of the browser's. @type {Map<string, string>} */
  const memory = new Map();
  return {
    /** The text stored under a name, or null. @param {string} name @returns {string | null} */
    kept(name) {
      try {
        return memory.get(name) ?? globalThis[where].getItem(name);
      } catch {
        return null;
      }
    },
    /**
     * Stores a text. If there is no room for it, the old one is removed too: after a reload, better nothing than an outdated
     * state.
     *
     * @param {string} name
     * @param {string} text
     */
    store(name, text) {
      memory.set(name, text);
      try {
        globalThis[where].removeItem(name);
        globalThis[where].setItem(name, text);
        memory.delete(name);
      } catch {
        // Forbidden or full.
      }
    },
  };
}

const ofTab = storage("sessionStorage");
const ofBrowser = storage("localStorage");

/** Of the tab, see `storage`. */
export const kept = ofTab.kept;
export const store = ofTab.store;
/** Of the browser. */
export const remembered = ofBrowser.kept;
export const remember = ofBrowser.store;

/** Seconds for which a cookie is kept. */
const YEAR = 365 * 24 * 3600;

/** Stores what the server reads before it answers; whether the browser does. @param {string} name @param {string} value */
export function storeCookie(name, value) {
  try {
    document.cookie = `${name}=${value}; path=/; max-age=${YEAR}; samesite=lax`;
    return document.cookie.includes(`${name}=${value}`);
  } catch {
    return false;
  }
}
