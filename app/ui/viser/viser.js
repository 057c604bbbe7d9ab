// @ts-check
/**
 * The one way into viser's page: its test hook, `window.__viserMutable`.
 *
 * viser is pinned exactly. What is used of it is written down here as types, and driven by the browser tests.
 *
 * @typedef {{x: number, y: number, z: number, clone(): Vector, set(x: number, y: number, z: number): Vector,
 *   project(camera: Camera): Vector, applyMatrix4(matrix: Matrix): Vector}} Vector
 * @typedef {object} Matrix
 * @typedef {{position: Vector, fov: number, updateMatrixWorld(): void}} Camera
 * @typedef {{minAzimuthAngle: number, maxAzimuthAngle: number, azimuthAngle: number, minPolarAngle: number,
 *   maxPolarAngle: number, minDistance: number, maxDistance: number, dollyToCursor: boolean,
 *   mouseButtons: Record<string, number>, touches: Record<string, number>, constructor: any,
 *   setLookAt(...values: (number | boolean)[]): void, moveTo(x: number, y: number, z: number, glides: boolean): void,
 *   getTarget(into: Vector, atEnd: boolean): Vector, update(seconds: number): void}} Controls
 * @typedef {{type: string, name?: string, owner?: string, props?: Record<string, any>,
 *   updates?: Record<string, any>, [key: string]: any}} Message
 * @typedef {{getPixelRatio(): number, setPixelRatio(ratio: number): void, render(scene: Scene, camera: unknown): void}}
 *   Renderer
 * @typedef {{onBeforeRender: () => void, onAfterRender: (renderer: Renderer, scene: Scene, camera: unknown) => void}}
 *   Scene
 * @typedef {object} Viser
 * @property {HTMLCanvasElement | null} canvas
 * @property {Scene | null} scene whose methods are called whenever it is about to be drawn, and when it is
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

/**
 * Calls back once viser's page has made its hook, before the first message can come.
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

/** Whether viser's page is as this script knows it. @param {Viser | undefined} found */
export const isKnown = (found) =>
  found !== undefined &&
  Array.isArray(found.messageQueue) &&
  typeof found.sendMessage === "function" &&
  typeof found.requestRender === "function" &&
  typeof found.nodeRefFromName === "object";
