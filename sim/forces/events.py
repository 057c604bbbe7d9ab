"""Where in a step something begins to yield or to slide, or turns round, from both ends of the step.

What yields or slides does so as far as it is beyond a limit, by y(t). Within a step, y is taken as the cubic
through its values and rates at both ends.
"""

from __future__ import annotations

import math

from ..engine.jit import FAST, kernel

# Unless noted, doubling or halving one of these numbers fails no test.
UNSEEN = 0.05
"""Speed that a step may add to a mass where something turns round or breaks, or miss at a kink, as a fraction
of the tolerance per second."""
LARGEST_PART = 0.999
"""Largest part of a step that is tried instead of it."""
_HALVINGS = 40
"""Number of halvings with which the moment of an event is looked for."""


@kernel(forceinline=True, fastmath=FAST)
def peak(h, y0, r0, y1, r1):
    """The largest value of a cubic within a step, by its values and rates at both ends.

    Returns:
        That, and the part of the step after which it is reached: 1 where that is the end, as it is also where
        the rates do not fit to the values, since a mass is led without a speed.
    """
    rise = y1 - y0
    if not (r0 > 0.0 and r1 < 0.0 and abs(rise - 0.5 * h * (r0 + r1)) < 0.25 * h * (r0 - r1)):
        return y1, 1.0
    c1, c2, c3 = h * r0, 3.0 * rise - h * (2.0 * r0 + r1), h * (r0 + r1) - 2.0 * rise
    part = c1 / (math.sqrt(max(c2 * c2 - 3.0 * c1 * c3, 0.0)) - c2)
    return y0 + part * (c1 + part * (c2 + part * c3)), part


@kernel(fastmath=FAST)
def crossing(h, y0, r0, y1, r1):
    """The part of the step after which a cubic that starts below zero gets there, by bisection."""
    _, high = peak(h, y0, r0, y1, r1)
    rise, low = y1 - y0, 0.0
    c1, c2, c3 = h * r0, 3.0 * rise - h * (2.0 * r0 + r1), h * (r0 + r1) - 2.0 * rise
    for _ in range(_HALVINGS):
        part = 0.5 * (low + high)
        if y0 + part * (c1 + part * (c2 + part * c3)) < 0.0:
            low = part
        else:
            high = part
    return high


@kernel(fastmath=FAST)
def _part_beyond(h, kink, bend, unseen):
    """The part of a step that leads just beyond a kink of a force; 1 if the step may be kept.

    Before and after the kink, accelerations differ by `bend` (px/s³) times the time to it. What a step that
    knows one side does not see is at most the integral of that over the shorter side.
    """
    shorter = h * min(kink, 1.0 - kink)
    if 0.5 * bend * shorter * shorter <= unseen:
        return 1.0
    return kink + min(math.sqrt(0.2 * unseen / bend) / h, 0.5 * (1.0 - kink))


@kernel(fastmath=FAST)
def kink_fraction(h, y0, r0, y1, r1, room, quick, unseen):
    """The part of a step that leads just beyond where something begins to yield, or where it turns round.

    Args:
        h: length of the step, s.
        y0, r0, y1, r1: of both ends, how far it yields and the rate of that, in px and px/s, or radians.
        room: how far it can yield.
        quick: the acceleration of a mass, px/s², by as much of it as 1.
        unseen: speed of a mass that does not matter, px/s.

    Returns:
        That; 1 if the step may be kept.
    """
    top, turn = peak(h, y0, r0, y1, r1)
    if not (top > 0.0 and room > 0.0):
        return 1.0
    if y0 < 0.0:
        part = _part_beyond(h, crossing(h, y0, r0, y1, r1), quick * (top - y0) / h, unseen)
        if part < 1.0:
            return part
    missed = min(top, room) - min(max(y0, y1, 0.0), room)
    if quick * missed * h > unseen:
        bend = (r0 - r1) / h
        return turn + min(math.sqrt(0.5 * unseen / (quick * bend * h)) / h, 0.5 * (1.0 - turn))
    return 1.0


@kernel(fastmath=FAST)
def bend_fraction(h, y0, r0, y1, r1, mobility, unseen):
    """The part of a step that leads just beyond where a force has a kink, as what it is limited by is passed.

    Args:
        h, unseen: as in `kink_fraction`.
        y0, r0, y1, r1: of both ends, how far it is beyond its limit, kg px/s², and the rate of that.
        mobility: acceleration of a mass by a force of one, 1/kg.
    """
    top, part = max(peak(h, y0, r0, y1, r1)[0], y0), 1.0
    if not top > 0.0:
        return 1.0
    for backwards in (False, True):
        low = y1 if backwards else y0
        if low < 0.0:
            kink = 1.0 - crossing(h, y1, -r1, y0, -r0) if backwards else crossing(h, y0, r0, y1, r1)
            part = min(part, _part_beyond(h, kink, mobility * (top - low) / h, unseen))
    return part


@kernel(fastmath=FAST)
def slip_fraction(h, spring, mobility, start, end, unseen):
    """The part of a step that leads just beyond where a tangential spring begins to slide, or turns round.

    Args:
        h: length of the step, s.
        spring: (K, G) as in `push`.
        mobility: acceleration by friction of one, 1/kg.
        start, end: of both ends, the stretch, px, the speed along, px/s, the most that friction can be,
            kg px/s², and the rate of that.
        unseen: as in `kink_fraction`.
    """
    stiffness, damping = spring
    y0, r0, y1, r1 = slid(stiffness, start, end)
    part = kink_fraction(h, y0, r0, y1, r1, math.inf, stiffness * mobility, unseen)
    # With the dashpot, friction is at its limit before the spring is, and not once that has turned round.
    (stretch0, along0, most0, grows0), (stretch1, along1, most1, grows1) = start, end
    elastic0 = min(max(stiffness * stretch0, -most0), most0)
    elastic1 = min(max(stiffness * stretch1, -most1), most1)
    pull = damping * (along1 - along0) / h
    for side in (-1.0, 1.0):
        y0, y1 = side * (elastic0 + damping * along0) - most0, side * (elastic1 + damping * along1) - most1
        r0 = side * (stiffness * along0 + pull) - grows0
        r1 = side * (stiffness * along1 + pull) - grows1
        part = min(part, bend_fraction(h, y0, r0, y1, r1, mobility, unseen))
    return part


@kernel(forceinline=True, fastmath=FAST)
def slid(stiffness, start, end):
    """How far a tangential spring is beyond its limit at both ends of a step, px, and the rates of that.

    Arguments: see `slip_fraction`.
    """
    (stretch0, along0, most0, grows0), (stretch1, along1, most1, grows1) = start, end
    side, soft = math.copysign(1.0, stretch1), 1.0 / stiffness
    y0, y1 = side * stretch0 - most0 * soft, side * stretch1 - most1 * soft
    return y0, side * along0 - grows0 * soft, y1, side * along1 - grows1 * soft


@kernel(forceinline=True, fastmath=FAST)
def kept_stretch(h, stiffness, start, end):
    """The stretch at the end of a step of h seconds, px, less what has slid; with h = 0, only at the end."""
    y0, r0, y1, r1 = slid(stiffness, start, end)
    top = peak(h, y0, r0, y1, r1)[0] if h > 0.0 else y1
    return end[0] - math.copysign(max(top, 0.0), end[0])


@kernel(forceinline=True, fastmath=FAST)
def stretch_since_touch(h, stiffness, depths, speeds, way, alongs, most):
    """The stretch of a tangential spring at the end of the step in which a mass enters, px.

    Args:
        h: length of the step, s.
        stiffness: K as in `push`.
        depths, speeds, alongs: of both ends, px; and outwards and along, px/s.
        way: along, from the one to the other, px.
        most: the most that friction can be at the end.
    """
    entered = crossing(h, depths[0], -speeds[0], depths[1], -speeds[1])
    c1, c2 = h * alongs[0], 3.0 * way - h * (2.0 * alongs[0] + alongs[1])
    c3 = h * (alongs[0] + alongs[1]) - 2.0 * way
    since = way - entered * (c1 + entered * (c2 + entered * c3))
    return min(max(since, -most / stiffness), most / stiffness)


@kernel(fastmath=FAST)
def touch_fraction(h, spring, mobility, depths, speeds, end, unseen):
    """The part of a step that leads just beyond where a mass enters what has a tangential spring.

    The step does not see the spring, which begins with its end.

    Args:
        depths, speeds: of both ends, px; and outwards, px/s.
        h, spring, mobility, end, unseen: as in `slip_fraction`; the stretch does not matter.
    """
    stiffness, _ = spring
    entered = crossing(h, depths[0], -speeds[0], depths[1], -speeds[1])
    inside = (1.0 - entered) * h
    _, along, most, _ = end
    # Both grow about in proportion to the time that has passed since, or its square.
    missed = min(stiffness * abs(along) * inside, most) * mobility * inside / 3.0
    if missed <= unseen:
        return 1.0
    return entered + min((0.3 * unseen / missed) ** (1.0 / 3.0), 0.5) * (1.0 - entered)
