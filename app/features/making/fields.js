// @ts-check
/** What the lesson form is built of. Below each field there is a line that says why its value was refused. */
import { make } from "../../ui/dialog.js";

/** @param {string} name of the field, as in "question.choices[1]" */
export function refusal(name) {
  const line = make("p", "softrod-refused");
  line.dataset.field = name;
  line.setAttribute("role", "alert");
  return line;
}

/** A field with its label and its refusal. @param {string} text @param {HTMLElement} field @param {string} name */
export function labelled(text, field, name) {
  const label = make("label", "", text);
  label.append(field);
  return box("softrod-making-field", label, refusal(name));
}

/** @param {string} name of its class @param {...Node} content */
export function box(name, ...content) {
  const element = make("div", name);
  element.append(...content);
  return element;
}

/** A text input. @param {string} value */
export function makeInput(value = "") {
  const input = make("input", "");
  Object.assign(input, { type: "text", value });
  return input;
}

/** @param {string} value */
export function makeArea(value = "") {
  const area = make("textarea", "");
  Object.assign(area, { rows: 2, value });
  return area;
}

/** @param {string} label */
export function makeSelect(label) {
  const select = make("select", "");
  select.ariaLabel = label;
  return select;
}

/** @param {HTMLSelectElement} select @param {[string, string][]} options values and labels @param {string} value */
export function setOptions(select, options, value) {
  const made = JSON.stringify(options);
  if (select.dataset.made !== made) {
    select.dataset.made = made;
    select.replaceChildren(...options.map(([name, words]) => new Option(words, name)));
  }
  select.value = value;
}

/** @param {string} text @param {string} name that finds it again @param {(on: boolean) => void} changed */
export function makeCheck(text, name, changed) {
  const label = make("label", "softrod-check");
  const check = make("input", "");
  check.type = "checkbox";
  check.dataset.focus = name;
  check.addEventListener("change", () => changed(check.checked));
  label.append(check, text);
  return { check, label };
}
