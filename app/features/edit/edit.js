// @ts-check
/** The tools that build and change the body. */
import { listenToClipboard } from "./clipboard.js";
import { raiseCross } from "./cross.js";
import { editing, setEditing } from "./editing.js";
import { listenToEdits } from "./gestures.js";
import { listenToEditKeys } from "./keys.js";
import { addEditMarks } from "./marks.js";
import { addEditStrip } from "./strip.js";
import { addTexts } from "./texts.js";
import { addTracing } from "./tracing.js";

function begin() {
  const tracing = addTracing();
  listenToEditKeys();
  listenToEdits();
  listenToClipboard();
  addEditMarks();
  addEditStrip(tracing);
  addTexts();
}

/** @type {import("../../ui/feature.js").Feature<"edit">} */
export default { commands: { edit: () => setEditing(!editing.on), cross: raiseCross }, begin };
