// @ts-check
/** The description of the body, or of the mass that keys have chosen: `D`, and with Shift the body. Esc closes it. */
import { isMeantElsewhere } from "../../ui/access.js";
import { makeDescribed } from "../../ui/described.js";
import { onMessage, send } from "../../wire/channel.js";

/** Begins to listen. @param {() => number} chosen the mass that keys have chosen, or -1 */
export function listenForDescription(chosen) {
  const described = makeDescribed("#canvas");
  onMessage("described", ({ text }) => described.tell(text));
  document.addEventListener("keydown", (event) => {
    const { target, key, ctrlKey, metaKey, altKey, shiftKey, repeat } = event;
    if (key === "Escape" && described.isOpen && !document.querySelector("dialog[open]")) described.close();
    if (key.toLowerCase() !== "d" || ctrlKey || metaKey || altKey || repeat || isMeantElsewhere(event)) return;
    if (target instanceof Element && target.closest("textarea, select, input:not([type=range]), dialog[open]")) return;
    event.preventDefault();
    const mass = shiftKey ? -1 : chosen();
    send({ do: "describe", mass: mass >= 0 ? mass : null });
  });
}
