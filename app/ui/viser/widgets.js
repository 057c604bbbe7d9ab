// @ts-check
/**
 * The widgets of viser's panel: selectors for them, labels that viser leaves out, and marks for the styles. Nothing outside
 * of this folder depends on how viser and its libraries call them.
 */
import { viserCanvas } from "./viser.js";

export const NUMBER_BOX = ".mantine-NumberInput-root";
export const SLIDER = ".mantine-Slider-root";
export const DIALOG = '.mantine-Modal-content[role="dialog"]';
export const PANEL = ".mantine-Paper-root";
export const CHARTS = ".uplot canvas";
/** A row of the panel, with a label and a control. */
const ROW = ".mantine-Flex-root:has(> div > p > label)";
/** The icon of the button that opens a file. */
export const OPEN = ".icon-tabler-upload";
/** Labels of buttons that are only an icon, by the class of the icon. @type {Record<string, string>} */
const ICONS = { "tabler-icon-list-search": "All commands" };
/** The icon of the button "Open anew" beside the title of the scene. */
const REOPEN = ".icon-tabler-refresh";
/** The icon of viser's tools for developers, which would change settings of softrod. */
const DEVELOPERS = ".tabler-icon-adjustments";

/** True if the page is dark. */
export const isDark = () => document.documentElement.dataset.mantineColorScheme === "dark";

/** A tab of the panel by its id, since its words may be translated. @param {string} id */
export const tabOf = (id) => document.querySelector(`[data-dock-tab="${id}"], [role=tab][id$="-tab-${id}"]`);

/** Marks the element whose width viser fits to the room beside the panel, for the styles. */
export const markCanvas = () => mark(viserCanvas()?.closest("[data-dock-root] > div"), "canvas");

/** The panel at a side of the canvas. @param {string} side */
export const panelAt = (side) => document.querySelector(`[data-dock-region="${side}"]`);

/** The text of a control's row. @param {Element} element */
const rowName = (element) => element.closest(ROW)?.querySelector("label")?.innerText ?? "";

/**
 * Marks an element by an attribute. A selector with `:has` would make the browser search the whole page whenever a text in
 * it changes, which took half of the page's time.
 *
 * @param {Element | null | undefined} element @param {string} mark
 */
function mark(element, mark) {
  if (element && element.getAttribute("data-softrod") !== mark) element.setAttribute("data-softrod", mark);
}

/** Labels a slider and the number box below it, whose text it shows: its own value may be a power of ten. @param {Element} slider */
function pair(slider) {
  const label = rowName(slider);
  const thumb = slider.querySelector(".mantine-Slider-thumb");
  if (!label || !thumb) return;
  if (thumb.ariaLabel !== label) thumb.ariaLabel = label;
  const root = slider.closest(ROW)?.parentElement?.nextElementSibling?.querySelector(NUMBER_BOX);
  const box = root?.querySelector("input");
  if (!root || !box || rowName(root)) return;
  mark(slider.parentElement, "slider");
  mark(root, "number");
  if (thumb.ariaValueText !== box.value) thumb.ariaValueText = box.value;
  const bubble = thumb.querySelector(".mantine-Slider-label");
  if (bubble && bubble.textContent !== box.value) bubble.textContent = box.value;
  if (box.ariaLabel !== label) box.ariaLabel = label;
}

function look() {
  document.querySelectorAll(SLIDER).forEach(pair);
  for (const [icon, text] of Object.entries(ICONS)) {
    const button = document.querySelector(`.${icon}`)?.closest("button");
    if (button && !button.ariaLabel) button.ariaLabel = text;
  }
  for (const input of document.querySelectorAll(".mantine-Flex-root input:not([type=hidden]):not([aria-label])")) {
    const label = rowName(input);
    if (label) input.ariaLabel = label;
  }
  const reopen = document.querySelector(REOPEN)?.closest("button");
  mark(reopen, "icon");
  mark(reopen?.parentElement, "icon-row");
  mark(reopen?.parentElement?.previousElementSibling, "before-icon");
  mark(document.querySelector(DEVELOPERS)?.closest("button"), "developers");
}

/** Begins to label and mark the widgets that appear in the page. */
export function watchWidgets() {
  let asked = false;
  const later = () => {
    asked = false;
    look();
  };
  new MutationObserver(() => {
    if (!asked) requestAnimationFrame(later);
    asked = true;
  }).observe(document.getElementById("root") ?? document.body, {
    childList: true, subtree: true, attributes: true, attributeFilter: ["aria-valuenow", "value"],
  });
}
