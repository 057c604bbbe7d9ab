// @ts-check
/** The part of the teacher's page that takes answers which pupils gave in files: as files, or by their QR codes. */
import { onMessage, send } from "../../wire/channel.js";
import { make, makeButton } from "../../ui/dialog.js";

/** Letters of a file that the server takes, at most. */
const MOST = 20_000;
/** Sentences that are shown. */
const SHOWN = 40;

/** What became of what was brought, the last first. @type {{told: string, refused: boolean}[]} */
let results = [];
/** What is typed, by a scanner or by hand. */
let typed = "";

/** @param {string} told @param {boolean} refused */
const note = (told, refused) => (results = [{ told, refused }, ...results].slice(0, SHOWN));

/** Begins to listen. @param {() => void} changed */
export function hearBrought(changed) {
  onMessage("brought", ({ told, refused }) => {
    note(told, refused);
    changed();
  });
}

/** How often anything became of something. */
export const broughtSoFar = () => results.map(({ told }) => told).join();

/** @param {string} text */
function bring(text) {
  if (text.length > MOST) note("That file is too long for answers to a lesson.", true);
  else if (text) send({ do: "bring", text });
}

/** What takes them. @param {() => void} changed */
export function brought(changed) {
  const box = make("div", "softrod-brought");
  box.append(make("p", "softrod-quiet", "From pupils who had the lesson as a file: they count as late answers, each once."));
  const save = makeButton("Save the lesson as a file for them", () => send({ do: "arrange", what: "lessonFile" }), "softrod-small");
  save.dataset.focus = "lessonFile";
  const files = make("label", "", "Their files ");
  const pick = make("input", "");
  Object.assign(pick, { type: "file", accept: ".json,application/json", multiple: true });
  pick.dataset.focus = "broughtFiles";
  pick.addEventListener("change", async () => {
    const chosen = [...(pick.files ?? [])];
    pick.value = "";
    for (const file of chosen) bring(file.size > 4 * MOST ? " ".repeat(MOST + 1) : (await file.text()).trim());
    changed();
  });
  files.append(pick);
  const form = make("form", "");
  const label = make("label", "", "Or the text of their QR codes, from a scanner or pasted ");
  const input = make("input", "");
  Object.assign(input, { value: typed, autocomplete: "off", spellcheck: false });
  input.dataset.focus = "broughtText";
  input.addEventListener("input", () => (typed = input.value));
  label.append(input);
  form.append(label, make("button", "softrod-small", "Take it"));
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    for (const text of typed.split(/\s+/)) bring(text);
    input.value = typed = "";
  });
  const list = make("ul", "");
  list.setAttribute("role", "status");
  for (const { told, refused } of results) list.append(make("li", refused ? "softrod-warning" : "", told));
  box.append(save, files, form, list);
  return box;
}
