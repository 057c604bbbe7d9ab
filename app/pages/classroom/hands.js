// @ts-check
/** Hands on a body that the server moves: what the hands of live files do, as messages. */
import { Hands } from "../../export/live/static/hands.js";
import { wireNumber } from "../../stage/screen.js";
import { heldArrow } from "../../ui/hands/arrow_keys.js";
import { listenToPad, releasePad } from "../../ui/hands/arrow_pad.js";
import { handAt, freeHand, takeHand } from "../../ui/hands/hands.js";
import { pageState, send } from "../../wire/channel.js";

/** @typedef {import("./picture.js").Picture} Picture */
/** @typedef {"up" | "down" | "left" | "right"} Key */

/** Milliseconds between two repetitions of held keys; the server releases what is not repeated. */
const REPEAT_EVERY = 100;

/** Has hands and keys act on the body. @param {Picture} picture @param {() => boolean} isOwn whether the body is this page's, and the server's to move */
export function addHands(picture, isOwn) {
  const shown = {
    get body() {
      return picture.body;
    },
    get plan() {
      return /** @type {import("../../stage/plan.js").Plan} */ (picture.plan);
    },
    get place() {
      return picture.place;
    },
    get unit() {
      return pageState().unit ?? "";
    },
  };
  const hands = new Hands(picture.canvas, shown);
  /** The server's hand of each pointer, and where it was last. @type {Map<number, {hand: number, mass: number, at: string}>} */
  const known = new Map();
  /** Of the page's world. @param {{x: number, y: number}} place px of the scene */
  const world = ({ x, y }) => {
    const { plan } = shown;
    return { x: (x - plan.x) * plan.scale, y: (y - plan.y) * plan.scale * plan.flip };
  };
  const report = () => {
    requestAnimationFrame(report);
    if (!picture.plan) return;
    if (!isOwn()) {
      for (const { hand } of known.values()) freeHand(hand);
      known.clear();
      return;
    }
    for (const [pointer, { hand, mass }] of known) {
      const led = hands.held.get(pointer);
      if (led && led.mass === mass) continue;
      known.delete(pointer);
      freeHand(hand);
      send({ do: "drop", hand });
    }
    /** @type {[number, number, number][]} */
    const moved = [];
    for (const [pointer, led] of hands.held) {
      const place = world(led), at = `${place.x} ${place.y}`;
      const before = known.get(pointer);
      if (!before) {
        const hand = takeHand();
        if (hand < 0) continue;
        known.set(pointer, { hand, mass: led.mass, at });
        send({ do: "grab", hand, mass: led.mass, x: wireNumber(place.x), y: wireNumber(place.y) });
      } else if (before.at !== at) {
        before.at = at;
        moved.push(handAt(before.hand, place));
      }
    }
    if (moved.length) send({ do: "at", hands: moved });
  };
  report();
  addKeys();
  return hands;
}

/** Has held arrow keys, and the pad's, act on the body. */
function addKeys() {
  /** @type {Set<Key>} */
  const held = new Set();
  const tell = () => {
    if (pageState().arrows?.length) send({ do: "keys", held: [...held] });
  };
  /** @param {Key} key @param {boolean} down */
  const press = (key, down) => {
    if (down === held.has(key)) return;
    if (down) held.add(key);
    else held.delete(key);
    tell();
  };
  document.addEventListener("keydown", (event) => {
    const key = heldArrow(event);
    const { target } = event;
    const isBusy = target instanceof Element && target.closest("input, select, textarea, svg, canvas:focus-visible");
    if (!key || isBusy || !pageState().arrows?.length) return;
    event.preventDefault();
    press(/** @type {Key} */ (key), true);
  });
  document.addEventListener("keyup", (event) => press(/** @type {Key} */ (heldArrow(event)), false));
  window.addEventListener("blur", () => {
    for (const key of [...held]) press(key, false);
    releasePad();
  });
  setInterval(() => held.size && tell(), REPEAT_EVERY);
  listenToPad((key) => press(key, true), (key) => press(key, false));
}
