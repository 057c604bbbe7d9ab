// @ts-check
/** Number boxes: a decimal comma is a decimal point, and a box that is left empty shows its number again. */

/** What each box last had. @type {WeakMap<HTMLInputElement, string>} */
const numbers = new WeakMap();

/** @param {EventTarget | null} target @returns {HTMLInputElement | null} */
const boxOf = (target) =>
  target instanceof HTMLInputElement && target.closest(".mantine-NumberInput-root") ? target : null;

/** A text that was typed or pasted, with its decimal comma as a point; commas that part thousands are left. @param {string} text */
export const withPoint = (text) =>
  text.includes(".") || text.indexOf(",") !== text.lastIndexOf(",") ? text : text.replace(",", ".");

/** @param {HTMLInputElement} box */
const note = (box) => {
  if (box.value !== "" && Number.isFinite(Number(box.value))) numbers.set(box, box.value);
};

/** Begins to listen. */
export function mindNumbers() {
  document.addEventListener(
    "beforeinput",
    (event) => {
      const box = boxOf(event.target);
      const text = event.data ?? event.dataTransfer?.getData("text/plain") ?? "";
      if (!box || event.isComposing || withPoint(text) === text) return;
      event.preventDefault();
      box.setRangeText(withPoint(text), box.selectionStart ?? 0, box.selectionEnd ?? 0, "end");
      box.dispatchEvent(new InputEvent("input", { bubbles: true, inputType: event.inputType }));
    },
    true,
  );
  document.addEventListener("focusin", ({ target }) => {
    const box = boxOf(target);
    if (box) note(box);
  });
  document.addEventListener("input", ({ target }) => {
    const box = boxOf(target);
    if (box) note(box);
  });
  document.addEventListener("focusout", ({ target }) => {
    const box = boxOf(target);
    const before = box && numbers.get(box);
    if (!box || before === undefined || (box.value !== "" && Number.isFinite(Number(box.value)))) return;
    // As if it had been typed; React hears of nothing else.
    Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, "value")?.set?.call(box, before);
    box.dispatchEvent(new Event("input", { bubbles: true }));
  });
}
