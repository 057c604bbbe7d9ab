// @ts-check
/**
 * The service worker of a gallery. It keeps all files of one publication, and answers with them, network or not. Another
 * publication has another worker, since this script begins with the list of files: that one fetches what has changed, then takes
 * over, and what only the old one had is removed.
 */
{
  const worker = /** @type {any} */ (self);
  /** The files, each with its SHA-256. @type {Record<string, string>} */
  const FILES = worker.FILES;
  /** Requests at a time. */
  const LANES = 6;
  /** Where the gallery is; a site may have several. @type {string} */
  const scope = worker.registration.scope;
  const opened = () => caches.open(`softrod ${scope}`);
  /** By what a file is kept. @param {string} file */
  const nameOf = (file) => `${scope}${file}?${FILES[file]}`;

  /** Keeps a file as it was published: nothing that a login page or a web filter sends instead. @param {Cache} kept @param {string} file */
  const keep = async (kept, file) => {
    if (await kept.match(nameOf(file))) return;
    const answer = await fetch(scope + file, { cache: "reload" });
    const data = await answer.arrayBuffer();
    const digest = [...new Uint8Array(await crypto.subtle.digest("SHA-256", data))].map((byte) => byte.toString(16).padStart(2, "0"));
    if (digest.join("") !== FILES[file]) throw new Error(`${file} is not as it was published`);
    // Without what the server has to say of it, such as where it has redirected the request.
    await kept.put(nameOf(file), new Response(data, { headers: { "Content-Type": answer.headers.get("Content-Type") ?? "" } }));
  };

  const keepAll = async () => {
    const [kept, left] = [await opened(), Object.keys(FILES)];
    const lane = async () => {
      for (let file = left.pop(); file !== undefined; file = left.pop()) await keep(kept, file);
    };
    await Promise.all(Array.from({ length: LANES }, lane));
    await worker.skipWaiting();
  };

  const removeOthers = async () => {
    const [kept, own] = [await opened(), new Set(Object.keys(FILES).map(nameOf))];
    for (const { url } of await kept.keys()) if (!own.has(url)) await kept.delete(url);
    await worker.clients.claim();
  };

  /** The file at an address, also where a server leaves out what its name ends with. @param {string} address */
  const fileAt = (address) => {
    const url = new URL(address);
    const path = (url.origin + url.pathname).slice(scope.length) || "index.html";
    return address.startsWith(scope) ? [path, `${path}.html`].find((file) => Object.hasOwn(FILES, file)) : undefined;
  };

  worker.addEventListener("install", (/** @type {any} */ event) => event.waitUntil(keepAll()));
  worker.addEventListener("activate", (/** @type {any} */ event) => event.waitUntil(removeOthers()));
  worker.addEventListener("fetch", (/** @type {any} */ event) => {
    const { request } = event;
    const file = request.method === "GET" && fileAt(request.url);
    if (!file) return;
    const answer = async () => (await (await opened()).match(nameOf(file))) ?? fetch(request);
    event.respondWith(answer());
  });
}
