// @ts-check
/**
 * The fold of a lesson from which its answers are handed in, as a file or as a QR code. Nothing is sent.
 *
 * @typedef {import("./answers.js").Sheet} Sheet
 */
import { make, makeButton, untranslated } from "../../../ui/dialog.js";
import { download } from "../../../ui/download.js";
import { language, say } from "../../../words/words.js";
import { element } from "../../static/parts.js";
import { packed } from "./answers.js";
import { qrCode } from "./qr.js";

/** Letters of a name, as a class takes them. */
const MAX_NAME = 20;
/** Modules of light paper around a QR code. */
const QUIET = 4;

/** A field for a line of text. @param {string} label @param {string} value @param {number} most letters @param {(text: string) => void} take */
export function lineField(label, value, most, take) {
  const box = make("label", "softrod-line", label);
  const input = make("input", "");
  Object.assign(input, { maxLength: most, value, autocomplete: "off" });
  input.addEventListener("input", () => take(input.value.trim()));
  box.append(input);
  return box;
}

/**
 * Show the fold.
 *
 * @param {() => Sheet} sheet the answers as they are now @param {import("./answers.js").Frame} frame of the scene
 * @param {(name: string) => void} rename
 */
export function addHandIn(sheet, frame, rename) {
  const box = element("answers", HTMLDetailsElement);
  box.hidden = false;
  const canvas = make("canvas", "qr");
  canvas.setAttribute("role", "img");
  canvas.ariaLabel = say("live-qr");
  const text = untranslated(make("code", ""));
  const note = make("p", "");
  const draw = () => {
    const { text: letters, left } = packed(sheet(), frame);
    text.textContent = letters;
    const told = { letters: letters.length };
    note.textContent = left.length
      ? say("live-qr.left", { ...told, left: new Intl.ListFormat(language).format(left) })
      : say("live-qr.text", told);
    paintQr(canvas, qrCode(letters));
  };
  const name = lineField(say("live-name"), sheet().name, MAX_NAME, (typed) => {
    rename(typed);
    draw();
  });
  name.querySelector("input")?.setAttribute("autocomplete", "nickname");
  const button = makeButton(say("live-save"), () => save(sheet()), "softrod-button softrod-first");
  box.addEventListener("toggle", () => box.open && draw());
  // The browser had taken its memory back.
  canvas.addEventListener("contextrestored", () => box.open && draw());
  box.append(make("p", "", say("live-leaves")), name, button, canvas, note, text);
  // What is answered while it is open.
  document.addEventListener("click", () => box.open && draw());
}

/** @param {Sheet} sheet */
function save(sheet) {
  const name = (sheet.name || sheet.id).replace(/[^\p{L}\p{N}]+/gu, "-");
  download(new Blob([JSON.stringify(sheet)], { type: "application/json" }), `answers-${name}.json`);
}

/** @param {HTMLCanvasElement} canvas @param {boolean[][]} modules */
function paintQr(canvas, modules) {
  const to = canvas.getContext("2d");
  if (!to) return;
  canvas.width = canvas.height = modules.length + 2 * QUIET;
  to.fillStyle = "#fff";
  to.fillRect(0, 0, canvas.width, canvas.height);
  to.fillStyle = "#000";
  modules.forEach((line, row) => line.forEach((dark, column) => dark && to.fillRect(column + QUIET, row + QUIET, 1, 1)));
}
