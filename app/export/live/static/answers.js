// @ts-check
/**
 * The answers to a lesson as a sheet that a class takes: a file, and a text that is short enough for a QR code. The text is
 * read by `app/classroom/sheets.py`, which has its form.
 *
 * @typedef {[x: number, y: number]} Point
 * @typedef {object} StepAnswer
 * @property {number | null} choice
 * @property {string} line
 * @property {Point[] | null} places where each mass was predicted to be, px
 * @property {boolean} reached whether the step's goal was
 * @typedef {object} Sheet
 * @property {"softrod-answers"} format
 * @property {1} version
 * @property {string} lesson eight hexadecimal digits that tell lessons apart
 * @property {string} id ten random hexadecimal digits, the same for all sheets of this browser
 * @property {number} turn counts the sheets of this browser: a later one has the larger number
 * @property {string} name that was typed, or empty
 * @property {StepAnswer[]} steps
 * @typedef {{left: number, top: number, width: number, height: number}} Frame px, from the corner with the least x and y
 */

import { say } from "../../../words/words.js";

/** How each text begins. */
const MARK = "SR1";
/** Letters of a text, at most; the QR code of `qr.js` has room for 154. */
const MAX_LETTERS = 150;
/** Bytes that are packed, at most, including the two of the checksum. */
const ROOM = Math.floor(((MAX_LETTERS - MARK.length) * 5) / 8);
/** Bytes of a name, at most. */
const MAX_NAME = 24;
/** Letters of five bits each: none that a keyboard with another layout would take for a sign. */
const LETTERS = "ABCDEFGHIJKLMNOPQRSTUVWXYZ234567";
/** The kind of a part of the text that is a line. */
const LINE = 0;
/** The kind of a part that is a prediction. */
const PLACES = 1;

/** A text in UTF-8, cut between two letters to so many bytes. @param {string} text @param {number} most */
function bytesOf(text, most) {
  let bytes = new TextEncoder().encode(text);
  for (let letters = [...text]; bytes.length > most; ) {
    letters = letters.slice(0, -1);
    bytes = new TextEncoder().encode(letters.join(""));
  }
  return [...bytes];
}

/** The checksum of some bytes: CRC-16/CCITT. @param {number[]} bytes */
function check(bytes) {
  let sum = 0xffff;
  for (const byte of bytes) {
    sum ^= byte << 8;
    for (let i = 0; i < 8; i++) sum = ((sum << 1) ^ (sum & 0x8000 ? 0x1021 : 0)) & 0xffff;
  }
  return [sum >> 8, sum & 0xff];
}

/** Bytes as letters. @param {number[]} bytes */
function lettersOf(bytes) {
  const bits = bytes.map((byte) => byte.toString(2).padStart(8, "0")).join("");
  return (bits.match(/.{1,5}/g) ?? []).map((five) => LETTERS[parseInt(five.padEnd(5, "0"), 2)]).join("");
}

/** @param {string} digits hexadecimal */
const pairs = (digits) => (digits.match(/../g) ?? []).map((pair) => parseInt(pair, 16));

/**
 * A sheet as text for a QR code. Choices and goals are always in it; then come predictions, which are rounded to a 128th
 * of the frame, and lines, the last one cut, as far as there is room.
 *
 * @param {Sheet} sheet @param {Frame} frame of the scene
 * @returns {{text: string, left: string[]}} and what has no room in it, in words
 */
export function packed({ lesson, id, turn, name, steps }, frame) {
  const bytes = [...pairs(lesson), ...pairs(id), Math.min(turn, 255), steps.length];
  for (let i = 0; i < steps.length; i += 2) {
    const [low, high] = [steps[i], steps[i + 1]].map((step) => (step ? (step.choice ?? -1) + 1 + (step.reached ? 8 : 0) : 0));
    bytes.push(low | (high << 4));
  }
  const called = bytesOf(name, MAX_NAME);
  bytes.push(called.length, ...called);
  /** @type {string[]} */
  const left = [];
  const room = () => ROOM - 2 - bytes.length - 2;
  const part = (/** @type {number} */ value, /** @type {number} */ from, /** @type {number} */ size) =>
    Math.min(Math.max(Math.round(64 + (128 * (value - from)) / size), 0), 255);
  steps.forEach(({ places }, i) => {
    if (!places) return;
    const rounded = places.flatMap(([x, y]) => [part(x, frame.left, frame.width), part(y, frame.top, frame.height)]);
    if (rounded.length > room()) left.push(say("live-left-prediction", { step: i + 1 }));
    else bytes.push((i << 1) | PLACES, rounded.length, ...rounded);
  });
  steps.forEach(({ line }, i) => {
    if (!line) return;
    const fits = bytesOf(line, Math.max(room(), 0));
    if (fits.length) bytes.push((i << 1) | LINE, fits.length, ...fits);
    if (fits.length < bytesOf(line, Infinity).length) left.push(say(fits.length ? "live-left-line.end" : "live-left-line", { step: i + 1 }));
  });
  return { text: MARK + lettersOf([...bytes, ...check(bytes)]), left };
}
