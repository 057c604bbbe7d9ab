// @ts-check
/** The bar of a page of a gallery: the page as a file of its own, and a key that leads back. */
import { element } from "../../export/static/parts.js";
import { isMeantElsewhere } from "../../ui/access.js";
import { download } from "../../ui/download.js";
import { keepGallery } from "./keep.js";

/** The page as it came, before its script changes anything. */
const whole = /** @type {HTMLElement} */ (document.documentElement.cloneNode(true));

/** Save the page without its bar, which would lead nowhere from a file that is alone. @param {string} name */
function save(name) {
  whole.querySelector("#bar")?.remove();
  delete whole.dataset.dark;
  download(new Blob([`<!doctype html>\n${whole.outerHTML}\n`], { type: "text/html" }), name);
}

function addBar() {
  const button = element("save", HTMLButtonElement);
  button.addEventListener("click", () => save(button.dataset.file ?? ""));
  document.addEventListener("keydown", (event) => {
    const { key, target, ctrlKey, metaKey, altKey } = event;
    const writes = target instanceof Element && target.matches("input, textarea, select");
    if (key.toLowerCase() !== "o" || ctrlKey || metaKey || altKey || writes || isMeantElsewhere(event)) return;
    document.querySelector(/** @type {"a"} */ ("#bar .all"))?.click();
  });
}

// A page that was saved has none.
if (document.getElementById("bar")) {
  addBar();
  keepGallery();
}
