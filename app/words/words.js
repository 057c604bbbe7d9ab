// @ts-check
/** The page's words in its language: Fluent messages, which the server puts into the page beside its script. */
import { FluentBundle, FluentResource } from "./fluent/fluent.js";

/** Words of a program without a page, as in tests. @type {{language: string, direction: string, text: string} | undefined} */
const given = /** @type {any} */ (globalThis).softrodWords;
const own = given || typeof document === "undefined" ? null : document.getElementById("words");
const words = given || {
  language: (own && own.lang) || "en",
  direction: (own && own.dir) || "ltr",
  text: (own && own.textContent) || "",
};

/** The tag of the page's language, and the direction of its text. */
export const language = words.language;
export const direction = words.direction;

/** The languages there are, each by what those who speak it call it. */
export const languages = () =>
  ((own && own.dataset.languages) || "").split(";").map((each) => {
    const [tag, name] = each.split("=");
    return { tag, name };
  });

const bundle = new FluentBundle(`${language}-u-nu-latn`, { useIsolating: direction === "rtl" });
bundle.addResource(new FluentResource(words.text));

/** What stands before the decimals. */
export const POINT = (new Intl.NumberFormat(words.language).formatToParts(1.5).find(({ type }) => type === "decimal") || { value: "." }).value;

/** A number that is written with a point as the page's language writes it. @param {string} text */
export const decimal = (text) => text.replace(".", POINT);

/** The last digit of a number before its unit; names of quantities and formulas have no such pair. */
const MEASURED = /(\d) (?=(?:px|[cmk]?m|k?g|ms|s|min|rad|N|J|W|Hz|%)(?![A-Za-z\d]))/g;

/** A text whose numbers and their units stay on one line. @param {string} text */
export const tied = (text) => text.replace(MEASURED, "$1\u00a0");

/** A number with its unit, which keeps its direction in a text from right to left. @param {string} text */
export const upright = (text) => (direction === "rtl" ? `\u2066${text}\u2069` : text);

/** A text that somebody typed, which keeps its own direction in any other. @param {string} text */
export const isolated = (text) => `\u2068${text}\u2069`;

/** Some texts as a list, as in "a, b and c". @param {string[]} items */
export const listed = (items) => new Intl.ListFormat(language.startsWith("en") ? "en-GB" : language).format(items);

/**
 * Some texts after one another, as in "a, b, c"; empty ones are left out.
 *
 * @param {(string | false | null | undefined)[]} items
 * @param {"language-comma" | "language-semicolon"} by
 */
export function joined(items, by = "language-comma") {
  const told = /** @type {string[]} */ (items.filter(Boolean));
  return told.length ? told.reduce((before, after) => say(by, { before, after })) : "";
}

/** A text as it is searched: in lower case, without accents, of the same length. @param {string} text */
export const folded = (text) =>
  [...text.toLocaleLowerCase(words.language)].map((letter) => letter.normalize("NFD")[0].replace("\u2019", "'").padEnd(letter.length)).join("");

/**
 * A text in the page's language, or its key where it is not there.
 *
 * @template {keyof import("./keys.js").Words} K
 * @param {K} key the message's, or that of one of its attributes, as in "play-step.hint"
 * @param {import("./keys.js").Words[K] extends never ? [] : [Record<import("./keys.js").Words[K], string | number>]} values
 *   what stands in its places; whole numbers choose between its plural forms
 * @returns {string}
 */
export function say(key, ...values) {
  const [name, attribute] = key.split(".");
  const message = bundle.getMessage(name);
  const pattern = message && (attribute ? message.attributes[attribute] : message.value);
  return pattern ? bundle.formatPattern(pattern, values[0] || null, []) : key;
}
