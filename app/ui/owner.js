// @ts-check
/**
 * Whose the page is. The terminal prints an address with the owner's key after a #, which no request has; the browser
 * remembers it. Other browsers make up a secret, by which their own scenes are found again.
 */
import { onMessage, pageState, send } from "../wire/channel.js";

const BEGIN = "#owner=";
const OWNER = "softrod-owner";
const TEACHER_BEGIN = "#teacher=";
/** The secret of the class that the page is of. */
const TEACHER = `softrod-teacher-${(new URLSearchParams(location.search).get("room") ?? "").toUpperCase()}`;
const VISITOR = "softrod-visitor";

/** Where the browser forbids storage, they are the page's own. @type {Map<string, string>} */
const memory = new Map();

/** @param {string} name */
function remembered(name) {
  try {
    return localStorage.getItem(name) ?? memory.get(name) ?? "";
  } catch {
    return memory.get(name) ?? "";
  }
}

/** @param {string} name @param {string} text */
function remember(name, text) {
  memory.set(name, text);
  try {
    localStorage.setItem(name, text);
  } catch {
    // Forbidden or full.
  }
}

/** Takes the owner's key out of the page's address, whether it is there at the beginning or comes later. */
function takeKey() {
  const begin = [BEGIN, TEACHER_BEGIN].find((begin) => location.hash.startsWith(begin));
  if (!begin) return false;
  remember(begin === BEGIN ? OWNER : TEACHER, location.hash.slice(begin.length, begin.length + 100));
  history.replaceState(null, "", location.pathname + location.search);
  return true;
}

function visitor() {
  if (!/^[0-9a-f]{32}$/.test(remembered(VISITOR))) {
    const bytes = crypto.getRandomValues(new Uint8Array(16));
    remember(VISITOR, [...bytes].map((byte) => byte.toString(16).padStart(2, "0")).join(""));
  }
  return remembered(VISITOR);
}

/** Tells every new connection; before links are taken out of the address. */
export function sayWhose() {
  takeKey();
  const say = () => send({ do: "who", visitor: visitor(), owner: remembered(OWNER), teacher: remembered(TEACHER) });
  /** @type {string | undefined} */
  let page;
  onMessage("pageState", () => {
    if (pageState().page === page) return;
    page = pageState().page;
    if (page) say();
  });
  window.addEventListener("hashchange", () => takeKey() && say());
}
