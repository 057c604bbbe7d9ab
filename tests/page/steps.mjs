// Moves bodies by the script of live files: reads one JSON object a line, writes where each is led to, and what is measured.
import { createInterface } from "node:readline";
import { Body } from "../../app/export/live/static/body.js";
import { measure } from "../../app/export/live/static/quantities.js";
import { write } from "../../app/export/live/static/settings.js";
import { StabilityMeter } from "../../app/export/live/static/stability.js";
import { advance } from "../../app/export/live/static/steps.js";

for await (const line of createInterface({ input: process.stdin })) {
  const { data, method, h, count, presses, set = [], measures = [] } = JSON.parse(line);
  const body = new Body(data);
  for (const [setting, value] of set) write(body, setting, value);
  const limit = new StabilityMeter(new Body(data), method).look();
  advance(body, method, h, count, [], presses);
  console.log(JSON.stringify({ positions: [...body.positions], broken: [...body.broken], setLength: [...body.setLength], measured: measures.map((name) => measure(body, name)), limit: Math.min(limit, 1) }));
}
