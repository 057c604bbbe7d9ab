// @ts-check
/**
 * Dialogs that the script makes itself. The browser keeps the focus in them, gives it back afterwards, and closes
 * them with Esc.
 */

/**
 * Makes an element.
 *
 * @template {keyof HTMLElementTagNameMap} K
 * @param {K} kind
 * @param {string} name of its class, or empty
 * @param {string} [text] shown as it is, never as HTML
 * @returns {HTMLElementTagNameMap[K]}
 */
export function make(kind, name, text = "") {
  const element = document.createElement(kind);
  if (name) element.className = name;
  if (text) element.textContent = text;
  return element;
}

/** @param {string} text @param {() => void} press @param {string} [name] */
export function makeButton(text, press, name = "softrod-button") {
  const button = make("button", name, text);
  button.type = "button";
  button.addEventListener("click", press);
  return button;
}

/**
 * A dialog with a title and a button that closes it.
 *
 * @param {string} title
 * @param {string} name of its class
 */
export function makeDialog(title, name) {
  const dialog = make("dialog", `softrod-dialog ${name}`);
  const head = make("div", "softrod-dialog-head");
  const heading = make("h2", "", title);
  heading.id = `${name}-title`;
  dialog.setAttribute("aria-labelledby", heading.id);
  const close = makeButton("×", () => dialog.close(), "softrod-close");
  close.ariaLabel = "Close";
  head.append(heading, close);
  const body = make("div", "softrod-dialog-body");
  dialog.append(head, body);
  // A press beside it closes it, but not one that began inside, as when text is marked.
  let outside = false;
  dialog.addEventListener("pointerdown", ({ target }) => (outside = target === dialog));
  dialog.addEventListener("click", ({ target }) => outside && target === dialog && dialog.close());
  document.body.append(dialog);
  return { dialog, head, body };
}
