// @ts-check
/** Converts between the scene, the page's world and the screen. Arithmetic only, without a page. */

/** @typedef {import("./environment.js").Screen} Screen */

/**
 * Positions of masses on the screen, x and y of each.
 *
 * @param {import("./plan.js").Plan} plan
 * @param {ArrayLike<number>} positions px of the scene
 * @param {Screen} on
 */
export function onScreen(plan, positions, on) {
  const places = new Float64Array(positions.length);
  const scale = plan.scale * on.step;
  for (let i = 0; i < positions.length; i += 2) {
    places[i] = on.x + (positions[i] - plan.x) * scale;
    places[i + 1] = on.y - (positions[i + 1] - plan.y) * scale * plan.flip;
  }
  return places;
}

/**
 * The point of the world under a place on the screen.
 *
 * @param {{x: number, y: number}} place
 * @param {Screen} on
 */
export const worldAt = (place, on) => ({ x: (place.x - on.x) / on.step, y: (on.y - place.y) / on.step });

/**
 * The place in the scene of a point of the world.
 *
 * @param {import("./plan.js").Plan} plan
 * @param {{x: number, y: number}} point
 */
export const sceneAt = (plan, { x, y }) => ({ x: x / plan.scale + plan.x, y: (y / plan.scale) * plan.flip + plan.y });

/** Pixels from a mass within which it is grabbed, by the kind of pointer. */
export const REACH = { mouse: 12, pen: 16, touch: 26 };

/** Rounds a coordinate of the world for a message. @param {number} value */
export const wireNumber = (value) => Number(value.toFixed(6));

/**
 * The mass to grab at a place on the screen: the nearest one within reach, or -1.
 *
 * @param {Float64Array} places of the masses, x and y of each
 * @param {ArrayLike<number>} radii px on the screen
 * @param {{x: number, y: number}} at
 * @param {number} reach px beyond which only the disc itself counts
 */
export function nearest(places, radii, at, reach) {
  let found = -1;
  let least = Infinity;
  for (let i = 0; i < radii.length; i++) {
    const distance = Math.hypot(places[2 * i] - at.x, places[2 * i + 1] - at.y);
    if (distance < least && distance <= Math.max(reach, radii[i])) [found, least] = [i, distance];
  }
  return found;
}
