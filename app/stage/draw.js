// @ts-check
/**
 * Instances of coils, wedges, discs, pins, ring and ghost from the positions of masses: arithmetic only, without a
 * page. All parts of a kind are one instanced node.
 *
 * @typedef {import("./plan.js").Plan} Plan
 * @typedef {import("./plan.js").Frame} Frame
 * @typedef {import("./plan.js").Damage} Damage
 * @typedef {object} Instances
 * @property {Float32Array} batched_positions three each
 * @property {Float32Array} batched_wxyzs four each
 * @property {Float32Array} batched_scales three each
 * @property {Uint8Array} [batched_colors] three each
 *
 * @typedef {object} Body a body in a picture
 * @property {Plan} plan
 * @property {Frame} frame
 * @property {Float64Array} world positions of its masses in the page's world
 * @property {Damage} damage
 * @property {boolean} [still] its muscles do not breathe
 */
import {
  BELLY, BREATH, CREASE, FILL, FULL_DEVIATION, GHOST_WIDTH, HALO, PIN, RING, ROPE, ROPE_PIECES, SHINE, THICKEST,
  THINNEST, WEDGE, WIDEST, YIELDED,
} from "./looks.js";
import { UNHARMED } from "./plan.js";
import { countMuscles, muscleAt, swings, waveIn } from "./swing.js";

// Depths: what is nearer is drawn over the rest.
const Z = { halo: -0.17, muscle: -0.16, pin: -0.15, spring: -0.12, yielded: -0.1, wedge: -0.06, ring: 0.0, rim: 0.02, mass: 0.03, shine: 0.04, ghost: 0.06 };
/** Size of a hidden instance: leaving it out would give its place to another one. */
const HIDDEN = 1e-6;
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
 * Where a spring lies: its first end, its direction (radians) and its length.
 *
 * @param {Plan} plan @param {Float64Array} world @param {number} spring
 */
function lineOf({ springs }, world, spring) {
  const [a, b] = [2 * springs[2 * spring], 2 * springs[2 * spring + 1]];
  const [dx, dy] = [world[b] - world[a], world[b + 1] - world[a + 1]];
  return { x: world[a], y: world[a + 1], angle: Math.atan2(dy, dx), length: Math.hypot(dx, dy) };
}

/**
 * Puts an instance along a spring; without a width it is hidden.
 *
 * @param {Instances} to @param {number} i @param {ReturnType<typeof lineOf>} line @param {number} z @param {number | null} width
 */
const putAlong = (to, i, { x, y, angle, length }, z, width) =>
  put(to, i, x, y, z, angle, width === null ? HIDDEN : length, width ?? HIDDEN);

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
 * Deviations of joints from their rest angles, degrees in (-180, 180]; 0 where a stop does not act.
 *
 * @param {Plan} plan
 * @param {Float32Array} positions px
 * @param {number} shift degrees added to all rest angles
 * @param {Damage} damage
 * @param {Float64Array} [turn] degrees that muscles add to each
 */
export function deviations(plan, positions, shift, damage = UNHARMED, turn) {
  const { springs, joints, restAngle, stops } = plan;
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
  for (let k = 0; k < stops.length; k += 2) if (stops[k + 1] * result[stops[k]] < 0) result[stops[k]] = 0;
  return result;
}

/**
 * Colours from a table, for values from -1 to 1.
 *
 * @param {Float32Array} table
 * @param {Float64Array} values
 * @param {number} repeat number of instances for each value
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
 * The same ink colour of the plan for every instance.
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
 * The present rest length of a spring, in the world.
 *
 * @param {Body} body @param {number} i @param {ArrayLike<number>} stretch what muscles multiply it by
 */
function restOf({ plan, frame, damage }, i, stretch) {
  const restLength = plan.restLength[i] * frame.lengthScale * (stretch[i] ?? 1) + (damage.setLength[i] ?? 0);
  return Math.max(restLength * plan.scale, 1e-9);
}

/** Strain over that of the full colour. @param {Plan} plan @param {number} i @param {number} length @param {number} rest */
const strainOf = ({ fullStrain }, i, length, rest) => (length / rest - 1) / fullStrain[fullStrain.length > 1 ? i : 0];

/** Springs but for ropes. @param {Body} body */
export function springs(body) {
  const { plan, frame, world, damage } = body;
  const count = plan.restLength.length;
  const result = instances(count);
  const strain = new Float64Array(count);
  const { stretch } = swings(plan, frame);
  const [hanging, buffers] = [new Set(plan.ropes), new Set(plan.buffers)];
  for (let i = 0; i < count; i++) {
    const line = lineOf(plan, world, i);
    const rest = restOf(body, i, stretch);
    // A buffer that touches nothing is as long as it rests.
    if (buffers.has(i)) line.length = Math.min(line.length, rest);
    strain[i] = strainOf(plan, i, line.length, rest);
    // A stretched coil gets thinner, as a real one does; a squeezed one never gets thicker than its masses.
    const part = plan.bars ? 1 : Math.min(THICKEST, Math.max(THINNEST, Math.sqrt(rest / line.length)));
    putAlong(result, i, line, Z.spring, damage.broken.has(i) || hanging.has(i) ? null : part * plan.thickness[i]);
  }
  return { ...result, batched_colors: colored(plan.strainColors, strain, 1) };
}

/** Springs that only pull: taut they are straight, and slack they hang in a parabola as long as they rest. @param {Body} body */
export function ropes(body) {
  const { plan, frame, world, damage } = body;
  const result = instances(plan.ropes.length * ROPE_PIECES);
  const strain = new Float64Array(plan.ropes.length);
  const { stretch } = swings(plan, frame);
  plan.ropes.forEach((spring, k) => {
    const { x, y, angle, length } = lineOf(plan, world, spring);
    const rest = restOf(body, spring, stretch);
    strain[k] = Math.max(0, strainOf(plan, spring, length, rest));
    // That of a parabola that hardly sags, and of a loop that hangs from one point.
    const sag = Math.sqrt(Math.max(0, ((rest - length) * (2 * rest + length)) / 8));
    const [dx, step] = [(length * Math.cos(angle)) / ROPE_PIECES, (length * Math.sin(angle)) / ROPE_PIECES];
    for (let n = 0; n < ROPE_PIECES; n++) {
      const part = n / ROPE_PIECES;
      const dy = step - (4 * sag * (1 - 2 * part - 1 / ROPE_PIECES)) / ROPE_PIECES;
      const piece = { x: x + n * dx, y: y + n * step - 4 * sag * part * (1 - part), angle: Math.atan2(dy, dx), length: Math.hypot(dx, dy) };
      putAlong(result, k * ROPE_PIECES + n, piece, Z.spring, damage.broken.has(spring) ? null : ROPE * plan.thickness[spring]);
    }
  });
  return { ...result, batched_colors: colored(plan.strainColors, strain, ROPE_PIECES) };
}

/**
 * Muscles: bellies along springs, or halos around the masses of joints. They breathe: a belly is thick and strong in
 * colour while its muscle is short.
 *
 * @param {Body} body
 * @param {boolean} ofJoints
 */
export function muscles({ plan, frame, world, damage, still = false }, ofJoints) {
  const all = Array.from({ length: countMuscles(plan) }, (_, k) => muscleAt(plan, k));
  const some = all.filter(({ joint }) => joint === ofJoints);
  const result = instances(some.length);
  const breath = new Float64Array(some.length);
  some.forEach((muscle, k) => {
    const { part, amplitude } = muscle;
    breath[k] = still ? 0 : (ofJoints ? 1 : -1) * Math.sign(amplitude) * waveIn(plan, frame, muscle);
    const grown = 1 + BREATH * breath[k];
    if (ofJoints) {
      const tip = plan.joints[4 * part + 2];
      const size = isBent(plan, part, damage) ? HALO * grown * plan.radius[tip] : HIDDEN;
      put(result, k, world[2 * tip], world[2 * tip + 1], Z.halo, 0, size, size);
    } else {
      const width = BELLY * grown * plan.thickness[part] * (plan.bars ? 1 : 2);
      putAlong(result, k, lineOf(plan, world, part), Z.muscle, damage.broken.has(part) ? null : width);
    }
  });
  return { ...result, batched_colors: colored(plan.muscleColors, breath, 1) };
}

/** True if both springs of a joint are whole. @param {Plan} plan @param {number} joint @param {Damage} damage */
const isBent = ({ joints }, joint, { broken }) => !broken.has(joints[4 * joint]) && !broken.has(joints[4 * joint + 1]);

/** Lines along springs that have yielded and are not broken. @param {Body} body */
export function yielded({ plan, world, damage }) {
  const count = plan.restLength.length;
  const result = instances(count);
  for (let i = 0; i < count; i++) {
    const marked = Math.abs(damage.setLength[i] ?? 0) > YIELDED * plan.restLength[i] && !damage.broken.has(i);
    putAlong(result, i, lineOf(plan, world, i), Z.yielded, marked ? CREASE * plan.thickness[i] : null);
  }
  return { ...result, batched_colors: inked(plan, 3, count) };
}

/** Wedges from the rest angle to the present one, each of some thin triangles. @param {Body} body */
export function wedges({ plan, frame, world, damage }) {
  const { slices, joints, springs } = plan;
  const off = deviations(plan, frame.positions, frame.angleShift, damage, swings(plan, frame).turn);
  const result = instances(off.length * slices);
  for (let j = 0; j < off.length; j++) {
    const [spring, tip, sense] = [joints[4 * j + 1], joints[4 * j + 2], joints[4 * j + 3]];
    const [a, b] = [2 * springs[2 * spring], 2 * springs[2 * spring + 1]];
    const present = Math.atan2((world[b + 1] - world[a + 1]) * sense, (world[b] - world[a]) * sense);
    const turn = ((off[j] * Math.PI) / 180) * plan.flip;
    const half = Math.min(Math.min(Math.abs(turn) / slices, 3) / 2, WIDEST);
    const radius = isBent(plan, j, damage) ? WEDGE * plan.radius[tip] : HIDDEN;
    const reach = slices === 1 ? radius * Math.cos(half) : radius;
    for (let k = 0; k < slices; k++) {
      const middle = present - turn * (1 - (k + 0.5) / slices);
      put(result, j * slices + k, world[2 * tip], world[2 * tip + 1], Z.wedge, middle, reach, 2 * reach * Math.tan(half));
    }
  }
  const part = off.map((degrees) => degrees / FULL_DEVIATION);
  return { ...result, batched_colors: colored(plan.turnColors, part, slices) };
}

/** Rims of all masses, then fills, then shines. @param {Body} body */
export function masses({ plan, world }) {
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

/** Supports of pinned masses. @param {Body} body */
export function pins({ plan, world }) {
  const result = instances(plan.pinned.length);
  plan.pinned.forEach((mass, i) => {
    const size = PIN * plan.radius[mass];
    put(result, i, world[2 * mass], world[2 * mass + 1], Z.pin, 0, size, size);
  });
  return { ...result, batched_colors: inked(plan, 0, plan.pinned.length) };
}

/** The ring around the driven mass. @param {Body} body */
export function ring({ plan, world }) {
  const result = instances(1);
  const size = RING * plan.radius[plan.driven];
  put(result, 0, world[2 * plan.driven], world[2 * plan.driven + 1], Z.ring, 0, size, size);
  return { ...result, batched_colors: inked(plan, 1, 1) };
}

/** Thin bars along the springs of a body that is compared with. @param {Body} body */
export function ghost({ plan, frame, damage }) {
  const world = toWorld(plan, frame.ghost ?? new Float32Array());
  const count = plan.restLength.length;
  const result = instances(count);
  for (let i = 0; i < count; i++) {
    putAlong(result, i, lineOf(plan, world, i), Z.ghost, damage.ghostBroken.has(i) ? null : GHOST_WIDTH);
  }
  return { ...result, batched_colors: inked(plan, 2, count) };
}

/**
 * All nodes of a body by their names, from the back to the front: the mesh, empty for that of the body's springs; the
 * instances; and when there are any, if not always.
 *
 * @type {Record<string, {mesh: string, draw: (body: Body) => Instances, has?: (body: Body) => boolean}>}
 */
export const NODES = {
  halos: { mesh: "disc", draw: (body) => muscles(body, true), has: ({ plan }) => plan.muscles.length > 0 },
  muscles: { mesh: "belly", draw: (body) => muscles(body, false), has: ({ plan }) => plan.muscles.length > 0 },
  pins: { mesh: "pin", draw: pins, has: ({ plan }) => plan.pinned.length > 0 },
  springs: { mesh: "", draw: springs },
  ropes: { mesh: "bar", draw: ropes, has: ({ plan }) => plan.ropes.length > 0 },
  yielded: { mesh: "bar", draw: yielded },
  wedges: { mesh: "slice", draw: wedges },
  ring: { mesh: "ring", draw: ring, has: ({ plan }) => plan.driven >= 0 },
  masses: { mesh: "disc", draw: masses },
  ghost: { mesh: "bar", draw: ghost, has: ({ frame }) => frame.ghost !== null },
};
