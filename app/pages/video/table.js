// @ts-check
/* The table of what was marked, in the form that softrod writes and reads. */

/** @typedef {{ x: number, y: number }} Place */
/**
 * How pixels of a video become lengths: the place of the origin, and how many pixels a unit is.
 * @typedef {{ origin: Place, pixels: number, unit: string, down: boolean }} Scale
 */
/**
 * A point of a video: what it is called, and its place in each frame in which it is marked, pixels.
 * @typedef {{ name: string, places: Map<number, Place> }} Point
 */

/** Digits of a number: a thousandth of a pixel is far less than can be seen. @param {number} value */
const digits = (value) => String(Number(value.toPrecision(7)));

/** @param {Place} place pixels, from the top left @param {Scale} scale @returns {Place} */
export function measured({ x, y }, { origin, pixels, down }) {
  const up = (y - origin.y) / pixels;
  return { x: (x - origin.x) / pixels, y: (down ? up : -up) || 0 };
}

/**
 * CSV: the time, and x and y of each point with their unit; a frame in which a point is not marked leaves its place
 * empty. A frame that is no later than the one before is the same picture, and left out.
 * @param {Point[]} points
 * @param {Map<number, number>} times of the frames, s
 * @param {Scale} scale
 */
export function tableOf(points, times, scale) {
  const marked = points.filter((point) => point.places.size);
  const every = [...new Set(marked.flatMap((point) => [...point.places.keys()]))].sort((a, b) => a - b);
  const timeOf = (/** @type {number} */ frame) => times.get(frame) ?? NaN;
  const frames = every.filter((frame, i) => i === 0 || timeOf(frame) > timeOf(every[i - 1]));
  const head = ["time [s]", ...marked.flatMap(({ name }) => [`${name}.x [${scale.unit}]`, `${name}.y [${scale.unit}]`])];
  const rows = frames.map((frame) => [
    digits(timeOf(frame)),
    ...marked.flatMap(({ places }) => {
      const place = places.get(frame);
      if (!place) return ["", ""];
      const { x, y } = measured(place, scale);
      return [digits(x), digits(y)];
    }),
  ]);
  return [head, ...rows].map((row) => row.join(",") + "\n").join("");
}
