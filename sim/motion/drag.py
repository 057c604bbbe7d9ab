"""Hands that hold masses and lead them: at once, or no faster than a body of many stiff springs can follow.

What is torn away at once is a shock, whose waves are as short as the body's springs: to follow those takes a
rod of a thousand masses a thousand times as long as the motion that its user sees. So there the hand comes
after the pointer, with an acceleration that does not jump, and slower than a pull goes through the springs.
"""

from __future__ import annotations

import copy
import math
from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from ..body.system import System
from ..errors import InputError
from ..kernels.core.tables import State
from ..scene.types import MAX_COORDINATE, MAX_SPEED, Scene
from .stability import quick_limit

_TOO_MANY = 8e4
"""Masses times the steps that explicit methods take for a simulated second, above which hands are
rate-limited. Bodies with a half or a tenth of that follow an anchor that is torn over thousands of pixels in
a frame."""

_PART = 1.0 / 3.0
"""The part of the speed of a pull that a hand goes at, at most."""
_SLOWEST = 100.0
"""Speed, px/s, that a hand may always go at."""

_EAGERNESS = 30.0
"""How fast the hand comes to where the pointer stands, 1/s."""

LONGEST_PART = 0.02
"""Seconds for which the hand's acceleration is a straight line in time."""

_THERE = 1e-9
"""px from its goal at which a hand is there."""


class HandMotion(NamedTuple):
    """How a hand moves in a short time: velocity, px/s; acceleration, px/s²; and the rate of that, px/s³."""

    vx: float
    vy: float
    ax: float
    ay: float
    jx: float
    jy: float


NO_MOTION = HandMotion(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)

HandMotions = Mapping[int, HandMotion]
"""How hands move, by the place of the mass in each."""

NO_MOTIONS: HandMotions = {}


def speed_to_follow(system: System, state: State, index: int) -> float:
    """The speed, px/s, at which a hand may lead the mass at a place.

    A pull goes through a chain of springs by their length times sqrt(stiffness / mass) in a second. Where a
    mass is led faster than that, its springs are torn apart, or pushed to nothing.
    """
    body, speed = system.body, MAX_SPEED
    for ends, others in ((body.spring_a, body.spring_b), (body.spring_b, body.spring_a)):
        for s in np.flatnonzero((ends == index) & (body.stiffness[: body.springs] > 0.0)):
            stiffness = float(body.stiffness[s])
            rate = math.sqrt(stiffness * float(system.inverse_mass[others[s] - 1]))
            speed = min(speed, _PART * float(state.pull[s]) / stiffness * rate)
    return max(speed, _SLOWEST)


class Hand:
    """Where a hand is, and how it comes to its goal.

    It is a critically damped filter of third order: without limits, x''' = w³ (goal - x) - 3 w² x' - 3 w x''.

    Args:
        x, y: place, px.
        vx, vy: velocity, px/s.
        fastest: speed that it goes at, at most, px/s.

    Attributes:
        goal: where it is to come to, px.
    """

    def __init__(self, x: float, y: float, vx: float, vy: float, fastest: float) -> None:
        self._state = np.array([(x, y), (vx, vy), (0.0, 0.0)])
        self._fastest = fastest
        self.goal = x, y

    @property
    def distance(self) -> float:
        """How far it still has to go, px."""
        return float(np.hypot(*(self._state[0] - self.goal)))

    @property
    def is_there(self) -> bool:
        """Whether it has come to rest at its goal."""
        return self.distance < _THERE and float(np.abs(self._state[1]).max()) < _EAGERNESS * _THERE

    def next_motion(self, duration: float) -> HandMotion:
        """How it moves in the next seconds, `LONGEST_PART` of them at most."""
        index, speed, acceleration = self._state
        way, w = self.goal - index, _EAGERNESS
        # Of a goal that keeps this distance, it would come after with its greatest speed.
        most = 3.0 * self._fastest / w
        way *= min(1.0, most / max(float(np.hypot(*way)), most))
        # The filter's way to there is (c0 + c1 t + c2 t²) exp(-w t), from the present state on.
        c0 = -way
        c1 = speed + w * c0
        c2 = 0.5 * (acceleration + 2.0 * w * c1 - w * w * c0)
        there = c0 + duration * (c1 + duration * c2)
        rate = c1 + 2.0 * duration * c2
        after = (2.0 * c2 - 2.0 * w * rate + w * w * there) * math.exp(-w * duration)
        jerk = (after - acceleration) / duration
        return HandMotion(*map(float, (*speed, *acceleration, *jerk)))

    def go_on(self, motion: HandMotion, elapsed: float) -> None:
        """Move for some seconds."""
        speed, acceleration, jerk = np.reshape(motion, (3, 2))
        index = self._state[0]
        self._state[0] = index + elapsed * (speed + elapsed * (0.5 * acceleration + elapsed * jerk / 6.0))
        self._state[1] = speed + elapsed * (acceleration + 0.5 * elapsed * jerk)
        self._state[2] = acceleration + elapsed * jerk


def within_bounds(to: tuple[float, float]) -> tuple[float, float]:
    """A place, px, where a mass may be put.

    Raises:
        InputError: it is not within what a scene may have.
    """
    x, y = (float(c) for c in to)
    if not (abs(x) <= MAX_COORDINATE and abs(y) <= MAX_COORDINATE):
        raise InputError(f"({x:g}, {y:g}) is not within ±{MAX_COORDINATE:g} px")
    return x, y


class Hands:
    """All that is in somebody's hand.

    Args:
        system, state: of the simulation.
        adaptive: whether its method chooses its steps.

    Attributes:
        rate_limited: whether the body has so many masses, on springs so stiff, that hands go at a limited
            speed. A method with fixed steps takes as long for anything.
        grabbed: masses of the scene that are held by a hand alone.
        targets: where masses are to be led in the next call, straight, px, by index.
        limited: the hands that lead masses no faster than these can follow, by index.
    """

    def __init__(self, system: System, state: State, adaptive: bool) -> None:
        self._system, self._state = system, state
        self.rate_limited = adaptive and bool(system.body.masses > _TOO_MANY * quick_limit(system))
        self.grabbed: set[int] = set()
        self.targets: dict[int, tuple[float, float]] = {}
        self.limited: dict[int, Hand] = {}

    @property
    def behind(self) -> dict[int, float]:
        """How far each rate-limited hand still has to go, px, by mass of the scene."""
        order = self._system.mass_order
        return {int(order[index - 1]): hand.distance for index, hand in self.limited.items()}

    def lead(self, index: int, to: tuple[float, float]) -> None:
        """Lead a mass in the next call."""
        self.limited.pop(index, None)
        self.targets[index] = to

    def lead_limited(self, index: int, to: tuple[float, float]) -> None:
        """Lead a mass as fast as it can follow."""
        self.targets.pop(index, None)
        if index not in self.limited:
            self._take(index, 0.0, 0.0)
        self.limited[index].goal = to

    def leave(self, index: int) -> None:
        """Lead a mass no more; it stands still."""
        self.targets.pop(index, None)
        if self.limited.pop(index, None):
            self._state.vx[index] = self._state.vy[index] = 0.0

    def hold(self, mass: int) -> bool:
        """Whether a mass of the scene is held, by the scene or by a hand."""
        return bool(self._system.held[self._system.mass_index[mass] - 1]) or mass in self.grabbed

    def grab(self, mass: int) -> None:
        """Take a mass of the scene, which may be moving."""
        index, free = int(self._system.mass_index[mass]), not self.hold(mass)
        self.grabbed.add(mass)
        if self.rate_limited and free:
            self._take(index, float(self._state.vx[index]), float(self._state.vy[index]))

    def release(self, mass: int) -> None:
        """Let go of a mass of the scene: it is at rest, or still led where the scene holds it."""
        index = int(self._system.mass_index[mass])
        if mass in self.grabbed:
            # However fast it was led: a throw would go by the last few milliseconds of a shaky hand.
            self._state.vx[index] = self._state.vy[index] = 0.0
            self.grabbed.remove(mass)
        self.targets.pop(index, None)
        if not self.hold(mass):
            self.leave(index)

    def weigh(self, scene: Scene) -> bool:
        """Say in the tables what forces do to each mass, nothing where it is held; whether all are."""
        system, state, masses = self._system, self._state, slice(1, self._system.body.masses + 1)
        held = system.held.copy()
        held[system.mass_index[list(self.grabbed)] - 1] = True
        free = np.where(held, 0.0, 1.0)
        state.vx[masses] *= free
        state.vy[masses] *= free
        state.inverse_mass[masses] = free * system.inverse_mass
        state.air[masses] = state.inverse_mass[masses] * scene.air_friction
        state.gx[masses] = free * scene.gravity[0]
        state.gy[masses] = free * scene.gravity[1]
        return bool(held.all())

    def settle(self) -> None:
        """Forget what is where it was to come to, after a call."""
        if self.targets:
            self.targets = {}
        if self.limited:
            self.limited = {index: hand for index, hand in self.limited.items() if not hand.is_there}

    def clear(self) -> None:
        """Let go of everything."""
        self.grabbed.clear()
        self.targets.clear()
        self.limited.clear()

    def take_over(self, old: Hands) -> None:
        """Hold what other hands hold of a body with the same masses."""
        self.grabbed = set(old.grabbed)
        if self.rate_limited:
            self.limited = copy.deepcopy(old.limited)

    def _take(self, index: int, vx: float, vy: float) -> None:
        """Take a mass with a velocity, px/s, into a rate-limited hand."""
        x, y = float(self._state.x[index]), float(self._state.y[index])
        self.limited[index] = Hand(x, y, vx, vy, speed_to_follow(self._system, self._state, index))
