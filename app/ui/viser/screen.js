// @ts-check
/** Where viser's camera, which looks straight at the plane z = 0, shows the world. */
import { viser } from "./viser.js";

/** How the world lies on the screen now. @returns {import("../../stage/environment.js").Screen | null} */
export function screen() {
  const { canvas, camera, nodeRefFromName } = viser() ?? {};
  const root = nodeRefFromName?.[""];
  if (!canvas || !camera || !root) return null;
  camera.updateMatrixWorld();
  const box = canvas.getBoundingClientRect();
  /** @param {number} x */
  const project = (x) => {
    const point = camera.position.clone().set(x, 0, 0).applyMatrix4(root.matrixWorld).project(camera);
    return { x: box.left + ((point.x + 1) / 2) * box.width, y: box.top + ((1 - point.y) / 2) * box.height };
  };
  const [origin, one] = [project(0), project(1)];
  const step = one.x - origin.x;
  // At the very beginning the camera is not in its place.
  return step > 0 && Number.isFinite(step + origin.x + origin.y) ? { ...origin, step } : null;
}
