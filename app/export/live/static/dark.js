// @ts-check
/**
 * Whether a file is on dark paper: the attribute `data-dark` of its root says it, and whoever changes that is a switch. It
 * runs before anything is shown, so that nothing flashes. Until somebody presses a switch, the system decides; then the
 * browser keeps it for all such files of a place.
 */
{
  const KEY = "softrod-dark";
  const root = document.documentElement;
  const night = matchMedia("(prefers-color-scheme: dark)");
  const isDark = () => root.hasAttribute("data-dark");

  const apply = () => {
    let kept = null;
    try {
      kept = localStorage.getItem(KEY);
    } catch {
      // A frame of another site may keep nothing.
    }
    root.toggleAttribute("data-dark", kept === null ? night.matches : kept === "yes");
    switched.takeRecords();
  };
  const switched = new MutationObserver(() => {
    try {
      if (isDark() === night.matches) localStorage.removeItem(KEY);
      else localStorage.setItem(KEY, isDark() ? "yes" : "no");
    } catch {
      // As above.
    }
  });

  switched.observe(root, { attributeFilter: ["data-dark"] });
  apply();
  night.addEventListener("change", apply);
  // Another file may have changed it: one to which one goes back, or one in another tab.
  window.addEventListener("pageshow", apply);
  window.addEventListener("storage", apply);
}
