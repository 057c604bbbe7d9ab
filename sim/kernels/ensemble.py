"""Many copies of one chain at once, by explicit methods with a fixed step: a lane of a vector is a body.

All bodies of a batch have as many masses, and nothing else in common: each lane has a step, masses, springs
and joints of its own. Lanes are innermost, so that every loop over them is a vector operation, however short
the chain: one vector, where the processor has registers for eight numbers. Everything is in one flat array,
in which place p has a record of FIELDS times LANES numbers: all distances between what a loop reads and
writes are constants, and the compiler needs no test for overlaps, which with an array for each field keeps
it from vectorising.

The record of place p has the mass at place p, the spring from there to the next place and the joint between
that spring and the one before it. The first record and the last are of no mass and no spring: zeros.

A pass goes along the chain once. At each place it finds what it can of the spring that begins there, the
force of the spring before, which that one's joint was missing for, and with it the acceleration of the mass
before, which is moved at once: nobody behind it asks where it was. What springs hand on stays in registers.
"""

from __future__ import annotations

import numpy as np

from .jit import FAST, kernel
from .lanes import eight_at_a_time
from .roots import inverse_root
from .tables import CONSERVATIVE

_U = np.uint64
"""Of all constants of the layout: numba tests signed indices for being negative, which no vector survives."""

LANES = _U(8)
"""Bodies of a batch."""

X, Y, VX, VY = _U(0), _U(1), _U(2), _U(3)
WEIGHT, AIR, GX, GY, STEP = _U(4), _U(5), _U(6), _U(7), _U(8)
"""Of a mass: 1/kg, 1/px and px/s², zero where it is held; for symplectic Euler, times the step. And the step
of the lane, s; in every record, since that is where the loop is."""
STIFFNESS, DAMPING, PULL = _U(9), _U(10), _U(11)
"""Of a spring: kg/s², kg/s, and stiffness times rest length."""
COUPLE_COS, COUPLE_SIN, COUPLE_SIZE = _U(12), _U(13), _U(14)
"""Of a joint: its stiffness times the cosine and the sine of its rest angle, and its stiffness, kg/s²."""
START_X, START_Y, START_VX, START_VY = _U(15), _U(16), _U(17), _U(18)
"""Of a mass at the start of a step of several stages."""
AX, AY = _U(19), _U(20)
"""Acceleration that velocity Verlet carries from step to step, px/s²."""
SUM_VX, SUM_VY, SUM_AX, SUM_AY = _U(19), _U(20), _U(21), _U(22)
"""Of the stages of Runge and Kutta's method, with their weights: 1, 2, 2, 1."""
FIELDS = _U(23)

EULER, VERLET, RUNGE_KUTTA_4 = 0, 1, 2
"""Methods that `run_ensemble` knows."""

_RECORD = FIELDS * LANES

_LX, _LY, _INVERSE, _ALONG, _OF_JOINT, _PART_X, _PART_Y, _TX, _TY = (_U(k) * LANES for k in range(9))
"""What a spring hands on to the next one: its vector, the inverse of its length (squared, under the
tutorial's law), and its force along itself as far as it is known; the couple of its joint with the spring
before it or, under the conservative law, its length; what that joint adds to its force under that law; and
the force of the spring before it, whole."""
CARRIED = 9 * int(LANES)
"""Numbers that are handed on."""

_FRESHEN, _STEP, _KICK, _KICK_AND_DRIFT, _FIRST, _MIDDLE, _LAST = 0, 1, 2, 3, 4, 5, 6
"""What a pass does with accelerations: keep them, Euler's step, Verlet's second half of a step alone and with
the first half of the next one, and the first, a middle and the last stage of Runge and Kutta's method."""


@kernel(fastmath=FAST)
def run_ensemble(data, carry, todo, masses, law, method, fresh):
    """Do `todo[lane]` steps in every lane, and leave the state in `data`.

    A lane that is done waits for the others with a step of zero, in which nothing accelerates it. Nothing
    stops a body that runs away: its numbers go to infinity and on to NaN, which harms no other lane.

    Args:
        data: ((masses + 2) records,) see above; at the end, WEIGHT to STEP are zero where a lane has waited.
        carry: (CARRIED,) scratch.
        todo: (LANES,) steps; zero at the end.
        law: NO_JOINTS, TUTORIAL or CONSERVATIVE; damping of joints is not known here.
        method: EULER, VERLET or RUNGE_KUTTA_4.
        fresh: whether the bodies have just been put where they are: velocity Verlet then carries nothing yet.
    """
    conservative = law == CONSERVATIVE
    if method == VERLET and fresh:
        if conservative:
            _pass(data, carry, masses, True, _FRESHEN, 0.0)
        else:
            _pass(data, carry, masses, False, _FRESHEN, 0.0)
    while True:
        steps = 0
        for lane in range(LANES):
            if todo[lane] > 0 and (steps == 0 or todo[lane] < steps):
                steps = todo[lane]
        if steps == 0:
            return
        for lane in range(LANES):
            if todo[lane] == 0:
                for place in range(_U(1), _U(masses) + _U(1)):
                    for field in (WEIGHT, AIR, GX, GY, STEP):
                        data[place * _RECORD + field * LANES + lane] = 0.0
            todo[lane] = max(todo[lane] - steps, 0)
        if conservative:
            _steps(data, carry, masses, steps, method, True)
        else:
            _steps(data, carry, masses, steps, method, False)


@kernel(inline="always")
def _steps(data, carry, masses, steps, method, conservative):
    if method == EULER:
        for _ in range(steps):
            _pass(data, carry, masses, conservative, _STEP, 0.0)
    elif method == VERLET:
        _drift_all(data, masses)
        for _ in range(steps - 1):
            _pass(data, carry, masses, conservative, _KICK_AND_DRIFT, 0.0)
        _pass(data, carry, masses, conservative, _KICK, 0.0)
    else:
        for _ in range(steps):
            _pass(data, carry, masses, conservative, _FIRST, 0.5)
            for part in (0.5, 1.0):
                _pass(data, carry, masses, conservative, _MIDDLE, part)
            _pass(data, carry, masses, conservative, _LAST, 1.0 / 6.0)


# `data` and `carry` are apart, or nothing of the latter could stay in registers.
@kernel(apart=True, forceinline=True, fastmath=FAST)
def _pass(data, carry, masses, conservative, what, part):
    """Find all accelerations, from the first mass to the last, and do `what` with each."""
    eight_at_a_time()
    for k in range(CARRIED):
        carry[k] = 0.0
    for lane in range(LANES):
        _spring(data, carry, _RECORD + lane, lane, conservative)
    for place in range(_U(2), _U(masses) + _U(1)):
        here, before = place * _RECORD, (place - _U(1)) * _RECORD
        for lane in range(LANES):
            x, y = carry[_TX + lane], carry[_TY + lane]
            _spring(data, carry, here + lane, lane, conservative)
            _move(data, before + lane, x - carry[_TX + lane], y - carry[_TY + lane], what, part)
    for lane in range(LANES):
        last = _U(masses) * _RECORD + lane
        _move(data, last, carry[_TX + lane], carry[_TY + lane], what, part)


@kernel(inline="always")
def _spring(data, carry, i, lane, conservative):
    """Go on to the spring that begins at record i (in its lane), and finish the one before it."""
    n = i + _RECORD
    lx = data[n + X * LANES] - data[i + X * LANES]
    ly = data[n + Y * LANES] - data[i + Y * LANES]
    rate = lx * (data[n + VX * LANES] - data[i + VX * LANES]) + ly * (
        data[n + VY * LANES] - data[i + VY * LANES]
    )
    square = lx * lx + ly * ly
    inverse = inverse_root(square)
    along = (
        data[i + PULL * LANES] * inverse
        - data[i + STIFFNESS * LANES]
        - data[i + DAMPING * LANES] * rate * (inverse * inverse)
    )
    cos, sin = data[i + COUPLE_COS * LANES], data[i + COUPLE_SIN * LANES]
    ax, ay, before = carry[_LX + lane], carry[_LY + lane], carry[_ALONG + lane]
    if conservative:
        size, length = data[i + COUPLE_SIZE * LANES], square * inverse
        before -= size * length * carry[_INVERSE + lane]
        along -= size * carry[_OF_JOINT + lane] * inverse
        tx = before * ax + carry[_PART_X + lane] + cos * lx + sin * ly
        ty = before * ay + carry[_PART_Y + lane] - sin * lx + cos * ly
        carry[_PART_X + lane], carry[_PART_Y + lane] = cos * ax - sin * ay, sin * ax + cos * ay
        carry[_OF_JOINT + lane] = length
    else:
        inverse *= inverse
        couple = cos * (ax * ly - ay * lx) - sin * (ax * lx + ay * ly)
        across = (carry[_OF_JOINT + lane] - couple) * carry[_INVERSE + lane]
        tx, ty = before * ax + across * ay, before * ay - across * ax
        carry[_OF_JOINT + lane] = couple
    carry[_TX + lane], carry[_TY + lane] = tx, ty
    carry[_LX + lane], carry[_LY + lane] = lx, ly
    carry[_INVERSE + lane], carry[_ALONG + lane] = inverse, along


@kernel(inline="always")
def _move(data, i, fx, fy, what, part):
    """Do `what` with the acceleration of the mass at record i (in its lane), given its springs' force."""
    x, y, vx, vy = data[i + X * LANES], data[i + Y * LANES], data[i + VX * LANES], data[i + VY * LANES]
    weight, air, h = data[i + WEIGHT * LANES], data[i + AIR * LANES], data[i + STEP * LANES]
    ax = fx * weight - air * (vx * abs(vx)) + data[i + GX * LANES]
    ay = fy * weight - air * (vy * abs(vy)) + data[i + GY * LANES]
    if what == _FRESHEN:
        data[i + AX * LANES], data[i + AY * LANES] = ax, ay
    elif what == _STEP:
        vx, vy = vx + ax, vy + ay  # times the step already
        data[i + VX * LANES], data[i + VY * LANES] = vx, vy
        data[i + X * LANES], data[i + Y * LANES] = x + h * vx, y + h * vy
    elif what in (_KICK, _KICK_AND_DRIFT):
        old_x, old_y = data[i + AX * LANES], data[i + AY * LANES]
        vx = data[i + START_VX * LANES] + 0.5 * h * (old_x + ax)
        vy = data[i + START_VY * LANES] + 0.5 * h * (old_y + ay)
        # A lane that waits keeps what it carries, which is not of its velocities but of predicted ones.
        ax, ay = (ax if h > 0.0 else old_x), (ay if h > 0.0 else old_y)
        data[i + AX * LANES], data[i + AY * LANES] = ax, ay
        if what == _KICK:
            data[i + VX * LANES], data[i + VY * LANES] = vx, vy
        else:
            _drift(data, i, h, x, y, vx, vy, ax, ay)
    else:
        _stage(data, i, part * h, x, y, vx, vy, ax, ay, what)


@kernel(inline="always")
def _drift(data, i, h, x, y, vx, vy, ax, ay):
    """Verlet's x += h v + h²/2 a, and v + h a for the next force to see; later, v += h/2 (a + a')."""
    data[i + START_VX * LANES], data[i + START_VY * LANES] = vx, vy
    data[i + X * LANES], data[i + Y * LANES] = x + h * (vx + 0.5 * h * ax), y + h * (vy + 0.5 * h * ay)
    data[i + VX * LANES], data[i + VY * LANES] = vx + h * ax, vy + h * ay


@kernel(inline="always")
def _drift_all(data, masses):
    for place in range(_U(1), _U(masses) + _U(1)):
        for lane in range(LANES):
            i = place * _RECORD + lane
            x, y, h = data[i + X * LANES], data[i + Y * LANES], data[i + STEP * LANES]
            vx, vy = data[i + VX * LANES], data[i + VY * LANES]
            _drift(data, i, h, x, y, vx, vy, data[i + AX * LANES], data[i + AY * LANES])


@kernel(inline="always")
def _stage(data, i, h, x, y, vx, vy, ax, ay, what):
    """Kutta's method of order 4; each stage starts from the velocities and accelerations of the last."""
    if what == _LAST:
        data[i + X * LANES] = data[i + START_X * LANES] + h * (data[i + SUM_VX * LANES] + vx)
        data[i + Y * LANES] = data[i + START_Y * LANES] + h * (data[i + SUM_VY * LANES] + vy)
        data[i + VX * LANES] = data[i + START_VX * LANES] + h * (data[i + SUM_AX * LANES] + ax)
        data[i + VY * LANES] = data[i + START_VY * LANES] + h * (data[i + SUM_AY * LANES] + ay)
        return
    if what == _FIRST:
        start_x, start_y, start_vx, start_vy = x, y, vx, vy
        data[i + START_X * LANES], data[i + START_Y * LANES] = x, y
        data[i + START_VX * LANES], data[i + START_VY * LANES] = vx, vy
        data[i + SUM_VX * LANES], data[i + SUM_VY * LANES] = vx, vy
        data[i + SUM_AX * LANES], data[i + SUM_AY * LANES] = ax, ay
    else:
        start_x, start_y = data[i + START_X * LANES], data[i + START_Y * LANES]
        start_vx, start_vy = data[i + START_VX * LANES], data[i + START_VY * LANES]
        data[i + SUM_VX * LANES] += 2.0 * vx
        data[i + SUM_VY * LANES] += 2.0 * vy
        data[i + SUM_AX * LANES] += 2.0 * ax
        data[i + SUM_AY * LANES] += 2.0 * ay
    data[i + X * LANES], data[i + Y * LANES] = start_x + h * vx, start_y + h * vy
    data[i + VX * LANES], data[i + VY * LANES] = start_vx + h * ax, start_vy + h * ay
