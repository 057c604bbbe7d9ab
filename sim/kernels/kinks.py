"""Friction of air where a velocity changes its sign: kinks that Adams' methods need not see.

Along each axis, friction slows a mass by air v |v|, which is air v² with a sign that jumps where v passes
through zero. Between two such moments everything is smooth. So the polynomial through past accelerations is
kept to one sign, that of v at present: a step in which v turns is done with the old sign, what friction did
from the turn on is added by itself, and then the past is told anew, as if friction had always had the new
sign. Without that, polynomials of high degree see a kink of each mass for as many steps as they look back.
"""

from __future__ import annotations

import math

import numpy as np

from .jit import FAST, kernel
from .steps import biggest
from .tables import PAST, SPARE

_MATTER = 0.03
"""Error of a step, in tolerances, that a kink may make without being looked at."""

_BEND = 0.5
"""The most that a velocity is taken to become steeper or flatter between its turn and the end of a step."""


@kernel(forceinline=True)
def ago(head, i):
    """The row of the acceleration i steps before the latest."""
    return np.uint64(head + i) & np.uint64(PAST - 1)


@kernel(fastmath=FAST)
def kinks_matter(air, a, step, weight, tolerance):
    """Whether kinks make errors that are not far below the tolerance.

    Args:
        air: (places) friction / mass, 1/px.
        a: flat accelerations, px/s²: what a velocity may become in a step after it was zero.
        step: length of a step, s.
        weight: of an acceleration's error, in that of a position after a step, over its square.
        tolerance: px per second.
    """
    most = 0.0
    for i in range(air.size):
        most = max(most, air[i])
    if most == 0.0:
        return False
    gain = step * biggest(a)
    return 2.0 * most * gain * gain * weight * step > _MATTER * tolerance


@kernel(apart=True, forceinline=True, fastmath=FAST)
def any_turns(v, to_v):
    """Whether any velocity changes its sign."""
    turned = 0
    for j in range(1, v.size - SPARE):
        turned += v[j] * to_v[j] < 0.0
    return turned > 0


@kernel(fastmath=FAST)
def without_kinks(air, v, to_v, to_a):
    """Make accelerations at the end of a step those of friction that has kept its sign."""
    places = air.size
    _keep_sign(air, v[:places], to_v[:places], to_a[:places])
    _keep_sign(air, v[places:], to_v[places:], to_a[places:])


@kernel(apart=True, forceinline=True, fastmath=FAST)
def _keep_sign(air, v, to_v, to_a):
    for i in range(1, air.size - SPARE):
        to = to_v[i]
        twice = 2.0 * air[i] * (to * abs(to))
        to_a[i] += twice if v[i] * to < 0.0 else 0.0


@kernel(fastmath=FAST)
def with_kinks(air, v, a, to_a, step, to_q, to_v):
    """Add what the change of sign did since then. Accelerations are taken to change evenly, and not by much.

    Args:
        air, v, a: (places) friction / mass, 1/px; flat velocities and accelerations at the start of the step.
        to_a: flat accelerations at its end, with the old sign.
        step: its length, s.
        to_q, to_v: flat positions and velocities at its end, which are corrected.
    """
    places = air.size
    _add(air, v[:places], a[:places], to_a[:places], step, to_q[:places], to_v[:places])
    _add(air, v[places:], a[places:], to_a[places:], step, to_q[places:], to_v[places:])


@kernel(apart=True, forceinline=True, fastmath=FAST)
def _add(air, v, a, to_a, step, to_q, to_v):
    for i in range(1, air.size - SPARE):
        to, rise = to_v[i], to_a[i]
        speed = abs(to)
        since = step * speed / (max(step * abs(rise), speed) + 1e-300)
        # How much steeper the velocity has become since the turn, as a part of its slope.
        bend = (rise - a[i]) * since / (step * rise + math.copysign(1e-300, rise))
        bend = max(-_BEND, min(_BEND, bend))
        since *= 1.0 + bend / 2.0
        # The integral of -2 air v |v|, and once more for the position, to first order in the bend.
        gained = -2.0 * air[i] * (to * speed) * since if v[i] * to < 0.0 else 0.0
        to_v[i] = to + gained * (1.0 / 3.0 - bend / 12.0)
        to_q[i] += gained * since * (1.0 / 12.0 - bend / 30.0)


@kernel(fastmath=FAST)
def turn_past(air, v, to_v, past, head, known, back, step):
    """Give friction in past accelerations the new sign, where a velocity has turned.

    Args:
        air, v, to_v: (places) friction / mass, 1/px; flat velocities before and after the latest step.
        past: rows of flat accelerations, px/s², the latest one with the new sign.
        head, known: the row of the latest; how many rows are at equal distances in time.
        back: see `Adams`.
        step: that distance, s.
    """
    places, first = air.size, (known - 1) * PAST
    for j in range(1, v.size - SPARE):
        now = to_v[j]
        if v[j] * now < 0.0:
            twice = math.copysign(2.0 * air[j % places], now)
            p0, p1, p2 = past[head, j] + twice * now * now, past[ago(head, 1), j], past[ago(head, 2), j]
            p3, p4, p5 = past[ago(head, 3), j], past[ago(head, 4), j], past[ago(head, 5), j]
            p6, p7 = past[ago(head, 6), j], past[ago(head, 7), j]
            for r in range(1, known):
                w = back[first + r]
                gained = w[0] * p0 + w[1] * p1 + w[2] * p2 + w[3] * p3
                speed = now - step * (gained + (w[4] * p4 + w[5] * p5 + w[6] * p6 + w[7] * p7))
                past[ago(head, r), j] -= twice * speed * speed
