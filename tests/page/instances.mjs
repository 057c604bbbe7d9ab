// Reads lines {plan, frame, damage} from standard input and writes, for each, what the page would draw.
import { createInterface } from "node:readline";
import * as draw from "../../app/stage/draw.js";
import { airAt, loops, outline, resisting, skin, wallInView } from "../../app/stage/environment.js";
import { swings } from "../../app/stage/swing.js";
import { readDamage, readFrame, readPlan } from "../../app/stage/plan.js";

const plain = (instances) =>
  Object.fromEntries(Object.entries(instances).map(([name, array]) => [name.replace("batched_", ""), [...array]]));

for await (const line of createInterface({ input: process.stdin })) {
  const data = JSON.parse(line);
  const [plan, frame] = [readPlan(new Float32Array(data.plan)), readFrame(new Float32Array(data.frame))];
  const damage = readDamage(new Float32Array(data.damage));
  const body = { plan, frame, world: draw.toWorld(plan, frame.positions), damage };
  // A screen whose pixels are px of the scene, for outlines.
  const on = { x: plan.x, y: plan.y, step: 1 / plan.scale };
  const places = Float64Array.from(frame.positions, (value, i) => (i % 2 ? plan.y - (value - plan.y) * plan.flip : value));
  const view = { left: 0, right: 600, top: 0, bottom: 600 };
  console.log(
    JSON.stringify({
      ...Object.fromEntries(Object.entries(draw.NODES).map(([name, node]) => [name, node.has?.(body) ?? true ? plain(node.draw(body)) : null])),
      deviations: [...draw.deviations(plan, frame.positions, frame.angleShift, damage, swings(plan, frame).turn)],
      sizes: [plan.walls.length, plan.fillings.length, plan.wind.length],
      outlines: {
        ...resisting(plan, on, view),
        wall: plan.walls.length ? outline(wallInView(plan, plan.walls, 0, on, view).corners) : "",
        gas: loops(plan, places, true, damage.broken),
        liquid: loops(plan, places, false, damage.broken),
        skin: plan.contact ? skin(plan, places, damage.broken) : "",
      },
      air: plan.wind.length ? Object.values(airAt(plan.wind, 120, 250)) : [],
    }),
  );
}
