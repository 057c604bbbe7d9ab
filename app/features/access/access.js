// @ts-check
/** The page Access of the View menu: a dialog of settings that this device keeps. */
import { access, apply, isStill, onCalm, setAccess } from "../../ui/access.js";
import { make, makeDialog } from "../../ui/dialog.js";
import { newId } from "../../ui/gui/control.js";
import { storeCookie } from "../../ui/kept/storage.js";
import { isProjector, toggleProjector } from "../../ui/looks.js";
import { send } from "../../wire/channel.js";
import { language, languages, say } from "../../words/words.js";

const LANGUAGE = "softrod-lang";

/** Speaks another language from now on: the page is loaded anew, and gets its body back. @param {string} tag */
function speak(tag) {
  if (tag === language) return;
  const isKept = storeCookie(LANGUAGE, tag);
  const address = new URL(location.href);
  address.searchParams.delete("lang");
  // A browser that keeps no cookies is asked in the address.
  if (!isKept) address.searchParams.set("lang", tag);
  if (address.href === location.href) location.reload();
  else location.replace(address);
}

/** Has a screen reader pass something by. @template {HTMLElement} E @param {E} element */
function hide(element) {
  element.ariaHidden = "true";
  return element;
}

/**
 * A setting with its name, and below it what it does. A screen reader has both of the setting itself, and so not once more beside
 * it.
 *
 * @param {HTMLElement} control @param {string} name @param {string} hint
 */
function row(control, name, hint) {
  const label = make("label", "softrod-access-row");
  label.append(hide(make("span", "softrod-access-name", name)), control);
  const about = hide(make("p", "softrod-access-hint", hint));
  control.ariaLabel = name;
  control.setAttribute("aria-describedby", (about.id = newId()));
  const all = make("div", "");
  all.append(label, about);
  return all;
}

/** @template {string} T @param {[T, string][]} choices @param {T} chosen @param {(value: T) => void} choose */
function list(choices, chosen, choose) {
  const select = make("select", "softrod-access-list");
  for (const [value, text] of choices) {
    const option = make("option", "", text);
    option.value = value;
    option.selected = value === chosen;
    select.append(option);
  }
  select.addEventListener("change", () => choose(/** @type {T} */ (select.value)));
  return select;
}

/** @param {boolean} on @param {(on: boolean) => void} turn */
function toggle(on, turn) {
  const box = make("input", "");
  box.type = "checkbox";
  box.checked = on;
  box.addEventListener("change", () => turn(box.checked));
  return box;
}

function show() {
  const { dialog, body } = makeDialog(say("access-title"), "softrod-access");
  const tongues = list(languages().map(({ tag, name }) => [tag, name]), language, speak);
  for (const option of tongues.options) option.lang = option.value;
  const letters = list(
    [
      ["always", say("access-letters.always")],
      ["body", say("access-letters.body")],
      ["never", say("access-letters.never")],
    ],
    access().letters,
    (value) => setAccess({ letters: value }),
  );
  body.append(
    row(tongues, say("access-language"), say("access-language.hint")),
    row(letters, say("access-letters"), say("access-letters.hint")),
    row(toggle(access().taps, (taps) => setAccess({ taps })), say("access-taps"), say("access-taps.hint")),
    row(toggle(isProjector(), toggleProjector), say("access-larger"), say("access-larger.hint")),
    row(toggle(access().contrast, (contrast) => setAccess({ contrast })), say("access-contrast"), say("access-contrast.hint")),
    row(toggle(access().still, (still) => (setAccess({ still }), tellStill())), say("access-still"), say("access-still.hint")),
    row(toggle(access().sound, (sound) => setAccess({ sound })), say("access-sound"), say("access-sound.hint")),
    row(toggle(access().events, (events) => setAccess({ events })), say("access-events"), say("access-events.hint")),
    make("p", "softrod-access-hint", say("access-kept")),
  );
  dialog.addEventListener("close", () => dialog.remove());
  dialog.showModal();
}

/** The server reads it before it shows a page's first body, which then stands. */
const keepStill = () => storeCookie("softrod-still", String(Number(isStill())));

// Before the page connects.
keepStill();

/** Tells the server whether bodies that are opened from now on stand. */
function tellStill() {
  keepStill();
  send({ do: "still", on: isStill() });
}

function begin() {
  apply();
  onCalm(tellStill);
}

/** @type {import("../../ui/feature.js").Feature<"access">} */
export default { commands: { access: show }, begin };
