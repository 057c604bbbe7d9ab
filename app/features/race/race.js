// @ts-check
/** A race of bodies, whose strip is loaded at the first one. */
import { hearLater } from "../../wire/later.js";

const strip = () => import("./strip.js");

const begin = () => hearLater(["race", "raceAnswer"], (message) => message.tell === "raceAnswer" || Boolean(message.on), async () => (await strip()).hear);

/** @type {import("../../ui/feature.js").Feature<"race">} */
export default { commands: { race: async () => (await strip()).openRace() }, begin };
