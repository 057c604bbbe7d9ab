// @ts-check
/**
 * A picture of what the page shows: viser's canvas, drawn again at twice the size, with all that softrod draws under and
 * over it, and the scene's title and the time. It is made in the browser and downloaded from there.
 *
 * Every SVG and canvas element belongs to it whose class begins with `softrod-`, unless it is a part of a button or of
 * the panel.
 *
 * @typedef {import("../../ui/viser/viser.js").Renderer} Renderer
 */
import { decimal } from "../../words/words.js";
import { hold } from "../../stage/canvas.js";
import { pageState } from "../../wire/channel.js";
import { SVG } from "../../stage/svg.js";
import { timeNow } from "../../ui/clock.js";
import { download } from "../../ui/download.js";
import { viser, viserCanvas } from "../../ui/viser/viser.js";

/** Pixels of a picture for a pixel of the page, at least. */
const FINE = 2;
/** Frames after which all that is drawn is of one picture. */
const SETTLED = 3;
/** Pixels of a side at most. */
const LARGEST = 8192;
const LAYERS = ':is(svg, canvas)[class*="softrod-"]';
/** What is part of a control, not of the picture. */
const CONTROLS = "button, .softrod-dock, .softrod-panel";
/** What of an element's style comes from style sheets, which a picture does not have. */
const STYLES = [
  "display", "visibility", "opacity", "fill", "fill-opacity", "fill-rule", "stroke", "stroke-opacity", "stroke-width",
  "stroke-dasharray", "stroke-dashoffset", "stroke-linecap", "stroke-linejoin", "paint-order", "vector-effect", "color",
  "font-family", "font-size", "font-weight", "font-style", "font-variant-numeric", "letter-spacing", "text-anchor",
  "dominant-baseline", "marker-start", "marker-mid", "marker-end", "stop-color", "stop-opacity", "transform",
  "transform-origin", "transform-box", "mix-blend-mode",
];

/** Once viser has drawn. @returns {Promise<[Renderer, import("../../ui/viser/viser.js").Scene, unknown]>} */
function drawn() {
  const { scene, requestRender } = viser() ?? {};
  if (!scene) return Promise.reject(new Error("there is no scene"));
  return new Promise((done) => {
    const before = scene.onAfterRender;
    scene.onAfterRender = (renderer, shown, camera) => {
      scene.onAfterRender = before;
      setTimeout(() => done([renderer, shown, camera]), 0);
    };
    requestRender?.();
  });
}

/**
 * A copy of an element that looks the same without the page's style sheets.
 *
 * @param {Element} element
 */
function dressed(element) {
  const copy = /** @type {Element} */ (element.cloneNode(true));
  const [from, to] = [element, copy].map((root) => [root, ...root.querySelectorAll("*")]);
  from.forEach((source, i) => {
    const styles = getComputedStyle(source);
    const style = STYLES.map((name) => `${name}:${styles.getPropertyValue(name)}`).join(";");
    to[i].setAttribute("style", style);
    to[i].removeAttribute("class");
  });
  return copy;
}

/**
 * A layer as a file of its own, which shows the canvas's box.
 *
 * @param {SVGSVGElement} layer
 * @param {DOMRect} box
 * @param {number} fine
 */
function alone(layer, box, fine) {
  const root = document.createElementNS(SVG, "svg");
  root.setAttribute("viewBox", `${box.left} ${box.top} ${box.width} ${box.height}`);
  root.setAttribute("width", String(box.width * fine));
  root.setAttribute("height", String(box.height * fine));
  const group = document.createElementNS(SVG, "g");
  const to = layer.getScreenCTM();
  if (to) group.setAttribute("transform", `matrix(${to.a} ${to.b} ${to.c} ${to.d} ${to.e} ${to.f})`);
  const look = dressed(layer);
  group.setAttribute("style", look.getAttribute("style") ?? "");
  group.append(...look.childNodes);
  root.append(group);
  return new Blob([new XMLSerializer().serializeToString(root)], { type: "image/svg+xml" });
}

/** @param {Blob} file */
async function image(file) {
  const url = URL.createObjectURL(file);
  try {
    const found = new Image();
    found.src = url;
    await found.decode();
    return found;
  } finally {
    URL.revokeObjectURL(url);
  }
}

/** @typedef {{source: Blob | HTMLCanvasElement, opacity: number, place: DOMRect}} Layer */

/**
 * How a layer looks now.
 *
 * @param {Element} layer
 * @param {DOMRect} box of the canvas
 * @param {number} fine
 * @returns {Layer}
 */
function taken(layer, box, fine) {
  if (layer instanceof SVGSVGElement) return { source: alone(layer, box, fine), opacity: 1, place: box };
  const copy = document.createElement("canvas");
  const from = /** @type {HTMLCanvasElement} */ (layer);
  [copy.width, copy.height] = [from.width, from.height];
  if (copy.width && copy.height) copy.getContext("2d")?.drawImage(from, 0, 0);
  return { source: copy, opacity: Number(getComputedStyle(layer).opacity), place: layer.getBoundingClientRect() };
}

/**
 * All that is to be seen, from the back to the front, as it is at one time.
 *
 * @param {HTMLCanvasElement} canvas
 * @param {number} fine
 */
async function taking(canvas, fine) {
  // viser's nodes take over a picture some time after it came, and what lies under them goes by that.
  for (let i = 1; i < SETTLED; i++) await drawn();
  const [renderer, scene, camera] = await drawn();
  const box = canvas.getBoundingClientRect();
  const ratio = renderer.getPixelRatio();
  renderer.setPixelRatio(fine);
  renderer.render(scene, camera);
  const body = taken(canvas, box, fine);
  renderer.setPixelRatio(ratio);
  renderer.render(scene, camera);
  const layers = [...document.querySelectorAll(LAYERS)].filter(
    (layer) => layer !== canvas && !layer.closest(CONTROLS) && layer.getClientRects().length > 0,
  );
  /** @param {Element} layer */
  const height = (layer) => Number(getComputedStyle(layer).zIndex) || 0;
  layers.sort((one, other) => height(one) - height(other));
  /** @param {boolean} under */
  const some = (under) => layers.filter((layer) => height(layer) < 0 === under).map((layer) => taken(layer, box, fine));
  return { box, time: timeNow(), layers: [...some(true), body, ...some(false)] };
}

/** @returns {Promise<HTMLCanvasElement>} */
async function picture() {
  const canvas = viserCanvas();
  if (!canvas) throw new Error("there is no canvas");
  const { width, height } = canvas.getBoundingClientRect();
  const fine = Math.min(Math.max(FINE, devicePixelRatio), LARGEST / Math.max(width, height));
  hold(true);
  const { box, time, layers } = await taking(canvas, fine).finally(() => hold(false));
  const result = document.createElement("canvas");
  [result.width, result.height] = [Math.round(box.width * fine), Math.round(box.height * fine)];
  const to = result.getContext("2d");
  if (!to) throw new Error("there is no canvas");
  const styles = getComputedStyle(document.documentElement);
  /** @param {string} name */
  const styled = (name) => styles.getPropertyValue(`--softrod-${name}`);
  to.scale(fine, fine);
  to.fillStyle = styled("paper");
  to.fillRect(0, 0, box.width, box.height);
  for (const { source, opacity, place } of layers) {
    const look = source instanceof Blob ? await image(source) : source;
    if (!look.width || !look.height) continue;
    to.globalAlpha = opacity;
    to.drawImage(look, place.left - box.left, place.top - box.top, place.width, place.height);
  }
  to.globalAlpha = 1;
  to.fillStyle = styled("text");
  to.font = `600 18px ${styled("font")}`;
  to.fillText(pageState().title ?? "", 18, 32);
  to.font = `14px ${styled("font")}`;
  to.fillText(`t = ${decimal(time.toFixed(2))} s`, 18, 54);
  return result;
}

let busy = false;

/** Makes a picture, and has the browser save it as a file. */
export async function takePicture() {
  if (busy) return;
  busy = true;
  try {
    const made = await picture();
    const file = await new Promise((/** @type {BlobCallback} */ done) => made.toBlob(done, "image/png"));
    if (!file) throw new Error("the picture could not be packed");
    download(file, `${(pageState().title ?? "").replace(/[^\p{L}\p{N} ._-]+/gu, "-").slice(0, 80) || "softrod"}.png`);
  } finally {
    busy = false;
  }
}
