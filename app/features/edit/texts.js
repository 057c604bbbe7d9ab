// @ts-check
/**
 * The form for the scene's name and description, in the place of the description. What a user wrote is shown as text,
 * never as HTML, and stays in the form until the server has accepted it.
 */
import { onMessage, pageState, send } from "../../wire/channel.js";
import { make, makeButton } from "../../ui/dialog.js";
import { say } from "../../words/words.js";

/** Limits of a scene's file, see `Scene`. */
const MAX_NAME = 60;
const MAX_DESCRIPTION = 2000;
/** Milliseconds between two checks whether viser has replaced the description. */
const CHECK_EVERY = 100;
/** Milliseconds within which the button that opened the form gets the focus back, unless something else has it. */
const RETURN_FOCUS_WITHIN = 1000;

/** @template {HTMLInputElement | HTMLTextAreaElement} T @param {string} text @param {T} field @param {number} max letters */
function labelled(text, field, max) {
  const label = make("label", "", text);
  field.maxLength = max;
  label.append(field);
  return label;
}

/** Identifies the open scene. */
const openScene = () => `${pageState().page}.${pageState().scene}`;

class TextsForm {
  /** The scene that the form is for; empty while it is closed. */
  scene = "";
  /** Until when the button may get the focus back: the server replaces it with the text. */
  returnUntil = 0;

  constructor() {
    this.name = make("input", "");
    Object.assign(this.name, { type: "text", required: true });
    this.description = make("textarea", "");
    this.description.rows = 5;
    this.refused = make("p", "softrod-refused");
    this.refused.setAttribute("role", "alert");
    const buttons = make("div", "softrod-texts-buttons");
    buttons.append(make("button", "softrod-button softrod-first", say("edit-texts.done")), makeButton(say("edit-texts.cancel"), () => this.close()));
    this.form = make("form", "softrod-texts");
    this.form.ariaLabel = say("edit-texts");
    this.form.append(labelled(say("edit-texts.name"), this.name, MAX_NAME), labelled(say("edit-texts.description"), this.description, MAX_DESCRIPTION), this.refused, buttons);
    this.form.addEventListener("submit", (event) => {
      event.preventDefault();
      this.refused.textContent = "";
      send({ do: "setTexts", name: this.name.value, description: this.description.value });
    });
    this.form.addEventListener("keydown", (event) => {
      if (event.key === "Enter" && event.target === this.description && (event.ctrlKey || event.metaKey)) this.form.requestSubmit();
      if (event.key !== "Escape") return;
      event.preventDefault(); // the key is for the form, not for the body
      this.close();
    });
  }

  open() {
    this.scene = openScene();
    this.name.value = pageState().title ?? "";
    this.description.value = document.querySelector("#softrod-about > p")?.textContent ?? "";
    this.refused.textContent = "";
    this.place();
    this.name.select();
  }

  close() {
    if (!this.scene) return;
    this.scene = "";
    if (this.form.contains(document.activeElement)) this.returnUntil = performance.now() + RETURN_FOCUS_WITHIN;
    this.form.remove();
    this.place();
  }

  /** Puts the form into its place, which viser may have replaced. */
  place() {
    const place = document.getElementById("softrod-about");
    place?.toggleAttribute("data-open", this.scene !== "");
    if (this.scene && place && this.form.parentElement !== place) place.append(this.form);
    if (!this.scene && performance.now() < this.returnUntil && document.activeElement === document.body) place?.querySelector("button")?.focus();
  }

  /** @param {string} refused why the texts were refused, or empty */
  take(refused) {
    this.refused.textContent = refused;
    if (refused) this.name.focus();
    else this.close();
  }
}

/** Listens to the button below the description. */
export function addTexts() {
  const texts = new TextsForm();
  document.addEventListener("click", ({ target }) => {
    if (target instanceof Element && target.closest(".softrod-edit-texts")) texts.open();
  });
  onMessage("textsTaken", ({ refused }) => texts.take(refused));
  onMessage("pageState", () => texts.scene && texts.scene !== openScene() && texts.close());
  setInterval(() => texts.place(), CHECK_EVERY);
}
