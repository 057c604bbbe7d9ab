// @ts-check
/**
 * Number boxes: a number is set at Enter, on leaving the box or after a pause, never at every key. Half a number is another
 * number: on its way to 150000 a stiffness would be 15, and springs would break.
 *
 * While a user types into a box, React gets no input events and cannot write into it. The finished number is handed to it as
 * if it had been typed at once.
 */
import { send } from "../../wire/channel.js";
import { NUMBER_BOX, SLIDER } from "./widgets.js";

/** Milliseconds without a key before the number is set. */
const PAUSE = 2000;
/** Characters of an unreadable text that are shown to the user. */
const SHOWN = 40;

/** A comma that may be a decimal comma or separate thousands. */
const AMBIGUOUS_COMMA = /^[+-]?[1-9]\d{0,2},\d{3}$/;
const GROUPED = /^\d{1,3}([.,])\d{3}(\1\d{3})*$/;

/**
 * Reads a number, or NaN: with a decimal point or comma, with an exponent, and with spaces, commas or points between groups
 * of three digits. A single comma before three digits is ambiguous, and not read.
 *
 * @param {string} text
 */
export function readNumber(text) {
  const plain = text.trim().replace(/\u2212/g, "-").replace(/(\d)[\s'\u2019](?=\d{3}(?!\d))/g, "$1");
  const [, sign = "", digits = "", exponent = ""] = /^([+-]?)([\d.,]*\d[.,]?)(e[+-]?\d+)?$/i.exec(plain) ?? [];
  if (!digits || AMBIGUOUS_COMMA.test(plain)) return NaN;
  const last = digits.replace(/\d/g, "").slice(-1);
  const [whole = "", fraction = "", ...more] = last ? digits.split(last) : [digits];
  // A mark that occurs more than once separates thousands.
  const before = more.length ? digits : whole;
  if (/[.,]/.test(before) && !GROUPED.test(before)) return NaN;
  const number = Number(`${sign}${before.replace(/[.,]/g, "") || "0"}.${(more.length ? "" : fraction) || "0"}${exponent}`);
  return Number.isFinite(number) ? number : NaN;
}

/** A number without an exponent, for a box. @param {number} number */
export const plainText = (number) => number.toLocaleString("en-US", { useGrouping: false, maximumFractionDigits: 20 });

/** @param {EventTarget | null} target @returns {HTMLInputElement | null} */
const boxOf = (target) =>
  target instanceof HTMLInputElement && target.closest(NUMBER_BOX) ? target : null;

const native = () =>
  /** @type {{get(): string, set(text: string): void}} */ (
    Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, "value")
  );
/** The real value of a box. @param {HTMLInputElement} box */
const read = (box) => native().get.call(box);
/** Changes it unnoticed by React. @param {HTMLInputElement} box @param {string} text */
const write = (box, text) => native().set.call(box, text);

/** A number that is being typed into a box and not set yet. */
class Draft {
  /** @param {HTMLInputElement} box */
  constructor(box) {
    this.box = box;
    this.had = box.value;
    /** The value that React has meanwhile tried to show. @type {string | undefined} */
    this.wanted = undefined;
    /** React's own property, by which it follows the value. */
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

  /** Sets the number after a pause, counted from now. */
  wait() {
    clearTimeout(this.timer);
    this.timer = setTimeout(setAndGoOn, PAUSE);
  }

  /** Gives the box back to React, with the value that it wants to show. */
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
/** True during an input event of this script. */
let handing = false;

/** Discards the draft, and shows the present value. */
function drop() {
  draft?.end();
  draft = null;
}

/** Sets the number; if it cannot be read, the user gets a notice. */
function settle() {
  if (!draft) return;
  const { box, text: typed } = draft;
  const number = readNumber(typed);
  drop();
  if (Number.isNaN(number)) {
    if (typed.trim()) send({ do: "unread", text: typed.trim().slice(0, SHOWN) });
    return;
  }
  // Emptied first: the library derives what was typed from the position of the caret at the last key.
  for (const text of ["", plainText(number)]) hand(box, text);
}

/** Hands a text to React as if it had been typed. @param {HTMLInputElement} box @param {string} text */
function hand(box, text) {
  handing = true;
  write(box, text);
  box.dispatchEvent(new Event("input", { bubbles: true }));
  handing = false;
}

/** Sets the number if it may be complete, but leaves the text as it is, so that the user can go on. */
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

/** Begins another step of undo. */
const visit = () => send({ do: "visit" });

/** Begins to listen. */
export function listenToNumbers() {
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
