"""The push and the friction of whatever is entered: a wall, or the neighbourhood of a spring.

At the depth d, entered with the speed s, the push is k d² (1 + c s + b tanh(s / s1)), at least 0, and the
friction mu N tanh(u / u0), where N is the push and u the speed along the surface. The push is continuously
differentiable at the surface, so that methods with error control keep their order. Its energy is k d³ / 3;
the rest is dissipated. One of c and b is zero, as the `Restitution` says. With c, the damping is that of
Hunt & Crossley, "Coefficient of restitution interpreted as damping in vibroimpact" (1975).

With b, whatever enters is pushed harder on the way in than on the way out, as by Walton & Braun, "Viscosity,
granular-temperature, and stress calculations for shearing assemblies of inelastic, frictional disks" (1986).
With s1 = `_CALM` sqrt(k w) d^(3/2), which is in proportion to the speed that leads to the depth d, and the
mobility w (the acceleration by a force of one), bounces at all speeds are alike, so all lose the same part,
and what is at rest in a depth is damped like a spring of the damping ratio b / (2 sqrt(2) `_CALM`). After
Tsuji, Tanaka & Ishida, "Lagrangian numerical simulation of plug flow of cohesionless particles in a
horizontal pipe" (1992), whose damping grows with sqrt(k w) d^(1/2), too, but without bounds.

Friction that holds is that of a tangential spring (Cundall & Strack, "A discrete numerical model for granular
assemblies", 1979): where its stiffness K is not zero, the friction is K z + G u, where both K z and the sum
are limited to mu N. The stretch z, px, is the way along the surface since both touched, less what
exceeded mu N / K at the end of any step: an elastic part and a slider in a row, with the slider's return
mapping after the step, as in `plasticity`. So nothing creeps that mu N is enough to hold. The
spring has the energy K z² / 2, and what the slider and the dashpot take is dissipated. The dashpot
G = sqrt(K / w) has the damping ratio 1/2.

An explicit method with a fixed step h may arrive deep inside in a single step, where the push would throw the
mass out faster than it came. So for these methods all are softened, by what vanishes like the fourth power
of the step, as fast as the error of the best of them. With x = h w (c k d² + 4 h k d), the push is divided by
the fourth root of 1 + x⁴. The factor 1 + c s gets h s x⁴ / (2 d (1 + x⁴)) more, or else a bounce in few steps
would gain some per cent of its speed. The slip speed u0 becomes that of u0⁴ + (mu N h w)⁴, and s1 that of
s1⁴ + (b k d² h w)⁴. K is divided by the fourth root of 1 + (h² w K)⁴, and G by that of 1 + (2 h w G)⁴.

Kernels for one mass come first, then the same for arrays in NumPy, and how c follows from a bounciness.
"""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from ...engine.jit import FUSED, kernel
from ...engine.numerics.tanhs import tanh
from ...scene.surroundings import Restitution
from ..term import Floats, Vectors

REFERENCE_SPEED = 1000.0
"""Speed, px/s, at which a mass hits a wall to leave it with the bounciness of the wall. Doubled or halved,
`test_short_steps_leave_as_the_bounciness_says` fails."""

_CALM = 0.06
"""Speed below which the push is damped as by a dashpot, in parts of sqrt(k w) d^(3/2): so small that what
rolls loses speed, too, and so large that it hardly makes the equations stiffer than bodies are. Doubled,
`test_a_heap_of_rings_comes_to_rest` fails."""
_MIN_BOUNCE = 0.1
"""The least bounciness that is distinguished with a constant restitution. Doubled,
`test_with_a_constant_restitution_all_speeds_keep_the_same_part` fails."""

CALMING = 0.5
"""Damping of a softened push, in parts of the depth that is left in a step; a quarter is just enough. Halved,
`test_a_fixed_step_that_resolves_a_bounce_keeps_its_height` fails."""


@kernel(forceinline=True, fastmath=FUSED)
def push_and_friction(
    stiffness, lost, friction, slip_speed, tangential, h, mobility, mobility_along, depth, speed, along,
    stretch,
):  # fmt: skip
    """(push, friction, elastic part of the push), kg px/s²; for a mass of 1 kg where k is a hardness.

    Args:
        stiffness, lost, friction, slip_speed, tangential: k, (c, b, s1 / d^(3/2)), mu, u0 and (K, G) above.
        h: step of an explicit method with a fixed step, s; 0 for all others.
        mobility, mobility_along: w above, for the push and for the friction.
        depth: px, positive.
        speed: outwards, px/s.
        along: speed along the surface, px/s.
        stretch: z above, px.
    """
    damping, hysteresis, calm = lost
    elastic = stiffness * depth * depth
    gain = 1.0 - damping * speed
    if hysteresis > 0.0:
        if h > 0.0:
            fourth = (calm * depth) ** 4 * (depth * depth)
            slow = math.sqrt(math.sqrt(fourth + (h * mobility * hysteresis * elastic) ** 4))
        else:
            slow = calm * depth * math.sqrt(depth)
        gain -= hysteresis * tanh(speed / (slow + 1e-300))
    if h == 0.0:
        push = max(elastic * gain, 0.0)
        return push, _friction_force(friction * push, slip_speed, tangential, along, stretch), elastic
    power = (h * mobility * (damping * elastic + 4.0 * h * stiffness * depth)) ** 4
    less = 1.0 / (1.0 + power)
    push = stiffness * depth * (depth * gain - CALMING * h * speed * power * less)
    push = max(push, 0.0) * math.sqrt(math.sqrt(less))
    most, tangential = friction * push, softened(tangential, h, mobility_along)
    slip_speed = math.sqrt(math.sqrt(slip_speed**4 + (h * mobility_along * most) ** 4))
    return push, _friction_force(most, slip_speed, tangential, along, stretch), elastic


@kernel(forceinline=True, fastmath=FUSED)
def softened(tangential, h, mobility_along):
    """(K, G) of a tangential spring for a fixed step of h seconds; arguments as above."""
    stiffness, damping = tangential
    if h == 0.0 or stiffness == 0.0:
        return stiffness, damping
    x, y = h * h * mobility_along * stiffness, 2.0 * h * mobility_along * damping
    return stiffness / math.sqrt(math.sqrt(1.0 + x**4)), damping / math.sqrt(math.sqrt(1.0 + y**4))


@kernel(forceinline=True, fastmath=FUSED)
def _friction_force(most, slip_speed, tangential, along, stretch):
    """Friction, limited to `most`."""
    stiffness, damping = tangential
    if stiffness == 0.0:
        return most * tanh(along / slip_speed)
    elastic = min(max(stiffness * stretch, -most), most)
    return min(max(elastic + damping * along, -most), most)


@kernel(forceinline=True, fastmath=FUSED)
def friction_slopes(most, slip_speed, tangential, along, stretch):
    """The derivatives of friction by `most` = mu N, by the stretch, and by the speed along.

    That is without what explicit methods change.
    """
    stiffness, damping = tangential
    if stiffness == 0.0:
        held = tanh(along / slip_speed)
        return held, 0.0, most * (1.0 - held * held) / slip_speed
    elastic, by_most, by_stretch = stiffness * stretch, 0.0, stiffness
    if abs(elastic) >= most:
        by_most, by_stretch = math.copysign(1.0, elastic), 0.0
        elastic = by_most * most
    whole = elastic + damping * along
    if abs(whole) >= most:
        return math.copysign(1.0, whole), 0.0, 0.0
    return by_most, by_stretch, damping


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
def push_slopes(stiffness, lost, depth, speed):
    """The derivatives of the push by depth and by the speed s outwards: k d² (1 - c s - b tanh(s / s1)).

    That is without what explicit methods change.
    """
    damping, hysteresis, calm = lost
    gain, slope, steeper = 1.0 - damping * speed, damping, 0.0
    if hysteresis > 0.0:
        slow = calm * depth * math.sqrt(depth) + 1e-300
        part = tanh(speed / slow)
        gain -= hysteresis * part
        left = hysteresis * (1.0 - part * part) / slow
        slope, steeper = slope + left, 1.5 * left * speed
    if gain <= 0.0:
        return 0.0, 0.0
    return stiffness * depth * (2.0 * gain + steeper), -slope * stiffness * depth * depth


def pushes_and_frictions(
    stiffness: float,
    lost: Lost,
    friction: float | Floats,
    slip_speed: float,
    tangential: tuple[float, float],
    h: float,
    mobility: float | Floats,
    mobility_along: float | Floats,
    depth: NDArray[np.floating],
    speed: Vectors,
    stretch: Floats,
) -> tuple[Floats, Floats]:
    """The push and the friction of `push_and_friction` for arrays; the speed is outwards + i along."""
    damping, hysteresis, calm = lost
    elastic = stiffness * depth**2
    power = (h * mobility * (damping * elastic + 4.0 * h * stiffness * depth)) ** 4
    calming = CALMING * h / np.maximum(depth, 1e-300) * (power / (1.0 + power))
    slow = ((calm * np.maximum(depth, 0.0) ** 1.5) ** 4 + (h * mobility * hysteresis * elastic) ** 4) ** 0.25
    gain = 1.0 - (damping + calming) * speed.real
    gain -= hysteresis * np.tanh(speed.real / np.maximum(slow, 1e-300))
    push = np.maximum(elastic * gain, 0.0) / (1.0 + power) ** 0.25
    most = friction * push
    if tangential[0] == 0.0:
        slips = (slip_speed**4 + (h * mobility_along * most) ** 4) ** 0.25
        return push, most * np.tanh(speed.imag / slips)
    held, resisting = softened_for(tangential, h, mobility_along)
    return push, np.clip(np.clip(held * stretch, -most, most) + resisting * speed.imag, -most, most)


def softened_for(
    tangential: tuple[float, float], h: float, mobility_along: float | Floats
) -> tuple[float | Floats, float | Floats]:
    """`softened` for arrays."""
    stiffness, damping = tangential
    x, y = h * h * mobility_along * stiffness, 2.0 * h * mobility_along * damping
    return stiffness / (1.0 + x**4) ** 0.25, damping / (1.0 + y**4) ** 0.25


Lost = tuple[float, float, float]
"""(c, b, s1 / d^(3/2)), s/px, 1 and px^(-1/2)/s; c or b is zero."""


def losses(restitution: Restitution, bounciness: float, stiffness: float, mobility: float) -> Lost:
    """How a push of a stiffness k, on what has the mobility w, loses energy."""
    calm = _CALM * math.sqrt(stiffness * mobility)
    if restitution == "constant":
        return 0.0, hysteresis_of(bounciness), calm
    return damping_factor(bounciness), 0.0, calm


def tangential_spring(stiffness: float, mobility: float) -> tuple[float, float]:
    """(K, G) of what has the mobility w along the surface."""
    return stiffness, math.sqrt(stiffness / mobility)


@lru_cache
def hysteresis_of(bounciness: float) -> float:
    """The b with which everything leaves with the part e of the speed with which it came."""
    e = max(bounciness, _MIN_BOUNCE)
    if e >= 1.0:
        return 0.0
    low, high = 0.0, 1.5
    for _ in range(40):
        b = 0.5 * (low + high)
        low, high = (b, high) if _left_of_a_bounce(b) > e else (low, b)
    return 0.5 * (low + high)


def _left_of_a_bounce(b: float) -> float:
    """The speed that is left of 1 in units in which k w = 1, by Runge-Kutta steps."""
    h, depth, speed = 0.02, 0.0, 1.0  # speed: inwards

    def pushed(depth: float, speed: float) -> float:
        if depth <= 0.0:
            return 0.0
        return -depth * depth * max(1.0 + b * math.tanh(speed / (_CALM * depth**1.5)), 0.0)

    while depth > 0.0 or speed > 0.0:
        a1 = pushed(depth, speed)
        a2 = pushed(depth + 0.5 * h * speed, speed + 0.5 * h * a1)
        a3 = pushed(depth + 0.5 * h * (speed + 0.5 * h * a1), speed + 0.5 * h * a2)
        a4 = pushed(depth + h * (speed + 0.5 * h * a2), speed + h * a3)
        depth += h * (speed + h / 6.0 * (a1 + a2 + a3))
        speed += h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4)
    return -speed


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
