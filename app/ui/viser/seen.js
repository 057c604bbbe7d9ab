// @ts-check
/** What viser's page shows, for the browser tests: these know nothing of viser and of what it draws with. */
import { viser } from "./viser.js";

/** What is drawn in. */
export const canvas = () => viser()?.canvas;

/** Has all drawn once more. */
export const render = () => viser()?.requestRender();

/**
 * The matrices of a node's instances in the page's world, as they are handed to the graphics card, 16 numbers each; null if
 * there is no such node.
 *
 * @param {string} name
 */
export function instances(name) {
  /** @type {number[] | null} */
  let found = null;
  const node = /** @type {any} */ (viser()?.nodeRefFromName[name]);
  node?.traverse((/** @type {any} */ part) => {
    if (!part.isInstancedMesh || !part.matricesTexture) return;
    found = Array.from(part.matricesTexture._data.slice(0, 16 * part.instancesCount));
  });
  return found;
}

/** Where places of the page's world are on the screen, CSS pixels. @param {number[][]} places x, y and z of each */
export function project(places) {
  const { camera, canvas, nodeRefFromName } = viser() ?? {};
  const root = nodeRefFromName?.[""];
  if (!camera || !canvas || !root) return [];
  const box = canvas.getBoundingClientRect();
  camera.updateMatrixWorld();
  return places.map(([x, y, z]) => {
    const point = camera.position.clone().set(x, y, z).applyMatrix4(root.matrixWorld).project(camera);
    return [box.left + ((point.x + 1) / 2) * box.width, box.top + ((1 - point.y) / 2) * box.height];
  });
}

/** Where the page looks from: its matrix, what it looks at, and how; null while there is no camera. */
export function camera() {
  const { camera, cameraControl } = /** @type {any} */ (viser() ?? {});
  if (!camera || !cameraControl) return null;
  camera.updateMatrixWorld();
  return {
    matrix: camera.matrixWorld.toArray(),
    target: cameraControl.getTarget(camera.position.clone()).toArray(),
    azimuth: cameraControl.azimuthAngle,
    polar: cameraControl.polarAngle,
    distance: cameraControl.distance,
  };
}

/** The charts of the panel, as the plotting library has them. @returns {any[]} */
export const charts = () =>
  Object.values(/** @type {any} */ (window).__viserTestpoints?.uplots ?? {}).map(({ chart }) => chart);
