// @ts-check
/** Reads arrays of numbers by the tables of sections by which Python writes them (app/wire/sections.py). */
import { LAYOUTS } from "./layouts.js";

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
  for (const section of LAYOUTS[kind]) {
    const values = take();
    if (typeof section === "string") found[section] = values;
    else for (const [i, name] of section.entries()) found[name.replace("?", "")] = name.endsWith("?") ? values[i] === 1 : (values[i] ?? 0);
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
