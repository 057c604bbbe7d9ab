// @ts-check
/** Reads arrays of numbers by the tables of sections by which Python writes them (app/wire/sections.py). */
import { LAYOUTS } from "./layouts.js";

/** The layouts, in which flags are found once instead of in each frame. */
const TABLES = Object.fromEntries(
  Object.entries(LAYOUTS).map(([kind, layout]) => [
    kind,
    layout.map((section) =>
      typeof section === "string" ? section : section.map((name) => ({ name: name.replace("?", ""), isFlag: name.endsWith("?") })),
    ),
  ]),
);

/**
 * The sections of an array by their names. Those missing at the end are empty, and their numbers 0.
 *
 * @template {keyof import("./wire.js").Layouts} K
 * @param {K} kind
 * @param {Float32Array} data
 * @returns {import("./wire.js").Layouts[K]}
 */
export function unpack(kind, data) {
  const take = sections(data);
  /** @type {any} */
  const found = {};
  for (const section of TABLES[kind]) {
    const values = take();
    if (typeof section === "string") found[section] = values;
    else for (const [i, { name, isFlag }] of section.entries()) found[name] = isFlag ? values[i] === 1 : (values[i] ?? 0);
  }
  return found;
}

/** Returns a function that reads one section after the other. @param {Float32Array} data sections, each after its length */
export function sections(data) {
  let at = 0;
  return () => {
    const length = data[at] ?? 0;
    const section = data.subarray(at + 1, at + 1 + length);
    at += 1 + length;
    return section;
  };
}
