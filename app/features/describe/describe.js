// @ts-check
/** The description of the body, or of a part of it: a card over the canvas, which a screen reader reads. Esc closes it. */
import { chosenMass } from "../../stage/overlay.js";
import { onMessage, send } from "../../wire/channel.js";
import { addTeller, make, makeClose, overCanvas } from "../../ui/dialog.js";
import { isFree, swallow } from "../../ui/hands/keys.js";
import { speakOfEvents } from "./speaker.js";
import { say } from "../../words/words.js";

/** The mass beside which a card stands; -1 for none. */
let read = -1;

/** Describes what is selected, or else the mass that keys have chosen or that was clicked, or else the body. */
function describe() {
  const mass = [chosenMass(), read].find((each) => each >= 0);
  send({ do: "describe", mass: mass ?? null });
}

function begin() {
  speakOfEvents();
  onMessage("massCard", ({ mass = -1 }) => (read = mass));
  const card = make("section", "softrod-described softrod-floats");
  card.ariaLabel = say("describe-title");
  card.hidden = true;
  const text = make("p", "");
  /** What had the focus before. @type {Element | null} */
  let before = null;
  const close = () => {
    const target = before?.isConnected && before !== document.body ? before : document.querySelector(".softrod-body");
    if (card.contains(document.activeElement) && target instanceof HTMLElement) target.focus();
    card.hidden = true;
  };
  card.append(text, makeClose(close, say("describe-close")));
  overCanvas().append(card);
  // The card is hidden while it is closed, and what is hidden is not read.
  const tell = addTeller();
  onMessage("described", (told) => {
    text.textContent = told.text;
    tell(told.text);
    if (!card.contains(document.activeElement)) before = document.activeElement;
    card.hidden = false;
  });
  window.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || card.hidden || !isFree(event)) return;
    close();
    swallow(event);
  }, true);
}

/** @type {import("../../ui/feature.js").Feature<"describe">} */
export default { commands: { describe }, begin };
