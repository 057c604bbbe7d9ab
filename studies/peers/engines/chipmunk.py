"""Chipmunk, by pymunk: damped springs, or pin joints in their place; rings of capsules in heaps.

Every step is a call from Python, since pymunk has none of many steps.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

import sim

from ..plain import Equations, Floats
from ..runs import FRAME, Ladder
from ..scenes import HEAPS, PATHS, SECONDS
from . import lacking, package
from .rings import Rings, sides_of, walls_of

NAME = "Chipmunk"

RATES = tuple(60.0 * 2**i for i in range(12))
"""Steps a second."""

HEAP_RATES = (60.0, 120.0, 240.0, 480.0, 960.0)
"""Of heaps of stiff rings; springs as soft as softrod's need the rates below, or they run away."""

SPRING_RATES = (960.0, 1920.0, 3840.0)


def missing() -> str:
    """See `engines`."""
    return lacking("pymunk")


def ladders(name: str) -> list[Ladder]:
    """See `engines`."""
    if name in HEAPS:
        scene = HEAPS[name]()
        return [
            Ladder(
                NAME, "stiff rings, 10 iterations", HEAP_RATES, _text, lambda r: _Heap(scene, r, 10, True)
            ),
            Ladder(
                NAME, "stiff rings, 30 iterations", HEAP_RATES, _text, lambda r: _Heap(scene, r, 30, True)
            ),
            Ladder(NAME, "springy rings", SPRING_RATES, _text, lambda r: _Heap(scene, r, 10, False)),
        ]
    if name not in PATHS:
        return []
    scene = PATHS[name].make()
    return [
        Ladder(
            NAME, f"{what}, {n} iterations", RATES if what == "springs" else RATES[:7], _text,
            lambda rate, what=what, n=n: _Net(scene, rate, n, what == "pins"),
        )
        for what, n in (("springs", 10), ("springs", 100), ("pins", 10), ("pins", 100))
    ]  # fmt: skip


def _text(rate: float) -> str:
    return f"{rate:g} steps/s"


class _Net:
    """A rope or a net; see `Runner`."""

    def __init__(self, scene: sim.Scene, rate: float, iterations: int, pins: bool) -> None:
        self._equations, self._rate = Equations(scene), rate
        self._iterations, self._pins = iterations, pins
        self._bodies: list[Any] = []

    def restart(self) -> None:
        pymunk = package("pymunk")

        equations = self._equations
        self._space = pymunk.Space()
        self._space.gravity = tuple(equations.gravity)
        self._space.iterations = self._iterations
        self._bodies = []
        for mass, held, (x, y, u, v) in zip(
            equations.masses, equations.held, equations.start.reshape(-1, 4), strict=True
        ):
            kind = pymunk.Body.KINEMATIC if held else pymunk.Body.DYNAMIC
            body = pymunk.Body(float(mass), math.inf, body_type=kind)
            body.position, body.velocity = (x, y), (u, v)
            self._bodies.append(body)
        joints = []
        for (a, b), (k, c, rest) in zip(equations.springs, equations.numbers, strict=True):
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
        if self._equations.circle is None:
            for _ in range(round(SECONDS * self._rate)):
                space.step(step)
            return
        lead_at, x, y = self._equations.lead_at, *led.position
        for i in range(round(SECONDS * self._rate)):
            # So fast that it is where it should be at the end of the step.
            there = lead_at((i + 1) * step)
            led.velocity = (there[0] - x) / step, (there[1] - y) / step
            x, y = there[0], there[1]
            space.step(step)

    def positions(self) -> Floats:
        return np.array([body.position for body in self._bodies])


class _Heap:
    """A heap of rings of capsules; see `Runner`."""

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
