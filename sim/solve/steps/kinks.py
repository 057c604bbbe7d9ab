"""Kinks of the tutorial's air friction where a velocity component changes its sign, kept away from Adams
methods.

Along each axis, that friction slows a mass by air v |v|, which is air v² with a sign that jumps where v
passes through zero. Between such moments everything is smooth. So the polynomial through past accelerations
uses one sign only, that of the present v. A step in which v changes its sign is done with the old sign; the
effect of friction after the change is added separately; and the past accelerations are rewritten as if
friction had always had the new sign. Otherwise polynomials of high degree would see each kink for as many
steps as they look back.
"""

from __future__ import annotations

import math

import numpy as np

from ...engine.jit import FAST, kernel
from ...engine.lanes import eight_at_a_time
from ...engine.tables import PAST, SPARE
from .common import max_abs

_MATTER = 0.03
"""Error of a step, in tolerances, up to which kinks are ignored. By experiment on 20 bodies: doubled, errors
of Adams grow by 8 %; halved, nothing changes."""

_BEND = 0.5
"""Largest assumed deviation of a velocity's slope at its change of sign from the mean slope after it,
relative to the mean slope. Below 1 it keeps that slope positive; halved, nothing changes on 20 bodies."""


@kernel(forceinline=True)
def ago(head, i):
    """Return the row of the acceleration i steps before the latest."""
    return np.uint64(head + i) & np.uint64(PAST - 1)


@kernel(fastmath=FAST)
def kinks_matter(air, a, step, weight, tolerance):
    """Return whether the errors of kinks are not far below the tolerance.

    Args:
        air: (slots,) friction / mass, 1/px.
        a: flat accelerations, px/s², which bound the velocity that is reached in a step from zero.
        step: length of a step, s.
        weight: error of a position after a step, per error of an acceleration and per step squared.
        tolerance: px per second.
    """
    most = 0.0
    for i in range(air.size):
        most = max(most, air[i])
    if most == 0.0:
        return False
    gain = step * max_abs(a)
    return 2.0 * most * gain * gain * weight * step > _MATTER * tolerance


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def any_turns(v, to_v):
    """Return whether any velocity changes its sign."""
    eight_at_a_time()
    turned = 0
    for j in range(1, v.size - SPARE):
        turned += v[j] * to_v[j] < 0.0
    return turned > 0


@kernel(fastmath=FAST)
def without_kinks(air, v, to_v, to_a):
    """Change accelerations at the end of a step to those with the old sign of friction."""
    slots = air.size
    _keep_sign(air, v[:slots], to_v[:slots], to_a[:slots])
    _keep_sign(air, v[slots:], to_v[slots:], to_a[slots:])


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _keep_sign(air, v, to_v, to_a):
    eight_at_a_time()
    for i in range(1, air.size - SPARE):
        to = to_v[i]
        twice = 2.0 * air[i] * (to * abs(to))
        to_a[i] += twice if v[i] * to < 0.0 else 0.0


@kernel(fastmath=FAST)
def with_kinks(air, v, a, to_a, step, to_q, to_v):
    """Add the effect of the new sign of friction after a change of sign within the step.

    Without friction, accelerations are assumed to change linearly and little.

    Args:
        air, v, a: (slots,) friction / mass, 1/px; flat velocities and accelerations at the start of the step.
        to_a: flat accelerations at its end, with the old sign of friction.
        step: its length, s.
        to_q, to_v: flat positions and velocities at its end, which are corrected.
    """
    slots = air.size
    _add(air, v[:slots], a[:slots], to_a[:slots], step, to_q[:slots], to_v[:slots])
    _add(air, v[slots:], a[slots:], to_a[slots:], step, to_q[slots:], to_v[slots:])


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _add(air, v, a, to_a, step, to_q, to_v):
    eight_at_a_time()
    per_step = 1.0 / step
    for i in range(1, air.size - SPARE):
        was, to = v[i], to_v[i]
        side, speed = math.copysign(1.0, to), abs(to)
        # Accelerations at both ends in the direction of `to`, without friction, which varies most.
        begin, rise = side * a[i] - air[i] * (was * was), side * to_a[i] - air[i] * (to * to)
        # Without friction the velocity is speed (r x + (1 - r) x²) at the fraction x of the time since the
        # change of sign, where its slope is the root.
        root = math.sqrt(max(rise * rise - 2.0 * per_step * (rise - begin) * speed, 0.0))
        inverse = 2.0 / max(rise + root, speed * per_step + 1e-300)
        since = min(step, speed * inverse)
        r = max(1.0 - _BEND, min(1.0 + _BEND, root * inverse))
        rest = 1.0 - r
        square = r * r / 3.0 + r * rest / 2.0 + rest * rest / 5.0
        # To second order, friction with the old sign adds as much to the velocity as it takes with the new
        # sign. So the sum of both squares, which determines the loss, is twice the square without friction.
        added = min(air[i] * speed * since * square, 0.5)
        mean, since = speed * (1.0 - added), since * (1.0 - added * (1.0 + rest))
        lost = 2.0 * air[i] * side * (mean * mean) * since if was * to < 0.0 else 0.0
        to_v[i] = to - lost * square
        to_q[i] -= lost * since * (r * r / 12.0 + r * rest / 10.0 + rest * rest / 30.0)


@kernel(fastmath=FAST)
def turn_past(air, v, to_v, past, head, known, back, step):
    """Give friction in past accelerations the new sign where a velocity has changed its sign.

    Args:
        air, v, to_v: (slots,) friction / mass, 1/px; flat velocities before and after the latest step.
        past: rows of flat accelerations, px/s², the latest one with the new sign.
        head, known: row of the latest; number of rows at equal distances in time.
        back: see `Adams`.
        step: this distance, s.
    """
    slots, first = air.size, (known - 1) * PAST
    for j in range(1, v.size - SPARE):
        now = to_v[j]
        if v[j] * now < 0.0:
            twice = math.copysign(2.0 * air[j % slots], now)
            p0, p1, p2 = past[head, j] + twice * now * now, past[ago(head, 1), j], past[ago(head, 2), j]
            p3, p4, p5 = past[ago(head, 3), j], past[ago(head, 4), j], past[ago(head, 5), j]
            p6, p7 = past[ago(head, 6), j], past[ago(head, 7), j]
            for r in range(1, known):
                w = back[first + r]
                gained = w[0] * p0 + w[1] * p1 + w[2] * p2 + w[3] * p3
                speed = now - step * (gained + (w[4] * p4 + w[5] * p5 + w[6] * p6 + w[7] * p7))
                past[ago(head, r), j] -= twice * speed * speed
