// @ts-check
/** How somebody uses the page: settings on the page Access of the View menu, which this device keeps. */
const NAME = "softrod-access";

/**
 * @typedef {object} Access
 * @property {"always" | "body" | "never"} letters when letters, digits, signs and Space are commands
 * @property {boolean} still whether nothing moves by itself, whatever the system says
 * @property {boolean} sound whether anything is heard
 * @property {boolean} events whether a screen reader is told what happens
 * @property {boolean} taps whether a tap picks up what can be dragged, and the next one says where it goes
 * @property {boolean} contrast whether letters and edges stand out more, whatever the system says
 */
/** @type {Access} */
export const USUAL = { letters: "always", still: false, contrast: false, sound: true, events: false, taps: false };

const calm = typeof matchMedia === "undefined" ? null : matchMedia("(prefers-reduced-motion: reduce)");

/** What is kept, as far as it can be read. @returns {Access} */
function read() {
  try {
    const { letters, still, contrast, sound, events, taps } = JSON.parse(localStorage.getItem(NAME) || "{}");
    const when = letters === "body" || letters === "never" ? letters : USUAL.letters;
    return { letters: when, still: still === true, contrast: contrast === true, sound: sound !== false, events: events === true, taps: taps === true };
  } catch {
    // The browser stores nothing, or somebody has changed it.
    return USUAL;
  }
}

let now = read();
/** @type {(() => void)[]} */
const watchers = [];

/** Calls back when a setting has changed. @param {() => void} changed */
export const onAccess = (changed) => void watchers.push(changed);

/** The settings. */
export const access = () => now;

/** Whether nothing is to move by itself. */
export const isStill = () => now.still || (calm !== null && calm.matches);

/** Keeps other settings, where the browser stores anything. @param {Partial<Access>} changed */
export function setAccess(changed) {
  now = { ...now, ...changed };
  try {
    localStorage.setItem(NAME, JSON.stringify(now));
  } catch {
    // They hold until the page is left.
  }
  apply();
  for (const changed of watchers) changed();
}

/** Shows them where only the style is concerned. */
export function apply() {
  document.documentElement.toggleAttribute("data-softrod-still", now.still);
  document.documentElement.toggleAttribute("data-softrod-contrast", now.contrast);
}

/** Calls back when the system's wish for less motion changes. @param {() => void} call */
export const onCalm = (call) => calm && calm.addEventListener("change", call);

/**
 * Whether a key is a character that may be meant for something else than the page: typed by mistake, or said to a program
 * that writes what it hears.
 *
 * @param {{key?: string, ctrlKey?: boolean, metaKey?: boolean, target: EventTarget | null}} event of a keyboard
 */
export function isMeantElsewhere({ key = "", ctrlKey, metaKey, target }) {
  if (now.letters === "always" || key.length !== 1 || ctrlKey || metaKey) return false;
  return now.letters === "never" || !(target instanceof Element && target.matches(".softrod-body, #canvas"));
}
