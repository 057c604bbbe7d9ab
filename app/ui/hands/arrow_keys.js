// @ts-check
/** The arrow keys. */

/** Where each points, y upwards. @type {Record<string, [x: number, y: number]>} */
export const ARROWS = { ArrowUp: [0, 1], ArrowDown: [0, -1], ArrowLeft: [-1, 0], ArrowRight: [1, 0] };

/** The name of an arrow key while it is held, as messages have it; undefined for any other key. @param {{key: string}} event */
export const heldArrow = ({ key }) =>
  key in ARROWS ? /** @type {"up" | "down" | "left" | "right"} */ (key.slice("Arrow".length).toLowerCase()) : undefined;
