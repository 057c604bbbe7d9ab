// @ts-check
/**
 * A picture behind the body, to draw over: of a bridge, or a skeleton. It is read in the browser and stays in the tab's
 * storage; neither the server nor a saved scene contains it.
 *
 * @typedef {{data: string, x: number, y: number, width: number, ratio: number, opacity: number}} Picture
 *   data URL, centre and width in the page's world, height over width, opacity
 */
import { make, makeButton } from "../../ui/dialog.js";
import { editing, onEditing } from "./editing.js";
import { ARROWS } from "../../ui/hands/arrow_keys.js";
import { isFree, swallow } from "../../ui/hands/keys.js";
import { takePointer } from "../../ui/hands/take.js";
import { makeSvg, set } from "../../stage/svg.js";
import { screen } from "../../ui/viser/screen.js";
import { kept, store } from "../../ui/kept/storage.js";
import { onUnderlay } from "../../stage/underlay.js";
import { viser, viserCanvas } from "../../ui/viser/viser.js";
import { say } from "../../words/words.js";

const STORED = "softrod-picture";
/** Pixels of the longer side, at most: the storage has room for some megabytes. */
const MAX_PIXELS = 1600;
const MIN_PIXELS = 200;
/** Characters of a stored picture, at most. */
const MAX_LETTERS = 2_500_000;
/** Width of a new picture, in the page's world, where a scene is 6 wide. */
const FIRST_WIDTH = 5;
/** Range of the width. */
const MIN_WIDTH = 0.5;
const MAX_WIDTH = 30;
/** Milliseconds without a change after which it is stored. */
const STORE_AFTER = 300;
/** Elements that use the arrow keys themselves. */
const USES_ARROWS = '.softrod-body, .softrod-grip, .softrod-own-grip, input, [role="tab"], [role="slider"]:focus-visible';
/** Distance by which an arrow key moves it, in the page's world. */
const STEP = 0.1;
/** The same with Shift. */
const FINE_STEP = 0.01;

/** Reads a file as a picture that fits the storage; null if it is none. @param {File} file */
async function read(file) {
  const address = URL.createObjectURL(file);
  try {
    const image = new Image();
    image.src = address;
    await image.decode();
    const [width, height] = [image.naturalWidth || MAX_PIXELS, image.naturalHeight || MAX_PIXELS];
    const canvas = document.createElement("canvas");
    const context = canvas.getContext("2d");
    for (let longest = MAX_PIXELS; context && longest > MIN_PIXELS; longest *= 0.7) {
      const part = Math.min(1, longest / Math.max(width, height));
      [canvas.width, canvas.height] = [Math.max(1, Math.round(width * part)), Math.max(1, Math.round(height * part))];
      context.drawImage(image, 0, 0, canvas.width, canvas.height);
      const data = canvas.toDataURL("image/webp", 0.85);
      if (data.length < MAX_LETTERS) return { data, ratio: height / width };
    }
    return null;
  } catch {
    return null;
  } finally {
    URL.revokeObjectURL(address);
  }
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

class Tracing {
  /** @type {Picture | null} */
  picture = JSON.parse(kept(STORED) || "null");
  /** The timer by which it is stored. */
  storing = 0;
  /** Whether the pointer and the arrow keys move it. */
  moving = false;

  constructor() {
    this.file = make("input", "");
    Object.assign(this.file, { type: "file", accept: "image/*", hidden: true });
    this.file.addEventListener("change", () => this.open());
    this.says = make("span", "");
    this.says.setAttribute("role", "status");
    this.size = slider(say("edit-picture.size"), Math.log2(MIN_WIDTH), Math.log2(MAX_WIDTH), (value) => this.put({ width: 2 ** value }));
    this.opacity = slider(say("edit-picture.opacity"), 0.1, 1, (opacity) => this.put({ opacity }));
    this.move = makeButton(say("edit-picture.move"), () => this.show(!this.moving), "");
    this.move.title = say("edit-picture.drag");
    this.row = make("div", "softrod-edit-picture");
    this.row.append(
      this.size.label, this.opacity.label, this.move,
      makeButton(say("edit-picture.another"), () => this.file.click(), ""), makeButton(say("edit-picture.remove"), () => this.replace(null), ""), this.file,
    );
    this.row.hidden = true;
    this.button = makeButton(say("edit-picture"), () => {
      if (this.picture) this.row.hidden = !this.row.hidden;
      else this.file.click();
      this.show();
      this.scroll();
    }, "");
    this.button.title = say("edit-picture.hint");
    this.image = makeSvg("image", "");
    this.image.setAttribute("preserveAspectRatio", "none");
  }

  /** Reads the chosen file. */
  async open() {
    const [file] = this.file.files ?? [];
    this.file.value = "";
    if (!file) return;
    const found = await read(file);
    this.says.textContent = found ? "" : say("edit-no-picture", { name: file.name });
    if (!found) return;
    this.row.hidden = false;
    this.replace({ x: 0, y: 0, width: FIRST_WIDTH, opacity: 0.5, ...this.picture, ...found });
    this.scroll();
  }

  /** On a phone, the bar is longer than the screen. */
  scroll() {
    this.row.scrollIntoView({ block: "nearest", inline: "start" });
  }

  /** @param {Picture | null} picture */
  replace(picture) {
    this.picture = picture;
    this.storeSoon();
    this.show();
  }

  /** @param {Partial<Picture>} changes */
  put(changes) {
    if (!this.picture) return;
    Object.assign(this.picture, changes);
    this.storeSoon();
    viser()?.requestRender();
  }

  /** Stores it after a pause: it may be some megabytes. */
  storeSoon() {
    clearTimeout(this.storing);
    this.storing = setTimeout(() => this.storeNow(), STORE_AFTER);
  }

  storeNow() {
    if (!this.storing) return;
    clearTimeout(this.storing);
    this.storing = 0;
    store(STORED, this.picture ? JSON.stringify(this.picture) : "");
  }

  /** Shows the controls as they are now. @param {boolean} [moving] whether pointer and arrows move the picture */
  show(moving = this.moving) {
    const focused = this.row.contains(document.activeElement);
    if (!this.picture || !editing.on) this.row.hidden = true;
    if (this.row.hidden && focused) this.button.focus();
    this.moving = moving && !this.row.hidden;
    this.button.ariaPressed = String(!this.row.hidden);
    this.move.ariaPressed = String(this.moving);
    if (this.picture) {
      this.size.input.value = String(Math.log2(this.picture.width));
      this.opacity.input.value = String(this.picture.opacity);
    }
    viser()?.requestRender();
  }

  /** @param {import("../../stage/screen.js").Screen} on @param {Element} svg */
  draw(on, svg) {
    if (!this.picture) {
      this.image.remove();
      return;
    }
    if (svg.firstChild !== this.image) svg.prepend(this.image);
    const { data: href, opacity, ...picture } = this.picture;
    const width = picture.width * on.step;
    const height = width * picture.ratio;
    const [x, y] = [on.x + picture.x * on.step - width / 2, on.y - picture.y * on.step - height / 2];
    set(this.image, { href, x, y, width, height, opacity });
  }

  /** Listens to the pointer and the keys that move it. */
  listen() {
    /** @type {{id: number, x: number, y: number, from: {x: number, y: number}} | null} */
    let hold = null;
    window.addEventListener("pointerdown", (event) => {
      const canvas = viserCanvas();
      if (!this.moving || !this.picture || !canvas || event.target !== canvas || event.button !== 0 || hold) return;
      swallow(event);
      takePointer(canvas, event, { name: say("taps-picture") });
      hold = { id: event.pointerId, x: event.clientX, y: event.clientY, from: { ...this.picture } };
    }, true);
    for (const kind of /** @type {const} */ (["pointermove", "pointerup", "pointercancel", "lostpointercapture"])) {
      window.addEventListener(kind, (event) => {
        if (!hold || event.pointerId !== hold.id) return;
        event.stopImmediatePropagation();
        const step = screen()?.step ?? 1;
        if (kind === "pointermove") this.put({ x: hold.from.x + (event.clientX - hold.x) / step, y: hold.from.y - (event.clientY - hold.y) / step });
        else hold = null;
      }, true);
    }
    window.addEventListener("keydown", (event) => {
      if (!this.moving || !this.picture || !isFree(event)) return;
      const arrow = ARROWS[event.key];
      if (event.key === "Escape") this.show(false);
      else if (arrow && !(event.target instanceof Element && event.target.matches(USES_ARROWS))) {
        const step = event.shiftKey ? FINE_STEP : STEP;
        this.put({ x: this.picture.x + arrow[0] * step, y: this.picture.y + arrow[1] * step });
      } else return;
      swallow(event);
    }, true);
  }
}

/** Restores the picture, and begins to listen: before the pointer and the keys of the body. */
export function addTracing() {
  const tracing = new Tracing();
  window.addEventListener("pagehide", () => tracing.storeNow());
  onUnderlay(({ on }, svg) => tracing.draw(on, svg));
  tracing.listen();
  let { on } = editing;
  onEditing(() => {
    if (editing.on === on) return;
    ({ on } = editing);
    tracing.show();
  });
  return tracing;
}
