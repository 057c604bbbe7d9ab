// @ts-check
/** Dialogs that the server opens. Their last button only closes, and so do Esc and a press beside them. */
import { takeOver } from "../../wire/channel.js";
import { make, makeClose } from "../dialog.js";
import { newId, Place } from "./control.js";

/** The open dialogs, by their ids. @type {Map<string, HTMLDialogElement>} */
const open = new Map();

/** Closes the dialogs of a connection that is over. */
export function closeDialogs() {
  for (const dialog of open.values()) dialog.remove();
  open.clear();
}

/**
 * Begins to show them.
 *
 * @param {Map<string, Place>} places where controls are, by their ids
 */
export function takeDialogs(places) {
  takeOver("GuiModalMessage", ({ uuid, title }) => {
    const dialog = make("dialog", "softrod-dialog softrod-asked");
    const heading = make("h2", "", title);
    heading.id = newId();
    dialog.setAttribute("aria-labelledby", heading.id);
    const head = make("div", "softrod-dialog-head");
    const body = make("div", "softrod-dialog-body softrod-controls");
    const close = () => [...body.querySelectorAll("button")].at(-1)?.click();
    head.append(heading, makeClose(close));
    dialog.append(head, body);
    dialog.addEventListener("cancel", (event) => {
      event.preventDefault();
      close();
    });
    let outside = false;
    dialog.addEventListener("pointerdown", ({ target }) => (outside = target === dialog));
    dialog.addEventListener("click", ({ target }) => outside && target === dialog && close());
    document.body.append(dialog);
    open.set(uuid, dialog);
    places.set(uuid, new Place(body));
    dialog.showModal();
  });
  takeOver("GuiCloseModalMessage", ({ uuid }) => {
    const dialog = open.get(uuid);
    open.delete(uuid);
    places.delete(uuid);
    dialog?.close(); // gives the focus back
    dialog?.remove();
  });
}
