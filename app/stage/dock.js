// @ts-check
/**
 * Places the bar at the bottom of the canvas, above what covers it, and tells the styles how high it reaches, and a sheet over it.
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
  const floor = below + dock.offsetHeight;
  const { style } = document.documentElement;
  style.setProperty("--softrod-floor", `${floor}px`);
  style.setProperty("--softrod-over", `${Math.max(0, window.innerHeight - floorOf(box) - floor)}px`);
  return dock.offsetHeight;
}

/** The lower end of the visible part of the canvas: that of the bar of time, or of a sheet. @param {DOMRect} box of the canvas */
export function floorOf(box) {
  const covers = [...document.querySelectorAll(".softrod-dock, .softrod-panel")].map((element) => element.getBoundingClientRect());
  const across = covers.filter(({ left, width }) => width > 0 && left <= box.left + 1 && left + width >= box.right - 1);
  return Math.min(box.bottom, ...across.map(({ top }) => top));
}
