// @ts-check
/** How a live file looks: on white or dark paper, larger for a projector; and the dialog with these and with the keys. */
import { make, makeButton, makeDialog } from "../../../ui/dialog.js";
import { element } from "../../static/parts.js";

/** Factor of all sizes for a projector. */
const LARGER = 1.5;

/** What keys do; some only where the body uses them. @type {[string, string, ("arrows" | "follow")?][]} */
const KEYS = [
  ["drag", "a mass is held while you drag it; several fingers drag several"],
  ["Space", "play or pause"],
  ["N", "one step"],
  ["R", "reset: the body starts again, with the sliders as they are"],
  ["F", "the ringed mass follows the pointer, or stops", "follow"],
  ["↑ ↓ held", "springs get longer or shorter", "arrows"],
  ["→ ← held", "rest angles grow or shrink", "arrows"],
  // ifdef HAS_STEERING
  ["arrows held", "motors turn, forwards and backwards"],
  // endif
  ["D, P", "dark or white; larger, for a projector"],
  ["Tab", "to the body: there arrows choose a mass, Space takes hold of it, arrows move it"],
  ["?", "this help"],
];

/** Whether the file is on dark paper, see `dark.js`. */
export const isDark = () => document.documentElement.hasAttribute("data-dark");

/** @param {{arrows: boolean, follow: boolean}} has what the body can do */
export function addView(has) {
  const root = document.documentElement;
  const darken = () => {
    root.toggleAttribute("data-dark");
    dark.ariaPressed = String(isDark());
  };
  const enlarge = () => {
    const on = larger.ariaPressed !== "true";
    larger.ariaPressed = String(on);
    root.toggleAttribute("data-larger", on);
    root.style.setProperty("--softrod-larger", String(on ? LARGER : 1));
  };
  const { dialog, body } = makeDialog("View and keys", "softrod-view");
  const dark = makeButton("Dark", darken);
  const larger = makeButton("Larger, for a projector", enlarge);
  larger.ariaPressed = "false";
  const row = make("div", "softrod-dialog-line");
  row.append(dark, larger);
  const table = make("dl", "keys");
  for (const [keys, does, needs] of KEYS) {
    if (needs && !has[needs]) continue;
    const line = make("div", "");
    line.append(make("dt", "", keys), make("dd", "", does));
    table.append(line);
  }
  body.append(row, table);
  const show = () => {
    dark.ariaPressed = String(isDark());
    dialog.showModal();
  };
  element("view", HTMLButtonElement).addEventListener("click", show);
  return { dark: darken, larger: enlarge, help: show };
}
