"""Hands, which hold and lead masses: at once, or at a limited speed for bodies of many stiff springs.

Moving a mass at once is a shock that sends waves through the body which are as short as its springs.
Resolving them takes a thousand times the computing time of the motion that one sees, in a rod of a thousand
masses. In such bodies the hand follows the pointer with a continuous acceleration, and more slowly than a
pull travels through the springs.
"""

from __future__ import annotations

import copy
import math
from collections.abc import Mapping
from functools import cached_property
from typing import NamedTuple

import numpy as np

from ..engine.tables import State
from ..errors import InputError
from ..model.state import Bools
from ..model.system import System
from ..scene.numbers import MAX_COORDINATE, MAX_SPEED
from ..text import Text
from .stability import quick_limit

_TOO_MANY = 8e4
"""Number of masses times the number of steps of an explicit method per simulated second, 1/s, above which
hands are rate-limited. Bodies with half or a tenth of that can follow an anchor that is moved by thousands of
pixels in a frame. Doubled or halved, `test_only_long_stiff_rods_limit_the_speed_of_a_hand` fails."""

_PART = 1.0 / 3.0
"""Largest speed of a hand as a fraction of the speed at which a pull travels through the springs. Doubled
or halved, `test_an_anchor_torn_away_costs_no_more_than_a_calm_one` fails."""
_SLOWEST = 100.0
"""Speed, px/s, that is always allowed. Doubled or halved, no test of hands fails."""

_APPROACH_RATE = 30.0
"""Rate at which a hand approaches the pointer, 1/s. Doubled,
`test_a_hand_moves_without_a_jerk_wherever_the_pointer_jumps` fails; halved,
`test_it_comes_to_its_goal_and_stays`."""

LONGEST_PART = 0.02
"""Longest time, s, for which the acceleration of a hand is taken to be linear in time. Doubled,
`test_a_hand_waits_when_attempts_run_out` fails."""

_THERE = 1e-9
"""Distance, px, from its goal below which a hand has arrived. Doubled or halved, no test of hands fails."""


class HandMotion(NamedTuple):
    """Motion of a hand during a short time: velocity, px/s, acceleration, px/s², and jerk, px/s³."""

    vx: float
    vy: float
    ax: float
    ay: float
    jx: float
    jy: float


NO_MOTION = HandMotion(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
"""A hand at rest."""

HandMotions = Mapping[int, HandMotion]
"""Motions of hands, by the slot of the mass in each."""

NO_MOTIONS: HandMotions = {}
"""No hands."""


def speed_to_follow(system: System, state: State, index: int) -> float:
    """The largest speed, px/s, at which a hand may lead the mass in a slot.

    A pull travels through a chain of springs at their length times sqrt(stiffness / mass). If a mass is led
    faster than that, its springs are torn apart or compressed to nothing.
    """
    body, speed = system.body, MAX_SPEED
    for ends, others in ((body.spring_a, body.spring_b), (body.spring_b, body.spring_a)):
        for s in np.flatnonzero((ends == index) & (body.stiffness[: body.springs] > 0.0)):
            stiffness = float(body.stiffness[s])
            rate = math.sqrt(stiffness * float(system.inverse_mass[others[s] - 1]))
            speed = min(speed, _PART * float(state.rest_tension[s]) / stiffness * rate)
    return max(speed, _SLOWEST)


class Hand:
    """A hand at a limited speed: a critically damped filter of third order that approaches a goal.

    Without the limit, x''' = w³ (goal - x) - 3 w² x' - 3 w x''.

    Args:
        x, y: initial position, px.
        vx, vy: initial velocity, px/s.
        fastest: largest speed, px/s.

    Attributes:
        goal: the position to approach, px.
    """

    def __init__(self, x: float, y: float, vx: float, vy: float, fastest: float) -> None:
        self._state = np.array([(x, y), (vx, vy), (0.0, 0.0)])
        self._fastest = fastest
        self.goal = x, y

    @property
    def distance(self) -> float:
        """Distance to the goal, px."""
        return float(np.hypot(*(self._state[0] - self.goal)))

    @property
    def is_there(self) -> bool:
        """Whether it has come to rest at its goal."""
        return self.distance < _THERE and float(np.abs(self._state[1]).max()) < _APPROACH_RATE * _THERE

    def next_motion(self, duration: float) -> HandMotion:
        """Its motion during the next `duration` seconds, at most `LONGEST_PART`."""
        position, speed, acceleration = self._state
        way, w = self.goal - position, _APPROACH_RATE
        # It would follow a goal that keeps this distance with its largest speed.
        most = 3.0 * self._fastest / w
        way *= min(1.0, most / max(float(np.hypot(*way)), most))
        # The filter approaches the goal by (c0 + c1 t + c2 t²) exp(-w t), from the present state on.
        c0 = -way
        c1 = speed + w * c0
        c2 = 0.5 * (acceleration + 2.0 * w * c1 - w * w * c0)
        there = c0 + duration * (c1 + duration * c2)
        rate = c1 + 2.0 * duration * c2
        after = (2.0 * c2 - 2.0 * w * rate + w * w * there) * math.exp(-w * duration)
        jerk = (after - acceleration) / duration
        return HandMotion(*map(float, (*speed, *acceleration, *jerk)))

    def go_on(self, motion: HandMotion, elapsed: float) -> None:
        """Move for `elapsed` seconds."""
        speed, acceleration, jerk = np.reshape(motion, (3, 2))
        position = self._state[0]
        self._state[0] = position + elapsed * (speed + elapsed * (0.5 * acceleration + elapsed * jerk / 6.0))
        self._state[1] = speed + elapsed * (acceleration + 0.5 * elapsed * jerk)
        self._state[2] = acceleration + elapsed * jerk


def within_bounds(to: tuple[float, float]) -> tuple[float, float]:
    """The position, px, if it is within the range of a scene.

    Raises:
        InputError: it is not.
    """
    x, y = (float(c) for c in to)
    if not (abs(x) <= MAX_COORDINATE and abs(y) <= MAX_COORDINATE):
        raise InputError(Text("({x:g}, {y:g}) is not within ±{most:g} px", x=x, y=y, most=MAX_COORDINATE))
    return x, y


class Hands:
    """All hands of a simulation.

    Args:
        system, state: of the simulation.
        adaptive: whether its method chooses its steps.

    Attributes:
        grabbed: masses of the scene that are held by a hand.
        targets: positions, px, to which masses are led in straight lines until the next call comes to its
            end, by slot.
        limited: the rate-limited hands, by slot.
    """

    def __init__(self, system: System, state: State, adaptive: bool) -> None:
        self._system, self._state, self._adaptive = system, state, adaptive
        self.grabbed: set[int] = set()
        self.targets: dict[int, tuple[float, float]] = {}
        self.limited: dict[int, Hand] = {}

    @cached_property
    def rate_limited(self) -> bool:
        """Whether the body has so many masses, on springs so stiff, that hands move at a limited speed.

        Never with a fixed step, where every motion takes the same computing time.
        """
        return self._adaptive and bool(self._system.body.masses > _TOO_MANY * quick_limit(self._system))

    @property
    def behind(self) -> dict[int, float]:
        """Distance of each rate-limited hand to its goal, px, by mass of the scene."""
        order = self._system.mass_order
        return {int(order[index - 1]): hand.distance for index, hand in self.limited.items()}

    def lead(self, index: int, to: tuple[float, float]) -> None:
        """Lead the mass in a slot to a position in the next call, in a straight line."""
        self.limited.pop(index, None)
        self.targets[index] = to

    def lead_limited(self, index: int, to: tuple[float, float]) -> None:
        """Lead the mass in a slot to a position at a limited speed."""
        self.targets.pop(index, None)
        if index not in self.limited:
            self._take(index, 0.0, 0.0)
        self.limited[index].goal = to

    def leave(self, index: int) -> None:
        """Stop leading the mass in a slot, which comes to rest."""
        self.targets.pop(index, None)
        if self.limited.pop(index, None):
            self._state.vx[index] = self._state.vy[index] = 0.0

    @property
    def held(self) -> Bools:
        """(n,) whether each mass is held, by the scene or by a hand, in the order of the slots."""
        held = self._system.held
        if self.grabbed:
            held = held.copy()
            held[self._system.mass_index[list(self.grabbed)] - 1] = True
        return held

    def hold(self, mass: int) -> bool:
        """Whether a mass of the scene is held, by the scene or by a hand."""
        return bool(self._system.held[self._system.mass_index[mass] - 1]) or mass in self.grabbed

    def grab(self, mass: int) -> None:
        """Hold a mass of the scene, which may be moving."""
        index, free = int(self._system.mass_index[mass]), not self.hold(mass)
        self.grabbed.add(mass)
        if self.rate_limited and free:
            self._take(index, float(self._state.vx[index]), float(self._state.vy[index]))

    def release(self, mass: int) -> None:
        """Let go of a mass of the scene. It is then at rest; if the scene holds it, it may still be led."""
        index = int(self._system.mass_index[mass])
        if mass in self.grabbed:
            # Whatever its velocity was: that of a throw would depend on the last few milliseconds of a shaky
            # hand.
            self._state.vx[index] = self._state.vy[index] = 0.0
            self.grabbed.remove(mass)
        self.targets.pop(index, None)
        if not self.hold(mass):
            self.leave(index)

    def settle(self, ended: bool) -> None:
        """After a call, forget the hands that have arrived, and the targets if the call came to its end."""
        if self.targets and ended:
            self.targets = {}
        if self.limited:
            self.limited = {index: hand for index, hand in self.limited.items() if not hand.is_there}

    def clear(self) -> None:
        """Let go of all masses."""
        self.grabbed.clear()
        self.targets.clear()
        self.limited.clear()

    def take_over(self, old: Hands) -> None:
        """Take over what the hands of a simulation with the same masses hold."""
        self.grabbed = set(old.grabbed)
        if self.rate_limited:
            self.limited = copy.deepcopy(old.limited)

    def _take(self, index: int, vx: float, vy: float) -> None:
        """Give the mass in a slot, which has a velocity (px/s), to a new rate-limited hand."""
        x, y = float(self._state.x[index]), float(self._state.y[index])
        self.limited[index] = Hand(x, y, vx, vy, speed_to_follow(self._system, self._state, index))
