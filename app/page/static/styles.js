// @ts-check
/** The styles that the server writes, in a place from which folding the panel does not take them. */

const SOURCE = "<style>/* softrod */";
/** @type {HTMLStyleElement | null} */
let style = null;

/** Takes the styles that a message has, if they are softrod's. @param {unknown} content */
export function keepStyles(content) {
  if (typeof content !== "string" || !content.startsWith(SOURCE)) return;
  const template = document.createElement("template");
  template.innerHTML = content;
  if (!style) {
    style = document.createElement("style");
    document.head.append(style);
  }
  style.textContent = [...template.content.children].map((one) => one.textContent).join("\n");
}
