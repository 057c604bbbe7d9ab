// @ts-check
/** The storage of the tab. If the browser forbids it, nothing is stored, and the page works all the same. */

/** The text stored under a name, or null. @param {string} name */
export function kept(name) {
  try {
    return sessionStorage.getItem(name);
  } catch {
    return null;
  }
}

/**
 * Stores a text. If there is no room for it the old one is removed too: better nothing than an outdated state.
 *
 * @param {string} name
 * @param {string} text
 */
export function store(name, text) {
  try {
    sessionStorage.removeItem(name);
    sessionStorage.setItem(name, text);
  } catch {
    // Forbidden or full.
  }
}
