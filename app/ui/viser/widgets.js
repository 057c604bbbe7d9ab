// @ts-check
/**
 * The widgets of viser's panel: what viser and its libraries call them, names for what they leave without, and marks for
 * the styles. Nothing outside of this folder knows what they are called.
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
/** Buttons that are only an icon, by what they do. @type {Record<string, string>} */
const ICONS = { "tabler-icon-list-search": "All commands" };
/** The icon of "Open anew", which stands beside the scene's title; and of viser's own page for developers, which changes what
 * softrod sets. */
const [ANEW, DEVELOPERS] = [".icon-tabler-refresh", ".tabler-icon-adjustments"];

/** Whether the page is dark. */
export const isDark = () => document.documentElement.dataset.mantineColorScheme === "dark";

/** A tab of the panel beside the canvas, or of that of a phone, by its id: its words may be translated. @param {string} id */
export const tabOf = (id) => document.querySelector(`[data-dock-tab="${id}"], [role=tab][id$="-tab-${id}"]`);

/** Marks the element whose width viser fits to the room beside the panel, for the styles. */
export const markCanvas = () => mark(viserCanvas()?.closest("[data-dock-root] > div"), "canvas");

/** The panel at a side of the canvas. @param {string} side */
export const panelAt = (side) => document.querySelector(`[data-dock-region="${side}"]`);

/** The text of a control's row. @param {Element} element */
const rowName = (element) => element.closest(ROW)?.querySelector("label")?.innerText ?? "";

/**
 * Marks an element by an attribute: a selector with `:has` would have the browser go through the whole page whenever a
 * text in it changes, which took half of the page's time.
 *
 * @param {Element | null | undefined} element @param {string} mark
 */
function mark(element, mark) {
  if (element && element.getAttribute("data-softrod") !== mark) element.setAttribute("data-softrod", mark);
}

/** A slider and the box below it, which has its value; that of a logarithmic slider is over powers of ten. @param {Element} slider */
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
  const anew = document.querySelector(ANEW)?.closest("button");
  mark(anew, "icon");
  mark(anew?.parentElement, "icon-row");
  mark(anew?.parentElement?.previousElementSibling, "before-icon");
  mark(document.querySelector(DEVELOPERS)?.closest("button"), "developers");
}

/** Begins to name and to mark what comes into the page. */
export function mindWidgets() {
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
