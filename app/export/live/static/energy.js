// @ts-check
/**
 * Energies of a body, kg px²/s².
 *
 * @typedef {import("./body.js").Body} Body
 */

/** By name, those that the body has. @param {Body} body @returns {Record<string, number>} */
export function energies(body) {
  const { positions: x, velocities: v, mass, gravity, held } = body;
  let [kinetic, height, linear, angular] = [0, 0, 0, 0];
  for (let m = 0; m < body.masses; m++) {
    const i = 2 * m;
    kinetic += 0.5 * mass[m] * (v[i] ** 2 + v[i + 1] ** 2);
    if (!held[m]) height -= mass[m] * (gravity[0] * x[i] + gravity[1] * x[i + 1]);
  }
  for (let s = 0; s < body.springs; s++) {
    const [a, b] = [2 * body.ends[2 * s], 2 * body.ends[2 * s + 1]];
    const longer = Math.hypot(x[b] - x[a], x[b + 1] - x[a + 1]) - body.restLengthOf(s);
    if (body.broken[s] || (body.sides && body.sides.springs[s] * longer < 0)) continue;
    linear += 0.5 * body.stiffness[s] * longer ** 2;
  }
  body.measure();
  for (let j = 0; j < body.joints; j++) angular += body.energyOf(j);
  return { kinetic, height, ...(body.springs && { linear }), ...(body.joints && { angular }) };
}
