// @ts-check
/** Numbers as text. */
import { decimal } from "../words/words.js";

/** A thin space that does not break a line. */
const THIN = "\u202f";

/** A number with at most seven digits, in groups of three, and a minus instead of a hyphen. @param {number} value */
export const grouped = (value) =>
  decimal(
    Number(value.toPrecision(7))
      .toLocaleString("en-US", { maximumFractionDigits: 12 })
      .replace(/,/g, THIN)
      .replace("-", "−"),
  );
