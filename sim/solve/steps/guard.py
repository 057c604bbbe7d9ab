"""The check that keeps diverged states from leaving a kernel."""

from __future__ import annotations

import numpy as np

from ...engine.bits import from_bits, size_bits
from ...engine.jit import FAST, kernel

GOOD, BAD_NUMBER, BAD_POSITION, BAD_SPEED, STUCK, CHANGED = 0, 1, 2, 3, 4, 5
"""Status of a run. STUCK: no step is accepted, however short. CHANGED: springs have broken, so the run has to
be restarted with the remaining ones."""


@kernel(forceinline=True, fastmath=FAST)
def state_ok(body, integrator, q, v, final):
    """Return whether all numbers of a state are within the limits.

    If not, and `final`, write the reason to `integrator.run`, which ends the run. Without `final`, a shorter
    step may still be tried.
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
    """Write to `integrator.run` what is wrong, and at which mass."""
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
