// @ts-check
/** Where viser's camera, which looks straight at the plane z = 0, shows the world. */
import { project } from "./viser.js";

/** The present place of the world on the screen. @returns {import("../../stage/environment.js").Screen | null} */
export function screen() {
  const [[x, y] = [NaN, NaN], [right] = [NaN]] = project([[0, 0, 0], [1, 0, 0]]);
  const step = right - x;
  // At the very beginning the camera is not placed yet.
  return step > 0 && Number.isFinite(step + x + y) ? { x, y, step } : null;
}
