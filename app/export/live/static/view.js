// @ts-check
/** How a live file looks: on white or dark paper, larger for a projector; and the dialog with these and with the keys. */
import { access, apply, setAccess } from "../../../ui/access.js";
import { make, makeButton, makeDialog } from "../../../ui/dialog.js";
import { say } from "../../../words/words.js";
import { element } from "../../static/parts.js";

/** Factor of all sizes for a projector. */
const LARGER = 1.5;

/**
 * Keys, and what they do; some only where the body uses them.
 *
 * @type {[string, string, ("arrows" | "follow")?][]}
 */
const KEYS = [
  [say("live-keys-drag.keys"), say("live-keys-drag")],
  [say("live-keys-play.keys"), say("live-keys-play")],
  ["N", say("live-keys-step")],
  ["R", say("live-keys-reset")],
  ["F", say("live-keys-follow"), "follow"],
  [say("live-keys-longer.keys"), say("live-keys-longer"), "arrows"],
  [say("live-keys-bent.keys"), say("live-keys-bent"), "arrows"],
  // ifdef HAS_STEERING
  [say("live-keys-motors.keys"), say("live-keys-motors")],
  // endif
  ["D, Z", say("live-keys-dark")],
  [say("live-keys-body.keys"), say("live-keys-body")],
  ["?", say("live-keys-help")],
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
  const { dialog, body } = makeDialog(say("live-view"), "softrod-view");
  const dark = makeButton(say("live-dark"), darken);
  const larger = makeButton(say("live-larger"), enlarge);
  larger.ariaPressed = "false";
  const row = make("div", "softrod-dialog-line");
  row.append(dark, larger);
  /** A switch that this device keeps. @param {string} name @param {() => boolean} isOn @param {(on: boolean) => void} turn */
  const addSwitch = (name, isOn, turn) => {
    const button = makeButton(name, () => {
      turn(!isOn());
      button.ariaPressed = String(isOn());
    });
    button.ariaPressed = String(isOn());
    row.append(button);
  };
  addSwitch(say("access-contrast"), () => access().contrast, (contrast) => setAccess({ contrast }));
  addSwitch(say("access-still"), () => access().still, (still) => setAccess({ still }));
  addSwitch(say("access-letters"), () => access().letters === "always", (on) => setAccess({ letters: on ? "always" : "never" }));
  apply();
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
