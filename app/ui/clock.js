// @ts-check
/** Simulated time as the page shows it, and the command of the step button. */
import { shown } from "../stage/canvas.js";
import { pageState } from "../wire/channel.js";
import { awaySince } from "./away.js";

/** The simulated time, s. A body at rest sends no pictures, but its time goes on while there is a connection. */
export function timeNow() {
  const { frame, since } = shown();
  const passed = pageState().rest ? (Math.max(0, Math.min(performance.now(), awaySince()) - since) / 1e3) * (pageState().speed ?? 1) : 0;
  return (frame?.time ?? 0) + passed;
}

/** The command of the step button: in the past the next frame, otherwise a step. */
export const nextStep = () => (pageState().scrubbed ? "forward" : "step");
