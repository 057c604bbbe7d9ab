// @ts-check
/**
 * Hands on the body of a live file: by mouse, pen and several fingers, and by keys alone while the canvas has the focus.
 * There the arrows choose a mass, Space takes hold of it and lets go, and the arrows then move it.
 *
 * @typedef {import("./body.js").Body} Body
 * @typedef {import("../../../stage/plan.js").Plan} Plan
 * @typedef {import("../../../stage/environment.js").Screen} Screen
 */
import { element } from "../../static/parts.js";

/** Pixels from the rim of a mass within which it is taken hold of. */
const REACH = { mouse: 12, pen: 16, touch: 26 };
/** How far an arrow moves a mass, in units of the world, and how many times farther with Shift. */
const [STEP, FAR] = [0.06, 5];
/** The hand of the keys among those of pointers. */
const KEYS = -1;

/** @type {Record<string, [number, number]>} */
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

/**
 * @param {HTMLCanvasElement} canvas
 * @param {{body: () => Body, plan: () => Plan, place: () => Screen}} of what is shown now
 */
export function addHands(canvas, { body, plan, place }) {
  /** Each hand's mass, and where it leads it, px. @type {Map<number, {mass: number, x: number, y: number}>} */
  const led = new Map();
  /** The mass that the keys have chosen. */
  let chosen = -1;
  /** Whether the ringed mass follows the pointer, and where that is, px. */
  let follows = false;
  /** @type {{x: number, y: number} | null} */
  let pointer = null;
  const says = element("says", HTMLElement);

  /** Where a mass is on the screen. @param {number} mass */
  const onScreen = (mass) => {
    const { positions } = body();
    const { scale, x, y, flip } = plan();
    const on = place();
    return {
      x: on.x + on.step * (positions[2 * mass] - x) * scale,
      y: on.y - on.step * (positions[2 * mass + 1] - y) * scale * flip,
    };
  };
  /** Where a place on the canvas is, px. @param {number} left @param {number} top */
  const inScene = (left, top) => {
    const { scale, x, y, flip } = plan();
    const on = place();
    return { x: x + (left - on.x) / on.step / scale, y: y + ((on.y - top) / on.step / scale) * flip };
  };
  /** The nearest mass within reach, or -1. @param {number} left @param {number} top @param {number} reach */
  const massAt = (left, top, reach) => {
    const { radius } = plan();
    const { step } = place();
    let [found, least] = [-1, reach];
    for (let m = 0; m < radius.length; m++) {
      const at = onScreen(m);
      const far = Math.hypot(at.x - left, at.y - top) - radius[m] * step;
      if (far < least) [found, least] = [m, far];
    }
    return found;
  };
  /** @param {PointerEvent} event */
  const spot = ({ clientX, clientY }) => {
    const box = canvas.getBoundingClientRect();
    return [clientX - box.left, clientY - box.top];
  };

  canvas.addEventListener("pointerleave", () => (pointer = null));
  canvas.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    const [left, top] = spot(event);
    pointer = inScene(left, top);
    const mass = massAt(left, top, REACH[/** @type {"mouse"} */ (event.pointerType)] ?? REACH.mouse);
    if (mass < 0) return;
    event.preventDefault();
    canvas.setPointerCapture(event.pointerId);
    for (const [hand, { mass: other }] of led) if (other === mass) led.delete(hand);
    led.set(event.pointerId, { mass, x: body().positions[2 * mass], y: body().positions[2 * mass + 1] });
    canvas.classList.add("holds");
  });
  canvas.addEventListener("pointermove", (event) => {
    const [left, top] = spot(event);
    const hand = led.get(event.pointerId);
    pointer = inScene(left, top);
    if (hand) Object.assign(hand, pointer);
    else if (event.pointerType === "mouse") canvas.classList.toggle("near", massAt(left, top, REACH.mouse) >= 0);
  });
  for (const kind of /** @type {const} */ (["pointerup", "pointercancel", "lostpointercapture"])) {
    canvas.addEventListener(kind, ({ pointerId }) => {
      led.delete(pointerId);
      canvas.classList.toggle("holds", led.size > 0);
    });
  }
  // Two fingers of which one holds a mass do not zoom; its pointer is pressed before its touch starts.
  canvas.addEventListener("touchstart", (event) => led.size && event.preventDefault(), { passive: false });
  const name = () => `mass ${chosen} of 0 to ${body().masses - 1}`;
  canvas.addEventListener("focus", () => {
    if (!canvas.matches(":focus-visible")) return;
    if (chosen < 0) chosen = Math.min(body().masses - 1, Math.max(0, plan().driven));
    says.textContent = `${name()}. Arrows choose another one, Space takes hold of it.`;
  });
  canvas.addEventListener("blur", () => {
    led.delete(KEYS);
    chosen = -1;
  });
  canvas.addEventListener("keydown", (event) => {
    const { key, shiftKey, repeat, ctrlKey, metaKey, altKey } = event;
    if (chosen < 0 || ctrlKey || metaKey || altKey) return;
    const hand = led.get(KEYS);
    if (key === " ") {
      event.preventDefault();
      event.stopPropagation();
      if (repeat) return;
      if (hand) led.delete(KEYS);
      else led.set(KEYS, { mass: chosen, x: body().positions[2 * chosen], y: body().positions[2 * chosen + 1] });
      says.textContent = `${name()} ${hand ? "let go" : "taken hold of; arrows move it"}`;
      return;
    }
    const arrow = ARROWS[key];
    if (!arrow) return;
    event.preventDefault();
    event.stopPropagation();
    if (hand) {
      const { scale, flip } = plan();
      const way = (STEP / scale) * (shiftKey ? FAR : 1);
      hand.x += way * arrow[0];
      hand.y += way * arrow[1] * flip;
    } else {
      const { masses } = body();
      chosen = (chosen + masses + (arrow[0] + arrow[1] > 0 ? 1 : -1)) % masses;
      says.textContent = name();
    }
  });

  /** The hands, each with its mass and where that is to be. */
  const hands = () => {
    const mass = plan().driven;
    return follows && pointer && mass >= 0 && !led.size ? [{ mass, ...pointer }] : [...led.values()];
  };

  return {
    hands,
    /** Have the ringed mass follow the pointer, or no longer. */
    follow: () => (follows = !follows),
    follows: () => follows,
    letGo: () => led.clear(),
    /** Put the masses where hands have them, while the clock stands. */
    moveAtOnce() {
      const { positions, velocities } = body();
      for (const { mass, x, y } of hands()) {
        positions[2 * mass] = x;
        positions[2 * mass + 1] = y;
        velocities[2 * mass] = velocities[2 * mass + 1] = 0;
      }
    },
    /** Mark the mass that the keys have chosen. */
    mark() {
      const to = canvas.getContext("2d");
      if (chosen < 0 || !to || document.activeElement !== canvas) return;
      const at = onScreen(chosen);
      to.beginPath();
      to.arc(at.x, at.y, plan().radius[chosen] * place().step + 6, 0, 2 * Math.PI);
      to.lineWidth = led.has(KEYS) ? 4 : 2;
      to.strokeStyle = getComputedStyle(document.documentElement).getPropertyValue("--softrod-brand");
      to.stroke();
    },
  };
}
