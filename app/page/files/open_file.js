// @ts-check
/** Opens a file of this computer, a scene or a log: it is sent to the server, which reads it. */
import { send } from "../../wire/channel.js";
import { make } from "../looks/dialog.js";
import { OPEN } from "../viser/widgets.js";
import { packed } from "./keep.js";
import { sendParts } from "./links.js";

/** Bytes of a file at most: more than any scene or log may have. */
const MOST = 8_000_000;

/** Begins to listen to the button of the Share tab. */
export function listenToOpenFile() {
  const input = make("input", "");
  Object.assign(input, { type: "file", name: "file", accept: "application/json,.json,.jsonl", hidden: true });
  document.body.append(input);
  document.addEventListener("click", ({ target }) => {
    if (target instanceof Element && target.closest("button")?.querySelector(OPEN)) input.click();
  });
  input.addEventListener("change", async () => {
    const [file] = input.files ?? [];
    input.value = "";
    if (!file) return;
    if (file.size > MOST) send({ do: "unsent", what: "file" });
    else sendParts("file", `${encodeURIComponent(file.name)}:${await packed(file)}`);
  });
}
