"""Box2D 3, by pyb2d3: distance joints with a spring; rings of capsules and weld joints in heaps.

A call from Python is a step of any number of substeps. A led mass gets its velocity once a call.
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

RATES = tuple(60.0 * 2**i for i in range(1, 13))
"""Substeps a second."""

CALLS = 240.0
"""Calls a second where a mass is led, as far as there are as many substeps; others have 60."""

HEAP_RATES = (240.0, 480.0, 960.0, 1920.0)

METRE = 100.0
"""px, by which Box2D's lengths are chosen: how deep bodies may be in each other, how fast they are pushed."""


def paths(scene: sim.Scene) -> list[Contender]:
    """Springs, and rigid joints in their place, on a rope or a net."""
    return [
        _contender("springs", RATES, lambda rate: _Net(scene, rate, rigid=False)),
        _contender("rigid joints", RATES[:6], lambda rate: _Net(scene, rate, rigid=True)),
    ]


def heaps(scene: sim.Scene) -> list[Contender]:
    """Rings of capsules with welds that bend, or do not."""
    return [
        _contender("springy welds", HEAP_RATES, lambda rate: _Heap(scene, rate, rigid=False)),
        _contender("rigid welds", HEAP_RATES, lambda rate: _Heap(scene, rate, rigid=True)),
    ]


def _contender(method: str, rates: Sequence[float], make: Callable[[float], Runner]) -> Contender:
    return Contender("Box2D", method, ladder(rates), per_second("substeps"), make)


def _world(gravity: tuple[float, float]) -> Any:
    pyb2d3 = package("pyb2d3")

    pyb2d3.set_length_units_per_meter(METRE)
    world = pyb2d3.World(gravity=gravity, maximum_linear_speed=1e7)
    world.sleeping_enabled = False
    world.continuous_enabled = False
    return world


class _Net(Runner):
    """A rope or a net."""

    def __init__(self, scene: sim.Scene, rate: float, rigid: bool) -> None:
        self._system, self._rigid = PlainSystem(scene), rigid
        led = self._system.circle is not None
        self._calls = round(SECONDS * min(rate, CALLS if led else 60.0))
        self._substeps = round(rate * SECONDS) // self._calls

    def restart(self) -> None:
        pyb2d3 = package("pyb2d3")

        system = self._system
        self._world = world = _world((float(system.gravity[0]), float(system.gravity[1])))
        self._bodies = pyb2d3.Bodies()
        made = []
        for mass, held, (x, y, _, _) in zip(
            system.masses, system.held, system.start.reshape(-1, 4), strict=True
        ):
            make = world.create_kinematic_body if held else world.create_dynamic_body
            body = make(position=(float(x), float(y)), fixed_rotation=True)
            if not held:
                data = pyb2d3.MassData()
                data.mass, data.center, data.rotational_inertia = float(mass), (0.0, 0.0), 0.0
                body.mass_data = data
            made.append(body)
            self._bodies.append(body.id)
        self._led = made[0]
        for (a, b), (k, c, rest) in zip(system.springs, system.numbers, strict=True):
            free = [1.0 / system.masses[i] for i in (a, b) if not system.held[i]]
            weight = 1.0 / sum(free)
            hertz, damping = math.sqrt(k / weight) / (2.0 * math.pi), c / (2.0 * math.sqrt(k * weight))
            world.create_distance_joint(
                made[a], made[b], length=float(rest), enable_spring=not self._rigid,
                hertz=hertz, damping_ratio=damping,
            )  # fmt: skip

    def advance(self) -> None:
        step = SECONDS / self._calls
        if self._system.circle is None:
            for _ in range(self._calls):
                self._world.step(step, self._substeps)
            return
        x, y = self._led.position
        for i in range(self._calls):
            there = self._system.lead_at((i + 1) * step)
            self._led.linear_velocity = (float((there[0] - x) / step), float((there[1] - y) / step))
            x, y = there[0], there[1]
            self._world.step(step, self._substeps)

    def positions(self) -> Floats:
        return np.array(self._bodies.get_positions(), float)


class _Heap(Runner):
    """A heap of rings of capsules."""

    frames = round(HEAP_SECONDS / FRAME)

    def __init__(self, scene: sim.Scene, rate: float, rigid: bool) -> None:
        self._scene, self._substeps, self._rigid = scene, round(rate * FRAME), rigid
        self._rings = Rings(scene)

    def restart(self) -> None:
        pyb2d3 = package("pyb2d3")

        rings, contact = self._rings, self._scene.contact
        assert contact is not None
        self._world = world = _world(self._scene.gravity)
        material = pyb2d3.surface_material(friction=contact.friction, restitution=contact.bounciness)
        ground = world.create_static_body(position=(0.0, 0.0))
        for a, b in walls_of(self._scene):
            shape = pyb2d3.shape_def(material=material)
            ground.create_shape(shape, pyb2d3.capsule(tuple(a), tuple(b), radius=rings.radius))
        self._bodies = pyb2d3.Bodies()
        area = 4.0 * rings.radius * rings.half + math.pi * rings.radius**2
        inertia = rings.mass * (2.0 * rings.half) ** 2 / 12.0
        hertz = math.sqrt(2.0 * rings.turning / inertia) / (2.0 * math.pi)
        for number, ring in enumerate(rings.corners):
            sides = []
            for middle, angle, _ in sides_of(ring):
                body = world.create_dynamic_body(
                    position=(float(middle[0]), float(middle[1])), rotation=pyb2d3.make_rot(angle)
                )
                shape = pyb2d3.shape_def(
                    density=rings.mass / area, material=material,
                    filter=pyb2d3.make_filter(group_index=-(number + 1)),
                )  # fmt: skip
                ends = (-rings.half, 0.0), (rings.half, 0.0)
                body.create_shape(shape, pyb2d3.capsule(*ends, radius=rings.radius))
                sides.append((body, angle))
                self._bodies.append(body.id)
            for (one, before), (other, after) in zip(sides, sides[1:] + sides[:1], strict=True):
                world.create_weld_joint(
                    one, other, local_anchor_a=(rings.half, 0.0), local_anchor_b=(-rings.half, 0.0),
                    reference_angle=math.remainder(after - before, 2.0 * math.pi),
                    angular_hertz=0.0 if self._rigid else hertz, angular_damping_ratio=0.0,
                )  # fmt: skip

    def advance(self) -> None:
        self._world.step(FRAME, self._substeps)

    def positions(self) -> Floats:
        return np.array(self._bodies.get_world_points((-self._rings.half, 0.0)), float)
