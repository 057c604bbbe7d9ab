// @ts-check
/** Files that the browser saves. */

/** Milliseconds after which the browser has read a file that it saves. */
const READ = 60_000;

/** Has the browser save a file. @param {Blob} file @param {string} name */
export function download(file, name) {
  const url = URL.createObjectURL(file);
  Object.assign(document.createElement("a"), { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), READ);
}
