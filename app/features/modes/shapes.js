// @ts-check
/** Shapes and levels of modes as feature.py encodes them, and where a shape places the masses. Arithmetic and words, without a page. */
import { sections } from "../../wire/unpack.js";
import { decimal, say } from "../../words/words.js";

/**
 * @typedef {object} Shape
 * @property {Float32Array} moves x and y of each mass, relative to the largest
 * @property {Float32Array} nodes a spring for each, and how far along it
 * @property {Float32Array} antinodes masses
 *
 * @typedef {object} Shapes
 * @property {number} number that levels have, too
 * @property {number} size of the body, px
 * @property {Float32Array} rest x and y of each mass, px
 * @property {Float32Array} part of each mass
 * @property {Shape[]} modes
 *
 * @typedef {object} Levels
 * @property {number} number of the shapes
 * @property {number} time simulated seconds
 * @property {number} other what is in no mode, in full bars; negative where the modes would have more than the body has
 * @property {number} touching contact energy, in that of a full bar
 * @property {Float32Array} levels amplitude of each mode, in full bars
 * @property {Float32Array} shares of the energy: of each mode, and of what is in none
 * @property {Float32Array} frames cosine, sine, x and y of each part
 */

/** @param {Float32Array} data @returns {Shapes | null} */
export function readShapes(data) {
  if (!data.length) return null;
  const take = sections(data);
  const [number, size] = take();
  const [rest, part] = [take(), take()];
  const modes = [];
  for (let moves = take(); moves.length; moves = take()) modes.push({ moves, nodes: take(), antinodes: take() });
  return { number, size, rest, part, modes };
}

/** @param {Float32Array} data @returns {Levels} */
export function readLevels(data) {
  const take = sections(data);
  const [number, time, other, touching] = take();
  return { number, time, other, touching, levels: take(), shares: take(), frames: take() };
}

/**
 * The places of the masses when a mode is at an amplitude.
 *
 * @param {Shapes} shapes
 * @param {number} mode
 * @param {number} amplitude of the mass that it moves most, px
 * @param {Float32Array} [frames] present positions and turns of the parts
 * @returns {Float32Array} px, x and y of each
 */
export function posed({ rest, part, modes }, mode, amplitude, frames) {
  const { moves } = modes[mode];
  const places = new Float32Array(rest.length);
  for (let m = 0; m < part.length; m++) {
    const [x, y] = [rest[2 * m] + amplitude * moves[2 * m], rest[2 * m + 1] + amplitude * moves[2 * m + 1]];
    const at = 4 * part[m];
    const lies = frames !== undefined && at + 3 < frames.length;
    const [c, s, dx, dy] = lies ? frames.subarray(at, at + 4) : [1, 0, 0, 0];
    places[2 * m] = c * x - s * y + dx;
    places[2 * m + 1] = s * x + c * y + dy;
  }
  return places;
}

/** A number with as many digits as are useful. @param {number} value @param {number} [digits] */
export const few = (value, digits = 3) => decimal(String(Number(value.toPrecision(digits))));

/** A share of the energy in words. @param {number} share */
export function percent(share) {
  const value = 100 * Math.abs(share);
  return value > 0 && value < 0.1 ? say("modes-share.least") : say("modes-share", { percent: few(value, value < 10 ? 2 : 3) });
}
