// @ts-check
/** Files that are opened, pictures that are saved, and links. */
import { listenToOpenFile } from "./open_file.js";
import { makeShareDialog } from "./share.js";

let openShareDialog = () => {};

function begin() {
  listenToOpenFile();
  openShareDialog = makeShareDialog();
}

/** @type {import("../../ui/feature.js").Feature<"files">} */
export default {
  commands: {
    share: () => openShareDialog(),
    video: () => void window.open("video", "_blank", "noopener"),
    picture: async () => (await import("./picture.js")).takePicture(),
  },
  begin,
};
