// @ts-check
/** The tab's own storage. A browser may forbid it: then nothing is kept, and the page works all the same. */

/** What is kept under a name, or null. @param {string} name */
export function kept(name) {
  try {
    return sessionStorage.getItem(name);
  } catch {
    return null;
  }
}

/**
 * Keeps a text. If there is no room for it, what was kept before goes too: better nothing than something old.
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
