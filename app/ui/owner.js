// @ts-check
/**
 * Identifies the user of the page. The terminal prints an address with the owner's key after a #, which is in no request;
 * the browser remembers it. Other browsers make up a secret, by which the server finds their scenes again.
 */
import { onMessage, pageState, send } from "../wire/channel.js";
import { remember, remembered } from "./kept/storage.js";

const BEGIN = "#owner=";
const OWNER = "softrod-owner";
const TEACHER_BEGIN = "#teacher=";
/** Where the secret of the page's class is stored. */
const TEACHER = `softrod-teacher-${(new URLSearchParams(location.search).get("room") ?? "").toUpperCase()}`;
const VISITOR = "softrod-visitor";

/** Moves a key from the page's address into the storage; returns true if there was one. */
function takeKey() {
  const begin = [BEGIN, TEACHER_BEGIN].find((begin) => location.hash.startsWith(begin));
  if (!begin) return false;
  remember(begin === BEGIN ? OWNER : TEACHER, location.hash.slice(begin.length, begin.length + 100));
  history.replaceState(null, "", location.pathname + location.search);
  return true;
}

function visitor() {
  const known = remembered(VISITOR) ?? "";
  if (/^[0-9a-f]{32}$/.test(known)) return known;
  const bytes = crypto.getRandomValues(new Uint8Array(16));
  const made = [...bytes].map((byte) => byte.toString(16).padStart(2, "0")).join("");
  remember(VISITOR, made);
  return made;
}

/** Identifies the user to every new connection; call it before links are taken out of the address. */
export function identify() {
  takeKey();
  const say = () => send({ do: "who", visitor: visitor(), owner: remembered(OWNER) ?? "", teacher: remembered(TEACHER) ?? "" });
  /** @type {string | undefined} */
  let page;
  onMessage("pageState", () => {
    if (pageState().page === page) return;
    page = pageState().page;
    if (page) say();
  });
  window.addEventListener("hashchange", () => takeKey() && say());
}
