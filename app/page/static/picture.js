// @ts-check
/**
 * A picture of what the page shows: viser's canvas, drawn anew at twice the size, with all that softrod draws under and
 * over it, and the scene's title and the time. It is made in the browser and downloaded from there.
 *
 * Every SVG and canvas element belongs to it whose class begins with `softrod-`, unless it is a part of a button or of
 * the panel.
 *
 * @typedef {import("./viser.js").Renderer} Renderer
 */
import { onTold, told } from "./channel.js";
import { SVG } from "./overlay.js";
import { timeNow } from "./transport.js";
import { viser } from "./viser.js";

/** Pixels of a picture for a pixel of the page, at least. */
const FINE = 2;
/** Pixels of a side at most. */
const LARGEST = 8192;
const LAYERS = ':is(svg, canvas)[class*="softrod-"]';
/** What is part of a control, not of the picture. */
const CONTROLS = "button, [role=tabpanel], .softrod-dock, .mantine-Paper-root";
/** What of an element's style comes from style sheets, which a picture does not have. */
const STYLES = [
  "display", "visibility", "opacity", "fill", "fill-opacity", "fill-rule", "stroke", "stroke-opacity", "stroke-width",
  "stroke-dasharray", "stroke-dashoffset", "stroke-linecap", "stroke-linejoin", "paint-order", "vector-effect", "color",
  "font-family", "font-size", "font-weight", "font-style", "font-variant-numeric", "letter-spacing", "text-anchor",
  "dominant-baseline", "marker-start", "marker-mid", "marker-end", "stop-color", "stop-opacity", "transform",
  "transform-origin", "transform-box", "mix-blend-mode",
];

/**
 * viser's canvas, drawn at so many pixels for one of the page.
 *
 * @param {number} fine
 * @returns {Promise<HTMLCanvasElement>}
 */
function drawnAnew(fine) {
  const { canvas, scene, requestRender } = viser() ?? {};
  if (!canvas || !scene) return Promise.reject(new Error("there is no canvas"));
  const copy = document.createElement("canvas");
  return new Promise((done) => {
    const before = scene.onAfterRender;
    scene.onAfterRender = (renderer, shown, camera) => {
      scene.onAfterRender = before;
      // After viser's own frame, but before the browser takes the canvas's content away.
      queueMicrotask(() => {
        const ratio = renderer.getPixelRatio();
        renderer.setPixelRatio(fine);
        renderer.render(shown, camera);
        [copy.width, copy.height] = [canvas.width, canvas.height];
        copy.getContext("2d")?.drawImage(canvas, 0, 0);
        renderer.setPixelRatio(ratio);
        renderer.render(shown, camera);
        done(copy);
      });
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
 * A layer as an image of the canvas's box.
 *
 * @param {SVGSVGElement} layer
 * @param {DOMRect} box
 * @param {number} fine
 */
async function rastered(layer, box, fine) {
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
  const url = URL.createObjectURL(new Blob([new XMLSerializer().serializeToString(root)], { type: "image/svg+xml" }));
  try {
    const image = new Image();
    image.src = url;
    await image.decode();
    return image;
  } finally {
    URL.revokeObjectURL(url);
  }
}

/** What lies under the canvas, and what over it, each from the back to the front. @param {HTMLCanvasElement} canvas */
function layers(canvas) {
  const found = [...document.querySelectorAll(LAYERS)].filter(
    (layer) => layer !== canvas && !layer.closest(CONTROLS) && layer.getClientRects().length > 0,
  );
  /** @param {Element} layer */
  const height = (layer) => Number(getComputedStyle(layer).zIndex) || 0;
  found.sort((one, other) => height(one) - height(other));
  const over = found.filter((layer) => height(layer) >= 0);
  return { under: found.filter((layer) => height(layer) < 0), over };
}

/** @returns {Promise<HTMLCanvasElement>} */
async function picture() {
  const canvas = viser()?.canvas;
  if (!canvas) throw new Error("there is no canvas");
  const box = canvas.getBoundingClientRect();
  const fine = Math.min(Math.max(FINE, devicePixelRatio), LARGEST / Math.max(box.width, box.height));
  const body = await drawnAnew(fine);
  const result = document.createElement("canvas");
  [result.width, result.height] = [Math.round(box.width * fine), Math.round(box.height * fine)];
  const to = result.getContext("2d");
  if (!to) throw new Error("there is no canvas");
  const styles = getComputedStyle(document.documentElement);
  /** @param {string} name @param {string} otherwise */
  const color = (name, otherwise) => styles.getPropertyValue(`--softrod-${name}`) || otherwise;
  to.fillStyle = color("paper", "#ffffff");
  to.fillRect(0, 0, result.width, result.height);
  /** @param {Element} layer */
  const add = async (layer) => {
    to.globalAlpha = layer instanceof HTMLCanvasElement ? Number(getComputedStyle(layer).opacity) : 1;
    if (layer instanceof SVGSVGElement) {
      to.drawImage(await rastered(layer, box, fine), 0, 0, result.width, result.height);
    } else if (layer instanceof HTMLCanvasElement && layer.width && layer.height) {
      const { left, top, width, height } = layer.getBoundingClientRect();
      to.drawImage(layer, (left - box.left) * fine, (top - box.top) * fine, width * fine, height * fine);
    }
    to.globalAlpha = 1;
  };
  const { under, over } = layers(canvas);
  for (const layer of under) await add(layer);
  to.drawImage(body, 0, 0, result.width, result.height);
  for (const layer of over) await add(layer);
  to.scale(fine, fine);
  to.fillStyle = color("text", "#334155");
  to.font = "600 18px system-ui, sans-serif";
  to.fillText(told().title ?? "", 18, 32);
  to.font = "14px system-ui, sans-serif";
  to.fillText(`t = ${timeNow().toFixed(2)} s`, 18, 54);
  return result;
}

let busy = false;

/** Makes a picture, and has the browser keep it as a file. */
export async function takePicture() {
  if (busy) return;
  busy = true;
  try {
    const image = await picture();
    const file = await new Promise((/** @type {BlobCallback} */ done) => image.toBlob(done, "image/png"));
    if (!file) throw new Error("the picture could not be packed");
    const link = document.createElement("a");
    link.href = URL.createObjectURL(file);
    link.download = `${(told().title ?? "").replace(/[^\p{L}\p{N} ._-]+/gu, "-").slice(0, 80) || "softrod"}.png`;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
  } finally {
    busy = false;
  }
}

/** Takes a picture whenever the server says that somebody asked for one. */
export function mindPictures() {
  let last = Number(told().picture ?? 0);
  onTold(() => {
    const asked = Number(told().picture ?? 0);
    if (asked > last) void takePicture();
    last = asked;
  });
}
