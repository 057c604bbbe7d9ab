"""Muscles: rest lengths and rest angles that follow a wave.

At the phase p = omega t + p0, a wave w is sin p, or the pulse exp(4 (sin p - 1)). A spring's rest length R is
its own times 1 + A w; a joint's rest angle is its own plus A w.

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

import numpy as np

from ..engine.jit import FAST, kernel
from ..engine.numerics.waves import SHARPNESS, wave_rate
from ..engine.table import Floats, Indices, Rows
from ..engine.tables import CONTROL_SCALE, Muscles
from ..scene.parts import Beat, JointMuscle, SpringMuscle
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
    pulse: float  # 1 for a pulse, 0 for a sine


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


def swings(beat: Beat, muscles: Sequence[SpringMuscle | JointMuscle], time: float) -> Floats:
    """(k,) the amplitude times the wave of each muscle at a time, s."""
    return waves(_rows(beat, muscles), time)


def _rows(beat: Beat, muscles: Sequence[SpringMuscle | JointMuscle]) -> Rows:
    """(k, 4) a row for each muscle."""
    rows = [
        Row(
            muscle.amplitude,
            math.tau * muscle.per_beat * beat.frequency,
            math.radians(muscle.per_beat * beat.phase + muscle.phase),
            float(muscle.wave == "pulse"),
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
        growth = body.rest_length[s] * scale * wave_rate(muscles.stretch[i], t)
        power -= spring_force(body, state, q, s) * growth
    for i in range(muscles.joint.size):
        power += joint_power(body, state, q, muscles.joint[i], wave_rate(muscles.turn[i], t))
    return power


# ------------------------------------------------------------------------- in NumPy
def waves(rows: Rows, t: float) -> Floats:
    """(k,) the amplitude times the wave of each row at a time, s."""
    amplitude, rate, phase, pulse = rows.T
    size = np.sin(rate * t + phase)
    return amplitude * np.where(pulse > 0.0, np.exp(SHARPNESS * (size - 1.0)), size)
