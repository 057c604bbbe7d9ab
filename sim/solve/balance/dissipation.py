"""The energy dissipated by dampers in a step: the integral of strength times rate squared.

The rate is that of a spring's length or a joint's angle. Quadrature of its square is as accurate as the
method, with one exception. Where a damper stops its masses within a fraction of a step, the velocities have
errors that the tolerance allows, but their squares are multiplied by a large strength, and the damper would
seem to dissipate many times the available energy. The mean rate, which follows from positions, is accurate
even then.
"""

from __future__ import annotations

from ...engine.jit import FAST, kernel
from ...engine.numerics.vectors import from_to, length_of

MEAN = 0
"""Row of a damper's mean rate over a step, px/s or 1/s; in all rows, springs precede joints."""
STRENGTH = 1
"""Row of a damper's mean strength, kg/s or kg px²/s."""
POWER = 2
"""Row of a damper's mean power, kg px²/s³."""
DAMPER_ROWS = 3
"""Number of these rows."""

# Unless noted, doubling or halving one of these numbers fails no test.
_SWINGING = 2.0
"""Mean power, relative to the power at the mean rate, above which the rate counts as oscillating. Doubled,
`test_the_balance_closes_at_any_damping` fails."""

_QUICKLY = 4.0
"""Step length, in time constants of a damper, from which an oscillating rate must be an error, since its
masses could not oscillate so fast. Doubled, `test_a_damper_takes_what_its_masses_had_of_each_other` fails."""


@kernel(fastmath=FAST)
def gather_dampers(body, q, v, part, dampers):
    """Add the rates, strengths and powers of dampers at positions q and velocities v, weighted by `part`."""
    springs = body.springs
    if body.damped:
        for s in range(springs):
            rate = _lengthening(body, q, v, s)
            dampers[MEAN, s] += part * rate
            dampers[STRENGTH, s] += part * body.damping[s]
            dampers[POWER, s] += part * body.damping[s] * rate * rate
    if body.joint_damped:
        for j in range(body.joints):
            rate, strength = _bending(body, q, v, j)
            dampers[MEAN, springs + j] += part * rate
            dampers[STRENGTH, springs + j] += part * strength
            dampers[POWER, springs + j] += part * strength * rate * rate


@kernel(fastmath=FAST)
def dissipated_energy(body, inverse_mass, q, v, h, dampers):
    """Return the energy that all dampers dissipate in a step of length h from q and v, kg px²/s².

    If a damper is quick and its rate seems to oscillate, the rate is assumed to decay from its initial value
    to its mean and to stay there.
    """
    power, springs = 0.0, body.springs
    if body.damped:
        for s in range(springs):
            most = dampers[POWER, s]
            mean, strength = dampers[MEAN, s], dampers[STRENGTH, s]
            if most > _SWINGING * strength * mean * mean:
                quickness = h * strength * (inverse_mass[body.spring_a[s]] + inverse_mass[body.spring_b[s]])
                most = _calmed(mean, strength, most, _lengthening(body, q, v, s), quickness)
            power += most
    if body.joint_damped:
        for j in range(body.joints):
            most = dampers[POWER, springs + j]
            mean, strength = dampers[MEAN, springs + j], dampers[STRENGTH, springs + j]
            if most > _SWINGING * strength * mean * mean:
                quickness = h * strength * _effective_inverse_inertia(body, inverse_mass, q, j)
                most = _calmed(mean, strength, most, _bending(body, q, v, j)[0], quickness)
            power += most
    return h * power


@kernel(inline="always")
def _calmed(mean, strength, most, first, quickness):
    """Return the mean power of a damper whose rate seems to oscillate.

    Args:
        mean, strength, most: its mean rate, strength and power.
        first: its rate at the start of the step.
        quickness: step length divided by its time constant.
    """
    if quickness < _QUICKLY:
        return most
    off = first - mean
    return min(most, strength * (mean * mean + (2.0 * mean * off + 0.5 * off * off) / quickness))


@kernel(inline="always")
def _lengthening(body, q, v, s):
    """Return the rate of change of a spring's length, px/s."""
    x, y = from_to(q, body.spring_a[s], body.spring_b[s])
    u, w = from_to(v, body.spring_a[s], body.spring_b[s])
    return (x * u + y * w) / length_of(x, y, body.softening)


@kernel(inline="always")
def _bending(body, q, v, j):
    """Return the rate of change of a joint's angle, 1/s, and its damper's strength, kg px²/s."""
    turned_a, len_a = _turning(body, q, v, body.joint_a[j])
    turned_b, len_b = _turning(body, q, v, body.joint_b[j])
    return turned_b - turned_a, body.torque_damping[j + 1] * len_a * len_b


@kernel(inline="always")
def _turning(body, q, v, s):
    """Return the rate at which a spring turns, 1/s, and its length, px."""
    x, y = from_to(q, body.spring_a[s], body.spring_b[s])
    u, w = from_to(v, body.spring_a[s], body.spring_b[s])
    length = length_of(x, y, body.softening)
    return (x * w - y * u) / (length * length), length


@kernel(inline="always")
def _effective_inverse_inertia(body, inverse_mass, q, j):
    """Return the inverse moment of inertia of a joint's angle, 1/(kg px²), ignoring that its springs share a
    mass."""
    light = 0.0
    for s in (body.joint_a[j], body.joint_b[j]):
        a, b = body.spring_a[s], body.spring_b[s]
        length = length_of(*from_to(q, a, b), body.softening)
        light += (inverse_mass[a] + inverse_mass[b]) / (length * length)
    return light
