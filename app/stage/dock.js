// @ts-check
/**
 * Places the bar at the bottom of the canvas, above what covers it.
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
  dock.style.bottom = `${window.innerHeight - box.bottom + hidden}px`;
  return dock.offsetHeight;
}
