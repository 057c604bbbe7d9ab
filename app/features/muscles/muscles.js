// @ts-check
/** The strip of muscles. */
import { addMuscles } from "./strip.js";

/** @type {import("../../ui/feature.js").Feature<"muscles">} */
export default { commands: {}, begin: addMuscles };
