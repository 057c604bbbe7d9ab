// @ts-check
/** Has the browser keep the whole gallery, so that it opens without a network, and offers to install it. */

/**
 * Begins that on a page of a server; pages on the disk are there anyway. Without TLS no browser keeps anything.
 *
 * @param {() => void} [done] called once all of it is kept
 */
export function keepGallery(done) {
  if (!location.protocol.startsWith("http")) return;
  const manifest = document.createElement("link");
  Object.assign(manifest, { rel: "manifest", href: "manifest.json", crossOrigin: "use-credentials" });
  document.head.append(manifest);
  const keeper = navigator.serviceWorker;
  if (!keeper) return;
  window.addEventListener("load", async () => {
    try {
      await keeper.register("offline.js");
      await keeper.ready;
      done?.();
    } catch {
      // The browser or the server forbids it, or there is no room: the gallery needs its server, then.
    }
  });
}
