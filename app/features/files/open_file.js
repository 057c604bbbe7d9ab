// @ts-check
/**
 * Opens a file of this computer, a scene, a log or a table of what was measured, which is chosen or dropped on the
 * page: it is sent to the server, which reads it.
 */
import { send } from "../../wire/channel.js";
import { make } from "../../ui/dialog.js";
import { packed } from "../../ui/kept/keep.js";
import { sendParts } from "../../ui/kept/links.js";

/** Bytes of a file, at most: more than any scene or log may have. */
const MAX_BYTES = 8_000_000;
/** The icon of the button that opens a file. */
const OPEN = ".icon-tabler-upload";
const KINDS = "application/json,.json,.jsonl,.csv,.tsv,.txt,.dat";

/** @param {File | undefined} file */
async function open(file) {
  if (!file) return;
  if (file.size > MAX_BYTES) send({ do: "unsent", what: "file" });
  else sendParts("file", `${encodeURIComponent(file.name)}:${await packed(file)}`);
}

/** Begins to listen to the button of the Share tab, and to files that are dropped. */
export function listenToOpenFile() {
  const input = make("input", "");
  Object.assign(input, { type: "file", name: "file", accept: KINDS, hidden: true });
  document.body.append(input);
  document.addEventListener("click", ({ target }) => {
    if (target instanceof Element && target.closest("button")?.querySelector(OPEN)) input.click();
  });
  input.addEventListener("change", () => {
    const [file] = input.files ?? [];
    input.value = "";
    open(file);
  });
  /** Whether files are dragged, and not a piece of the page. @param {DragEvent} event */
  const hasFiles = (event) => event.dataTransfer?.types.includes("Files") ?? false;
  document.addEventListener("dragover", (event) => {
    if (hasFiles(event)) event.preventDefault();
  });
  document.addEventListener("drop", (event) => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    open(event.dataTransfer?.files[0]);
  });
}
