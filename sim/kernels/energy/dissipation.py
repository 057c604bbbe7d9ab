"""What dampers take away in a step: the power of each, its strength times the square of a rate, over time.

The rate is that of a spring's length or of a joint's angle. Quadrature of its square is as exact as the
method. But where a damper calms its masses in a fraction of a step, the velocities at both ends are off by
what the tolerance allows, and the strength makes much of their squares: it would seem to take away many times
the energy that there is. The mean rate, which positions tell, is known all the same.
"""

from __future__ import annotations

from ..core.jit import FAST, kernel
from ..core.vectors import from_to, length_of

MEAN = 0
"""Row of a damper's mean rate over a step, px/s or 1/s; springs first, then joints, as in the rows below."""
STRENGTH = 1
"""Row of its mean strength, kg/s or kg px²/s."""
POWER = 2
"""Row of its mean power, kg px²/s³."""
DAMPER_ROWS = 3

_SWINGING = 2.0
"""The power of a damper whose rate is anything but its mean one, beside that at its mean rate."""

_QUICKLY = 4.0
"""How many times faster than in a step a damper has to calm its masses so that no swing of its rate can be
one of theirs."""


@kernel(fastmath=FAST)
def gather_dampers(body, q, v, part, dampers):
    """Add what dampers do at positions q and velocities v to their rows, times a part of the step."""
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
def taken_away(body, inverse_mass, q, v, h, dampers):
    """Energy that all dampers take away in a step of length h that starts at q and v.

    A damper that is quick, and whose rate swings all the same, is taken to let its masses come to its mean
    rate from that at the start, and then to go on with that.
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
                quickness = h * strength * _lightness(body, inverse_mass, q, j)
                most = _calmed(mean, strength, most, _bending(body, q, v, j)[0], quickness)
            power += most
    return h * power


@kernel(inline="always")
def _calmed(mean, strength, most, first, quickness):
    """The mean power of a damper whose rate seems to swing.

    Args:
        mean, strength, most: its mean rate, strength and power.
        first: its rate at the start of the step.
        quickness: length of the step over the time in which it calms its masses.
    """
    if quickness < _QUICKLY:
        return most
    off = first - mean
    return min(most, strength * (mean * mean + (2.0 * mean * off + 0.5 * off * off) / quickness))


@kernel(inline="always")
def _lengthening(body, q, v, s):
    """The rate of a spring's length, px/s."""
    x, y = from_to(q, body.spring_a[s], body.spring_b[s])
    u, w = from_to(v, body.spring_a[s], body.spring_b[s])
    return (x * u + y * w) / length_of(x, y, body.softening)


@kernel(inline="always")
def _bending(body, q, v, j):
    """The rate of a joint's angle, 1/s, and its damper's strength, kg px²/s."""
    turned_a, len_a = _turning(body, q, v, body.joint_a[j])
    turned_b, len_b = _turning(body, q, v, body.joint_b[j])
    return turned_b - turned_a, body.torque_damping[j + 1] * len_a * len_b


@kernel(inline="always")
def _turning(body, q, v, s):
    """The rate at which a spring turns, 1/s, and its length, px."""
    x, y = from_to(q, body.spring_a[s], body.spring_b[s])
    u, w = from_to(v, body.spring_a[s], body.spring_b[s])
    length = length_of(x, y, body.softening)
    return (x * w - y * u) / (length * length), length


@kernel(inline="always")
def _lightness(body, inverse_mass, q, j):
    """What a torque at a joint does to its angle, 1/(kg px²), but for the mass that both springs share."""
    light = 0.0
    for s in (body.joint_a[j], body.joint_b[j]):
        a, b = body.spring_a[s], body.spring_b[s]
        length = length_of(*from_to(q, a, b), body.softening)
        light += (inverse_mass[a] + inverse_mass[b]) / (length * length)
    return light
