// @ts-check
/** Hands on the body, by keys, mouse, touch and pen. Begins after features whose tools handle keys and pointers first. */
import { addPad } from "../../ui/hands/arrow_pad.js";
import { addBodyKeys } from "../../ui/hands/body_keys.js";
import { listenToKeys } from "../../ui/hands/keys.js";
import { listenToPointer } from "../../ui/hands/pointer.js";

function begin() {
  listenToKeys();
  listenToPointer();
  addBodyKeys();
  addPad();
}

/** @type {import("../../ui/feature.js").Feature<"hands">} */
export default { commands: {}, begin };
