// @ts-check
/** What viser's page shows, for browser tests, which then need not know viser or the library that draws. */
import { viser } from "./viser.js";

/**
 * The matrices of a node's instances in the page's world, as the graphics card gets them, 16 numbers each; null without
 * such a node.
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

/** The camera: its matrix, its target and its angles; null while there is none. */
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


/** Calls back after each of the next redraws of the canvas, until it returns false. @param {() => boolean} look */
export function afterRedraws(look) {
  const { scene } = viser() ?? {};
  if (!scene) return;
  const before = scene.onAfterRender;
  scene.onAfterRender = (...rest) => {
    before?.apply(scene, rest);
    if (!look()) scene.onAfterRender = before;
  };
}
