// @ts-check
/**
 * Number boxes: what is typed is set at Enter, on leaving the box or after a pause, never at every key. Half a number
 * is another number: on its way to 150000 a stiffness would be 15, and springs would break.
 *
 * While a box is being typed in, React hears of no input and cannot write into it. What is set is handed to it as if
 * it had been typed at once.
 */
import { send } from "../../wire/channel.js";
import { NUMBER_BOX, SLIDER } from "./widgets.js";

/** Milliseconds without a key after which what was typed is set. */
const PAUSE = 2000;
/** Letters of a text that cannot be read, as far as they are told. */
const TOLD = 40;

/** What may be a decimal comma or one that parts thousands. */
const EITHER = /^[+-]?[1-9]\d{0,2},\d{3}$/;
const GROUPED = /^\d{1,3}([.,])\d{3}(\1\d{3})*$/;

/**
 * The number that a text means, or NaN: with a decimal point or comma, with an exponent, and with spaces, commas or
 * points between groups of three digits. A comma alone before three digits could be either, and is not read.
 *
 * @param {string} text
 */
export function readNumber(text) {
  const plain = text.trim().replace(/\u2212/g, "-").replace(/(\d)[\s'\u2019](?=\d{3}(?!\d))/g, "$1");
  const [, sign = "", digits = "", exponent = ""] = /^([+-]?)([\d.,]*\d[.,]?)(e[+-]?\d+)?$/i.exec(plain) ?? [];
  if (!digits || EITHER.test(plain)) return NaN;
  const last = digits.replace(/\d/g, "").slice(-1);
  const [whole = "", fraction = "", ...more] = last ? digits.split(last) : [digits];
  // A mark that stands more than once parts thousands.
  const before = more.length ? digits : whole;
  if (/[.,]/.test(before) && !GROUPED.test(before)) return NaN;
  const number = Number(`${sign}${before.replace(/[.,]/g, "") || "0"}.${(more.length ? "" : fraction) || "0"}${exponent}`);
  return Number.isFinite(number) ? number : NaN;
}

/** A number as a box takes it: without an exponent. @param {number} number */
export const plainText = (number) => number.toLocaleString("en-US", { useGrouping: false, maximumFractionDigits: 20 });

/** @param {EventTarget | null} target @returns {HTMLInputElement | null} */
const boxOf = (target) =>
  target instanceof HTMLInputElement && target.closest(NUMBER_BOX) ? target : null;

const native = () =>
  /** @type {{get(): string, set(text: string): void}} */ (
    Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, "value")
  );
/** What a box really has. @param {HTMLInputElement} box */
const read = (box) => native().get.call(box);
/** Changes that without React's knowing. @param {HTMLInputElement} box @param {string} text */
const write = (box, text) => native().set.call(box, text);

/** What is being typed into a box and is not set yet. */
class Draft {
  /** @param {HTMLInputElement} box */
  constructor(box) {
    this.box = box;
    this.had = box.value;
    /** What the page wants to show in the box meanwhile. @type {string | undefined} */
    this.wanted = undefined;
    /** React's own property, by which it knows what the box has. */
    this.tracked = Object.getOwnPropertyDescriptor(box, "value");
    Object.defineProperty(box, "value", {
      configurable: true,
      get: () => read(box),
      set: (text) => {
        if (String(text) !== this.text) this.wanted = String(text);
      },
    });
    box.classList.add("softrod-draft");
  }

  get text() {
    return read(this.box);
  }

  /** Has what was typed set after a pause, counted from now. */
  wait() {
    clearTimeout(this.timer);
    this.timer = setTimeout(setAndGoOn, PAUSE);
  }

  /** Gives the box back to React, with what that wants to show. */
  end() {
    clearTimeout(this.timer);
    const { box, had, wanted, tracked } = this;
    box.classList.remove("softrod-draft");
    if (tracked) Object.defineProperty(box, "value", tracked);
    else delete (/** @type {any} */ (box).value);
    if (wanted === undefined) write(box, had);
    else box.value = wanted;
  }
}

/** @type {Draft | null} */
let draft = null;
/** Whether the input that is heard of is the script's own. */
let handing = false;

/** Puts back what the box had, or what it is to have by now. */
function drop() {
  draft?.end();
  draft = null;
}

/** Sets what was typed; what cannot be read is told. */
function settle() {
  if (!draft) return;
  const { box, text: typed } = draft;
  const number = readNumber(typed);
  drop();
  if (Number.isNaN(number)) {
    if (typed.trim()) send({ do: "unread", text: typed.trim().slice(0, TOLD) });
    return;
  }
  // Emptied first: the library finds out what was typed by where the caret was at the last key.
  for (const text of ["", plainText(number)]) hand(box, text);
}

/** Has React take a text for typed. @param {HTMLInputElement} box @param {string} text */
function hand(box, text) {
  handing = true;
  write(box, text);
  box.dispatchEvent(new Event("input", { bubbles: true }));
  handing = false;
}

/** Sets what was typed, if that may be all of it, and leaves the text as it is for its user to go on. */
function setAndGoOn() {
  if (!draft) return;
  const { box, text } = draft;
  if (!/\d$/.test(text) || Number.isNaN(readNumber(text))) return;
  const { selectionStart, selectionEnd } = box;
  settle();
  if (document.activeElement !== box) return;
  draft = new Draft(box);
  write(box, text);
  box.setSelectionRange(selectionStart, selectionEnd);
}

/** What is changed from here on is another step of undo. */
const visit = () => send({ do: "visit" });

/** Begins to listen. */
export function mindNumbers() {
  document.addEventListener(
    "beforeinput",
    ({ target, inputType }) => {
      const box = boxOf(target);
      if (!box || draft?.box === box || inputType === "insertLineBreak") return; // that is Enter
      settle();
      draft = new Draft(box);
    },
    true,
  );
  for (const kind of /** @type {const} */ (["input", "change"])) {
    document.addEventListener(
      kind,
      (event) => {
        if (!draft || draft.box !== event.target || handing) return;
        event.stopImmediatePropagation();
        draft.wait();
      },
      true,
    );
  }
  window.addEventListener(
    "keydown",
    ({ key, target, isComposing }) => {
      if (!draft || draft.box !== target || isComposing) return;
      if (key === "Escape") drop();
      else if (["Enter", "ArrowUp", "ArrowDown"].includes(key)) settle();
    },
    true,
  );
  document.addEventListener("focusout", settle, true);
  document.addEventListener("focusin", ({ target }) => {
    if (target instanceof Element && target.closest(`${SLIDER}, ${NUMBER_BOX}`)) visit();
  });
  document.addEventListener(
    "pointerdown",
    ({ target }) => {
      if (draft && target !== draft.box) settle();
      if (target instanceof Element && target.closest(SLIDER)) visit();
    },
    true,
  );
}
