// @ts-check
/**
 * A picture behind the body, to draw over: of a bridge, or a skeleton. It is read in the browser and stays there, in the
 * tab's own storage; neither the server nor a saved scene has it.
 *
 * @typedef {{data: string, x: number, y: number, width: number, ratio: number, opacity: number}} Picture
 *   its address, the middle and the width in the world, height over width, and how opaque it is
 */
import { make, makeButton } from "../../ui/dialog.js";
import { editing, onEditing } from "./editing.js";
import { ARROWS } from "../../ui/hands/key_table.js";
import { isFree, swallow } from "../../ui/hands/keys.js";
import { makeSvg, set } from "../../stage/svg.js";
import { screen } from "../../stage/screen.js";
import { kept, store } from "../../ui/kept/storage.js";
import { onUnderlay } from "../../stage/underlay.js";
import { render, viserCanvas } from "../../ui/viser/viser.js";

const STORED = "softrod-picture";
/** Pixels of the longer side that are kept: the storage has room for some megabytes. */
const LONGEST = 1600;
/** Characters of the largest picture that is kept. */
const MOST = 2_500_000;
/** Width at first, and the range of the slider, in the world: a scene's frame is 6 wide. */
const [FIRST, NARROWEST, WIDEST] = [5, 0.5, 30];
/** Milliseconds without a change after which it is stored. */
const STORE_AFTER = 300;
/** What does something else with the arrows. */
const OWN_ARROWS = '.softrod-body, .softrod-grip, .softrod-own-grip, input, [role="tab"], [role="slider"]:focus-visible';
/** By how much an arrow moves it, in the world, and with Shift. */
const [STEP, FINE] = [0.1, 0.01];

/** @type {Picture | null} */
let picture = null;
/** The timer by which it is stored. */
let storing = 0;
/** Whether the pointer and the arrows move it. */
let moving = false;

/** What was stored. @returns {Picture | null} */
const restored = () => JSON.parse(kept(STORED) || "null");

/**
 * Reads a file as a picture, not larger than is needed.
 *
 * @param {File} file
 * @returns {Promise<{data: string, ratio: number} | null>} null if it is none
 */
async function read(file) {
  const address = URL.createObjectURL(file);
  try {
    const image = new Image();
    image.src = address;
    await image.decode();
    const [wide, high] = [image.naturalWidth || LONGEST, image.naturalHeight || LONGEST];
    const canvas = document.createElement("canvas");
    const context = canvas.getContext("2d");
    for (let longest = LONGEST; context && longest > 200; longest *= 0.7) {
      const part = Math.min(1, longest / Math.max(wide, high));
      [canvas.width, canvas.height] = [Math.max(1, Math.round(wide * part)), Math.max(1, Math.round(high * part))];
      context.drawImage(image, 0, 0, canvas.width, canvas.height);
      const data = canvas.toDataURL("image/webp", 0.85);
      if (data.length < MOST) return { data, ratio: high / wide };
    }
    return null;
  } catch {
    return null;
  } finally {
    URL.revokeObjectURL(address);
  }
}

/**
 * Brings back the picture that there was, and begins to listen: before the pointer and the keys of the body.
 *
 * @returns {{button: HTMLButtonElement, row: HTMLElement, said: HTMLElement}} for the bar of the tools: what brings it,
 *   its controls, and what went wrong
 */
export function addTracing() {
  picture = restored();
  const row = make("div", "softrod-edit-picture");
  const file = make("input", "");
  file.type = "file";
  file.accept = "image/*";
  file.hidden = true;
  const said = make("span", "");
  said.setAttribute("role", "status");
  const size = slider("Size", Math.log2(NARROWEST), Math.log2(WIDEST), (value) => put({ width: 2 ** value }));
  const opacity = slider("Opacity", 0.1, 1, (value) => put({ opacity: value }));
  const move = makeButton("Move it", () => {
    moving = !moving;
    show();
  }, "");
  move.title = "Drag it, or use the arrow keys, until Esc";
  const another = makeButton("Another", () => file.click(), "");
  const remove = makeButton("Take it away", () => {
    picture = null;
    moving = false;
    keep();
    show();
  }, "");
  row.append(size.label, opacity.label, move, another, remove, file);
  row.hidden = true;
  const button = makeButton("Picture", () => {
    if (picture) row.hidden = !row.hidden;
    else file.click();
    if (row.hidden) moving = false;
    show();
    row.scrollIntoView({ block: "nearest", inline: "start" });
  }, "");
  button.title = "A picture behind the body, to draw over; it stays in this browser";

  const storeNow = () => {
    clearTimeout(storing);
    storing = 0;
    store(STORED, picture ? JSON.stringify(picture) : "");
  };
  // Not at every move of the pointer: it may be some megabytes.
  const keep = () => {
    clearTimeout(storing);
    storing = setTimeout(storeNow, STORE_AFTER);
  };
  window.addEventListener("pagehide", () => storing && storeNow());
  /** @param {Partial<Picture>} changes */
  const put = (changes) => {
    if (!picture) return;
    Object.assign(picture, changes);
    keep();
    render();
  };
  const show = () => {
    const focused = row.contains(document.activeElement);
    if (!picture || !editing.on) row.hidden = true;
    if (row.hidden && focused) button.focus();
    if (row.hidden) moving = false;
    button.ariaPressed = String(!row.hidden);
    move.ariaPressed = String(moving);
    if (picture) {
      size.input.value = String(Math.log2(picture.width));
      opacity.input.value = String(picture.opacity);
    }
    render();
  };
  file.addEventListener("change", async () => {
    const [chosen] = file.files ?? [];
    file.value = "";
    const found = chosen && (await read(chosen));
    if (!found) {
      if (chosen) said.textContent = `${chosen.name} is no picture that this browser can show`;
      return;
    }
    said.textContent = "";
    picture = { x: 0, y: 0, width: FIRST, opacity: 0.5, ...(picture ?? {}), ...found };
    keep();
    row.hidden = false;
    show();
    row.scrollIntoView({ block: "nearest", inline: "start" }); // on a phone, the bar is longer than it shows
  });

  const image = makeSvg("image", "");
  image.setAttribute("preserveAspectRatio", "none");
  onUnderlay(({ on }, svg) => {
    if (!picture) {
      image.remove();
      return;
    }
    if (svg.firstChild !== image) svg.prepend(image);
    const wide = picture.width * on.step;
    const high = wide * picture.ratio;
    const [x, y] = [on.x + picture.x * on.step - wide / 2, on.y - picture.y * on.step - high / 2];
    set(image, { href: picture.data, x, y, width: wide, height: high, opacity: picture.opacity });
  });
  listen(put, () => {
    moving = false;
    show();
  });
  let { on } = editing;
  onEditing(() => {
    if (editing.on === on) return;
    ({ on } = editing);
    show();
  });
  return { button, row, said };
}

/** @param {string} text @param {number} low @param {number} high @param {(value: number) => void} moved */
function slider(text, low, high, moved) {
  const label = make("label", "", text);
  const input = make("input", "");
  Object.assign(input, { type: "range", min: String(low), max: String(high), step: "any" });
  input.addEventListener("input", () => moved(Number(input.value)));
  label.append(input);
  return { label, input };
}

/**
 * Moves it with the pointer and with arrows, until Esc.
 *
 * @param {(changes: Partial<Picture>) => void} put @param {() => void} stop
 */
function listen(put, stop) {
  /** @type {{id: number, x: number, y: number, from: {x: number, y: number}} | null} */
  let hold = null;
  window.addEventListener("pointerdown", (event) => {
    const canvas = viserCanvas();
    if (!moving || !picture || !canvas || event.target !== canvas || event.button !== 0 || hold) return;
    swallow(event);
    canvas.setPointerCapture(event.pointerId);
    hold = { id: event.pointerId, x: event.clientX, y: event.clientY, from: { ...picture } };
  }, true);
  window.addEventListener("pointermove", (event) => {
    if (!hold || event.pointerId !== hold.id) return;
    event.stopImmediatePropagation();
    const step = screen()?.step ?? 1;
    put({ x: hold.from.x + (event.clientX - hold.x) / step, y: hold.from.y - (event.clientY - hold.y) / step });
  }, true);
  for (const kind of /** @type {const} */ (["pointerup", "pointercancel", "lostpointercapture"])) {
    window.addEventListener(kind, (event) => {
      if (!hold || event.pointerId !== hold.id) return;
      event.stopImmediatePropagation();
      hold = null;
    }, true);
  }
  window.addEventListener("keydown", (event) => {
    const way = ARROWS[event.key];
    const { target } = event;
    if (!moving || !picture || !isFree(event)) return;
    if (event.key === "Escape") {
      swallow(event);
      stop();
      return;
    }
    if (!way) return;
    if (target instanceof Element && target.matches(OWN_ARROWS)) return;
    swallow(event);
    const step = event.shiftKey ? FINE : STEP;
    put({ x: picture.x + way[0] * step, y: picture.y + way[1] * step });
  }, true);
}
