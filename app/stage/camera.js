// @ts-check
/** The camera: seen from the front, moved and zoomed but never turned. */
import { shown } from "./canvas.js";
import { onMessage, pageState } from "../wire/channel.js";
import { toWorld } from "./draw.js";
import { MARGIN, NEAR, STRIP } from "./looks.js";
import { editing } from "../features/edit/editing.js";
import { placeTransport } from "./dock.js";
import { viser } from "../ui/viser/viser.js";

/** How many times larger than the scene's frame a view may be; a body farther away is left out. */
const LARGEST = 20;
/** Pixels of a canvas below which the buttons over the bar of time have no room beside a body, and those around them. */
const [NARROW, ROOM] = [480, 18];
/** Width of a phone's canvas at most, and pixels that the words at its upper left take: the scene stands below them there. */
const [PHONE, WORDS] = [450, 66];
/** From which part of the canvas's width on the row of tools leaves no room for the body beside it. */
const WIDE = 0.75;
/** Milliseconds between two looks at the size of the canvas, and at whether viser has its way with the camera. */
const LOOK_EVERY = 100;

let fits = 0;
/** Where the last fit put the camera. @type {number[]} */
let seen = [];
/** @type {(() => void)[]} */
const listeners = [];

/** Whether the camera is still where the last fit put it. */
function untouched() {
  const { camera } = viser() ?? {};
  const now = camera ? [camera.position.x, camera.position.y, camera.position.z] : [];
  return now.length === seen.length && now.every((value, i) => Math.abs(value - seen[i]) < 1e-6);
}

/** How often the scene was fitted to the window. */
export const fitted = () => fits;

/** Calls back after every fit. @param {() => void} listener */
export const onFit = (listener) => listeners.push(listener);

/** @param {import("../ui/viser/viser.js").Controls} controls */
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
 * Where an element can be seen from: what is scrolled out of view does not count.
 *
 * @param {Element} element
 * @param {HTMLCanvasElement} canvas
 */
function visibleTop(element, canvas) {
  let { top } = element.getBoundingClientRect();
  for (let around = element.parentElement; around && !around.contains(canvas); around = around.parentElement) {
    if (getComputedStyle(around).overflowY !== "visible") top = Math.max(top, around.getBoundingClientRect().top);
  }
  return top;
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
    if (element.closest(".softrod-dock, .softrod-edit-bar")) continue;
    const { width } = element.getBoundingClientRect();
    const edge = visibleTop(element, canvas);
    if (width > 0.9 * box.width && edge > box.top + 0.2 * box.height) top = Math.min(top, edge);
  }
  return box.bottom - top;
}

/**
 * Height that the tools take at the top and at the bottom, where they stand in a row over nearly all of its width; and
 * that of the buttons over the bar of time, where a narrow canvas has no room beside them.
 *
 * @param {DOMRect} box of the canvas
 */
function besideTools(box) {
  const [strip, bar] = document.querySelectorAll(".softrod-edit.softrod-edit-row, .softrod-edit-bar.softrod-edit-row");
  const row = strip?.getBoundingClientRect();
  if (!editing.on) {
    const buttons = [...document.querySelectorAll(".softrod-menu-lid, .softrod-box-lid")];
    const height = Math.max(0, ...buttons.map((button) => button.getBoundingClientRect().height));
    return { above: 0, below: box.width < NARROW && height ? height + ROOM : 0 };
  }
  if (!row || !bar || row.width < WIDE * box.width) return { above: 0, below: 0 };
  return { above: Math.max(0, row.bottom - box.top), below: bar.getBoundingClientRect().height };
}

/**
 * Makes room for the surfaces of walls that would be just beyond the edge.
 *
 * @param {{left: number, right: number, low: number, high: number}} seen is changed
 * @param {import("./plan.js").Plan} plan
 */
export function showWalls(seen, { walls, scale, x, y, flip }) {
  const size = Math.max(seen.right - seen.left, seen.high - seen.low);
  for (let i = 0; i < walls.length; i += 4) {
    const [px, py, nx, ny] = [(walls[i] - x) * scale, (walls[i + 1] - y) * scale * flip, walls[i + 2], walls[i + 3] * flip];
    // From the surface to the nearest corner.
    const free = ((nx > 0 ? seen.left : seen.right) - px) * nx + ((ny > 0 ? seen.low : seen.high) - py) * ny;
    const missing = free + STRIP * size;
    if (missing <= 0 || free > NEAR * size) continue;
    if (Math.abs(nx) > Math.abs(ny)) seen[nx > 0 ? "left" : "right"] -= missing / nx;
    else seen[ny > 0 ? "low" : "high"] -= missing / ny;
  }
}

/**
 * What is to be seen, in the page's world.
 *
 * @param {number} width of the scene's frame, whose middle is the origin
 * @param {number} height
 * @param {boolean} withBody whether the body belongs to it, wherever it is
 */
function bounds(width, height, withBody) {
  const { plan, frame } = shown();
  const all = { left: -width / 2, right: width / 2, low: -height / 2, high: height / 2 };
  if (plan) showWalls(all, plan);
  if (!withBody || !plan || !frame) return all;
  const { second } = frame;
  const world = [...toWorld(plan, frame.positions), ...(second ? toWorld(plan, second.positions) : [])];
  const whole = { ...all };
  for (let i = 0; i < world.length; i += 2) {
    const radius = plan.radius[i / 2] ?? 0;
    whole.left = Math.min(whole.left, world[i] - radius);
    whole.right = Math.max(whole.right, world[i] + radius);
    whole.low = Math.min(whole.low, world[i + 1] - radius);
    whole.high = Math.max(whole.high, world[i + 1] + radius);
  }
  const size = Math.max((whole.right - whole.left) / width, (whole.high - whole.low) / height);
  return size <= LARGEST ? whole : all;
}

/**
 * Shows the scene's frame, whole, in the part of the canvas that can be seen.
 *
 * @param {boolean} [withBody] whether also the body, wherever it is
 * @returns {boolean} whether it could
 */
export function fit(withBody = false) {
  const { canvas, camera, cameraControl: controls, nodeRefFromName } = viser() ?? {};
  const root = nodeRefFromName?.[""];
  const [width, height] = [pageState().width ?? 0, pageState().height ?? 0];
  if (!canvas || !camera || !controls || !root || !(width > 0 && height > 0)) return false;
  const box = canvas.getBoundingClientRect();
  const sheet = covered(canvas, box);
  const dock = sheet + placeTransport(box, sheet);
  const { above, below } = besideTools(box);
  const hidden = dock + below;
  const free = box.height - hidden - above;
  if (!(box.width > 0 && free > 0)) return false;
  const { left, right, low, high } = bounds(width, height, withBody);
  const perPixel = MARGIN * Math.max((right - left) / box.width, (high - low) / free);
  const distance = (perPixel * box.height) / (2 * Math.tan((camera.fov * Math.PI) / 360));
  const spare = (free - (high - low) / perPixel) / 2;
  const lowered = box.width < PHONE ? Math.max(0, Math.min(spare, WORDS - spare)) : 0;
  const [x, y] = [(left + right) / 2, (low + high) / 2 + perPixel * (lowered - (hidden - above) / 2)];
  controls.minAzimuthAngle = -Infinity;
  controls.maxAzimuthAngle = Infinity;
  // From the nodes' coordinates to those of the camera.
  const eye = camera.position.clone().set(x, y, distance).applyMatrix4(root.matrixWorld);
  const target = camera.position.clone().set(x, y, 0).applyMatrix4(root.matrixWorld);
  controls.setLookAt(eye.x, eye.y, eye.z, target.x, target.y, target.z, false);
  controls.maxDistance = LARGEST * distance;
  controls.minDistance = distance / 200;
  controls.update(0);
  flatten(controls);
  fits += 1;
  seen = [camera.position.x, camera.position.y, camera.position.z];
  for (const listener of listeners) listener();
  return true;
}

/**
 * Moves the view by a way of the page's world.
 *
 * @param {number} dx @param {number} dy
 */
export function shift(dx, dy) {
  const { camera, cameraControl: controls, nodeRefFromName } = viser() ?? {};
  const root = nodeRefFromName?.[""];
  if (!camera || !controls || !root) return;
  const [from, to] = [0, 1].map((part) => camera.position.clone().set(part * dx, part * dy, 0).applyMatrix4(root.matrixWorld));
  const fitted = untouched();
  const end = controls.getTarget(camera.position.clone(), true);
  controls.moveTo(end.x + to.x - from.x, end.y + to.y - from.y, end.z + to.z - from.z, false);
  controls.update(0);
  if (fitted) seen = [camera.position.x, camera.position.y, camera.position.z];
}

/** Keeps the camera flat, and fits every new scene and every new size of the window. */
export function keepFlat() {
  /** @type {unknown} */
  let flat = null;
  /** @type {number | undefined} */
  let scene;
  let size = "";
  let covers = "";
  const paper = matchMedia("print");
  const look = () => {
    const { canvas, cameraControl: controls } = viser() ?? {};
    // On paper the canvas has another size, but what is drawn in it has not.
    if (!canvas || !controls || paper.matches) return;
    if (flat !== controls || controls.mouseButtons.left !== controls.constructor.ACTION.TRUCK) {
      flat = controls;
      flatten(controls);
    }
    document.documentElement.style.setProperty("--softrod-canvas", `${canvas.clientWidth}px`);
    const now = `${canvas.clientWidth}x${canvas.clientHeight}`;
    const box = canvas.getBoundingClientRect();
    const sheet = covered(canvas, box);
    placeTransport(box, sheet);
    const { above, below } = besideTools(box);
    const strips = [...document.querySelectorAll(".softrod-strip")].map(
      (strip) => /** @type {HTMLElement} */ (strip).offsetHeight,
    );
    const cover = [sheet, above, below, ...strips].join(" ");
    // A view that its user has chosen stays when the panel's sheet, the tools or a strip grow or shrink.
    const grown = cover !== covers && untouched();
    if ((pageState().scene !== scene || size !== now || grown) && fit()) {
      scene = pageState().scene;
      size = now;
      covers = cover;
    }
  };
  onMessage("pageState", look);
  setInterval(look, LOOK_EVERY);
}
