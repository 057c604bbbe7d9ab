"""Chipmunk, by pymunk: damped springs, or pin joints in their place; rings of capsules in heaps.

Every step is a call from Python, since pymunk has no call for many steps.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

import sim

from ..engine import package, per_second
from ..measure import Contender, ladder
from ..plain import PlainSystem
from ..runs import FRAME, SECONDS, Floats, Runner
from ..scenes import HEAP_SECONDS
from .rings import Rings, sides_of, walls_of

RATES = tuple(60.0 * 2**i for i in range(12))
"""Steps per second on ropes and nets."""

HEAP_RATES = (60.0, 120.0, 240.0, 480.0, 960.0)
"""Steps per second in heaps of stiff rings."""

SPRING_RATES = (960.0, 1920.0, 3840.0)
"""Steps per second in heaps of rings as soft as those of softrod, which run away with fewer."""


def paths(scene: sim.Scene) -> list[Contender]:
    """Damped springs, and pins in their place, on a rope or a net."""
    return [
        _contender(
            f"{what}, {n} iterations", rates, lambda rate, p=what == "pins", n=n: _Net(scene, rate, n, p)
        )
        for what, rates in (("springs", RATES), ("pins", RATES[:7]))
        for n in (10, 100)
    ]


def heaps(scene: sim.Scene) -> list[Contender]:
    """Rings of capsules that do not bend, and others that do."""
    return [
        _contender("stiff rings, 10 iterations", HEAP_RATES, lambda rate: _Heap(scene, rate, 10, stiff=True)),
        _contender("stiff rings, 30 iterations", HEAP_RATES, lambda rate: _Heap(scene, rate, 30, stiff=True)),
        _contender("springy rings", SPRING_RATES, lambda rate: _Heap(scene, rate, 10, stiff=False)),
    ]


def _contender(method: str, rates: Sequence[float], make: Callable[[float], Runner]) -> Contender:
    return Contender("Chipmunk", method, ladder(rates), per_second("steps"), make)


class _Net(Runner):
    """A rope or a net."""

    def __init__(self, scene: sim.Scene, rate: float, iterations: int, pins: bool) -> None:
        self._system, self._rate = PlainSystem(scene), rate
        self._iterations, self._pins = iterations, pins
        self._bodies: list[Any] = []

    def restart(self) -> None:
        pymunk = package("pymunk")

        system = self._system
        self._space = pymunk.Space()
        self._space.gravity = tuple(system.gravity)
        self._space.iterations = self._iterations
        self._bodies = []
        for mass, held, (x, y, u, v) in zip(
            system.masses, system.held, system.start.reshape(-1, 4), strict=True
        ):
            kind = pymunk.Body.KINEMATIC if held else pymunk.Body.DYNAMIC
            body = pymunk.Body(float(mass), math.inf, body_type=kind)
            body.position, body.velocity = (x, y), (u, v)
            self._bodies.append(body)
        joints = []
        for (a, b), (k, c, rest) in zip(system.springs, system.numbers, strict=True):
            ends = self._bodies[a], self._bodies[b], (0.0, 0.0), (0.0, 0.0)
            if self._pins:
                joint = pymunk.PinJoint(*ends)
                joint.distance = rest
            else:
                joint = pymunk.DampedSpring(*ends, rest, k, c)
            joints.append(joint)
        self._space.add(*self._bodies, *joints)

    def advance(self) -> None:
        space, step, led = self._space, 1.0 / self._rate, self._bodies[0]
        if self._system.circle is None:
            for _ in range(round(SECONDS * self._rate)):
                space.step(step)
            return
        lead_at, x, y = self._system.lead_at, *led.position
        for i in range(round(SECONDS * self._rate)):
            # So fast that it is where it should be at the end of the step.
            there = lead_at((i + 1) * step)
            led.velocity = (there[0] - x) / step, (there[1] - y) / step
            x, y = there[0], there[1]
            space.step(step)

    def positions(self) -> Floats:
        return np.array([body.position for body in self._bodies])


class _Heap(Runner):
    """A heap of rings of capsules."""

    frames = round(HEAP_SECONDS / FRAME)

    def __init__(self, scene: sim.Scene, rate: float, iterations: int, stiff: bool) -> None:
        self._scene, self._steps, self._iterations = scene, round(rate * FRAME), iterations
        self._stiff = stiff
        self._rings = Rings(scene)

    def restart(self) -> None:
        pymunk = package("pymunk")

        rings, contact = self._rings, self._scene.contact
        assert contact is not None
        space = self._space = pymunk.Space()
        space.gravity, space.iterations = self._scene.gravity, self._iterations
        for (ax, ay), (bx, by) in walls_of(self._scene):
            wall = pymunk.Segment(space.static_body, (ax, ay), (bx, by), rings.radius)
            wall.friction, wall.elasticity = contact.friction, contact.bounciness
            space.add(wall)
        self._bodies = []
        for number, ring in enumerate(rings.corners):
            sides = []
            for middle, angle, length in sides_of(ring):
                half = 0.5 * length
                moment = pymunk.moment_for_segment(rings.mass, (-half, 0.0), (half, 0.0), rings.radius)
                body = pymunk.Body(rings.mass, moment)
                body.position, body.angle = tuple(middle), angle
                shape = pymunk.Segment(body, (-half, 0.0), (half, 0.0), rings.radius)
                shape.friction, shape.elasticity = contact.friction, contact.bounciness
                shape.filter = pymunk.ShapeFilter(group=number + 1)
                space.add(body, shape)
                sides.append(body)
            for one, other in zip(sides, sides[1:] + sides[:1], strict=True):
                half, bend = rings.half, one.angle - other.angle
                if self._stiff:
                    turn = pymunk.RotaryLimitJoint(one, other, -bend, -bend)
                else:
                    turn = pymunk.DampedRotarySpring(one, other, bend, rings.turning, 0.0)
                space.add(pymunk.PivotJoint(one, other, (half, 0.0), (-half, 0.0)), turn)
            self._bodies += sides

    def advance(self) -> None:
        for _ in range(self._steps):
            self._space.step(FRAME / self._steps)

    def positions(self) -> Floats:
        half = (-self._rings.half, 0.0)
        return np.array([body.local_to_world(half) for body in self._bodies])
