// @ts-check
/** Where on the bar a time is: the last minute takes half of it, or more, and all that was before the rest. */

/** Seconds that stay fine, however long the run is. */
export const FINE = 60;

/**
 * The bar of a run. Positions on it are seconds from its end back, in which the last minute is true, and what was
 * before takes at most as much room.
 * @param {number} start of the run, s
 * @param {number} end
 */
export function barOf(start, end) {
  const turn = Math.max(start, end - FINE);
  const before = turn - start;
  const room = Math.min(before, FINE);
  return {
    /** The lowest position; the highest is the end of the run. */
    low: turn - room,
    /** The position from which on seconds are true. */
    turn,
    /** @param {number} position @returns {number} the time there, s */
    time: (position) => (position >= turn || room === 0 ? position : start + ((position - turn + room) / room) * before),
    /** @param {number} time s @returns {number} its position */
    position: (time) => (time >= turn || before === 0 ? time : turn - room + ((time - start) / before) * room),
  };
}
