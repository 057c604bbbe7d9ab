// @ts-check
/**
 * Links that hold a scene after their #. A browser keeps that to itself, so it is sent to the server here. Nothing in
 * it is read in the page, and the address is given back without it: a reload then goes on with what is kept.
 */
import { LINK_PATH } from "../../stage/looks.js";
import { pageState, send } from "../../wire/channel.js";

/** The end of such a link's path; the page itself may be in a folder. */
const PATH = new RegExp(`${LINK_PATH}$`);
/** How the data begins: the number of its way of packing, and a dot. */
const BEGIN = /^#\d+\./;
/** Characters of a message; the gate takes 64 KiB. */
const PART = 48_000;
/** Parts of a text; the server takes no more. */
const MAX_PARTS = 99;

/** The data of a link that is to be opened. */
let due = "";

/** Takes a link out of the page's address; before viser's page begins, which would connect to all of that. */
export function takeLink() {
  const { hash, pathname, search } = location;
  if (PATH.test(pathname) || BEGIN.test(hash)) due = hash.slice(1);
  if (hash || PATH.test(pathname)) history.replaceState(null, "", `${pathname.replace(PATH, "/")}${search}`);
}

/**
 * Has viser's page leave the page's address alone: for a page in a folder it would write the address of its WebSocket
 * there, which the server takes for an attack at the next reload.
 */
export function keepAddress() {
  const replace = history.replaceState.bind(history);
  history.replaceState = (state, title, url) => title !== "Viser" && replace(state, title, url);
}

/**
 * Sends a text in parts; one that is too long is not sent, and its user is told.
 *
 * @param {import("../../wire/wire.js").TextKind} kind
 * @param {string} letters
 * @returns {boolean} whether it was sent
 */
export function sendParts(kind, letters) {
  const parts = Math.max(1, Math.ceil(letters.length / PART));
  if (parts > MAX_PARTS) {
    send({ do: "unsent", what: kind });
    return false;
  }
  for (let i = 0; i < parts; i++) send({ do: "part", kind, number: i + 1, of: parts, letters: letters.slice(PART * i, PART * (i + 1)) });
  return true;
}

/** Has the server open the link that the page was opened with, if there is a connection. */
export function openLink() {
  if (!due || !pageState().page) return;
  sendParts("link", due);
  due = "";
}

/** Begins to take links that are put into the address of the page that is there. */
export function listenToLinks() {
  window.addEventListener("hashchange", () => {
    takeLink();
    openLink();
  });
}
