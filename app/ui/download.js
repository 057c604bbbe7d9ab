// @ts-check
/** Files that the browser saves. */

/** Milliseconds after which the browser has read a file that it saves. */
const READ = 60_000;

/** Has the browser save a file. @param {Blob} file @param {string} name */
export function download(file, name) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(file);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), READ);
}
