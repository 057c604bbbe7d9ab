// @ts-check
/** The sections of arrays of numbers. Made by `uv run python -m tests.page.generate` from the messages. */

/**
 * By the tags of messages: names of sections, or of the numbers of one; flags end in "?".
 *
 * @type {Record<keyof import("./wire.js").Layouts, (string | string[])[]>}
 */
export const LAYOUTS = {
  readings: [["opening", "time"], "values"],
  arrows: [["generation", "time", "step", "jointStep"], "least", "held", "forces", "velocities", "torques"],
  plan: [["generation", "scale", "x", "y", "flip", "many?", "bars?", "slices", "driven"], "radius", "springs", "restLength", "thickness", "fullStrain", "joints", "restAngle", "pinned", "massColors", "strainColors", "turnColors", "inkColors", "walls", "belts", "rails", "fillings", "wind", ["contact"], "ropes", "buffers", "stops", "loads", "muscles", "muscleColors", ["medium?", "ground?"], "motors", "pushes"],
  frame: [["generation", "time", "lengthScale", "angleShift", "timeRest"], "positions", "ghost", "secondMoment", "secondPositions", "efforts", "secondEfforts"],
  damage: [["generation"], "broken", "setLength", "setAngle", "ghostBroken", "secondBroken", "secondSetLength", "secondSetAngle"],
};
