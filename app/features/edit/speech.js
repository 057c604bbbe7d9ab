// @ts-check
/** What editing says to a screen reader. */
import { addTeller } from "../../ui/dialog.js";

/** Milliseconds in which the last of several things is said: of what was built, that is not also said to be selected. */
const SETTLES = 60;

/** @type {(text: string) => void} */
let speak = () => {};
/** The timer of what is said next. */
let saying = 0;

/** Says something; the same words again, too. @param {string} text */
export function tell(text) {
  clearTimeout(saying);
  saying = setTimeout(() => speak(text), SETTLES);
}

/** Makes the region that is read out. */
export function addSpeech() {
  speak = addTeller();
}
