// @ts-check
/** What to do on a canvas where there is nothing but one mass: a sentence, and the tool that draws a body. */
import { make, makeButton } from "../ui/dialog.js";
import { editing, isEditable, onEditing, setEditing, setTool } from "../features/edit/editing.js";
import { onMarksRedraw, redrawMarks } from "./sight.js";

/** How far down it stands, as a part of the canvas above the bar of time. */
const LOW = 0.62;

/** What to do: before the tool is taken, and with it. */
const BEFORE = "Nothing is built here yet.";
const [CLICK, TAP] = ["Click", "Tap"].map((press) => `${press} for a mass. Drag from a mass for a spring.`);

/** Puts it up, hidden. */
export function addEmpty() {
  const note = make("div", "softrod-empty");
  const text = make("p", "");
  const button = makeButton("Draw a body", () => {
    setEditing(true);
    setTool("build");
    button.blur(); // the keys are the tools' now
  });
  button.classList.add("softrod-first");
  note.append(text, button);
  document.body.append(note);
  const touch = matchMedia("(pointer: coarse)");
  const building = () => editing.on && editing.tool === "build";
  onEditing(redrawMarks);
  onMarksRedraw(({ plan, box, floor }) => {
    note.hidden = !isEditable() || plan.radius.length > 1 || plan.springs.length > 0 || (editing.on && !building());
    if (note.hidden) return;
    text.textContent = !building() ? BEFORE : touch.matches ? TAP : CLICK;
    button.hidden = building();
    note.style.left = `${box.left + box.width / 2}px`;
    note.style.top = `${box.top + LOW * (floor - box.top)}px`;
    note.style.maxWidth = `${0.8 * box.width}px`;
  });
}
