// @ts-check
/**
 * Messages between the page and the server, listed in docs/wire.md. They travel through viser's connection, in one kind of
 * message that viser's page never sees.
 *
 * @typedef {import("./wire.js").Received} Received
 * @typedef {object} Message as it travels
 * @property {string} type
 * @property {string} [text]
 * @property {Float32Array} [numbers]
 *
 * @typedef {{type: string, [field: string]: any}} OfViser a message of viser's own kinds
 */
/** The type of viser's messages that carry softrod's. */
const CARRIER = "SoftrodMessage";
/** Sends a message by the present connection. @type {(message: Message | OfViser) => void} */
let post = () => {};
/** @type {Partial<import("./wire.js").PageState>} */
let state = {};
/** @type {Map<string, ((message: any) => void)[]>} */
const listeners = new Map();

/** What handles viser's own messages in place of viser's page. @type {Map<string, (message: OfViser) => void>} */
const takers = new Map();

/** Sets how messages are sent. @param {typeof post} sender */
export const sendBy = (sender) => void (post = sender);

/** The state of the page that the server sent last. */
export const pageState = () => state;

/** True if the page has a control. @param {string} control */
export const has = (control) => state.controls?.includes(control) ?? false;

/**
 * Calls back with every message of a kind from the server.
 *
 * @template {keyof Received} K
 * @param {K} kind
 * @param {(message: Received[K]) => void} listener
 */
export function onMessage(kind, listener) {
  listeners.set(kind, [...(listeners.get(kind) ?? []), listener]);
}

/**
 * Handles messages of one of viser's kinds, which viser's page then never sees.
 *
 * @param {string} type
 * @param {(message: OfViser) => void} take
 */
export const takeOver = (type, take) => void takers.set(type, take);

/**
 * Hands a message to the script, if it is softrod's or of a kind that softrod has taken over.
 *
 * @param {Message} received
 * @returns {boolean} true if it was
 */
export function receive(received) {
  const { type, text, numbers } = received;
  const take = takers.get(type);
  if (take) callAll([take], received);
  if (type !== CARRIER) return take !== undefined;
  const message = { ...JSON.parse(text ?? "{}"), ...(numbers && { numbers }) };
  if (message.tell === "pageState") state = message;
  callAll(listeners.get(message.tell) ?? [], message);
  return true;
}

/**
 * Calls each of some functions; one that throws is reported and does not stop the others.
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

/** Stops sending until the next `pageState`: the connection is lost. */
export const stopSending = () => (state = { ...state, page: "" });

/** Sends a message of one of viser's kinds, if there is a connection. @param {OfViser} message */
export function answer(message) {
  if (state.page) post(message);
}

/** Sends a message to the server, if there is a connection. @param {import("./wire.js").FromPage} message */
export function send(message) {
  if (state.page) post({ type: CARRIER, text: JSON.stringify(message) });
}
