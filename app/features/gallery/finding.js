// @ts-check
/** How scenes on cards are searched, and where arrows lead among them: in the page's gallery, and in one that is a site. */
import { isMeantElsewhere } from "../../ui/access.js";
import { direction, folded } from "../../words/words.js";

const [BACK, ON] = direction === "rtl" ? ["ArrowRight", "ArrowLeft"] : ["ArrowLeft", "ArrowRight"];

/**
 * Which of the scenes that are found is meant most likely: one whose title is what was typed, or else begins with it, or else
 * the first.
 *
 * @param {{name: string, title: string}[]} found @param {string} wanted
 * @returns {string | undefined} its name
 */
export function meant(found, wanted) {
  const text = folded(wanted.trim());
  const by = (/** @type {(title: string) => boolean} */ isIt) => found.find(({ title }) => isIt(folded(title)));
  return (by((title) => title === text) ?? by((title) => title.startsWith(text)) ?? found[0])?.name;
}

/**
 * Whether a scene is one that is searched for: each word is in its title, its name or what it shows.
 *
 * @param {{name: string, title: string, text: string, group: string}} entry
 * @param {string} wanted
 */
export function isFound({ name, title, text, group }, wanted) {
  const all = folded(`${title} ${name} ${text} ${group}`);
  return folded(wanted).split(/\s+/).every((word) => all.includes(word));
}

/**
 * To which of some places an arrow leads: to the next in reading order, or to the nearest in the row above or below.
 *
 * @param {string} key
 * @param {number} from
 * @param {{x: number, y: number}[]} places in reading order
 */
export function arrived(key, from, places) {
  if (key === ON) return Math.min(from + 1, places.length - 1);
  if (key === BACK) return Math.max(from - 1, 0);
  if (key === "Home") return 0;
  if (key === "End") return places.length - 1;
  const sign = key === "ArrowDown" ? 1 : -1;
  const [at, beyond] = [places[from], places.map(({ y }) => sign * (y - places[from].y))];
  const row = Math.min(...beyond.filter((distance) => distance > 4));
  let [best, least] = [from, Infinity];
  places.forEach(({ x }, i) => {
    if (Math.abs(beyond[i] - row) < 4 && Math.abs(x - at.x) < least) [best, least] = [i, Math.abs(x - at.x)];
  });
  return best;
}

/** Moves the focus to a card. @param {HTMLElement | undefined} card */
export function focusCard(card) {
  card?.focus({ preventScroll: true });
  card?.scrollIntoView({ block: "nearest" });
}

/**
 * Moves the focus by keys: arrows go from card to card and back to the field of the search, letters go there from anywhere.
 *
 * @param {KeyboardEvent} event
 * @param {HTMLElement} search
 * @param {HTMLElement[]} cards that are shown, in reading order
 * @param {HTMLElement | undefined} [first] the card to which one gets from the search
 * @param {HTMLElement | undefined} [best] the card that Enter opens there
 * @returns {boolean} whether that was the key
 */
export function moveByKey(event, search, cards, first = cards[0], best = cards[0]) {
  const { target, key } = event;
  const from = cards.findIndex((card) => card === target);
  if (target === search) {
    if (key === "Enter") best?.click();
    else if (key === "ArrowDown") focusCard(first);
    else return false;
  } else if (from >= 0 && /^(Arrow(Up|Down|Left|Right)|Home|End)$/.test(key)) {
    const to = arrived(key, from, cards.map((card) => card.getBoundingClientRect()));
    if (key === "ArrowUp" && to === from) search.focus();
    else focusCard(cards[to]);
  } else {
    if (key.length === 1 && key !== " " && !(target instanceof HTMLInputElement) && !isMeantElsewhere(event)) search.focus(); // which takes the letter
    return false;
  }
  event.preventDefault();
  return true;
}
