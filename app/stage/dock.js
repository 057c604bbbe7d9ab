// @ts-check
/**
 * Places the bar at the bottom of the canvas, above what covers it, and tells the styles how high it reaches.
 *
 * @param {DOMRect} box of the canvas
 * @param {number} hidden covered height at its bottom, px
 * @returns {number} its height, px
 */
export function placeTransport(box, hidden) {
  const dock = /** @type {HTMLElement | null} */ (document.querySelector(".softrod-dock"));
  if (!dock) return 0;
  dock.style.left = `${box.left}px`;
  dock.style.width = `${box.width}px`;
  const below = window.innerHeight - box.bottom + hidden;
  dock.style.bottom = `${below}px`;
  document.documentElement.style.setProperty("--softrod-floor", `${below + dock.offsetHeight}px`);
  return dock.offsetHeight;
}
