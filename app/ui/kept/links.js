// @ts-check
/**
 * Links with a scene after their #. Browsers do not send that part, so it is sent to the server here, unread, and removed
 * from the address: a reload then goes on with the stored state.
 */
import { LINK_PATH } from "../../stage/looks.js";
import { pageState, send } from "../../wire/channel.js";

/** End of the path of such a link; the page itself may be in a folder. */
const PATH = new RegExp(`${LINK_PATH}$`);
/** Beginning of the data: the version of the packing, and a dot. */
const BEGIN = /^#\d+\./;
/** Characters of a part; the gate accepts messages up to 64 KiB. */
const PART = 48_000;
/** Parts of a text that the server accepts. */
const MAX_PARTS = 99;

/** The data of a link that has to be opened. */
let due = "";

/** Takes a link out of the page's address; call it before viser's page begins, which would connect to all of it. */
export function takeLink() {
  const { hash, pathname, search } = location;
  if (PATH.test(pathname) || BEGIN.test(hash)) due = hash.slice(1);
  if (hash || PATH.test(pathname)) history.replaceState(null, "", `${pathname.replace(PATH, "/")}${search}`);
}

/**
 * Keeps viser's page from changing the address: for a page in a folder it would add the address of its WebSocket, which
 * the server would take for an attack at the next reload.
 */
export function keepAddress() {
  const replace = history.replaceState.bind(history);
  history.replaceState = (state, title, url) => title !== "Viser" && replace(state, title, url);
}

/**
 * Sends a text in parts; if it is too long, the user gets a notice instead.
 *
 * @param {import("../../wire/wire.js").TextKind} kind
 * @param {string} letters
 * @returns {boolean} true if it was sent
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

/** Has the server open the link of the page's address, if there is a connection. */
export function openLink() {
  if (!due || !pageState().page) return;
  sendParts("link", due);
  due = "";
}

/** Opens links that are pasted into the address of the present page. */
export function listenToLinks() {
  window.addEventListener("hashchange", () => {
    takeLink();
    openLink();
  });
}
