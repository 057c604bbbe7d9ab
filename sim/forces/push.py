"""The push and the friction of whatever is entered: a wall, or the neighbourhood of a spring.

At the depth d, entered with the speed s, the push is k d² (1 + c s + b tanh(s / u0)), and the friction
mu N tanh(u / u0), where N is the push and u the speed along the surface. The push is continuously
differentiable at the surface, so that methods with error control keep their order. Its energy is k d³ / 3;
the rest is dissipated. One of c and b is zero, as the `Restitution` says. With c, the damping is that of
Hunt & Crossley, "Coefficient of restitution interpreted as damping in vibroimpact" (1975). With b, whatever
is entered pushes harder on the way in than on the way out, so that all speeds well above u0 lose the same
part (Walton & Braun, "Viscosity, granular-temperature, and stress calculations for shearing assemblies of
inelastic, frictional disks", 1986), and what hardly moves is damped as by a dashpot of N b / u0.

An explicit method with a fixed step h may arrive deep inside in a single step, where the push would throw the
mass out faster than it came. So for these methods all are softened, by what vanishes like the fourth power
of the step, as fast as the error of the best of them. With the mobility w (the acceleration by a force of
one) and x = h w (c k d² + 4 h k d), the push is divided by the fourth root of 1 + x⁴. The slip speed becomes
that of u0⁴ + (mu N h w)⁴ in the friction, and that of u0⁴ + (b k d² h w)⁴ in the push. The factor
1 + c s gets h s x⁴ / (2 d (1 + x⁴)) more, or else a bounce in few steps would gain some per cent of its
speed.

Kernels for one mass come first, then the same for arrays in NumPy, and how c follows from a bounciness.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from ..kernels.engine.jit import FUSED, kernel
from ..scene.surroundings import Restitution
from .term import Floats, Vectors

REFERENCE_SPEED = 1000.0
"""Speed, px/s, at which a mass hits a wall to leave it with the bounciness of the wall."""

CALMING = 0.5
"""Damping of a softened push, in parts of the depth that is left in a step; a quarter is just enough."""


@kernel(forceinline=True, fastmath=FUSED)
def push_and_friction(
    stiffness, damping, hysteresis, friction, slip_speed, h, mobility, mobility_along, depth, speed, along
):  # fmt: skip
    """(push, friction, elastic part of the push), kg px/s²; for a mass of 1 kg where k is a hardness.

    Args:
        stiffness, damping, hysteresis, friction, slip_speed: k, c, b, mu and u0 above.
        h: step of an explicit method with a fixed step, s; 0 for all others.
        mobility, mobility_along: w above, for the push and for the friction.
        depth: px, positive.
        speed: outwards, px/s.
        along: speed along the surface, px/s.
    """
    elastic = stiffness * depth * depth
    gain = 1.0 - damping * speed
    if hysteresis > 0.0:
        slow = math.sqrt(math.sqrt(slip_speed**4 + (h * mobility * hysteresis * elastic) ** 4))
        gain -= hysteresis * math.tanh(speed / slow)
    if h == 0.0:
        push = max(elastic * gain, 0.0)
        return push, friction * push * math.tanh(along / slip_speed), elastic
    power = (h * mobility * (damping * elastic + 4.0 * h * stiffness * depth)) ** 4
    gain -= CALMING * h * speed * (power / depth) / (1.0 + power)
    push = max(elastic * gain, 0.0) / math.sqrt(math.sqrt(1.0 + power))
    slip_speed = math.sqrt(math.sqrt(slip_speed**4 + (h * mobility_along * friction * push) ** 4))
    return push, friction * push * math.tanh(along / slip_speed), elastic


@kernel(forceinline=True, fastmath=FUSED)
def time_to_deepest(hardness, depth, speed, outwards, h):
    """The time, s, in which a mass gets as deep as its speed leads; infinite if it does not enter within h s.

    Args:
        hardness: acceleration by the push, per depth squared, 1/(px s²).
        depth: px; negative outside.
        speed: outwards, px/s.
        outwards: acceleration outwards, px/s². A mass that rests has none, and counts as slow.
        h: s.
    """
    if not max(depth, depth - h * speed) > 0.0:
        return math.inf
    # As fast as it is, and as it will be when it has been thrown out.
    out = math.sqrt(2.0 / 3.0 * hardness * max(depth, 0.0) ** 3)
    fastest = abs(speed) + min(h * abs(outwards), out)
    return (1.5 / (hardness * fastest + 1e-300)) ** (1.0 / 3.0)


@kernel(forceinline=True, fastmath=FUSED)
def push_slopes(stiffness, damping, hysteresis, slip_speed, depth, speed):
    """The derivatives of the push by depth and by the speed s outwards: k d² (1 - c s - b tanh(s / u0)).

    That is without what explicit methods change.
    """
    gain, slope = 1.0 - damping * speed, damping
    if hysteresis > 0.0:
        part = math.tanh(speed / slip_speed)
        gain -= hysteresis * part
        slope += hysteresis * (1.0 - part * part) / slip_speed
    if gain <= 0.0:
        return 0.0, 0.0
    return 2.0 * stiffness * depth * gain, -slope * stiffness * depth * depth


def pushes_and_frictions(
    stiffness: float,
    damping: float,
    hysteresis: float,
    friction: float | Floats,
    slip_speed: float,
    h: float,
    mobility: float | Floats,
    mobility_along: float | Floats,
    depth: NDArray[np.floating],
    speed: Vectors,
) -> tuple[Floats, Floats]:
    """The push and the friction of `push_and_friction` for arrays; the speed is outwards + i along."""
    elastic = stiffness * depth**2
    power = (h * mobility * (damping * elastic + 4.0 * h * stiffness * depth)) ** 4
    calming = CALMING * h / np.maximum(depth, 1e-300) * (power / (1.0 + power))
    slow = (slip_speed**4 + (h * mobility * hysteresis * elastic) ** 4) ** 0.25
    gain = 1.0 - (damping + calming) * speed.real - hysteresis * np.tanh(speed.real / slow)
    push = np.maximum(elastic * gain, 0.0) / (1.0 + power) ** 0.25
    slips = (slip_speed**4 + (h * mobility_along * friction * push) ** 4) ** 0.25
    return push, friction * push * np.tanh(speed.imag / slips)


def hysteresis_of(bounciness: float) -> float:
    """The b with which everything fast bounces with a part e of its speed: e² = (1 - b) / (1 + b)."""
    return (1.0 - bounciness**2) / (1.0 + bounciness**2)


def losses(restitution: Restitution, bounciness: float) -> tuple[float, float]:
    """(c, b), of which one is zero."""
    if restitution == "constant":
        return 0.0, hysteresis_of(bounciness)
    return damping_factor(bounciness), 0.0


def damping_factor(bounciness: float) -> float:
    """The factor c of the damping, s/px, with which a mass of the reference speed bounces as it should.

    Without other forces, a mass that enters with s leaves with r where c s - ln(1 + c s) = -c r - ln(1 - c r)
    (Hunt & Crossley 1975). Zero for a bounciness of 1; 0.01 is the least that is distinguished.
    """
    e = max(bounciness, 0.01)
    if e >= 1.0:
        return 0.0
    low, high = 0.0, 1.0 / e
    for _ in range(200):
        c = 0.5 * (low + high)
        left = c - math.log1p(c) + e * c + math.log1p(-e * c) if e * c < 1.0 else -math.inf
        # Both sides vanish at c = 0; in between, more damping is needed as long as the left side is larger.
        low, high = (c, high) if left > 0.0 else (low, c)
    return 0.5 * (low + high) / REFERENCE_SPEED
