// @ts-check
/** What the form of a lesson is made of: fields with a sentence below each that says why it was refused. */
import { make } from "../../ui/dialog.js";

/** @param {string} name of the field, as in "question.choices[1]" */
export function refusal(name) {
  const line = make("p", "softrod-refused");
  line.dataset.field = name;
  line.setAttribute("role", "alert");
  return line;
}

/** @param {string} text @param {HTMLElement} field @param {string} name */
export function labelled(text, field, name) {
  const box = make("div", "softrod-making-field");
  const label = make("label", "", text);
  label.append(field);
  box.append(label, refusal(name));
  return box;
}

/** A list to choose from. @param {string} label */
export function makeSelect(label) {
  const select = make("select", "");
  select.ariaLabel = label;
  return select;
}

/** @param {HTMLSelectElement} select @param {[string, string][]} options names and words @param {string} value */
export function setOptions(select, options, value) {
  const made = JSON.stringify(options);
  if (select.dataset.made !== made) {
    select.dataset.made = made;
    select.replaceChildren(...options.map(([name, words]) => new Option(words, name)));
  }
  select.value = value;
}

/** @param {string} text @param {string} name @param {() => void} changed */
export function makeCheck(text, name, changed) {
  const label = make("label", "softrod-check");
  const box = make("input", "");
  box.type = "checkbox";
  box.dataset.focus = name;
  box.addEventListener("change", changed);
  label.append(box, text);
  return { box, label };
}
