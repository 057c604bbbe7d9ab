// @ts-check
/** The page's clock, and where its next step leads. */
import { shown } from "../stage/canvas.js";
import { pageState } from "../wire/channel.js";
import { awaySince } from "./away.js";

/** The simulated time. A body at rest sends no pictures, but its clock goes on, while there is a connection. */
export function timeNow() {
  const { frame, since } = shown();
  const passed = pageState().rest ? (Math.max(0, Math.min(performance.now(), awaySince()) - since) / 1e3) * (pageState().speed ?? 1) : 0;
  return (frame?.time ?? 0) + passed;
}

/** What the step button does: in the past, go on to the next frame; else make a step. */
export const nextStep = () => (pageState().scrubbed ? "forward" : "step");
