// The English words, for modules of the page that run without one: `node --import ./tests/page/words.mjs`.
import { readdirSync, readFileSync } from "node:fs";

const folder = new URL("../../app/words/en/", import.meta.url);
const text = readdirSync(folder).map((name) => readFileSync(new URL(name, folder), "utf-8")).join("\n");
globalThis.softrodWords = { language: "en", direction: "ltr", text };
