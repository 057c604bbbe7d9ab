"""A state that has run away never gets out of a kernel.

The state is looked at after every 64th step, which costs next to nothing. When it is bad, those steps
are undone and done again one at a time, so that the simulation stops at the very last good state.
"""

from __future__ import annotations

import numpy as np

from .bits import from_bits, size_bits
from .controls import refresh
from .jit import FAST, kernel
from .tables import COUNT_MASS, COUNT_WHAT, Indices

CHECK_EVERY = 64

GOOD, BAD_NUMBER, BAD_POSITION, BAD_SPEED, STUCK = 0, 1, 2, 3, 4
"""What is wrong with a state; STUCK: no step from it is short enough."""

DONE, STRIDE, WHAT, MASS = 0, 1, 2, 3
"""Places in the `progress` array: steps done, steps until the next look, GOOD or what is wrong, and the
mass that shows it."""


def new_progress() -> Indices:
    """The progress at the start of a call."""
    return np.array([0, CHECK_EVERY, GOOD, -1], np.int64)


@kernel(inline="always")
def verdict(live, masses, farthest, fastest):
    """(GOOD or what is wrong, the mass that shows it)."""
    for i in range(1, masses + 1):
        x, y, vx, vy = live.x[i], live.y[i], live.vx[i], live.vy[i]
        if not (np.isfinite(x) and np.isfinite(y) and np.isfinite(vx) and np.isfinite(vy)):
            return BAD_NUMBER, i
        if abs(x) > farthest or abs(y) > farthest:
            return BAD_POSITION, i
        if abs(vx) > fastest or abs(vy) > fastest:
            return BAD_SPEED, i
    return GOOD, -1


@kernel(inline="always")
def keep(live, kept):
    """Copy the state away."""
    for i in range(live.x.size):
        kept[0, i] = live.x[i]
        kept[1, i] = live.y[i]
        kept[2, i] = live.vx[i]
        kept[3, i] = live.vy[i]
    for i in range(live.controls.size):
        kept[4, i] = live.controls[i]


@kernel(inline="always")
def put_back(body, live, kept):
    """Copy the state back."""
    for i in range(live.x.size):
        live.x[i] = kept[0, i]
        live.y[i] = kept[1, i]
        live.vx[i] = kept[2, i]
        live.vy[i] = kept[3, i]
    for i in range(live.controls.size):
        live.controls[i] = kept[4, i]
    refresh(body, live)


@kernel(inner=True)
def judge(body, live, kept, progress, count, farthest, fastest):
    """Enter in `progress` how the `count` steps beyond the kept state went.

    Bad steps are undone; if they were more than one, they are to be done again with a stride of one.
    """
    what, mass = verdict(live, body.masses, farthest, fastest)
    if what == GOOD:
        progress[DONE] += count
        return
    put_back(body, live, kept)
    progress[STRIDE] = 1
    if count == 1:
        progress[WHAT] = what
        progress[MASS] = mass


@kernel(forceinline=True, fastmath=FAST)
def sound(body, flow, q, v, shortened):
    """Whether a state is one to keep; what is wrong with it goes into `flow.counts`.

    Unless `shortened`: then a shorter step is worth a try first, and it is only not kept.
    """
    farthest, fastest = flow.limits[0], flow.limits[1]
    far, fast = 0, 0
    for j in range(q.size):
        far = max(far, size_bits(q[j]))
        fast = max(fast, size_bits(v[j]))
    if from_bits(far) <= farthest and from_bits(fast) <= fastest:
        return True
    if shortened:
        _blame(body, flow, q, v)
    return False


@kernel(fastmath=FAST)
def _blame(body, flow, q, v):
    """Enter in `flow.counts` which mass shows what is wrong."""
    farthest, fastest = flow.limits[0], flow.limits[1]
    places = q.size // 2
    for i in range(1, body.masses + 1):
        for j in (i, places + i):
            what = GOOD
            if not (np.isfinite(q[j]) and np.isfinite(v[j])):
                what = BAD_NUMBER
            elif abs(q[j]) > farthest:
                what = BAD_POSITION
            elif abs(v[j]) > fastest:
                what = BAD_SPEED
            if what != GOOD:
                flow.counts[COUNT_WHAT] = what
                flow.counts[COUNT_MASS] = i
                return
