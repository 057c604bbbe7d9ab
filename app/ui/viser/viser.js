// @ts-check
/**
 * Access to viser's page by its test hook, `window.__viserMutable`.
 *
 * viser is pinned to one version. The types here list what is used of it; the browser tests exercise all of it.
 *
 * @typedef {{x: number, y: number, z: number, clone(): Vector, set(x: number, y: number, z: number): Vector,
 *   project(camera: Camera): Vector, applyMatrix4(matrix: Matrix): Vector}} Vector
 * @typedef {object} Matrix
 * @typedef {{position: Vector, fov: number, updateMatrixWorld(): void}} Camera
 * @typedef {{minAzimuthAngle: number, maxAzimuthAngle: number, azimuthAngle: number, minPolarAngle: number,
 *   maxPolarAngle: number, minDistance: number, maxDistance: number, distance: number, dollyToCursor: boolean,
 *   mouseButtons: Record<string, number>, touches: Record<string, number>, constructor: any,
 *   setLookAt(...values: (number | boolean)[]): void, moveTo(x: number, y: number, z: number, glides: boolean): void,
 *   dollyTo(distance: number, glides: boolean): void,
 *   getTarget(into: Vector, atEnd: boolean): Vector, update(seconds: number): void}} Controls
 * @typedef {{type: string, name?: string, owner?: string, props?: Record<string, any>,
 *   updates?: Record<string, any>, [key: string]: any}} Message
 * @typedef {{getPixelRatio(): number, setPixelRatio(ratio: number): void, render(scene: Scene, camera: unknown): void}}
 *   Renderer
 * @typedef {{onBeforeRender: () => void, onAfterRender: (renderer: Renderer, scene: Scene, camera: unknown) => void}}
 *   Scene
 * @typedef {object} Viser
 * @property {HTMLCanvasElement | null} canvas
 * @property {Scene | null} scene its methods are called before and after it is drawn
 * @property {Camera | null} camera
 * @property {Controls | null} cameraControl
 * @property {Record<string, {matrixWorld: Matrix} | undefined>} nodeRefFromName
 * @property {Message[]} messageQueue messages from the server that wait for the next frame
 * @property {(message: Message) => void} sendMessage to the server
 * @property {() => void} requestRender
 */

const NAME = "__viserMutable";

/** @returns {Viser | undefined} */
export const viser = () => /** @type {any} */ (window)[NAME];

/** The canvas that viser draws in, once there is one. */
export const viserCanvas = () => viser()?.canvas ?? null;

/** True if the page is dark. */
export const isDark = () => document.documentElement.dataset.mantineColorScheme === "dark";

/** The place of the canvas in the window. */
export const canvasBox = () => viserCanvas()?.getBoundingClientRect();

/** Requests a redraw of the canvas. */
export const render = () => viser()?.requestRender();

/** The camera, and a place of the page's world in its coordinates; null while there is no camera. */
export function viserCamera() {
  const { camera, cameraControl: controls, nodeRefFromName } = viser() ?? {};
  const root = nodeRefFromName?.[""];
  if (!camera || !root) return null;
  /** @param {number} x @param {number} y @param {number} z */
  const place = (x, y, z) => camera.position.clone().set(x, y, z).applyMatrix4(root.matrixWorld);
  return { camera, controls, place };
}

/**
 * Places of the page's world on the screen, CSS pixels; empty while there is no camera.
 *
 * @param {number[][]} places x, y and z of each
 */
export function project(places) {
  const [seen, box] = [viserCamera(), canvasBox()];
  if (!seen || !box) return [];
  const { camera, place } = seen;
  camera.updateMatrixWorld();
  return places.map(([x, y, z]) => {
    const point = place(x, y, z).project(camera);
    return [box.left + ((point.x + 1) / 2) * box.width, box.top + ((1 - point.y) / 2) * box.height];
  });
}

/**
 * Calls back once viser's page has made its hook, before the first message can arrive.
 *
 * @param {(viser: Viser) => void} ready
 */
export function whenViser(ready) {
  const present = viser();
  if (present) {
    ready(present);
    return;
  }
  Object.defineProperty(window, NAME, {
    configurable: true,
    get: () => undefined,
    set(/** @type {Viser} */ value) {
      Object.defineProperty(window, NAME, { configurable: true, writable: true, value });
      ready(value);
    },
  });
}

/** True if viser's page has what this script uses. @param {Viser | undefined} found */
export const isKnown = (found) =>
  found !== undefined &&
  Array.isArray(found.messageQueue) &&
  typeof found.sendMessage === "function" &&
  typeof found.requestRender === "function" &&
  typeof found.nodeRefFromName === "object";
