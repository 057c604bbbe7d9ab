// @ts-check
/** The description of the body, or of the mass that keys have chosen: `D`, and with Shift the body, for a screen reader. */
import { isMeantElsewhere } from "../../ui/access.js";
import { addTeller } from "../../ui/dialog.js";
import { onMessage, send } from "../../wire/channel.js";

/** Begins to listen. @param {() => number} chosen the mass that keys have chosen, or -1 */
export function listenForDescription(chosen) {
  const tell = addTeller();
  onMessage("described", ({ text }) => tell(text));
  document.addEventListener("keydown", (event) => {
    const { target, key, ctrlKey, metaKey, altKey, shiftKey, repeat } = event;
    if (key.toLowerCase() !== "d" || ctrlKey || metaKey || altKey || repeat || isMeantElsewhere(event)) return;
    if (target instanceof Element && target.closest("textarea, select, input:not([type=range]), dialog[open]")) return;
    event.preventDefault();
    const mass = shiftKey ? -1 : chosen();
    send({ do: "describe", mass: mass >= 0 ? mass : null });
  });
}
