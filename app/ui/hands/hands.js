// @ts-check
/**
 * Hands that hold masses, by number: one for each dragging pointer, and one for the keys.
 */
import { wireNumber } from "../../stage/screen.js";

/** Hands that the server accepts. */
const MAX_HANDS = 10;
/** @type {Set<number>} */
const busy = new Set();

/** Takes a free hand and returns its number, or -1. */
export function takeHand() {
  for (let number = 0; number < MAX_HANDS; number++) {
    if (busy.has(number)) continue;
    busy.add(number);
    return number;
  }
  return -1;
}

/** @type {((mass: number, holds: boolean) => void)[]} */
const watchers = [];

/** Calls back when a pointer takes hold of a mass, or lets go of it. @param {(mass: number, holds: boolean) => void} watcher */
export const onGrasp = (watcher) => void watchers.push(watcher);

/** Says that a pointer did. @param {number} mass @param {boolean} holds */
export function tellGrasp(mass, holds) {
  for (const told of watchers) told(mass, holds);
}

/** @param {number} number */
export const freeHand = (number) => busy.delete(number);

/** True if all hands are free. */
export const areFree = () => busy.size === 0;

/**
 * The place of a hand, for a message.
 *
 * @param {number} number of the hand @param {{x: number, y: number}} point of the world
 * @returns {[number, number, number]}
 */
export const handAt = (number, { x, y }) => [number, wireNumber(x), wireNumber(y)];
