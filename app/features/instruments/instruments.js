// @ts-check
/** What is measured on the canvas: arrows, traces, a stroboscope, coordinates, and the box of instruments. */
import { addArrows } from "./arrow_marks.js";
import { addCoordinates } from "./coordinates.js";
import { hearTools } from "./tools.js";
import { addInstruments } from "./toolbox.js";
import { addStrobe } from "./strobe.js";
import { addTraces } from "./trace.js";

function begin() {
  hearTools();
  addStrobe();
  addTraces();
  addArrows();
  addCoordinates();
  addInstruments();
}

/** @type {import("../../ui/feature.js").Feature<"instruments">} */
export default { commands: {}, begin };
