// @ts-check
/** Round lengths, as scales and grids have them. Arithmetic only. */

/**
 * Rounds up to one of 1, 2, 5, 10, 20, ...
 *
 * @param {number} least
 */
export function roundUp(least) {
  const power = 10 ** Math.floor(Math.log10(least));
  return power * (/** @type {number} */ ([1, 2, 5, 10].find((step) => step * power >= least * (1 - 1e-9))));
}

/** A round length as text; parts of a metre in cm. @param {number} size @param {string} unit */
export function lengthText(size, unit) {
  const inCm = unit === "m" && size < 1 && size >= 0.01;
  return `${Number((inCm ? 100 * size : size).toPrecision(1))} ${inCm ? "cm" : unit}`;
}

/** Rounds down to one of these. @param {number} most */
export function roundDown(most) {
  const power = 10 ** Math.floor(Math.log10(most));
  return power * (/** @type {number} */ ([10, 5, 2, 1].find((step) => step * power <= most * (1 + 1e-9))));
}
