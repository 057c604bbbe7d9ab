// @ts-check
/** The form in which a lesson is made. */
import { addMaker } from "./maker.js";

/** @type {import("../../ui/feature.js").Feature<"making">} */
export default { commands: {}, begin: addMaker };
