"""Kinetic, elastic and potential energy of a body."""

from __future__ import annotations

import math

from ..around.contact import energy_of_contact
from ..around.fillings import energy_of_fillings
from ..around.walls import energy_in_walls
from ..core.jit import FAST, kernel
from ..core.vectors import deflection, from_to, length_of
from ..forces.laws import is_sine, terms

KINETIC, LINEAR, ANGULAR, GRAVITY, WALLS, FILLINGS, CONTACT = 0, 1, 2, 3, 4, 5, 6
"""Indices of the energies in what `energies` writes."""
ENERGIES = 7
"""Their number."""


@kernel(fastmath=FAST)
def energies(body, state, mass, q, v, out):
    """Write the energies of motion, linear springs, angular springs, gravity, walls, fillings and contact,
    kg px²/s², into `out`, and return their sum.

    The energy of gravity, with that of the constant forces on masses, is counted from (0, 0). Held masses
    have neither kinetic energy nor that of gravity and walls. Under the tutorial's law, the angular energy is
    that of the conservative law.
    """
    slots, soft = q.size // 2, body.softening
    kinetic, linear, angular, height = 0.0, 0.0, 0.0, 0.0
    for i in range(1, body.masses + 1):
        if state.inverse_mass[i] > 0.0:
            kinetic += 0.5 * mass[i] * (v[i] * v[i] + v[slots + i] * v[slots + i])
            height -= mass[i] * (state.gx[i] * q[i] + state.gy[i] * q[slots + i])
    for s in range(body.springs):
        a, b = body.spring_a[s], body.spring_b[s]
        x, y = from_to(q, a, b)
        length = length_of(x, y, soft)
        if body.stiffness[s] > 0.0:
            off = length - state.pull[s] / body.stiffness[s]
            linear += 0.5 * body.stiffness[s] * off * off
    for j in range(body.joints):
        s, r = body.joint_a[j], body.joint_b[j]
        a0, a1, b0, b1 = body.spring_a[s], body.spring_b[s], body.spring_a[r], body.spring_b[r]
        ax, ay = from_to(q, a0, a1)
        bx, by = from_to(q, b0, b1)
        angular += body.torque_size[j + 1] * angular_energy(
            body.law, ax, ay, bx, by, state.torque_rest[j + 1], soft
        )
    walls, fillings, contact = 0.0, 0.0, 0.0
    if body.surroundings.present:
        walls = energy_in_walls(body, state.inverse_mass, q[:slots], q[slots:])
        fillings = energy_of_fillings(body.surroundings, q[:slots], q[slots:])
        if body.surroundings.contact.present:
            contact = energy_of_contact(body, q[:slots], q[slots:])
    out[KINETIC], out[LINEAR], out[ANGULAR], out[GRAVITY] = kinetic, linear, angular, height
    out[WALLS], out[FILLINGS], out[CONTACT] = walls, fillings, contact
    return kinetic + linear + angular + height + walls + fillings + contact


@kernel(forceinline=True, fastmath=FAST)
def angular_energy(law, ax, ay, bx, by, rest, softening):
    """The energy of a joint of stiffness one; for the tutorial's law that of the conservative one."""
    square_a, square_b = ax * ax + ay * ay, bx * bx + by * by
    len_a, len_b = math.sqrt(square_a + softening), math.sqrt(square_b + softening)
    off = deflection(ax * by - ay * bx, ax * bx + ay * by, rest)
    if not is_sine(law):
        return (square_a / len_a) * (square_b / len_b) * terms(law, off)[1]
    true = math.sqrt(square_a * square_b)
    sine = math.sin(0.5 * off)
    # |A||B| with softening minus |A||B| without it, avoiding the difference of two large numbers.
    more = softening * (square_a + square_b + softening) / (len_a * len_b + true)
    return 2.0 * true * sine * sine + more
