// @ts-check
/**
 * The switch between white and dark paper, which a browser keeps for all pages of a gallery. It runs before anything is
 * shown, so that nothing flashes. Until somebody presses the switch, the system decides.
 */
{
  const KEY = "softrod-theme";
  const root = document.documentElement;
  const night = matchMedia("(prefers-color-scheme: dark)");
  const system = () => (night.matches ? "dark" : "light");

  const apply = () => {
    try {
      const kept = localStorage.getItem(KEY);
      if (kept === "dark" || kept === "light") root.dataset.theme = kept;
      else delete root.dataset.theme;
    } catch {
      // A frame of another site may keep nothing.
    }
    document.getElementById("dark")?.setAttribute("aria-pressed", String((root.dataset.theme ?? system()) === "dark"));
  };
  /** @param {Event} event */
  const press = ({ target }) => {
    if (!(target instanceof Element) || !target.closest("#dark")) return;
    const wanted = (root.dataset.theme ?? system()) === "dark" ? "light" : "dark";
    root.dataset.theme = wanted;
    try {
      if (wanted === system()) localStorage.removeItem(KEY);
      else localStorage.setItem(KEY, wanted);
    } catch {
      // As above.
    }
    apply();
  };

  apply();
  document.addEventListener("DOMContentLoaded", apply);
  document.addEventListener("click", press);
  night.addEventListener("change", apply);
  // Another page of the gallery may have changed it: one to which one goes back, or one in another tab.
  window.addEventListener("pageshow", apply);
  window.addEventListener("storage", apply);
}
