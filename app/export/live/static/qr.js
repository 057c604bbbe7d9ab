// @ts-check
/**
 * QR codes of one size: version 5 with the least correction (5-L), for up to 154 capital letters, digits and some signs
 * (ISO/IEC 18004). All data is one block, so that nothing is interleaved.
 */

/** Modules of a side. */
const SIZE = 37;
/** Letters, at most. */
const MAX_LETTERS = 154;
/** Codewords of data. */
const DATA = 108;
/** Codewords of error correction. */
const EXTRA = 26;
const LETTERS = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ $%*+-./:";
/** The mask (row + column) % 2, and the bits that name it and the correction, with their own correction. */
const FORMAT = 0b111011111000100;

/** Products in the field of 256 elements that QR codes are corrected in. @param {number} a @param {number} b */
function times(a, b) {
  let product = 0;
  for (let bit = 7; bit >= 0; bit--) product = (product << 1) ^ ((product >> 7) * 0x11d) ^ (((b >> bit) & 1) * a);
  return product;
}

/** The codewords of correction, by Reed and Solomon. @param {number[]} data */
function correction(data) {
  // The coefficients of the product of all (x - 2^i), without the first one.
  let divisor = Array(EXTRA).fill(0);
  divisor[EXTRA - 1] = 1;
  for (let i = 0, root = 1; i < EXTRA; i++, root = times(root, 2)) {
    divisor = divisor.map((value, k) => times(value, root) ^ (divisor[k + 1] ?? 0));
  }
  const rest = Array(EXTRA).fill(0);
  for (const word of data) {
    const factor = word ^ rest[0];
    rest.push(0);
    rest.shift();
    divisor.forEach((value, k) => (rest[k] ^= times(value, factor)));
  }
  return rest;
}

/** The codewords of a text. @param {string} text */
function codewords(text) {
  let bits = "";
  const put = (/** @type {number} */ value, /** @type {number} */ width) => (bits += value.toString(2).padStart(width, "0"));
  put(0b0010, 4);
  put(text.length, 9);
  for (let i = 0; i < text.length; i += 2) {
    const pair = [...text.slice(i, i + 2)].map((letter) => LETTERS.indexOf(letter));
    if (pair.includes(-1)) throw new RangeError("a letter has no place in this QR code");
    if (pair.length === 2) put(45 * pair[0] + pair[1], 11);
    else put(pair[0], 6);
  }
  bits = bits.padEnd(Math.min(bits.length + 4, 8 * DATA), "0");
  bits = bits.padEnd(8 * Math.ceil(bits.length / 8), "0");
  const words = (bits.match(/.{8}/g) ?? []).map((byte) => parseInt(byte, 2));
  for (let i = 0; words.length < DATA; i++) words.push(i % 2 ? 0x11 : 0xec);
  return [...words, ...correction(words)];
}

/**
 * The modules of a QR code, by rows: whether each is dark.
 *
 * @param {string} text of the letters above, at most 154
 * @returns {boolean[][]}
 */
export function qrCode(text) {
  if (text.length > MAX_LETTERS) throw new RangeError("the text is too long for this QR code");
  /** @type {(boolean | null)[][]} null where data is to come */
  const grid = Array.from({ length: SIZE }, () => Array(SIZE).fill(null));
  /** Squares in each other around a place. @param {number} row @param {number} column @param {number} reach @param {number[]} light */
  const squares = (row, column, reach, light) => {
    for (let r = row - reach; r <= row + reach; r++) {
      for (let c = column - reach; c <= column + reach; c++) {
        if (grid[r]?.[c] !== undefined) grid[r][c] = !light.includes(Math.max(Math.abs(r - row), Math.abs(c - column)));
      }
    }
  };
  for (const [row, column] of [[3, 3], [3, SIZE - 4], [SIZE - 4, 3]]) squares(row, column, 4, [2, 4]);
  squares(SIZE - 7, SIZE - 7, 2, [1]);
  for (let i = 8; i < SIZE - 8; i++) grid[6][i] = grid[i][6] = i % 2 === 0;
  for (let i = 0; i < 15; i++) {
    const bit = ((FORMAT >> i) & 1) === 1;
    const near = i < 6 ? i : i < 8 ? i + 1 : i < 9 ? 7 : 14 - i;
    // Next to the upper left square, and again next to the two others.
    if (i < 8) [grid[near][8], grid[8][SIZE - 1 - i]] = [bit, bit];
    else [grid[8][near], grid[SIZE - 15 + i][8]] = [bit, bit];
  }
  grid[SIZE - 8][8] = true;
  const bits = codewords(text).flatMap((word) => [7, 6, 5, 4, 3, 2, 1, 0].map((bit) => ((word >> bit) & 1) === 1));
  let at = 0;
  for (let pair = SIZE - 1, up = true; pair > 0; pair -= 2, up = !up) {
    if (pair === 6) pair--; // the column of the timing pattern
    for (let i = 0; i < SIZE; i++) {
      const row = up ? SIZE - 1 - i : i;
      for (const column of [pair, pair - 1]) {
        if (grid[row][column] !== null) continue;
        // A few modules are left over; they are light before the mask.
        grid[row][column] = (bits[at++] ?? false) !== ((row + column) % 2 === 0);
      }
    }
  }
  return grid.map((line) => line.map(Boolean));
}
