// @ts-check
/** The part of the teacher's page that takes answers which pupils gave in files: as files, or by their QR codes. */
import { onMessage, send } from "../../wire/channel.js";
import { make } from "../../ui/dialog.js";
import { say } from "../../words/words.js";
import { box, button, typedLine } from "./elements.js";

/** Letters of a file that the server takes. */
const MAX_LENGTH = 20_000;
/** Sentences that are shown. */
const MAX_RESULTS = 40;

/** What became of each, the last first. @type {{told: string, refused: boolean}[]} */
let results = [];
/** What is typed, by a scanner or by hand. */
let typed = "";

/** @param {string} told @param {boolean} refused */
const note = (told, refused) => (results = [{ told, refused }, ...results].slice(0, MAX_RESULTS));

/** Begins to listen. @param {() => void} changed */
export function hearImports(changed) {
  onMessage("brought", ({ told, refused }) => {
    note(told, refused);
    changed();
  });
}

/** What became of all so far. */
export const importResults = () => results.map(({ told }) => told);

/** @param {string} text */
function offer(text) {
  if (text.length > MAX_LENGTH) note(say("desk-file-too-long"), true);
  else if (text) send({ do: "bring", text });
}

/** The part. @param {() => void} changed */
export function imports(changed) {
  const files = Object.assign(make("input", ""), { type: "file", accept: ".json,application/json", multiple: true });
  files.dataset.focus = "broughtFiles";
  files.addEventListener("change", async () => {
    const chosen = [...(files.files ?? [])];
    files.value = "";
    for (const file of chosen) offer(file.size > 4 * MAX_LENGTH ? " ".repeat(MAX_LENGTH + 1) : (await file.text()).trim());
    changed();
  });
  /** @param {string} text */
  const take = (text) => {
    for (const one of text.split(/\s+/)) offer(one);
    codes.reset();
    typed = "";
  };
  const codes = typedLine(say("desk-codes"), { spellcheck: false }, [say("desk-take")], take, "broughtText");
  const input = /** @type {HTMLInputElement} */ (codes.querySelector("input"));
  input.value = typed;
  input.addEventListener("input", () => (typed = input.value));
  const list = box("ul", "", ...results.map(({ told, refused }) => make("li", refused ? "softrod-warning" : "", told)));
  list.setAttribute("role", "status");
  return box(
    "div",
    "softrod-brought",
    make("p", "softrod-quiet", say("desk-from-files")),
    button(say("desk-lesson-file"), () => send({ do: "arrange", what: "lessonFile" }), { focus: "lessonFile" }),
    box("label", "", `${say("desk-their-files")} `, files),
    codes,
    list,
  );
}
