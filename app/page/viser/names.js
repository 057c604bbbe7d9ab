// @ts-check
/** Names for what viser's panel leaves without: sliders, their boxes and the buttons that are only an icon. */

/** @type {Record<string, string>} */
const ICONS = { "tabler-icon-list-search": "All commands" };

/** The text of a control's row. @param {Element} element */
const rowName = (element) => element.closest(".mantine-Flex-root:has(> div > p > label)")?.querySelector("label")?.innerText ?? "";

function name() {
  for (const thumb of document.querySelectorAll(".mantine-Slider-thumb")) {
    const label = rowName(thumb);
    if (label && thumb.ariaLabel !== label) thumb.ariaLabel = label;
    // A logarithmic slider is over powers of ten: the box below it has the value.
    const row = thumb.closest(".mantine-Flex-root:has(> div > p > label)")?.parentElement;
    const box = row?.nextElementSibling?.querySelector("input");
    if (box instanceof HTMLInputElement && label) {
      if (thumb.ariaValueText !== box.value) thumb.ariaValueText = box.value;
      const bubble = thumb.querySelector(".mantine-Slider-label");
      if (bubble && bubble.textContent !== box.value) bubble.textContent = box.value;
      if (box.ariaLabel !== label) box.ariaLabel = label;
    }
  }
  for (const [icon, text] of Object.entries(ICONS)) {
    const button = document.querySelector(`button:has(> span > .${icon}), button:has(.${icon})`);
    if (button && !button.ariaLabel) button.ariaLabel = text;
  }
  for (const input of document.querySelectorAll(".mantine-Flex-root input:not([type=hidden]):not([aria-label])")) {
    const label = rowName(input);
    if (label) input.ariaLabel = label;
  }
}

/** Begins to name what comes into the page. */
export function nameControls() {
  let asked = false;
  const later = () => {
    asked = false;
    name();
  };
  new MutationObserver(() => {
    if (!asked) requestAnimationFrame(later);
    asked = true;
  }).observe(document.getElementById("root") ?? document.body, {
    childList: true, subtree: true, attributes: true, attributeFilter: ["aria-valuenow", "value"],
  });
}
