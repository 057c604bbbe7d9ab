// @ts-check
/** Files that the server sends in parts: they are downloaded once they are whole. */
import { takeOver } from "../../wire/channel.js";
import { download } from "../download.js";

/** Begins to receive them. */
export function takeFiles() {
  /** @type {Map<string, {name: string, type: string, parts: BlobPart[], missing: number}>} */
  const files = new Map();
  takeOver("FileTransferStartDownload", ({ transfer_uuid: id, filename: name, mime_type: type, part_count: missing }) => {
    files.set(id, { name, type, parts: [], missing });
    finish(id);
  });
  takeOver("FileTransferPart", ({ transfer_uuid: id, part_index: at, content }) => {
    const file = files.get(id);
    if (!file) return;
    file.parts[at] = content;
    file.missing -= 1;
    finish(id);
  });
  /** @param {string} id */
  function finish(id) {
    const file = files.get(id);
    if (!file || file.missing > 0) return;
    files.delete(id);
    download(new Blob(file.parts, { type: file.type }), file.name);
  }
}
