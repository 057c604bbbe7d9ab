// @ts-check
/** What a page of a class reads of its line. */
import assert from "node:assert/strict";
import test from "node:test";
import { letters } from "../../app/pages/classroom/line.js";

test("letters are read with their numbers, as app/wire/line.py writes them", () => {
  const texts = new TextEncoder();
  /** @param {string} text @param {number[]} numbers */
  const letter = (text, numbers) => {
    const bytes = texts.encode(text), padded = new Uint8Array(4 * Math.ceil(bytes.length / 4));
    padded.set(bytes);
    return [new Uint8Array(new Uint32Array([bytes.length, numbers.length]).buffer), padded, new Uint8Array(new Float32Array(numbers).buffer)];
  };
  const parts = [...letter('{"tell":"frame"}', [1.5, -2]), ...letter('{"a":"é…"}', []), ...letter("{}", [0.25])];
  const batch = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    batch.set(part, at);
    at += part.length;
  }
  const found = letters(batch.buffer).map(({ text, numbers }) => [text, numbers && [...numbers]]);
  assert.deepEqual(found, [['{"tell":"frame"}', [1.5, -2]], ['{"a":"é…"}', undefined], ["{}", [0.25]]]);
  assert.deepEqual(letters(new ArrayBuffer(0)), []);
});
