// @ts-check
/**
 * From the positions of masses to the instances of coils, wedges, discs, pins, ring and ghost: arithmetic
 * only, without a page. Every kind of thing is one instanced node.
 *
 * @typedef {import("./plan.js").Plan} Plan
 * @typedef {import("./plan.js").Frame} Frame
 * @typedef {import("./plan.js").Damage} Damage
 * @typedef {object} Instances
 * @property {Float32Array} batched_positions three each
 * @property {Float32Array} batched_wxyzs four each
 * @property {Float32Array} batched_scales three each
 * @property {Uint8Array} [batched_colors] three each
 */
import {
  BELLY, BREATH, CREASE, FILL, FULL_DEVIATION, GHOST_WIDTH, HALO, PIN, RING, SHINE, THICKEST, THINNEST, WEDGE, WIDEST,
  YIELDED,
} from "./looks.js";
import { UNHARMED } from "./plan.js";
import { beatsAt, countMuscles, muscleAt, swings, waveAt } from "./swing.js";

// Depths: what is nearer is drawn over the rest.
const Z = { halo: -0.17, muscle: -0.16, pin: -0.15, spring: -0.12, yielded: -0.1, wedge: -0.06, ring: 0.0, rim: 0.02, mass: 0.03, shine: 0.04, ghost: 0.06 };
/** Size of what is not to be seen: an instance that is left out would be another one's. */
const VANISHED = 1e-6;
/** An angle in (-180, 180]. @param {number} degrees */
export const wrapped = (degrees) => degrees - 360 * Math.ceil((degrees - 180) / 360);

/** @param {number} count @returns {Instances} */
const instances = (count) => ({
  batched_positions: new Float32Array(3 * count),
  batched_wxyzs: new Float32Array(4 * count),
  batched_scales: new Float32Array(3 * count),
});

/**
 * @param {Instances} to
 * @param {number} i
 * @param {number} x
 * @param {number} y
 * @param {number} z
 * @param {number} angle about z, radians
 * @param {number} length
 * @param {number} width
 */
function put(to, i, x, y, z, angle, length, width) {
  to.batched_positions.set([x, y, z], 3 * i);
  to.batched_wxyzs[4 * i] = Math.cos(angle / 2);
  to.batched_wxyzs[4 * i + 3] = Math.sin(angle / 2);
  to.batched_scales.set([length, width, 1], 3 * i);
}

/**
 * Positions in the page's world.
 *
 * @param {Plan} plan
 * @param {Float32Array} positions px
 */
export function toWorld(plan, positions) {
  const world = new Float64Array(positions.length);
  for (let i = 0; i < positions.length; i += 2) {
    world[i] = (positions[i] - plan.x) * plan.scale;
    world[i + 1] = (positions[i + 1] - plan.y) * plan.scale * plan.flip;
  }
  return world;
}

/**
 * How far each joint is off its rest angle, degrees in (-180, 180].
 *
 * @param {Plan} plan
 * @param {Float32Array} positions px
 * @param {number} shift degrees added to all rest angles
 * @param {Damage} damage
 * @param {Float64Array} [turn] degrees that muscles add to each
 */
export function deviations(plan, positions, shift, damage = UNHARMED, turn) {
  const { springs, joints, restAngle } = plan;
  const result = new Float64Array(restAngle.length);
  /** @param {number} spring @returns {[number, number]} */
  const vector = (spring) => {
    const [a, b] = [2 * springs[2 * spring], 2 * springs[2 * spring + 1]];
    return [positions[b] - positions[a], positions[b + 1] - positions[a + 1]];
  };
  for (let j = 0; j < result.length; j++) {
    const [ax, ay] = vector(joints[4 * j]);
    const [bx, by] = vector(joints[4 * j + 1]);
    const angle = (Math.atan2(ax * by - ay * bx, ax * bx + ay * by) * 180) / Math.PI;
    result[j] = wrapped(angle - restAngle[j] - shift - (damage.setAngle[j] ?? 0) - (turn?.[j] ?? 0));
  }
  return result;
}

/**
 * The colours of a table for values from -1 to 1.
 *
 * @param {Float32Array} table
 * @param {Float64Array} values
 * @param {number} repeat how many instances each value colours
 */
function colored(table, values, repeat) {
  const last = table.length / 3 - 1;
  const colors = new Uint8Array(3 * values.length * repeat);
  values.forEach((value, i) => {
    const entry = 3 * Math.round(((Math.min(1, Math.max(-1, value)) + 1) / 2) * last);
    for (let k = i * repeat; k < (i + 1) * repeat; k++) {
      colors[3 * k] = table[entry];
      colors[3 * k + 1] = table[entry + 1];
      colors[3 * k + 2] = table[entry + 2];
    }
  });
  return colors;
}

/**
 * One of the plan's ink colours for every instance.
 *
 * @param {Plan} plan
 * @param {number} ink
 * @param {number} count
 */
function inked(plan, ink, count) {
  const colors = new Uint8Array(3 * count);
  for (let i = 0; i < count; i++) colors.set(plan.inkColors.subarray(3 * ink, 3 * ink + 3), 3 * i);
  return colors;
}

/**
 * @param {Plan} plan
 * @param {Frame} frame
 * @param {Float64Array} world
 * @param {Damage} damage
 * @returns {Instances}
 */
export function springs(plan, frame, world, damage = UNHARMED) {
  const count = plan.restLength.length;
  const result = instances(count);
  const strain = new Float64Array(count);
  const { stretch } = swings(plan, frame.time);
  for (let i = 0; i < count; i++) {
    const [a, b] = [2 * plan.springs[2 * i], 2 * plan.springs[2 * i + 1]];
    const [dx, dy] = [world[b] - world[a], world[b + 1] - world[a + 1]];
    const length = Math.hypot(dx, dy);
    const restLength = plan.restLength[i] * frame.lengthScale * (stretch[i] ?? 1) + (damage.setLength[i] ?? 0);
    const rest = Math.max(restLength * plan.scale, 1e-9);
    strain[i] = (length / rest - 1) / plan.fullStrain[plan.fullStrain.length > 1 ? i : 0];
    // A coil that is pulled far gets thinner, as a real one does, but never thicker than its masses.
    const part = plan.bars ? 1 : Math.min(THICKEST, Math.max(THINNEST, Math.sqrt(rest / length)));
    const [long, wide] = damage.broken.has(i) ? [VANISHED, VANISHED] : [length, part * plan.thickness[i]];
    put(result, i, world[a], world[a + 1], Z.spring, Math.atan2(dy, dx), long, wide);
  }
  return { ...result, batched_colors: colored(plan.strainColors, strain, 1) };
}

/**
 * What muscles are drawn as: bellies along springs, or halos around the masses of joints. They breathe: a belly is thick
 * and strong in colour while its muscle is short.
 *
 * @param {Plan} plan
 * @param {Frame} frame
 * @param {Float64Array} world
 * @param {boolean} ofJoints
 * @param {Damage} damage
 * @param {boolean} still whether they do not breathe
 * @returns {Instances}
 */
export function muscles(plan, frame, world, ofJoints, damage = UNHARMED, still = false) {
  const beats = beatsAt(plan, frame.time);
  const all = Array.from({ length: countMuscles(plan) }, (_, k) => muscleAt(plan, k));
  const some = all.filter(({ joint }) => joint === ofJoints);
  const result = instances(some.length);
  const breath = new Float64Array(some.length);
  some.forEach((muscle, k) => {
    const { part, amplitude } = muscle;
    breath[k] = still ? 0 : (ofJoints ? 1 : -1) * Math.sign(amplitude) * waveAt(muscle, beats);
    const grown = 1 + BREATH * breath[k];
    if (ofJoints) {
      const tip = plan.joints[4 * part + 2];
      const gone = damage.broken.has(plan.joints[4 * part]) || damage.broken.has(plan.joints[4 * part + 1]);
      const size = gone ? VANISHED : HALO * grown * plan.radius[tip];
      put(result, k, world[2 * tip], world[2 * tip + 1], Z.halo, 0, size, size);
    } else {
      const [a, b] = [2 * plan.springs[2 * part], 2 * plan.springs[2 * part + 1]];
      const [dx, dy] = [world[b] - world[a], world[b + 1] - world[a + 1]];
      const gone = damage.broken.has(part);
      const wide = BELLY * grown * plan.thickness[part] * (plan.bars ? 1 : 2);
      put(result, k, world[a], world[a + 1], Z.muscle, Math.atan2(dy, dx), gone ? VANISHED : Math.hypot(dx, dy), gone ? VANISHED : wide);
    }
  });
  return { ...result, batched_colors: colored(plan.muscleColors, breath, 1) };
}

/**
 * Lines along the springs that have yielded and are not broken.
 *
 * @param {Plan} plan
 * @param {Float64Array} world
 * @param {Damage} damage
 * @returns {Instances}
 */
export function yielded(plan, world, damage) {
  const count = plan.restLength.length;
  const result = instances(count);
  for (let i = 0; i < count; i++) {
    const [a, b] = [2 * plan.springs[2 * i], 2 * plan.springs[2 * i + 1]];
    const [dx, dy] = [world[b] - world[a], world[b + 1] - world[a + 1]];
    const marked = Math.abs(damage.setLength[i] ?? 0) > YIELDED * plan.restLength[i] && !damage.broken.has(i);
    const [long, wide] = marked ? [Math.hypot(dx, dy), CREASE * plan.thickness[i]] : [VANISHED, VANISHED];
    put(result, i, world[a], world[a + 1], Z.yielded, Math.atan2(dy, dx), long, wide);
  }
  return { ...result, batched_colors: inked(plan, 3, count) };
}

/**
 * Wedges from the rest angle to the present one, each of some thin triangles.
 *
 * @param {Plan} plan
 * @param {Frame} frame
 * @param {Float64Array} world
 * @param {Damage} damage
 * @returns {Instances}
 */
export function wedges(plan, frame, world, damage = UNHARMED) {
  const { slices, joints, springs } = plan;
  const off = deviations(plan, frame.positions, frame.angleShift, damage, swings(plan, frame.time).turn);
  const result = instances(off.length * slices);
  for (let j = 0; j < off.length; j++) {
    const [spring, tip, sense] = [joints[4 * j + 1], joints[4 * j + 2], joints[4 * j + 3]];
    const [a, b] = [2 * springs[2 * spring], 2 * springs[2 * spring + 1]];
    const present = Math.atan2((world[b + 1] - world[a + 1]) * sense, (world[b] - world[a]) * sense);
    const turn = ((off[j] * Math.PI) / 180) * plan.flip;
    const half = Math.min(Math.min(Math.abs(turn) / slices, 3) / 2, WIDEST);
    const gone = damage.broken.has(spring) || damage.broken.has(joints[4 * j]);
    const radius = gone ? VANISHED : WEDGE * plan.radius[tip];
    const reach = slices === 1 ? radius * Math.cos(half) : radius;
    for (let k = 0; k < slices; k++) {
      const middle = present - turn * (1 - (k + 0.5) / slices);
      put(result, j * slices + k, world[2 * tip], world[2 * tip + 1], Z.wedge, middle, reach, 2 * reach * Math.tan(half));
    }
  }
  const part = off.map((degrees) => degrees / FULL_DEVIATION);
  return { ...result, batched_colors: colored(plan.turnColors, part, slices) };
}

/**
 * Rims, then fills, then shines.
 *
 * @param {Plan} plan
 * @param {Float64Array} world
 * @returns {Instances}
 */
export function masses(plan, world) {
  const n = plan.radius.length;
  const result = instances(3 * n);
  for (let i = 0; i < n; i++) {
    const [x, y, radius] = [world[2 * i], world[2 * i + 1], plan.radius[i]];
    put(result, i, x, y, Z.rim, 0, radius, radius);
    put(result, n + i, x, y, Z.mass, 0, FILL * radius, FILL * radius);
    put(result, 2 * n + i, x - 0.3 * radius, y + 0.3 * radius, Z.shine, 0, SHINE * radius, SHINE * radius);
  }
  return { ...result, batched_colors: Uint8Array.from(plan.massColors) };
}

/**
 * @param {Plan} plan
 * @param {Float64Array} world
 * @returns {Instances}
 */
export function pins(plan, world) {
  const result = instances(plan.pinned.length);
  plan.pinned.forEach((mass, i) => {
    const size = PIN * plan.radius[mass];
    put(result, i, world[2 * mass], world[2 * mass + 1], Z.pin, 0, size, size);
  });
  return { ...result, batched_colors: inked(plan, 0, plan.pinned.length) };
}

/**
 * Around the driven mass.
 *
 * @param {Plan} plan
 * @param {Float64Array} world
 * @returns {Instances}
 */
export function ring(plan, world) {
  const result = instances(1);
  const size = RING * plan.radius[plan.driven];
  put(result, 0, world[2 * plan.driven], world[2 * plan.driven + 1], Z.ring, 0, size, size);
  return { ...result, batched_colors: inked(plan, 1, 1) };
}

/**
 * Thin bars for the springs of a second body.
 *
 * @param {Plan} plan
 * @param {Float64Array} world
 * @param {Damage} damage
 * @returns {Instances}
 */
export function ghost(plan, world, damage = UNHARMED) {
  const count = plan.restLength.length;
  const result = instances(count);
  for (let i = 0; i < count; i++) {
    const [a, b] = [2 * plan.springs[2 * i], 2 * plan.springs[2 * i + 1]];
    const [dx, dy] = [world[b] - world[a], world[b + 1] - world[a + 1]];
    const [long, wide] = damage.ghostBroken.has(i) ? [VANISHED, VANISHED] : [Math.hypot(dx, dy), GHOST_WIDTH];
    put(result, i, world[a], world[a + 1], Z.ghost, Math.atan2(dy, dx), long, wide);
  }
  return { ...result, batched_colors: inked(plan, 2, count) };
}
