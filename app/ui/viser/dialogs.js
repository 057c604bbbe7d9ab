// @ts-check
/** Esc closes a question or the help of viser's, by the button that does nothing else: the last one. */
import { swallow } from "../hands/keys.js";
import { DIALOG } from "./widgets.js";

/** Begins to listen; before the keys are listened to, which leave an open dialog alone. */
export function mindDialogs() {
  window.addEventListener(
    "keydown",
    (event) => {
      if (event.key !== "Escape") return;
      const buttons = document.querySelectorAll(`${DIALOG} button`);
      const last = buttons[buttons.length - 1];
      if (!(last instanceof HTMLElement)) return;
      swallow(event);
      last.click();
    },
    true,
  );
}
