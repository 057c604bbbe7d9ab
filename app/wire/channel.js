// @ts-check
/**
 * What the page and the server say to each other; docs/wire.md has all of it. It goes through viser's connection, in one kind of
 * message that viser's page never sees.
 *
 * @typedef {import("./wire.js").Told} Told
 * @typedef {object} Message as it travels
 * @property {string} type
 * @property {string} [text]
 * @property {Float32Array} [numbers]
 */
/** The name of that kind. */
const CARRIER = "SoftrodMessage";
/** Sends a message by the connection that there is. @type {(message: Message) => void} */
let post = () => {};
/** The state of the page. @type {Partial<import("./wire.js").PageState>} */
let heard = {};
/** @type {Map<string, ((told: any) => void)[]>} */
const readers = new Map();

/** Has everything sent in a way. @param {typeof post} sender */
export const sendBy = (sender) => void (post = sender);

/** How things are, as the server told it last. */
export const told = () => heard;

/** Whether the page has a control. @param {string} control */
export const has = (control) => heard.controls?.includes(control) ?? false;

/**
 * Calls back with everything of a kind that the server tells.
 *
 * @template {keyof Told} K
 * @param {K} kind
 * @param {(told: Told[K]) => void} reader
 */
export function onTold(kind, reader) {
  readers.set(kind, [...(readers.get(kind) ?? []), reader]);
}

/**
 * Takes what the server tells out of a message.
 *
 * @param {Message} message
 * @returns {boolean} whether it was for the script
 */
export function hear({ type, text, numbers }) {
  if (type !== CARRIER) return false;
  const message = { ...JSON.parse(text ?? "{}"), ...(numbers && { numbers }) };
  if (message.tell === "pageState") heard = message;
  callAll(readers.get(message.tell) ?? [], message);
  return true;
}

/**
 * Calls each of some functions; one that throws is reported, and keeps nothing from the others.
 *
 * @template {any[]} A
 * @param {Iterable<(...args: A) => void>} callbacks @param {A} args
 */
export function callAll(callbacks, ...args) {
  for (const call of callbacks) {
    try {
      call(...args);
    } catch (error) {
      reportError(error);
    }
  }
}

/** Says nothing more until the server has told how things are: the connection is lost. */
export const hangUp = () => (heard = { ...heard, page: "" });

/** Says something to the server, if there is a connection. @param {import("./wire.js").FromPage} message */
export function send(message) {
  if (heard.page) post({ type: CARRIER, text: JSON.stringify(message) });
}
