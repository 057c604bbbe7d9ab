// Moves bodies by the script of live files: reads one JSON object a line, writes where each is led to, and what is measured. With a
// program in JavaScript as its argument, it says whether that moves them by the tutorial's step to the very same places.
import { createInterface } from "node:readline";
import { pathToFileURL } from "node:url";
import { Body } from "../../app/export/live/static/body.js";
import { addDerived, measure } from "../../app/export/live/static/quantities.js";
import { write } from "../../app/export/live/static/settings.js";
import { StabilityMeter } from "../../app/export/live/static/stability.js";
import { advance } from "../../app/export/live/static/steps.js";

const { SoftBody } = process.argv[2] ? await import(pathToFileURL(process.argv[2])) : {};

/** Whether the program's body comes to the same places, in one call or in several. */
function same(data, h, count, positions) {
  const body = new SoftBody(data, h);
  body.step();
  for (let done = 1; done < count; done += 100) body.step(Math.min(100, count - done));
  return body.positions.every((value, i) => Object.is(value, positions[i]));
}

for await (const line of createInterface({ input: process.stdin })) {
  const { data, method, h, count, presses, set = [], measures = [], derived = {} } = JSON.parse(line);
  addDerived(derived);
  const body = new Body(data);
  for (const [setting, value] of set) write(body, setting, value);
  const limit = new StabilityMeter(new Body(data), method).look();
  advance(body, method, h, count, [], presses);
  console.log(JSON.stringify({
    positions: [...body.positions], broken: [...body.broken], setLength: [...body.setLength], limit: Math.min(limit, 1),
    measured: measures.map((name) => measure(body, name)),
    same: SoftBody && method === "symplectic_euler" ? [same(data, h, count, body.positions)] : [],
  }));
}
