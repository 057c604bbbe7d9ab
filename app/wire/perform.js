// @ts-check
/** Does a command of the table, whether it is the server's or the page's own. */
import { fit } from "../page/body/camera.js";
import { toggleChase } from "../page/body/chase.js";
import { has, onTold, send } from "./channel.js";
import { COMMANDS } from "./commands.js";
import { editing, setEditing } from "../page/edit/editing.js";
import { openGallery } from "../page/scenes/gallery.js";
import { toggleProjector } from "../page/looks/looks.js";
import { toggleSound } from "../page/modes/sound.js";
import { takePicture } from "../page/files/picture.js";
import { openRace } from "../page/race/race.js";
import { openShareDialog } from "../page/files/share.js";

/** @typedef {import("./wire.js").CommandName} CommandName */

/** What the page does itself. @type {Record<import("./wire.js").PageCommand, () => void>} */
const OWN = {
  gallery: () => openGallery(),
  race: () => openRace(),
  share: () => openShareDialog(),
  fit: () => void fit(true),
  chase: () => toggleChase(),
  larger: () => toggleProjector(),
  mute: () => toggleSound(),
  picture: () => void takePicture(),
  video: () => void window.open("video", "_blank", "noopener"),
  edit: () => setEditing(!editing.on),
};

/** Whether the page has the control without which a command is left out. @param {CommandName} command */
export const isOffered = (command) => has(COMMANDS[command].needs ?? "") || !COMMANDS[command].needs;

/** @param {CommandName} command */
export function perform(command) {
  if (!isOffered(command)) return;
  const own = OWN[/** @type {keyof typeof OWN} */ (command)];
  if (own) own();
  else send({ do: "perform", command });
}

/** Does those commands of the page that were given in the panel or in the palette. */
export const listenToCommands = () => onTold("run", ({ command }) => perform(command));
