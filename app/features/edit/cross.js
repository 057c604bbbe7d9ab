// @ts-check
/** A cross on the canvas, which arrow keys move and Enter presses: a pointer for whoever has none. */
import { isNothing, partAt, placeOf, rounded, step } from "./pick.js";
import { clickAt, hover } from "./gestures.js";
import { editing, nameOf, onEditing, setEditing } from "./editing.js";
import { tell } from "./speech.js";
import { placeText } from "../../stage/measures.js";
import { chosenMass } from "../../stage/overlay.js";
import { onScreen, sceneAt, worldAt } from "../../stage/screen.js";
import { sight } from "../../stage/sight.js";
import { pageState } from "../../wire/channel.js";
import { say } from "../../words/words.js";

/** Factor by which an arrow key moves it less with Shift. */
const FINE = 0.1;

/** Where it is, px of the scene; null while there is none. @type {{x: number, y: number} | null} */
let at = null;
onEditing(() => {
  if (!editing.on) at = null;
});

/** Where it is on the screen; null while there is none. @param {import("./pick.js").Sight | null} [seen] */
export function crossAt(seen = sight()) {
  if (!at || !seen) return null;
  const [x, y] = onScreen(seen.plan, [at.x, at.y], seen.on);
  return { x, y };
}

/** Says where it is, and what is there. */
function whereabouts() {
  const place = crossAt();
  if (!at || !place) return "";
  const told = placeText(at.x, at.y, pageState().unit ?? "");
  const parts = partAt(place, "mouse");
  return isNothing(parts) ? told : say("edit-cross-on", { place: told, part: nameOf(parts) });
}

/** Opens the tools, goes to the body, and puts the cross at the chosen mass or into the middle. */
export function raiseCross() {
  setEditing(true);
  const body = /** @type {HTMLElement | null} */ (document.querySelector(".softrod-body"));
  body?.focus();
  const seen = sight();
  if (!seen) return;
  const { plan, on, box, floor } = seen;
  const mass = chosenMass();
  const middle = { x: (box.left + box.right) / 2, y: (box.top + floor) / 2 };
  const place = sceneAt(plan, worldAt(mass >= 0 ? placeOf(seen, mass) : middle, on));
  at = { x: rounded(place.x, step()), y: rounded(place.y, step()) };
  hover(crossAt(seen));
  tell(say("edit-cross", { place: whereabouts() }));
}

/** Takes it away. @returns {boolean} whether there was one */
export function dropCross() {
  if (!at) return false;
  at = null;
  hover(null);
  tell(say("edit-cross.gone"));
  return true;
}

/** Moves it by a step of the grid. @param {readonly [number, number]} way @param {boolean} isFine */
export function moveCross([x, y], isFine) {
  const seen = sight();
  if (!at || !seen) return;
  const by = step() * (isFine ? FINE : 1);
  at = { x: rounded(at.x + x * by, by), y: rounded(at.y + y * by * seen.plan.flip, by) };
  hover(crossAt(seen));
  tell(whereabouts());
}

/** Does what a click there does. */
export function pressCross() {
  const place = crossAt();
  if (place && editing.on) clickAt(place);
}
