// @ts-check
/** The phases of a class. */

/** Phases in which each pupil has a body of their own. */
export const OWN_BODY = new Set(["try", "collect"]);
