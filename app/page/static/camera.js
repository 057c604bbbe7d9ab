// @ts-check
/** The camera: seen from the front, moved and zoomed but never turned. */
import { onTold, told } from "./channel.js";
import { placeTransport } from "./transport.js";
import { viser } from "./viser.js";

/** Room around the scene's frame. */
const MARGIN = 1.04;
/** Milliseconds between two looks at the size of the canvas, and at whether viser has its way with the camera. */
const LOOK_EVERY = 100;
let fits = 0;

/** Where the camera was after that. @type {number[]} */
let seen = [];
/** @type {(() => void)[]} */
const listeners = [];

/** Whether the camera is still there. */
function untouched() {
  const { camera } = viser() ?? {};
  const now = camera ? [camera.position.x, camera.position.y, camera.position.z] : [];
  return now.length === seen.length && now.every((value, i) => Math.abs(value - seen[i]) < 1e-6);
}

/** How often the scene was fitted to the window. */
export const fitted = () => fits;

/** Calls back whenever it was. @param {() => void} listener */
export const onFit = (listener) => listeners.push(listener);

/** @param {import("./viser.js").Controls} controls */
function flatten(controls) {
  const { ACTION } = controls.constructor;
  controls.minAzimuthAngle = controls.maxAzimuthAngle = controls.azimuthAngle;
  controls.minPolarAngle = controls.maxPolarAngle = Math.PI / 2;
  controls.mouseButtons.left = ACTION.TRUCK;
  controls.mouseButtons.right = ACTION.TRUCK;
  controls.mouseButtons.middle = ACTION.TRUCK;
  controls.touches.one = ACTION.TOUCH_TRUCK;
  controls.touches.two = ACTION.TOUCH_DOLLY_TRUCK;
  controls.touches.three = ACTION.TOUCH_TRUCK;
  controls.dollyToCursor = true;
}

/**
 * Height of what lies over the canvas at the bottom: the sheet of the panel on a phone.
 *
 * @param {HTMLCanvasElement} canvas
 * @param {DOMRect} box
 */
function covered(canvas, box) {
  let top = box.bottom;
  for (const element of document.elementsFromPoint(box.left + box.width / 2, box.bottom - 4)) {
    if (element === canvas || element.contains(canvas)) break;
    if (element.closest(".softrod-dock")) continue;
    const { top: edge, width } = element.getBoundingClientRect();
    if (width > 0.9 * box.width && edge > box.top + 0.2 * box.height) top = Math.min(top, edge);
  }
  return box.bottom - top;
}

/** Shows the scene's frame, whole, in the part of the canvas that can be seen; whether it could. */
export function fit() {
  const { canvas, camera, cameraControl: controls, nodeRefFromName } = viser() ?? {};
  const root = nodeRefFromName?.[""];
  const [width, height] = [Number(told().width), Number(told().height)];
  if (!canvas || !camera || !controls || !root || !(width > 0)) return false;
  const box = canvas.getBoundingClientRect();
  if (!(box.width > 0 && box.height > 0)) return false;
  const sheet = covered(canvas, box);
  const hidden = sheet + placeTransport(box, sheet);
  const free = box.height - hidden;
  const perPixel = MARGIN * Math.max(width / box.width, height / free);
  const distance = (perPixel * box.height) / (2 * Math.tan((camera.fov * Math.PI) / 360));
  const low = -(perPixel * hidden) / 2;
  controls.minAzimuthAngle = -Infinity;
  controls.maxAzimuthAngle = Infinity;
  // From the nodes' coordinates to those of the camera.
  const eye = camera.position.clone().set(0, low, distance).applyMatrix4(root.matrixWorld);
  const target = camera.position.clone().set(0, low, 0).applyMatrix4(root.matrixWorld);
  controls.setLookAt(eye.x, eye.y, eye.z, target.x, target.y, target.z, false);
  controls.maxDistance = 20 * distance;
  controls.minDistance = distance / 200;
  controls.update(0);
  flatten(controls);
  fits += 1;
  seen = [camera.position.x, camera.position.y, camera.position.z];
  for (const listener of listeners) listener();
  return true;
}

/** Keeps the camera flat, and fits every new scene and every new size of the window. */
export function keepFlat() {
  /** @type {unknown} */
  let flat = null;
  /** @type {string | undefined} */
  let scene;
  let size = "";
  let covers = 0;
  const look = () => {
    const { canvas, cameraControl: controls } = viser() ?? {};
    if (!canvas || !controls) return;
    if (flat !== controls || controls.mouseButtons.left !== controls.constructor.ACTION.TRUCK) {
      flat = controls;
      flatten(controls);
    }
    document.documentElement.style.setProperty("--softrod-canvas", `${canvas.clientWidth}px`);
    const now = `${canvas.clientWidth}x${canvas.clientHeight}`;
    const box = canvas.getBoundingClientRect();
    const sheet = covered(canvas, box);
    placeTransport(box, sheet);
    // A view that its user has chosen stays when the panel's sheet grows or shrinks.
    const grown = sheet !== covers && untouched();
    if ((told().scene !== scene || size !== now || grown) && fit()) {
      scene = told().scene;
      size = now;
      covers = sheet;
    }
  };
  onTold(look);
  setInterval(look, LOOK_EVERY);
}
