// @ts-check
/**
 * The form for the scene's name and description, in the place where the description stands. What a user wrote is text
 * here, never HTML. It stays until the server has taken it.
 */
import { onMessage, pageState, send } from "../../wire/channel.js";
import { make, makeButton } from "../../ui/dialog.js";

/** What a scene's file may have, see `Scene`. */
const LONGEST_NAME = 60;
const LONGEST_DESCRIPTION = 2000;
/** Milliseconds between two looks whether viser has made the place of the form anew. */
const LOOK_EVERY = 100;
/** Milliseconds for which the button gets the focus back, if nothing else took it. */
const GIVES_BACK = 1000;

/** @param {string} label @param {HTMLInputElement | HTMLTextAreaElement} field @param {number} longest */
function labelled(label, field, longest) {
  const row = make("label", "", label);
  field.maxLength = longest;
  row.append(field);
  return row;
}

/** Which scene is open, as the server counts them. */
const opening = () => `${pageState().page}.${pageState().scene}`;

/** Begins to listen to the button below the description. */
export function addTexts() {
  const [name, description, refused] = [make("input", ""), make("textarea", ""), make("p", "softrod-refused")];
  name.type = "text";
  name.required = true;
  description.rows = 5;
  refused.setAttribute("role", "alert");
  const buttons = make("div", "softrod-texts-buttons");
  const done = make("button", "softrod-button softrod-first", "Done");
  buttons.append(done, makeButton("Cancel", () => close()));
  const form = make("form", "softrod-texts");
  form.ariaLabel = "Name and description of this scene";
  form.append(
    labelled("Name", name, LONGEST_NAME),
    labelled("What it shows", description, LONGEST_DESCRIPTION),
    refused,
    buttons,
  );
  /** The scene that the form is for; empty while it is closed. */
  let of = "";
  /** Until when the button is to have the focus again, which the server makes anew with the text. */
  let back = 0;

  const close = () => {
    if (!of) return;
    of = "";
    if (form.contains(document.activeElement)) back = performance.now() + GIVES_BACK;
    form.remove();
    look();
  };
  const look = () => {
    const place = document.getElementById("softrod-about");
    place?.toggleAttribute("data-open", of !== "");
    if (of && place && form.parentElement !== place) place.append(form);
    if (!of && performance.now() < back && document.activeElement === document.body) place?.querySelector("button")?.focus();
  };
  const open = () => {
    of = opening();
    name.value = pageState().title ?? "";
    description.value = document.querySelector("#softrod-about > p")?.textContent ?? "";
    refused.textContent = "";
    look();
    name.select();
  };

  document.addEventListener("click", ({ target }) => {
    if (target instanceof Element && target.closest(".softrod-edit-texts")) open();
  });
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    refused.textContent = "";
    send({ do: "setTexts", name: name.value, description: description.value });
  });
  form.addEventListener("keydown", (event) => {
    if (event.key === "Enter" && event.target === description && (event.ctrlKey || event.metaKey)) form.requestSubmit();
    if (event.key !== "Escape") return;
    // It is the form that is left, and the body runs on.
    event.preventDefault();
    close();
  });
  onMessage("textsTaken", (letter) => {
    refused.textContent = letter.refused;
    if (letter.refused) name.focus();
    else close();
  });
  onMessage("pageState", () => of && of !== opening() && close());
  setInterval(look, LOOK_EVERY);
}
