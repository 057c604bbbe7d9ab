// @ts-check
/** The description of the body, or of a part of it: a card over the canvas. Esc closes it. */
import { chosenMass } from "../../stage/overlay.js";
import { onMessage, send } from "../../wire/channel.js";
import { makeDescribed } from "../../ui/described.js";
import { isFree, swallow } from "../../ui/hands/keys.js";
import { speakOfEvents } from "./speaker.js";

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
  const described = makeDescribed(".softrod-body");
  onMessage("described", ({ text }) => described.tell(text));
  window.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || !described.isOpen || !isFree(event)) return;
    described.close();
    swallow(event);
  }, true);
}

/** @type {import("../../ui/feature.js").Feature<"describe">} */
export default { commands: { describe }, begin };
