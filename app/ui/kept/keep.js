// @ts-check
/**
 * What survives a reload, a lost connection and a restart of the server: the tab's own storage keeps what the
 * server says of the session now and then, and every new connection gets it back.
 */
import { onMessage, pageState } from "../../wire/channel.js";
import { sendParts } from "./links.js";
import { kept, store } from "./storage.js";

const NAME = "softrod";
/** The scene that the page's address asked for. */
const ASKED = "softrod-asked";

/** What the server is to be given, if anything, until it says that it has it: what was kept before. */
let due = kept(NAME);

/** The connection is lost: the next one is to be given what is kept now. */
export const lost = () => (due = kept(NAME));

/** Whether the next connection is to be given something. */
export const hasKept = () => Boolean(due);

/**
 * Forgets what is kept of another scene than the one that the page's address asks for.
 *
 * @param {string} asked empty if it asks for none
 */
export function keepOnlyOf(asked) {
  if (asked && asked !== kept(ASKED)) {
    store(NAME, "");
    due = null;
  }
  store(ASKED, asked);
}

/** Compressed, as letters that a message can carry. @param {BlobPart} data */
export async function packed(data) {
  const stream = new Blob([data]).stream().pipeThrough(new CompressionStream("deflate"));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  let letters = "";
  for (let at = 0; at < bytes.length; at += 32768) letters += String.fromCharCode(...bytes.subarray(at, at + 32768));
  return btoa(letters);
}

/**
 * Gives it to each new connection, keeps what the server says from then on, and calls back.
 *
 * @param {() => void} then
 */
export function resume(then) {
  /** @type {string | undefined} */
  let page;
  onMessage("resumed", () => (due = null));
  // Unless the server knows nothing yet of what was kept before.
  onMessage("keepsake", ({ kept }) => due || store(NAME, kept));
  onMessage("pageState", async () => {
    if (pageState().page === page) return;
    const mine = (page = pageState().page);
    if (!mine) return;
    if (due) {
      const letters = await packed(due);
      if (mine !== page) return; // it is given to the next one
      if (due && !sendParts("resume", letters)) due = null;
    }
    then();
  });
}
