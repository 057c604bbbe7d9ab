// Moves bodies by the script of live files: reads one JSON object a line, writes the positions that each leads to.
import { createInterface } from "node:readline";
import { Body } from "../../app/export/live/static/body.js";
import { StabilityMeter } from "../../app/export/live/static/stability.js";
import { advance } from "../../app/export/live/static/steps.js";

for await (const line of createInterface({ input: process.stdin })) {
  const { data, method, h, count, presses } = JSON.parse(line);
  const body = new Body(data);
  const limit = new StabilityMeter(new Body(data), method).look();
  advance(body, method, h, count, [], presses);
  console.log(JSON.stringify({ positions: [...body.positions], broken: [...body.broken], setLength: [...body.setLength], limit: Math.min(limit, 1) }));
}
