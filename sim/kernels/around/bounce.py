"""The push and the friction of whatever is entered: a wall, or the surroundings of a spring.

At the depth d, entered with the speed s, the push is k d² (1 + c s), and the friction mu N tanh(u / u0),
where N is the push and u the speed along the surface. The push is continuously differentiable at the surface,
so that methods with error control keep their order. Its energy is k d³ / 3; the rest is dissipated. After
Hunt & Crossley, "Coefficient of restitution interpreted as damping in vibroimpact" (1975).

Methods of first order take both as a step of the linearly implicit Euler method would, so that a mass that is
deep inside, or pressed on a rough surface, does not explode at the step of the scene: with the mobility w
(the acceleration by a force of one), the push is divided by 1 + h w (c k d² + 2 h k d), and friction needs
the speed mu N h w more. Both vanish with the step.
"""

from __future__ import annotations

import math

from ..core.jit import FUSED, kernel


@kernel(forceinline=True, fastmath=FUSED)
def push_and_friction(stiffness, loss, rough, slip, h, across, around, depth, speed, along):
    """(push, friction, elastic part of the push).

    Args:
        stiffness, loss, rough, slip: k, c, mu and u0 above.
        h: step of a method of first order, s; 0 for all others.
        across, around: mobility along the push and along the friction.
        depth: px, positive.
        speed: outwards, px/s.
        along: speed along the surface, px/s.
    """
    elastic = stiffness * depth * depth
    push = max(elastic * (1.0 - loss * speed), 0.0)
    push /= 1.0 + h * across * (loss * elastic + 2.0 * h * stiffness * depth)
    friction = rough * push * math.tanh(along / (slip + h * around * rough * push))
    return push, friction, elastic


@kernel(forceinline=True, fastmath=FUSED)
def slopes_of_push(stiffness, loss, depth, speed):
    """The derivatives of the push, without what methods of first order change, by depth and by speed."""
    gain = 1.0 - loss * speed
    if gain <= 0.0:
        return 0.0, 0.0
    return 2.0 * stiffness * depth * gain, -loss * stiffness * depth * depth
