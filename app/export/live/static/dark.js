// @ts-check
/**
 * Whether a file is on dark paper, which is the attribute `data-dark` of its root; a switch changes that attribute. This
 * runs before anything is shown, so that nothing flashes. The system decides, until somebody presses a switch: that is
 * stored in the browser for all files of one origin.
 */
{
  const KEY = "softrod-dark";
  const root = document.documentElement;
  const night = matchMedia("(prefers-color-scheme: dark)");
  const isDark = () => root.hasAttribute("data-dark");

  const apply = () => {
    let stored = null;
    try {
      stored = localStorage.getItem(KEY);
    } catch {
      // A frame of another site may store nothing.
    }
    root.toggleAttribute("data-dark", stored === null ? night.matches : stored === "yes");
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
