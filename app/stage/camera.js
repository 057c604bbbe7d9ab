// @ts-check
/** The camera: it looks from the front, and is moved and zoomed but never turned. */
import { shown } from "./canvas.js";
import { onMessage, pageState } from "../wire/channel.js";
import { toWorld } from "./draw.js";
import { MARGIN, NEAR, STRIP } from "./looks.js";
import { editing } from "../features/edit/editing.js";
import { placeTransport } from "./dock.js";
import { viserCamera, viserCanvas } from "../ui/viser/viser.js";

/** Largest size of a view, in that of the scene's frame; a body farther away is left out. */
const MAX_VIEW = 20;
/** Pixels of a canvas below which the buttons over the bar of time have no room beside a body. */
const NARROW = 480;
/** Pixels around those buttons. */
const BUTTON_MARGIN = 18;
/** Pixels of a canvas below which the scene is fitted under the head-up display, as on a phone. */
const PHONE = 450;
/** Pixels that the head-up display takes there. */
const HUD_HEIGHT = 66;
/** Part of the canvas's width beyond which the row of tools leaves no room for a body beside it. */
const WIDE = 0.75;
/** Milliseconds between two checks of the canvas's size, and of whether viser has changed how the camera moves. */
const CHECK_EVERY = 100;

let fits = 0;
/** The camera after the last fit. @type {number[]} */
let fittedEye = [];
/** @type {(() => void)[]} */
const listeners = [];

/** The position of the camera; empty while there is none. */
function eye() {
  const position = viserCamera()?.camera.position;
  return position ? [position.x, position.y, position.z] : [];
}

/** True if the camera is still where the last fit put it. */
function untouched() {
  const now = eye();
  return now.length === fittedEye.length && now.every((value, i) => Math.abs(value - fittedEye[i]) < 1e-6);
}

/** The number of times that the scene was fitted to the window. */
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
 * The upper end of the visible part of an element, which may be scrolled.
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
 * Height of what covers the canvas at the bottom: the sheet of the panel on a phone.
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
 * Height that the tools take at the top and at the bottom if their row is nearly as wide as the canvas, or else the
 * buttons over the bar of time if a narrow canvas has no room beside them.
 *
 * @param {DOMRect} box of the canvas
 */
function besideTools(box) {
  const [strip, bar] = document.querySelectorAll(".softrod-edit.softrod-edit-row, .softrod-edit-bar.softrod-edit-row");
  const row = strip?.getBoundingClientRect();
  if (!editing.on) {
    const buttons = [...document.querySelectorAll(".softrod-menu-lid, .softrod-box-lid")];
    const height = Math.max(0, ...buttons.map((button) => button.getBoundingClientRect().height));
    return { above: 0, below: box.width < NARROW && height ? height + BUTTON_MARGIN : 0 };
  }
  if (!row || !bar || row.width < WIDE * box.width) return { above: 0, below: 0 };
  return { above: Math.max(0, row.bottom - box.top), below: bar.getBoundingClientRect().height };
}

/**
 * Extends a view to the surfaces of walls that would be just beyond its edge.
 *
 * @param {{left: number, right: number, low: number, high: number}} seen the view, which is changed
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
 * What a fit shows, in the page's world.
 *
 * @param {number} width of the scene's frame, whose middle is the origin
 * @param {number} height
 * @param {boolean} withBody include the body, wherever it is
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
  return size <= MAX_VIEW ? whole : all;
}

/**
 * Shows the scene's frame, whole, in the part of the canvas that can be seen.
 *
 * @param {boolean} [withBody] also the body, wherever it is
 * @returns {boolean} false while there is nothing to show
 */
export function fit(withBody = false) {
  const [canvas, seen] = [viserCanvas(), viserCamera()];
  const { width = 0, height = 0 } = pageState();
  if (!canvas || !seen?.controls || !(width > 0 && height > 0)) return false;
  const { camera, controls, place } = seen;
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
  const lowered = box.width < PHONE ? Math.max(0, Math.min(spare, HUD_HEIGHT - spare)) : 0;
  const [x, y] = [(left + right) / 2, (low + high) / 2 + perPixel * (lowered - (hidden - above) / 2)];
  controls.minAzimuthAngle = -Infinity;
  controls.maxAzimuthAngle = Infinity;
  const [from, target] = [place(x, y, distance), place(x, y, 0)];
  controls.setLookAt(from.x, from.y, from.z, target.x, target.y, target.z, false);
  controls.maxDistance = MAX_VIEW * distance;
  controls.minDistance = distance / 200;
  controls.update(0);
  flatten(controls);
  fits += 1;
  fittedEye = eye();
  for (const listener of listeners) listener();
  return true;
}

/**
 * Moves the view by a vector of the page's world.
 *
 * @param {number} dx @param {number} dy
 */
export function shift(dx, dy) {
  const seen = viserCamera();
  if (!seen?.controls) return;
  const { camera, controls, place } = seen;
  const [from, to] = [place(0, 0, 0), place(dx, dy, 0)];
  const fitted = untouched();
  const end = controls.getTarget(camera.position.clone(), true);
  controls.moveTo(end.x + to.x - from.x, end.y + to.y - from.y, end.z + to.z - from.z, false);
  controls.update(0);
  if (fitted) fittedEye = eye();
}

/** Keeps the camera from turning, and fits every new scene and every new size of the window. */
export function keepFlat() {
  /** @type {unknown} */
  let flat = null;
  /** @type {number | undefined} */
  let scene;
  let size = "";
  let covers = "";
  const paper = matchMedia("print");
  const look = () => {
    const [canvas, controls] = [viserCanvas(), viserCamera()?.controls];
    // In print the canvas has another size, but not what is drawn in it.
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
    // A view that the user has chosen stays when the panel's sheet, the tools or a strip change their size.
    const grown = cover !== covers && untouched();
    if ((pageState().scene !== scene || size !== now || grown) && fit()) {
      scene = pageState().scene;
      size = now;
      covers = cover;
    }
  };
  onMessage("pageState", look);
  setInterval(look, CHECK_EVERY);
}
