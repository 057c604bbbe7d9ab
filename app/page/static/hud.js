// @ts-check
/** The head-up display over the body: what the server writes, in an element that the panel cannot take away. */

const SOURCE = '<div id="softrod-hud"';
/** @type {HTMLElement | null} */
let hud = null;

/** Shows what a message has for the display, if it is for it. @param {unknown} content */
export function showHud(content) {
  if (typeof content !== "string" || !content.startsWith(SOURCE)) return;
  if (!hud) {
    hud = document.createElement("div");
    hud.className = "softrod-hud";
    document.body.append(hud);
  }
  const template = document.createElement("template");
  template.innerHTML = content;
  hud.replaceChildren(...(template.content.firstElementChild?.childNodes ?? []));
}
