// @ts-check
/*
 * Follows a small piece of a picture from frame to frame: where it looks most alike, by normalised cross-correlation
 * (Lewis 1995, "Fast normalized cross-correlation"), and between pixels by a parabola through the largest values.
 */

/**
 * A picture in grey, row by row.
 * @typedef {{ width: number, height: number, values: Float32Array }} Grey
 */
/**
 * A piece of a picture: values less their mean, and the root of the sum of their squares. `dx` and `dy` lead from its
 * middle pixel to the marked point.
 * @typedef {{ half: number, values: Float32Array, size: number, dx: number, dy: number }} Template
 */

/** Pixels from the middle of a template to its side. */
export const HALF = 9;
/** Pixels to each side within which a template is looked for. */
export const REACH = 28;
/** Likeness, at most 1, below which a template counts as lost. */
export const LOST = 0.7;
/** Variance of the grey of a template, of 255², below which there is nothing to recognise. */
const PLAIN = 4;

/**
 * @param {Uint8ClampedArray} pixels red, green, blue and opacity of each
 * @param {number} width
 * @param {number} height
 * @returns {Grey}
 */
export function greyOf(pixels, width, height) {
  const values = new Float32Array(width * height);
  for (let i = 0; i < values.length; i++) {
    values[i] = 0.299 * pixels[4 * i] + 0.587 * pixels[4 * i + 1] + 0.114 * pixels[4 * i + 2];
  }
  return { width, height, values };
}

/**
 * The piece of a picture around a point; null where it is too near to the picture's edge, or plain.
 * @param {Grey} grey
 * @param {number} x of the point, pixels; the middle of the first one is at 0.5
 * @param {number} y
 * @param {number} [half]
 * @returns {Template | null}
 */
export function cutOut(grey, x, y, half = HALF) {
  const column = Math.floor(x), row = Math.floor(y);
  const side = 2 * half + 1;
  if (column < half || row < half || column >= grey.width - half || row >= grey.height - half) return null;
  const values = new Float32Array(side * side);
  let sum = 0;
  for (let j = 0; j < side; j++) {
    for (let i = 0; i < side; i++) {
      const value = grey.values[(row - half + j) * grey.width + column - half + i];
      values[j * side + i] = value;
      sum += value;
    }
  }
  const mean = sum / values.length;
  let squares = 0;
  for (let i = 0; i < values.length; i++) {
    values[i] -= mean;
    squares += values[i] * values[i];
  }
  if (squares < PLAIN * values.length) return null;
  return { half, values, size: Math.sqrt(squares), dx: x - column, dy: y - row };
}

/**
 * How much the piece of a picture around a pixel is like a template: 1 where it is the same but for light and contrast.
 * @param {Grey} grey
 * @param {Template} template
 * @param {number} column
 * @param {number} row
 */
function likeness(grey, template, column, row) {
  const { half, values, size } = template;
  const side = 2 * half + 1;
  let sum = 0, squares = 0, product = 0;
  for (let j = 0; j < side; j++) {
    let at = (row - half + j) * grey.width + column - half;
    for (let i = 0; i < side; i++, at++) {
      const value = grey.values[at];
      sum += value;
      squares += value * value;
      product += value * values[j * side + i];
    }
  }
  const spread = squares - (sum * sum) / values.length;
  return spread < PLAIN * values.length ? 0 : product / (size * Math.sqrt(spread));
}

/**
 * Where a template is in a picture; null where nothing within reach is like it.
 * @param {Grey} grey
 * @param {Template} template
 * @param {number} x where it is looked for
 * @param {number} y
 * @param {number} [reach]
 * @returns {{ x: number, y: number, likeness: number } | null}
 */
export function find(grey, template, x, y, reach = REACH) {
  const { half } = template;
  const middle = Math.floor(x - template.dx + 0.5), centre = Math.floor(y - template.dy + 0.5);
  const left = Math.max(half, middle - reach), right = Math.min(grey.width - 1 - half, middle + reach);
  const top = Math.max(half, centre - reach), bottom = Math.min(grey.height - 1 - half, centre + reach);
  let best = -1, column = -1, row = -1;
  for (let j = top; j <= bottom; j++) {
    for (let i = left; i <= right; i++) {
      const value = likeness(grey, template, i, j);
      if (value > best) [best, column, row] = [value, i, j];
    }
  }
  if (best < LOST) return null;
  const across = column > half && column < grey.width - 1 - half;
  const along = row > half && row < grey.height - 1 - half;
  const at = (/** @type {number} */ i, /** @type {number} */ j) => likeness(grey, template, column + i, row + j);
  return {
    x: column + template.dx + (across ? vertex(at(-1, 0), best, at(1, 0)) : 0),
    y: row + template.dy + (along ? vertex(at(0, -1), best, at(0, 1)) : 0),
    likeness: best,
  };
}

/** Where the parabola through three values has its top, from the middle one. @param {number} before @param {number} here @param {number} after */
function vertex(before, here, after) {
  const bend = before - 2 * here + after;
  return bend < 0 ? Math.max(-0.5, Math.min(0.5, (0.5 * (before - after)) / bend)) : 0;
}
