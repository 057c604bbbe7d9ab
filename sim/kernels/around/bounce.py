"""The push and the friction of whatever is entered: a wall, or the surroundings of a spring.

At the depth d, entered with the speed s, the push is k d² (1 + c s), and the friction mu N tanh(u / u0),
where N is the push and u the speed along the surface. The push is continuously differentiable at the surface,
so that methods with error control keep their order. Its energy is k d³ / 3; the rest is dissipated. After
Hunt & Crossley, "Coefficient of restitution interpreted as damping in vibroimpact" (1975).

An explicit method with a fixed step h may arrive deep inside in a single step, where the push would throw the
mass out faster than it came. So for these methods both are softened, by what vanishes like the fourth power
of the step, as fast as the error of the best of them. With the mobility w (the acceleration by a force of
one) and x = h w (c k d² + 4 h k d), the push is divided by the fourth root of 1 + x⁴, and the slip speed
becomes that of u0⁴ + (mu N h w)⁴. The factor 1 + c s gets h s x⁴ / (2 d (1 + x⁴)) more, or else a bounce in
few steps would gain some per cent of its speed.
"""

from __future__ import annotations

import math

from ..core.jit import FUSED, kernel

CALMING = 0.5
"""Damping of a softened push, in parts of the depth that is left in a step; a quarter is just enough."""


@kernel(forceinline=True, fastmath=FUSED)
def push_and_friction(stiffness, loss, rough, slip, h, across, around, depth, speed, along):
    """(push, friction, elastic part of the push).

    Args:
        stiffness, loss, rough, slip: k, c, mu and u0 above.
        h: step of an explicit method with a fixed step, s; 0 for all others.
        across, around: mobility along the push and along the friction.
        depth: px, positive.
        speed: outwards, px/s.
        along: speed along the surface, px/s.
    """
    elastic = stiffness * depth * depth
    gain = 1.0 - loss * speed
    if h == 0.0:
        push = max(elastic * gain, 0.0)
        return push, rough * push * math.tanh(along / slip), elastic
    power = (h * across * (loss * elastic + 4.0 * h * stiffness * depth)) ** 4
    gain -= CALMING * h * speed * (power / depth) / (1.0 + power)
    push = max(elastic * gain, 0.0) / math.sqrt(math.sqrt(1.0 + power))
    slip = math.sqrt(math.sqrt(slip**4 + (h * around * rough * push) ** 4))
    return push, rough * push * math.tanh(along / slip), elastic


@kernel(forceinline=True, fastmath=FUSED)
def time_to_deepest(hardness, depth, speed, pull, h):
    """The time, s, in which a mass gets as deep as its speed leads; infinite if it does not enter within h s.

    Args:
        hardness: acceleration by the push, per depth squared, 1/(px s²).
        depth: px; negative outside.
        speed: outwards, px/s.
        pull: acceleration outwards, px/s². A mass that rests has none, and counts as slow.
        h: s.
    """
    if not max(depth, depth - h * speed) > 0.0:
        return math.inf
    # As fast as it is, and as it will be when it has been thrown out.
    out = math.sqrt(2.0 / 3.0 * hardness * max(depth, 0.0) ** 3)
    fastest = abs(speed) + min(h * abs(pull), out)
    return (1.5 / (hardness * fastest + 1e-300)) ** (1.0 / 3.0)


@kernel(forceinline=True, fastmath=FUSED)
def slopes_of_push(stiffness, loss, depth, speed):
    """The derivatives of the push, without what explicit methods change, by depth and by speed."""
    gain = 1.0 - loss * speed
    if gain <= 0.0:
        return 0.0, 0.0
    return 2.0 * stiffness * depth * gain, -loss * stiffness * depth * depth
