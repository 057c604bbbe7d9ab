"""Many copies of one chain at once, by explicit methods with a fixed step: a lane of a vector is a body.

All bodies of a batch have as many masses, and nothing else in common: each lane has a step, masses, springs
and joints of its own. Lanes are innermost, so that every loop over them is a vector operation, however short
the chain. Everything is in one flat array, in which place p has a record of FIELDS times LANES numbers: all
distances between what a loop reads and writes are constants, and the compiler needs no test for overlaps,
which with an array for each field keeps it from vectorising.

The record of place p has the mass at place p, the spring from there to the next place and the joint between
that spring and the one before it. The first record and the last are of no mass and no spring: zeros.
"""

from __future__ import annotations

import numpy as np

from .jit import FAST, kernel
from .lanes import eight_at_a_time
from .roots import inverse_root
from .tables import CONSERVATIVE

_U = np.uint64
"""Of all constants of the layout: numba tests signed indices for being negative, which no vector survives."""

LANES = _U(16)
"""Bodies of a batch."""

X, Y, VX, VY = _U(0), _U(1), _U(2), _U(3)
WEIGHT, AIR, GX, GY = _U(4), _U(5), _U(6), _U(7)
"""Of a mass: 1/kg, 1/px and px/s²; zero where it is held."""
STIFFNESS, DAMPING, PULL = _U(8), _U(9), _U(10)
"""Of a spring: kg/s², kg/s, and stiffness times rest length."""
COUPLE_COS, COUPLE_SIN, COUPLE_SIZE = _U(11), _U(12), _U(13)
"""Of a joint: its stiffness times the cosine and the sine of its rest angle, and its stiffness, kg/s²."""
STEP = _U(14)
"""The step of the lane, s; in every record, since that is where the loop is."""
LX, LY, INVERSE, ALONG, COUPLE, LENGTH, TX, TY = (
    _U(15),
    _U(16),
    _U(17),
    _U(18),
    _U(19),
    _U(20),
    _U(21),
    _U(22),
)
"""Scratch, of a spring."""
START_X, START_Y, START_VX, START_VY = _U(23), _U(24), _U(25), _U(26)
"""Of a mass at the start of a step of several stages."""
AX, AY = _U(27), _U(28)
"""Acceleration that velocity Verlet carries from step to step, px/s²."""
SUM_VX, SUM_VY, SUM_AX, SUM_AY = _U(27), _U(28), _U(29), _U(30)
"""Of the stages of Runge and Kutta's method, with their weights: 1, 2, 2, 1."""
FIELDS = _U(31)

EULER, VERLET, RUNGE_KUTTA_4 = 0, 1, 2
"""Methods that `run_ensemble` knows."""

_RECORD = FIELDS * LANES


@kernel(fastmath=FAST)
def run_ensemble(data, todo, masses, law, method, fresh):
    """Do `todo[lane]` steps in every lane, and leave the state in `data`.

    A lane that is done waits for the others with a step of zero. Nothing stops a body that runs away: its
    numbers go to infinity and on to NaN, which harms no other lane.

    Args:
        data: ((masses + 2) records,) see above; the steps are zero at the end.
        todo: (LANES,) steps; zero at the end.
        law: NO_JOINTS, TUTORIAL or CONSERVATIVE; damping of joints is not known here.
        method: EULER, VERLET or RUNGE_KUTTA_4.
        fresh: whether the bodies have just been put where they are: velocity Verlet then carries nothing yet.
    """
    eight_at_a_time()
    conservative = law == CONSERVATIVE
    if method == VERLET and fresh:
        if conservative:
            _freshen(data, masses, True)
        else:
            _freshen(data, masses, False)
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
                    data[place * _RECORD + STEP * LANES + lane] = 0.0
            todo[lane] = max(todo[lane] - steps, 0)
        if conservative:
            _steps(data, masses, steps, method, True)
        else:
            _steps(data, masses, steps, method, False)


@kernel(inline="always")
def _springs(data, masses, conservative):
    """What depends on one spring, and under the tutorial's law on the one before it."""
    for place in range(_U(1), _U(masses)):
        p = place * _RECORD
        for lane in range(LANES):
            i = p + lane
            n = i + _RECORD
            lx = data[n + X * LANES] - data[i + X * LANES]
            ly = data[n + Y * LANES] - data[i + Y * LANES]
            rate = lx * (data[n + VX * LANES] - data[i + VX * LANES]) + ly * (
                data[n + VY * LANES] - data[i + VY * LANES]
            )
            square = lx * lx + ly * ly
            inverse = inverse_root(square)
            data[i + LX * LANES], data[i + LY * LANES] = lx, ly
            data[i + ALONG * LANES] = (
                data[i + PULL * LANES] * inverse
                - data[i + STIFFNESS * LANES]
                - data[i + DAMPING * LANES] * rate * (inverse * inverse)
            )
            if conservative:
                data[i + INVERSE * LANES] = inverse
                data[i + LENGTH * LANES] = square * inverse
            else:
                b = i - _RECORD
                ax, ay = data[b + LX * LANES], data[b + LY * LANES]
                cross, dot = ax * ly - ay * lx, ax * lx + ay * ly
                data[i + INVERSE * LANES] = inverse * inverse
                data[i + COUPLE * LANES] = (
                    data[i + COUPLE_COS * LANES] * cross - data[i + COUPLE_SIN * LANES] * dot
                )


@kernel(inline="always")
def _acceleration(data, i, conservative):
    """Of the mass in this lane and record, once that of the one before it is known."""
    n, b = i + _RECORD, i - _RECORD
    lx, ly, along = data[i + LX * LANES], data[i + LY * LANES], data[i + ALONG * LANES]
    if conservative:
        cos, sin = data[i + COUPLE_COS * LANES], data[i + COUPLE_SIN * LANES]
        next_cos, next_sin = data[n + COUPLE_COS * LANES], data[n + COUPLE_SIN * LANES]
        ax, ay = data[b + LX * LANES], data[b + LY * LANES]
        cx, cy = data[n + LX * LANES], data[n + LY * LANES]
        push = (
            data[i + COUPLE_SIZE * LANES] * data[b + LENGTH * LANES]
            + data[n + COUPLE_SIZE * LANES] * data[n + LENGTH * LANES]
        )
        along -= push * data[i + INVERSE * LANES]
        tx = along * lx + cos * ax - sin * ay + next_cos * cx + next_sin * cy
        ty = along * ly + sin * ax + cos * ay - next_sin * cx + next_cos * cy
    else:
        across = (data[i + COUPLE * LANES] - data[n + COUPLE * LANES]) * data[i + INVERSE * LANES]
        tx, ty = along * lx + across * ly, along * ly - across * lx
    data[i + TX * LANES], data[i + TY * LANES] = tx, ty
    weight, air = data[i + WEIGHT * LANES], data[i + AIR * LANES]
    vx, vy = data[i + VX * LANES], data[i + VY * LANES]
    ax = (data[b + TX * LANES] - tx) * weight - air * (vx * abs(vx)) + data[i + GX * LANES]
    ay = (data[b + TY * LANES] - ty) * weight - air * (vy * abs(vy)) + data[i + GY * LANES]
    return ax, ay


@kernel(inline="always")
def _steps(data, masses, steps, method, conservative):
    if method == EULER:
        for _ in range(steps):
            _euler(data, masses, conservative)
    elif method == VERLET:
        for _ in range(steps):
            _verlet(data, masses, conservative)
    else:
        for _ in range(steps):
            _runge_kutta(data, masses, conservative)


@kernel(inline="always")
def _euler(data, masses, conservative):
    """Symplectic Euler: v += h a, then x += h v."""
    _springs(data, masses, conservative)
    for place in range(_U(1), _U(masses) + _U(1)):
        p = place * _RECORD
        for lane in range(LANES):
            i = p + lane
            ax, ay = _acceleration(data, i, conservative)
            h = data[i + STEP * LANES]
            vx, vy = data[i + VX * LANES] + h * ax, data[i + VY * LANES] + h * ay
            data[i + VX * LANES], data[i + VY * LANES] = vx, vy
            data[i + X * LANES] += h * vx
            data[i + Y * LANES] += h * vy


@kernel(inline="always")
def _freshen(data, masses, conservative):
    _springs(data, masses, conservative)
    for place in range(_U(1), _U(masses) + _U(1)):
        p = place * _RECORD
        for lane in range(LANES):
            i = p + lane
            ax, ay = _acceleration(data, i, conservative)
            data[i + AX * LANES], data[i + AY * LANES] = ax, ay


@kernel(inline="always")
def _verlet(data, masses, conservative):
    """x += h v + h²/2 a, v += h/2 (a + a'); a' is that of the new positions and of v + h a."""
    for place in range(_U(1), _U(masses) + _U(1)):
        p = place * _RECORD
        for lane in range(LANES):
            i = p + lane
            h, vx, vy = data[i + STEP * LANES], data[i + VX * LANES], data[i + VY * LANES]
            ax, ay = data[i + AX * LANES], data[i + AY * LANES]
            data[i + START_VX * LANES], data[i + START_VY * LANES] = vx, vy
            data[i + X * LANES] += h * (vx + 0.5 * h * ax)
            data[i + Y * LANES] += h * (vy + 0.5 * h * ay)
            data[i + VX * LANES], data[i + VY * LANES] = vx + h * ax, vy + h * ay
    _springs(data, masses, conservative)
    for place in range(_U(1), _U(masses) + _U(1)):
        p = place * _RECORD
        for lane in range(LANES):
            i = p + lane
            h = data[i + STEP * LANES]
            old_x, old_y = data[i + AX * LANES], data[i + AY * LANES]
            ax, ay = _acceleration(data, i, conservative)
            data[i + VX * LANES] = data[i + START_VX * LANES] + 0.5 * h * (old_x + ax)
            data[i + VY * LANES] = data[i + START_VY * LANES] + 0.5 * h * (old_y + ay)
            # A lane that waits keeps what it carries, which is not of its velocities but of predicted ones.
            data[i + AX * LANES] = ax if h > 0.0 else old_x
            data[i + AY * LANES] = ay if h > 0.0 else old_y


@kernel(inline="always")
def _runge_kutta(data, masses, conservative):
    """Kutta's method of order 4; each stage starts from the velocities and accelerations of the last."""
    _first_stage(data, masses, conservative)
    for stage in range(2):
        _middle_stage(data, masses, conservative, 0.5 if stage == 0 else 1.0)
    _last_stage(data, masses, conservative)


# The first stage keeps the start and the last one goes to the end: passes of their own would take a tenth
# more time, since a batch is larger than the nearest cache.
@kernel(inline="always")
def _first_stage(data, masses, conservative):
    _springs(data, masses, conservative)
    for place in range(_U(1), _U(masses) + _U(1)):
        p = place * _RECORD
        for lane in range(LANES):
            i = p + lane
            ax, ay = _acceleration(data, i, conservative)
            x, y = data[i + X * LANES], data[i + Y * LANES]
            vx, vy = data[i + VX * LANES], data[i + VY * LANES]
            h = 0.5 * data[i + STEP * LANES]
            data[i + START_X * LANES], data[i + START_Y * LANES] = x, y
            data[i + START_VX * LANES], data[i + START_VY * LANES] = vx, vy
            data[i + SUM_VX * LANES], data[i + SUM_VY * LANES] = vx, vy
            data[i + SUM_AX * LANES], data[i + SUM_AY * LANES] = ax, ay
            data[i + X * LANES], data[i + Y * LANES] = x + h * vx, y + h * vy
            data[i + VX * LANES], data[i + VY * LANES] = vx + h * ax, vy + h * ay


@kernel(inline="always")
def _middle_stage(data, masses, conservative, part):
    _springs(data, masses, conservative)
    for place in range(_U(1), _U(masses) + _U(1)):
        p = place * _RECORD
        for lane in range(LANES):
            i = p + lane
            ax, ay = _acceleration(data, i, conservative)
            vx, vy = data[i + VX * LANES], data[i + VY * LANES]
            h = part * data[i + STEP * LANES]
            data[i + SUM_VX * LANES] += 2.0 * vx
            data[i + SUM_VY * LANES] += 2.0 * vy
            data[i + SUM_AX * LANES] += 2.0 * ax
            data[i + SUM_AY * LANES] += 2.0 * ay
            data[i + X * LANES] = data[i + START_X * LANES] + h * vx
            data[i + Y * LANES] = data[i + START_Y * LANES] + h * vy
            data[i + VX * LANES] = data[i + START_VX * LANES] + h * ax
            data[i + VY * LANES] = data[i + START_VY * LANES] + h * ay


@kernel(inline="always")
def _last_stage(data, masses, conservative):
    _springs(data, masses, conservative)
    for place in range(_U(1), _U(masses) + _U(1)):
        p = place * _RECORD
        for lane in range(LANES):
            i = p + lane
            ax, ay = _acceleration(data, i, conservative)
            vx, vy = data[i + VX * LANES], data[i + VY * LANES]
            h = (1.0 / 6.0) * data[i + STEP * LANES]
            data[i + X * LANES] = data[i + START_X * LANES] + h * (data[i + SUM_VX * LANES] + vx)
            data[i + Y * LANES] = data[i + START_Y * LANES] + h * (data[i + SUM_VY * LANES] + vy)
            data[i + VX * LANES] = data[i + START_VX * LANES] + h * (data[i + SUM_AX * LANES] + ax)
            data[i + VY * LANES] = data[i + START_VY * LANES] + h * (data[i + SUM_AY * LANES] + ay)
