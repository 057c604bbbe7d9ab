// @ts-check
/**
 * The index of a gallery: search, keys, and addresses that lead to a search, a card or a scene. The cards are in the page
 * already; without this script they are links all the same.
 *
 * @typedef {{name: string, file: string, title: string, text: string, group: string}} Scene
 */
import { element } from "../../export/static/parts.js";
import { isMeantElsewhere } from "../../ui/access.js";
import { kept, store } from "../../ui/kept/storage.js";
import { isFound, moveByKey } from "../../features/gallery/finding.js";
import { say } from "../../words/words.js";
import { keepGallery } from "./keep.js";

/** Under this name the last search is stored, for the way back. */
const KEY = "softrod-search";
/** Milliseconds after the last letter after which the address has the search: browsers limit how often it may change. */
const REST = 300;

/** @type {Scene[]} */
const scenes = JSON.parse(element("scenes", HTMLScriptElement).textContent ?? "");
const search = element("search", HTMLInputElement);
const count = element("count", HTMLOutputElement);
const none = element("none", HTMLElement);
const all = count.value;
const dark = element("dark", HTMLButtonElement);
const root = document.documentElement;
let late = 0;

/** @param {Scene} scene */
const cardOf = ({ file }) => element(`at=${file}`, HTMLAnchorElement);
const found = () => scenes.filter((scene) => isFound(scene, search.value));

/** @param {Record<string, string>} fields */
function address(fields) {
  clearTimeout(late);
  const text = String(new URLSearchParams(Object.entries(fields).filter(([, value]) => value)));
  history.replaceState(null, "", text ? `#${text}` : location.pathname + location.search);
}

/** Show the scenes that are searched for. */
function filter() {
  const hits = new Set(found());
  for (const scene of scenes) cardOf(scene).parentElement?.toggleAttribute("hidden", !hits.has(scene));
  for (const section of document.querySelectorAll("section")) {
    const there = section.querySelectorAll("li:not([hidden])").length;
    section.hidden = !there;
    const jump = document.querySelector(/** @type {"a"} */ (`nav a[href="#${section.id}"]`));
    jump?.toggleAttribute("hidden", !there);
    jump?.lastElementChild?.replaceChildren(String(there));
  }
  count.value = search.value.trim() ? say("site-found", { found: hits.size, count: scenes.length }) : all;
  none.textContent = hits.size ? "" : say("site-none");
  store(KEY, search.value);
}

/** @param {string} text */
function seek(text) {
  search.value = text;
  filter();
}

/** Do what stands after the # of the address. */
function follow() {
  const asked = new URLSearchParams(location.hash.slice(1));
  const find = (/** @type {string | null} */ wanted) =>
    scenes.find(({ name }) => name === wanted) ?? scenes.find(({ file }) => file === wanted);
  const [scene, at, last] = [asked.get("scene"), find(asked.get("at")), kept(KEY) ?? ""];
  if (scene !== null) {
    const to = find(scene);
    if (to) location.replace(`${to.file}.html`);
    else none.textContent = say("site-unknown", { name: scene });
    return;
  }
  if (asked.has("search")) seek(asked.get("search") ?? "");
  else if (at) seek(isFound(at, last) ? last : "");
  else filter();
  if (!at) return;
  address({ search: search.value });
  cardOf(at).focus({ preventScroll: true });
  cardOf(at).scrollIntoView({ block: "center" });
}

search.addEventListener("input", () => {
  filter();
  clearTimeout(late);
  late = setTimeout(() => address({ search: search.value }), REST);
});
document.addEventListener("click", ({ target }) => {
  const card = target instanceof Element && target.closest("li a");
  // So that the browser's own way back leads to the card, too.
  if (card) address({ search: search.value, at: card.id.slice("at=".length) });
});
document.addEventListener("keydown", (event) => {
  const { target, key } = event;
  if (event.ctrlKey || event.metaKey || event.altKey || event.isComposing) return;
  if (key === "Escape") {
    seek("");
    address({});
    if (target === search) search.blur();
  } else if (target !== search && key === "/" && !isMeantElsewhere(event)) {
    search.focus();
    search.select();
  } else {
    moveByKey(event, search, found().map(cardOf));
    return;
  }
  event.preventDefault();
});
const shadow = () => (dark.ariaPressed = String(root.hasAttribute("data-dark")));
dark.addEventListener("click", () => root.toggleAttribute("data-dark"));
new MutationObserver(shadow).observe(root, { attributeFilter: ["data-dark"] });
shadow();
window.addEventListener("hashchange", follow);
follow();
keepGallery(() => (element("kept", HTMLElement).textContent = say("site-kept")));
