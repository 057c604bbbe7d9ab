"""The arrays that the kernels read and write.

Every array is one-dimensional, C-contiguous, float64 or int64, so that a kernel is compiled once. Arrays
over masses and springs are padded to a multiple of eight: vector loops then have no scalar rest, which for
twelve masses is the larger part of the work. A padding mass never moves and a padding spring pulls at
nothing; both are far apart, so that no length is zero.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Indices = NDArray[np.int64]


class Body(NamedTuple):
    """Read-only: how masses are joined, and the springs' constants. S springs, J joints, n masses.

    In a chain, spring s joins masses s and s + 1 and joint j holds springs j and j + 1.
    """

    masses: int
    springs: int
    joints: int
    damped: bool  # any linear spring has damping
    spring_a: Indices  # (S,) mass at the start of each spring
    spring_b: Indices
    stiffness: Floats  # (S padded) kg/s²
    damping: Floats  # (S padded) kg/s
    rest_length: Floats  # (S padded) px, before the scale
    joint_a: Indices  # (J,) first spring of each joint
    joint_b: Indices
    joint_stiffness: Floats  # (J,) kg/s²
    joint_rest: Floats  # (J,) degrees, before the shift
    # The couple of a joint acts on its spring a with one sign and on its spring b with the other. Each spring
    # names one joint of which it is b and one of which it is a (J where there is none: a couple of
    # zero); the rare others are in the lists. So the common case is a gather without branches.
    joint_in: Indices  # (S,)
    joint_out: Indices  # (S,)
    more_joint: Indices
    more_joint_spring: Indices
    more_joint_sign: Floats
    # The same for the springs of each mass.
    spring_in: Indices  # (n,)
    spring_out: Indices  # (n,)
    more_spring: Indices
    more_spring_mass: Indices
    more_spring_sign: Floats


class Live(NamedTuple):
    """Mutable: the state, and what the keys and the hand of the user change while it runs."""

    x: Floats  # (n padded) px
    y: Floats
    vx: Floats  # (n padded) px/s
    vy: Floats
    controls: Floats  # rest_length_scale, rest_angle_shift (degrees)
    pull: Floats  # (S padded) stiffness * rest length now
    couple_cos: Floats  # (J padded) stiffness * cos(rest angle now)
    couple_sin: Floats
    # What a force does to a mass in one step; all zero for a mass that is held.
    dt_mass: Floats  # (n padded) dt / m
    dt_air: Floats  # (n padded) dt * air friction / m
    dt_gx: Floats  # (n padded) dt * gravity
    dt_gy: Floats


class Work(NamedTuple):
    """Scratch, so that no step allocates."""

    lx: Floats  # (S padded) vectors of the springs
    ly: Floats
    dvx: Floats
    dvy: Floats
    inverse: Floats  # 1 / length
    turn: Floats  # what the joints add up to at each spring
    couple: Floats  # (J padded)
    tx: Floats  # force on the b end of each spring
    ty: Floats
    fx: Floats  # (n padded)
    fy: Floats


class Motion(NamedTuple):
    """What happens during one call: masses led from place to place, and keys held."""

    active: bool  # anything happens at all
    mass: Indices  # (M,) masses that are led
    from_x: Floats  # (M,)
    from_y: Floats
    to_x: Floats  # (M,) reached at the last step of the call
    to_y: Floats
    length_factor: float  # of every rest length, per step
    angle_step: float  # added to every rest angle, per step, degrees


CONTROL_SCALE, CONTROL_SHIFT = 0, 1
SCALE_MIN, SCALE_MAX = 0.01, 100.0


def padded(count: int) -> int:
    """The count, rounded up to a multiple of eight."""
    return -(-count // 8) * 8
