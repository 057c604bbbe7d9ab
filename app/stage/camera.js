// @ts-check
/**
 * The camera: it looks from the front, and is moved and zoomed but never turned. It shows where the body moves in the first
 * seconds, which the server tells, and goes after a body that leaves the view, unless the user has chosen another one.
 */
import { onPicture, shown } from "./canvas.js";
import { onMessage, pageState } from "../wire/channel.js";
import { toWorld } from "./draw.js";
import { MARGIN, NEAR, STRIP } from "./looks.js";
import { countSelected, editing } from "../features/edit/editing.js";
import { floorOf, placeTransport } from "./dock.js";
import { isStill } from "../ui/access.js";
import { viserCamera, viserCanvas } from "../ui/viser/viser.js";

/** Largest size of a view, in that of the scene's frame; a body farther away is left out. */
const MAX_VIEW = 20;
/** Pixels of a canvas below which neither words nor the buttons over the bar of time have room beside a body. */
const NARROW = 520;
/** Pixels around those buttons. */
const BUTTON_MARGIN = 18;
/** Pixels that the head-up display takes on such a canvas, which it nearly fills from side to side. */
const HUD_HEIGHT = 66;
/** Part of the free canvas that is left to it at most. */
const MOST_ABOVE = 0.35;
/** Part of the canvas's width beyond which the row of tools leaves no room for a body beside it. */
const WIDE = 0.75;
/** Pixels of a canvas's height below which it leaves none in any case. */
const LOW = 480;
/** Pixels of height below which the body has all of the canvas. */
const TIGHT = 180;
/** Milliseconds between two checks of the canvas's size, and of whether viser has changed how the camera moves. */
const CHECK_EVERY = 100;
/** Part of the body's motion that is free around it at each side. */
const AROUND = 1 / 8;
/** Size of a view, in that of the scene's frame, below which the frame is shown: it would be of a mass by itself. */
const LEAST_VIEW = 0.15;
/** Milliseconds for which a new scene waits to be told where its body moves. */
const WAIT = 1500;
/** Milliseconds between two looks whether the body has left the view. */
const LOOK_EVERY = 400;
/** Milliseconds of a glide. */
const GLIDE = 240;

let fits = 0;
/** The camera after the last fit. @type {number[]} */
let fittedEye = [];
/** The end of the glide that is under way, ms; 0 without one. */
let glidesUntil = 0;
/** What the last fit was to show. @type {View | null} */
let asked = null;
/** What is in sight since then: that, and what else the canvas has room for. @type {View | null} */
let inSight = null;
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

/** True if the view is where the last fit has put it, and shows the motion of the body, where that is known. */
export const isSettled = () => glidesUntil === 0 && fits > 0 && (pageState().view ?? []).join() === fittedView;
/** The motion that the last fit showed. */
let fittedView = "";

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
 * Height of what covers the canvas at the bottom, below the bar of time: a pupil's card or a form on a phone.
 *
 * @param {HTMLCanvasElement} canvas
 * @param {DOMRect} box
 */
function covered(canvas, box) {
  let top = box.bottom;
  for (const element of document.elementsFromPoint(box.left + box.width / 2, box.bottom - 4)) {
    if (element === canvas || element.contains(canvas)) break;
    if (element.closest(".softrod-dock, .softrod-edit-bar, .softrod-panel")) continue;
    const { width } = element.getBoundingClientRect();
    const edge = visibleTop(element, canvas);
    if (width > 0.9 * box.width && edge > box.top + 0.2 * box.height) top = Math.min(top, edge);
  }
  return box.bottom - top;
}

/** Height of the bar below the tools while nothing is selected: a view stands when a selection makes it higher. */
let barHeight = 0;

/**
 * Height that the tools take at the top, if their row is nearly as wide as the canvas or that is low, and at the bottom; or the buttons
 * over the bar of time if a narrow canvas has no room beside them.
 *
 * @param {DOMRect} box of the canvas
 */
function besideTools(box) {
  if (!editing.on) {
    barHeight = 0;
    const buttons = [...document.querySelectorAll(".softrod-menu-lid, .softrod-box-lid")];
    const height = Math.max(0, ...buttons.map((button) => button.getBoundingClientRect().height));
    // Not the display's present height: a body would jump whenever that comes or gets another line.
    const over = document.querySelector(".softrod-over")?.getBoundingClientRect();
    const wanted = Math.max(0, (over?.bottom ?? 0) - box.top) + (box.width < NARROW ? HUD_HEIGHT : 0);
    const above = Math.min(wanted, MOST_ABOVE * (floorOf(box) - box.top));
    // Where hardly a strip is left, the body lies under the buttons, larger.
    if (floorOf(box) - box.top < TIGHT) return { above: 0, below: 0 };
    return { above, below: box.width < NARROW && height ? height + BUTTON_MARGIN : 0 };
  }
  const [row, bar] = [".softrod-edit.softrod-edit-row", ".softrod-edit-bar"].map((name) => document.querySelector(name)?.getBoundingClientRect());
  const above = row && (row.width >= WIDE * box.width || box.height < LOW) ? Math.max(0, row.bottom - box.top) : 0;
  if (!barHeight || !countSelected()) barHeight = bar?.height ?? 0;
  return { above, below: barHeight };
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

/** @typedef {{left: number, right: number, low: number, high: number}} View a box in the page's world */

/** The box of the bodies as they are drawn now; null without any. @returns {View | null} */
function bodyBox() {
  const { plan, frame } = shown();
  if (!plan || !frame) return null;
  const { second } = frame;
  const world = [...toWorld(plan, frame.positions), ...(second ? toWorld(plan, second.positions) : [])];
  const box = { left: Infinity, right: -Infinity, low: Infinity, high: -Infinity };
  for (let i = 0; i < world.length; i += 2) {
    const radius = plan.radius[i / 2] ?? 0;
    box.left = Math.min(box.left, world[i] - radius);
    box.right = Math.max(box.right, world[i] + radius);
    box.low = Math.min(box.low, world[i + 1] - radius);
    box.high = Math.max(box.high, world[i + 1] + radius);
  }
  return Number.isFinite(box.left + box.right + box.low + box.high) ? box : null;
}

/** @param {View} view @param {number} dx @param {number} dy */
const moved = ({ left, right, low, high }, dx, dy) => ({ left: left + dx, right: right + dx, low: low + dy, high: high + dy });

/** @param {View} view */
const sizeOf = ({ left, right, low, high }) => Math.max(right - left, high - low);

/** A box with room around it. @param {View} view */
function withRoom({ left, right, low, high }) {
  const room = AROUND * Math.max(right - left, high - low);
  return { left: left - room, right: right + room, low: low - room, high: high + room };
}

/** What a new scene shows: where its body moves, or its frame. @returns {View} */
function motion() {
  const { width = 0, height = 0, view = [] } = pageState();
  const [w, h] = [(MARGIN * width) / 2, (MARGIN * height) / 2];
  const frame = { left: -w, right: w, low: -h, high: h };
  if (view.length < 4) return frame;
  const [left, right, low, high] = view;
  const path = { left, right, low, high };
  return sizeOf(path) < LEAST_VIEW * sizeOf(frame) ? frame : withRoom(path);
}

/**
 * What a fit shows.
 *
 * @param {boolean} withBody include the body, wherever it is
 * @returns {View}
 */
function bounds(withBody) {
  const all = motion();
  const { plan } = shown();
  if (plan) showWalls(all, plan);
  const body = withBody ? bodyBox() : null;
  if (!body) return all;
  const whole = {
    left: Math.min(all.left, body.left),
    right: Math.max(all.right, body.right),
    low: Math.min(all.low, body.low),
    high: Math.max(all.high, body.high),
  };
  const { width = 1, height = 1 } = pageState();
  return sizeOf(whole) <= MAX_VIEW * Math.max(width, height) ? whole : all;
}

/**
 * Shows where the body moves, whole, in the part of the canvas that can be seen.
 *
 * @param {boolean} [withBody] also the body, wherever it is
 * @returns {boolean} false while there is nothing to show
 */
export const fit = (withBody = false) => {
  const { width = 0, height = 0, view = [] } = pageState();
  if (!(width > 0 && height > 0) || !show(bounds(withBody), false)) return false;
  fittedView = view.join();
  return true;
};

/** The camera that shows a box in the free part of the canvas; null while there is none. @param {View} view */
function cameraFor({ left, right, low, high }) {
  const [canvas, seen] = [viserCanvas(), viserCamera()];
  if (!canvas || !seen?.controls) return null;
  const box = canvas.getBoundingClientRect();
  const sheet = covered(canvas, box);
  placeTransport(box, sheet);
  const dock = box.bottom - floorOf(box);
  const { above, below } = besideTools(box);
  const hidden = dock + below;
  const free = box.height - hidden - above;
  if (!(box.width > 0 && free > 0)) return null;
  const perPixel = Math.max((right - left) / box.width, (high - low) / free);
  const distance = (perPixel * box.height) / (2 * Math.tan((seen.camera.fov * Math.PI) / 360));
  const [x, y] = [(left + right) / 2, (low + high) / 2];
  const [w, h] = [(perPixel * box.width) / 2, (perPixel * free) / 2];
  const sight = { left: x - w, right: x + w, low: y - h, high: y + h };
  return { at: { x, y: y - (perPixel * (hidden - above)) / 2, distance }, sight };
}

/** @param {{x: number, y: number, distance: number}} to */
function put({ x, y, distance }) {
  const seen = viserCamera();
  if (!seen?.controls) return;
  const { controls, place } = seen;
  controls.minAzimuthAngle = -Infinity;
  controls.maxAzimuthAngle = Infinity;
  const [from, target] = [place(x, y, distance), place(x, y, 0)];
  controls.setLookAt(from.x, from.y, from.z, target.x, target.y, target.z, false);
  controls.maxDistance = MAX_VIEW * distance;
  controls.minDistance = distance / 200;
  controls.update(0);
  flatten(controls);
  fittedEye = eye();
  for (const listener of listeners) listener();
}

/** Where the camera was put last. @type {{x: number, y: number, distance: number} | null} */
let standing = null;

/**
 * Shows a box.
 *
 * @param {View} view @param {boolean} glides
 * @returns {boolean} false while that is impossible
 */
function show(view, glides) {
  const found = cameraFor(view);
  if (!found) return false;
  const to = found.at;
  asked = view;
  inSight = found.sight;
  fits += 1;
  const from = standing;
  standing = to;
  const lasts = glides && from && !isStill() ? GLIDE : 0;
  const begun = performance.now();
  const end = (glidesUntil = lasts ? begun + lasts : 0);
  if (!lasts || !from) {
    put(to);
    return true;
  }
  const step = () => {
    // Another fit, or a hand, has taken over.
    if (glidesUntil !== end || !untouched()) return;
    const part = Math.min((performance.now() - begun) / lasts, 1);
    const eased = 1 - (1 - part) ** 3;
    /** @param {"x" | "y" | "distance"} key */
    const between = (key) => from[key] + (to[key] - from[key]) * eased;
    if (part === 1) glidesUntil = 0;
    put({ x: between("x"), y: between("y"), distance: between("distance") });
    if (part < 1) requestAnimationFrame(step);
  };
  step();
  return true;
}

/** Goes after a body that has left the view: as large a view as before, unless the body has grown. */
function follow() {
  const body = bodyBox();
  // Who leads or edits the body needs a view that stands.
  if (editing.on || pageState().follow || glidesUntil || !untouched()) return;
  if (!body || !asked || !inSight) return;
  const { left, right, low, high } = inSight;
  if (body.left >= left && body.right <= right && body.low >= low && body.high <= high) return;
  const width = Math.max(asked.right - asked.left, (1 + 2 * AROUND) * (body.right - body.left));
  const height = Math.max(asked.high - asked.low, (1 + 2 * AROUND) * (body.high - body.low));
  const { width: w = 1, height: h = 1 } = pageState();
  if (Math.max(width, height) > MAX_VIEW * Math.max(w, h)) return; // it has exploded
  const [x, y] = [(body.left + body.right) / 2, (body.low + body.high) / 2];
  show({ left: x - width / 2, right: x + width / 2, low: y - height / 2, high: y + height / 2 }, true);
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
  if (standing) standing = { ...standing, x: standing.x + dx, y: standing.y + dy };
  if (asked) asked = moved(asked, dx, dy);
  if (inSight) inSight = moved(inSight, dx, dy);
  const end = controls.getTarget(camera.position.clone(), true);
  controls.moveTo(end.x + to.x - from.x, end.y + to.y - from.y, end.z + to.z - from.z, false);
  controls.update(0);
  if (fitted) fittedEye = eye();
}

/**
 * Moves the view as its user does: by parts of its height, and by how many times nearer.
 *
 * @param {number} across @param {number} up @param {number} nearer
 */
export function moveView(across, up, nearer) {
  const seen = viserCamera();
  if (!seen?.controls) return;
  const { camera, controls, place } = seen;
  const height = 2 * controls.distance * Math.tan((camera.fov * Math.PI) / 360);
  const [from, to] = [place(0, 0, 0), place(across * height, up * height, 0)];
  const end = controls.getTarget(camera.position.clone(), true);
  controls.moveTo(end.x + to.x - from.x, end.y + to.y - from.y, end.z + to.z - from.z, false);
  controls.dollyTo(controls.distance / nearer, false);
  controls.update(0);
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
  /** When the scene was first told of. */
  let since = 0;
  let known = "";
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
    const cover = [floorOf(box), above, below, ...strips].join(" ");
    // A view that the user has chosen stays when the panel's sheet, the tools or a strip change their size.
    const grown = cover !== covers && untouched();
    const { scene: opened = -1, view = [] } = pageState();
    const isNew = opened !== scene;
    if (isNew && since === 0) since = performance.now();
    // Only a body of the page's own is told of.
    if (isNew && !view.length && opened >= 0 && performance.now() - since < WAIT) return;
    const toldLater = !isNew && view.join() !== known && view.length > 0 && untouched();
    const same = isNew || toldLater || !untouched() ? null : asked;
    if ((isNew || toldLater || size !== now || grown) && (same ? show(same, false) : fit())) {
      scene = opened;
      known = view.join();
      since = 0;
      size = now;
      covers = cover;
    }
  };
  let pressed = false;
  window.addEventListener("pointerdown", () => (pressed = true), true);
  for (const kind of ["pointerup", "pointercancel"]) window.addEventListener(kind, () => (pressed = false), true);
  let looked = 0;
  onPicture(() => {
    const time = performance.now();
    if (pressed || time - looked < LOOK_EVERY) return;
    looked = time;
    follow();
  });
  onMessage("pageState", look);
  setInterval(look, CHECK_EVERY);
}
