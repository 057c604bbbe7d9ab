"""Kinetic, elastic and potential energy of a body."""

from __future__ import annotations

from ...engine.jit import FAST, kernel
from ...forces.all import GRAVITY, KINETIC, write_energies


@kernel(fastmath=FAST)
def energies(body, state, mass, q, v, out):
    """Write the energies, kg px²/s², into `out`, and return their sum.

    Included are the kinetic and gravitational energies and those of `forces.all.WITH_ENERGY`. The energy of
    gravity and of the constant forces on masses is relative to (0, 0). Held masses have no kinetic energy,
    nor that of gravity or walls. Under the tutorial's law, the angular energy is that of the conservative
    law.
    """
    slots = q.size // 2
    out[KINETIC], out[GRAVITY] = 0.0, 0.0
    for i in range(1, body.masses + 1):
        if state.inverse_mass[i] > 0.0:
            out[KINETIC] += 0.5 * mass[i] * (v[i] * v[i] + v[slots + i] * v[slots + i])
            out[GRAVITY] -= mass[i] * (state.gx[i] * q[i] + state.gy[i] * q[slots + i])
    write_energies(body, state, q, out)
    total = 0.0
    for i in range(out.size):
        total += out[i]
    return total
