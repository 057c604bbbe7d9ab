// @ts-check
/** The phases of a class. */

/** Phases in which each pupil has a body of their own. */
export const OWN_BODY = new Set(["try", "collect"]);

/** Phases in which what was predicted and chosen matters. */
export const PREDICTED = new Set(["ask", "results", "run", "reveal", "explain"]);
