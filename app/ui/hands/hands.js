// @ts-check
/**
 * The hands that hold masses, by number: one for each pointer that drags, and one for the keys. The server knows as many.
 */
import { wireNumber } from "../../stage/screen.js";

const MOST = 10;
/** @type {Set<number>} */
const busy = new Set();

/** The number of a free hand, which is busy from now on, or -1. */
export function freshHand() {
  for (let number = 0; number < MOST; number++) {
    if (busy.has(number)) continue;
    busy.add(number);
    return number;
  }
  return -1;
}

/** @param {number} number */
export const freeHand = (number) => busy.delete(number);

/** Whether nothing is in any hand. */
export const areFree = () => busy.size === 0;

/**
 * Where a hand is, as a message has it.
 *
 * @param {number} number of the hand @param {{x: number, y: number}} point of the world
 * @returns {[number, number, number]}
 */
export const handAt = (number, { x, y }) => [number, wireNumber(x), wireNumber(y)];
