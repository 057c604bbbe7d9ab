// @ts-check
/** How scenes on cards are searched, and where arrows lead among them: in the page's gallery, and in one that is a site. */

/**
 * Whether a scene is one that is searched for: each word is in its title, its name or what it shows.
 *
 * @param {{name: string, title: string, text: string, group: string}} entry
 * @param {string} wanted
 */
export function isFound({ name, title, text, group }, wanted) {
  const all = `${title} ${name} ${text} ${group}`.toLowerCase();
  return wanted.toLowerCase().split(/\s+/).every((word) => all.includes(word));
}

/**
 * To which of some places an arrow leads: to the next in reading order, or to the nearest in the row above or below.
 *
 * @param {string} key
 * @param {number} from
 * @param {{x: number, y: number}[]} places in reading order
 */
export function arrived(key, from, places) {
  if (key === "ArrowRight") return Math.min(from + 1, places.length - 1);
  if (key === "ArrowLeft") return Math.max(from - 1, 0);
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
