// @ts-check
/**
 * Takes away viser's own notices of files on their way: softrod says what became of a file. viser's page makes them, so
 * that only their words tell them apart; they are looked at as they come, before anything can translate them.
 */

const VISERS = ["Uploading ", "Received "];

/** Begins to watch. */
export function quietNotices() {
  new MutationObserver(() => {
    for (const notice of document.querySelectorAll(".mantine-Notification-root:not([data-softrod-quiet])")) {
      const title = notice.querySelector(".mantine-Notification-title, .mantine-Notification-description")?.textContent ?? "";
      if (notice instanceof HTMLElement && VISERS.some((begin) => title.startsWith(begin))) {
        notice.dataset.softrodQuiet = "";
        notice.style.display = "none";
      }
    }
  }).observe(document.body, { childList: true, subtree: true });
}
