// @ts-check
/** Closes viser's dialogs with Esc, by their last button, which only closes. */
import { swallow } from "../hands/keys.js";
import { DIALOG } from "./widgets.js";

/** Begins to listen; call it before the other keys, which ignore an open dialog. */
export function closeDialogsByKey() {
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
