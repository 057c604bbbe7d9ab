// @ts-check
/** A sentence on an empty canvas, and a button for the tool that draws a body. */
import { access } from "../ui/access.js";
import { make, makeButton, overCanvas } from "../ui/dialog.js";
import { editing, isEditable, onEditing, setEditing, setTool } from "../features/edit/editing.js";
import { say } from "../words/words.js";
import { onMarksRedraw, redrawMarks } from "./sight.js";

/** Its place from the top, as a part of the canvas above the bar of time. */
const HEIGHT = 0.62;

/** Adds it to the page, hidden. */
export function addEmpty() {
  const note = make("div", "softrod-empty");
  const text = make("p", "");
  const button = makeButton(say("stage-empty.draw"), () => {
    setEditing(true);
    setTool("build");
    button.blur(); // keys act on the tools
  });
  button.classList.add("softrod-first");
  note.append(text, button);
  overCanvas().append(note);
  const touch = matchMedia("(pointer: coarse)");
  const building = () => editing.on && editing.tool === "build";
  onEditing(redrawMarks);
  onMarksRedraw(({ plan, box, floor }) => {
    note.hidden = !isEditable() || plan.radius.length > 1 || plan.springs.length > 0 || (editing.on && !building());
    if (note.hidden) return;
    text.textContent = say(!building() ? "stage-empty" : access().taps ? "stage-empty.taps" : touch.matches ? "stage-empty.tap" : "stage-empty.click");
    button.hidden = building();
    note.style.left = `${box.left + box.width / 2}px`;
    note.style.top = `${box.top + HEIGHT * (floor - box.top)}px`;
    note.style.maxWidth = `${0.8 * box.width}px`;
  });
}
