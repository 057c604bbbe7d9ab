// What of the page is told by a drawn shape: its name, and where it is in the window; a picture of the page shows its colours.
() => {
  const SHAPES =
    "input:not([type=hidden], [type=file]), select, textarea, meter, progress, .softrod-meter, .softrod-key, .softrod-track, " +
    ".softrod-bars i, .softrod-desk-bar i, .softrod-lesson-dashes .softrod-done, .softrod-plot-title i, .chart i, .softrod-choice, " +
    ".softrod-seat-name, button:not(.softrod-handle) > svg, .softrod-tab[aria-selected=true], .softrod-switch > input";
  const isShown = (element) => element.checkVisibility({ opacityProperty: true, visibilityProperty: true }) && !element.matches(":disabled, :disabled *");
  const modal = document.querySelector("dialog[open]") ?? document;
  return [...modal.querySelectorAll(SHAPES)].filter(isShown).flatMap((element) => {
    const { left, top, width, height } = element.getBoundingClientRect();
    if (width < 3 || height < 3 || left < 3 || top < 3 || left + width > innerWidth - 3 || top + height > innerHeight - 3) return [];
    const hit = document.elementFromPoint(left + width / 2, top + height / 2);
    const isFree = !hit || getComputedStyle(element).pointerEvents === "none" || element.contains(hit) || hit.contains(element);
    return isFree ? [{ name: `${element.localName}.${element.className} ${element.ariaLabel ?? ""}`, box: [left, top, width, height].map(Math.round) }] : [];
  });
}
