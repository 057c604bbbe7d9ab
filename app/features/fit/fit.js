// @ts-check
/** The points of a table over the body. */
import { addMeasured } from "./measured.js";

/** @type {import("../../ui/feature.js").Feature<"fit">} */
export default { commands: {}, begin: addMeasured };
