"""The check that keeps states that have run away from leaving a kernel."""

from __future__ import annotations

import numpy as np

from ...engine.bits import from_bits, size_bits
from ...engine.jit import FAST, kernel

GOOD, BAD_NUMBER, BAD_POSITION, BAD_SPEED, STUCK, CHANGED = 0, 1, 2, 3, 4, 5
"""What is wrong with a state. STUCK: no step from it is accepted, however short. CHANGED: nothing is wrong,
but springs have broken, so that the run has to begin anew."""


@kernel(forceinline=True, fastmath=FAST)
def state_ok(body, integrator, q, v, final):
    """Whether all numbers of a state are within the limits.

    If not, and `final`, what is wrong is written into `integrator.run`, which ends the run. Otherwise a
    shorter step may still be tried.
    """
    farthest, fastest = integrator.run.farthest, integrator.run.fastest
    far, fast = 0, 0
    for j in range(q.size):
        far = max(far, size_bits(q[j]))
        fast = max(fast, size_bits(v[j]))
    if from_bits(far) <= farthest and from_bits(fast) <= fastest:
        return True
    if final:
        _blame(body, integrator, q, v)
    return False


@kernel(fastmath=FAST)
def _blame(body, integrator, q, v):
    """Write into `integrator.run` what is wrong, and at which mass."""
    farthest, fastest = integrator.run.farthest, integrator.run.fastest
    slots = q.size // 2
    for i in range(1, body.masses + 1):
        for j in (i, slots + i):
            status = GOOD
            if not (np.isfinite(q[j]) and np.isfinite(v[j])):
                status = BAD_NUMBER
            elif abs(q[j]) > farthest:
                status = BAD_POSITION
            elif abs(v[j]) > fastest:
                status = BAD_SPEED
            if status != GOOD:
                integrator.run.status = status
                integrator.run.mass = i
                return
