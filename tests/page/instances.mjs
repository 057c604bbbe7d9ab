// Reads lines {plan, frame} from standard input and writes, for each, what the page would draw.
import { createInterface } from "node:readline";
import * as draw from "../../app/page/static/draw.js";
import { readFrame, readPlan } from "../../app/page/static/plan.js";

const plain = (instances) =>
  Object.fromEntries(Object.entries(instances).map(([name, array]) => [name.replace("batched_", ""), [...array]]));

for await (const line of createInterface({ input: process.stdin })) {
  const data = JSON.parse(line);
  const [plan, frame] = [readPlan(new Float32Array(data.plan)), readFrame(new Float32Array(data.frame))];
  const world = draw.toWorld(plan, frame.positions);
  console.log(
    JSON.stringify({
      springs: plain(draw.springs(plan, frame, world)),
      wedges: plain(draw.wedges(plan, frame, world)),
      masses: plain(draw.masses(plan, world)),
      pins: plain(draw.pins(plan, world)),
      ring: plan.driven < 0 ? null : plain(draw.ring(plan, world)),
      ghost: frame.ghost ? plain(draw.ghost(plan, draw.toWorld(plan, frame.ghost))) : null,
      deviations: [...draw.deviations(plan, frame.positions, frame.angleShift)],
    }),
  );
}
