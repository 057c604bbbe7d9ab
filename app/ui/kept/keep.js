// @ts-check
/**
 * Survives a reload, a lost connection and a restart of the server: the tab stores the state that the server sends now and
 * then, and returns it to every new connection.
 */
import { onMessage, pageState } from "../../wire/channel.js";
import { sendParts } from "./links.js";
import { kept, store } from "./storage.js";

const NAME = "softrod";
/** Where the scene that the page's address asks for is stored. */
const ASKED = "softrod-asked";

/** The state that the server has to be given; null once it confirms that it has it. */
let due = kept(NAME);

/** Has the present state given to the next connection; the last one is lost. */
export const lost = () => (due = kept(NAME));

/** True if the next connection has to be given a state. */
export const hasKept = () => Boolean(due);

/**
 * Forgets the stored state if the page's address asks for another scene.
 *
 * @param {string} asked what it asks for; empty for none
 */
export function keepOnlyOf(asked) {
  if (asked && asked !== kept(ASKED)) {
    store(NAME, "");
    due = null;
  }
  store(ASKED, asked);
}

/** Takes the scene out of the page's address once another one is open, so that a reload and a copied address have that one. */
export function watchAddress() {
  /** @type {{page: string, scene: number, title: string} | undefined} */
  let first;
  onMessage("pageState", ({ page, scene, title }) => {
    if (!page || due) return;
    if (first?.page !== page) first = { page, scene, title };
    else if (scene !== first.scene && title !== first.title) forgetAsked();
  });
}

function forgetAsked() {
  const { searchParams: asked, pathname, hash } = new URL(location.href);
  if (!["s", "scene"].some((field) => asked.has(field))) return;
  for (const field of ["s", "scene"]) asked.delete(field);
  store(ASKED, "");
  history.replaceState(null, "", `${pathname}${asked.size ? `?${asked}` : ""}${hash}`);
}

/** Compresses data, as base64 for a message. @param {BlobPart} data */
export async function packed(data) {
  const stream = new Blob([data]).stream().pipeThrough(new CompressionStream("deflate"));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  let letters = "";
  for (let at = 0; at < bytes.length; at += 32768) letters += String.fromCharCode(...bytes.subarray(at, at + 32768));
  return btoa(letters);
}

/**
 * Gives the stored state to each new connection, then calls back; stores the states that the server sends from then on.
 *
 * @param {() => void} then
 */
export function resume(then) {
  /** @type {string | undefined} */
  let page;
  onMessage("resumed", () => (due = null));
  // Unless the server does not have the previous state yet.
  onMessage("keepsake", ({ kept }) => due || store(NAME, kept));
  onMessage("pageState", async () => {
    if (pageState().page === page) return;
    const mine = (page = pageState().page);
    if (!mine) return;
    if (due) {
      const letters = await packed(due);
      if (mine !== page) return; // the next connection gets it
      if (due && !sendParts("resume", letters)) due = null;
    }
    then();
  });
}
