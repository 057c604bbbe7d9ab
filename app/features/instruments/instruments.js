// @ts-check
/** What is measured on the canvas: arrows, traces, coordinates, and the box of instruments. */
import { addArrows } from "./arrow_marks.js";
import { addCoordinates } from "./coordinates.js";
import { hearTools } from "./tools.js";
import { addInstruments } from "./toolbox.js";
import { addTraces } from "./trace.js";

function begin() {
  hearTools();
  addTraces();
  addArrows();
  addCoordinates();
  addInstruments();
}

/** @type {import("../../ui/feature.js").Feature<"instruments">} */
export default { commands: {}, begin };
