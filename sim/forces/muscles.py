"""Muscles: rest lengths and rest angles that follow a wave.

At the phase p = omega t + p0, a wave w is sin p, or the pulse exp(4 (sin p - 1)). A spring's rest length R is
its own times 1 + A w; a joint's rest angle is its own plus A w. A muscle that keys work has |e| w instead of
w, with the effort e of its keys, and -omega instead of omega where e is below 0; or e, if it is steady. After
a change of keys, an effort comes from e0 to its goal g, -1, 0 or 1, as e = g + (e0 - g) exp(-t / RISE).

Muscles are no `Term`, since they exert no force of their own. They change what springs and joints pull
towards, as held keys do, and all that reads that goes by it: forces, derivatives, energies, what yields. So
methods need to know only the time, see `forces.drive.actuate_muscles`. They work on a body by moving: with
the energy k (|L| - R)² / 2 of a spring by the power -k (|L| - R) dR/dt, and with the torque G of a joint by
-G times the rate of its rest angle.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import msgspec
import numpy as np

from ..engine.jit import FAST, kernel
from ..engine.numerics.waves import EFFORTS, KEYS, PULSE, RISE, SHARPNESS, SINCE, SINE, STEADY, wave_rate
from ..engine.table import Floats, Indices, Rows
from ..engine.tables import CONTROL_SCALE, Muscles
from ..scene.parts import Beat, JointMuscle, Keys, SpringMuscle
from ..scene.types import Scene
from .joints import joint_power
from .springs import spring_force

# ------------------------------------------------------------------------- rows, and how a scene gives them
NO_MUSCLES = Muscles.empty().read_only()
"""Those of a body without any."""


class Row(NamedTuple):
    """A muscle; `engine.numerics.waves` has the columns."""

    amplitude: float  # of a spring's a fraction, of a joint's degrees
    rate: float  # omega, 1/s
    phase: float  # p0, radians
    kind: float  # of its wave
    steer: float  # index in `State.steer` of the keys that work it, or -1


KINDS = {"sine": SINE, "pulse": PULSE, "steady": STEADY}
"""Kinds by the names of waves."""


def steer_of(keys: Keys | msgspec.UnsetType) -> int:
    """The index in `State.steer` of what some keys do, -1 without keys."""
    return STEERS[keys] if keys else -1


STEERS: dict[str, int] = {"left-right": 0, "up-down": 1}
"""The index in `State.steer` by pairs of keys."""


def new_muscles(scene: Scene, spring_order: Indices, joint_order: Indices) -> Muscles:
    """The table of a valid scene.

    Args:
        scene: the scene.
        spring_order: (S,) scene index of each spring of the tables.
        joint_order: (J,) index in the tables of each joint of the scene.
    """
    beat, springs, joints = scene.beat, scene.linear_springs, scene.angular_springs
    if not beat:
        return NO_MUSCLES
    stretched = [(k, muscle) for k, s in enumerate(spring_order.tolist()) if (muscle := springs[s].muscle)]
    turned = [
        (k, muscle) for k, joint in zip(joint_order.tolist(), joints, strict=True) if (muscle := joint.muscle)
    ]
    return Muscles(
        present=bool(stretched or turned),
        period=1.0 / beat.frequency if beat.frequency else 0.0,
        spring=np.array([k for k, _ in stretched], np.int64),
        stretch=_rows(beat, [muscle for _, muscle in stretched]),
        joint=np.array([k for k, _ in turned], np.int64),
        turn=_rows(beat, [muscle for _, muscle in turned]),
    )


def swings(
    beat: Beat, muscles: Sequence[SpringMuscle | JointMuscle], steer: Sequence[float], time: float
) -> Floats:
    """(k,) the amplitude times the wave of each muscle at a time, s; `steer`: of a state, or empty."""
    return waves(_rows(beat, muscles), np.array(steer or (0.0,) * (SINCE + 1)), time)


def _rows(beat: Beat, muscles: Sequence[SpringMuscle | JointMuscle]) -> Rows:
    """(k, 5) a row for each muscle."""
    rows = [
        Row(
            muscle.amplitude,
            math.tau * muscle.per_beat * beat.frequency,
            math.radians(muscle.per_beat * beat.phase + muscle.phase),
            KINDS[muscle.wave],
            float(steer_of(muscle.keys)),
        )
        for muscle in muscles
    ]
    return np.array(rows, float).reshape(-1, len(Row._fields))


# ------------------------------------------------------------------------- the balance
@kernel(fastmath=FAST)
def power_of_muscles(body, state, q, t):
    """The power of all muscles at time t, at which rest lengths and angles are what they make of them;
    kg px²/s³."""
    muscles, scale, power = body.muscles, state.controls[CONTROL_SCALE], 0.0
    for i in range(muscles.spring.size):
        s = muscles.spring[i]
        growth = body.rest_length[s] * scale * wave_rate(muscles.stretch[i], state.steer, t)
        power -= spring_force(body, state, q, s) * growth
    for i in range(muscles.joint.size):
        power += joint_power(body, state, q, muscles.joint[i], wave_rate(muscles.turn[i], state.steer, t))
    return power


# ------------------------------------------------------------------------- in NumPy
def efforts(steer: Floats, t: float) -> Floats:
    """(2,) the effort of each pair of keys at a time, s."""
    goals = steer[:KEYS]
    return goals + (steer[EFFORTS:SINCE] - goals) * math.exp(-max(t - steer[SINCE], 0.0) / RISE)


def waves(rows: Rows, steer: Floats, t: float) -> Floats:
    """(k,) the amplitude times the wave of each row at a time, s."""
    amplitude, rate, phase, kind, keys = rows.T
    effort = np.where(keys < 0.0, 1.0, efforts(steer, t)[np.maximum(keys, 0.0).astype(int)])
    sine = np.sin(np.copysign(rate, effort) * t + phase)
    size = np.where(kind == PULSE, np.exp(SHARPNESS * (sine - 1.0)), sine)
    return amplitude * np.where(kind == STEADY, effort, np.abs(effort) * size)
