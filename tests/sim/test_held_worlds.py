"""Bodies on walls and on each other by friction that holds: methods with error control keep their tolerance.

The right motion is that of Runge-Kutta steps so short that it makes no difference how short they are.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from msgspec.structs import replace

from sim import AngularSpring, Integrator, LinearSpring, Mass, Scene, Simulation
from sim.scene.surroundings import Contact, Wall
from sim.scene.types import Method
from tests.amount import NIGHT, part_of

Vector = tuple[float, float]
Parts = tuple[list[Mass], list[LinearSpring], list[AngularSpring]]

WORLDS = 100
SECONDS = 0.5
STEP = 1e-5
"""Of the shortest steps, s."""


def regular(corners: int, radius: float) -> np.ndarray:
    angles = 2.0 * np.pi * np.arange(corners) / corners
    return radius * np.column_stack((np.cos(angles), np.sin(angles)))


def thrown(rng: np.random.Generator, at: Vector, velocity: Vector, kind: str) -> Parts:
    """A triangle, a box, a rod or a ring that turns as it flies."""
    if kind == "rod":
        places, ends = np.column_stack((25.0 * np.arange(4), np.zeros(4))), [(0, 1), (1, 2), (2, 3)]
        joints = [(0, 1), (1, 2)]
    else:
        count = {"triangle": 3, "box": 4, "ring": 7}[kind]
        places, ends = regular(count, 35.0), [(i, (i + 1) % count) for i in range(count)]
        joints = [(i, (i + 1) % count) for i in range(count)]
        if kind == "box":
            ends, joints = [*ends, (0, 2), (1, 3)], []
    turn, spin = rng.uniform(0.0, 2.0 * np.pi), float(rng.uniform(-3.0, 3.0))
    cos, sin = math.cos(turn), math.sin(turn)
    places = (places - places.mean(0)) @ np.array([[cos, sin], [-sin, cos]])
    stiffness, damping, mass = (float(rng.uniform(*span)) for span in ((2e3, 2e4), (1.0, 20.0), (0.5, 2.0)))
    way = [complex(*(places[b] - places[a])) for a, b in ends]
    masses = [
        Mass(
            position=(float(x + at[0]), float(y + at[1])), mass=mass,
            velocity=(velocity[0] - spin * float(y), velocity[1] + spin * float(x)),
        )
        for x, y in places
    ]  # fmt: skip
    springs = [
        LinearSpring(a=a, b=b, stiffness=stiffness, damping=damping, rest_length=abs(vector))
        for (a, b), vector in zip(ends, way, strict=True)
    ]
    corners = [
        AngularSpring(
            a=a, b=b, stiffness=0.3 * stiffness, damping=0.0,
            rest_angle=float(np.degrees(np.angle(way[b] / way[a]))),
        )
        for a, b in joints
    ]  # fmt: skip
    return masses, springs, corners


def world(kind: str, seed: int) -> Scene:
    """A body that is thrown onto a slope, or onto another one that lies on a floor."""
    rng = np.random.default_rng([seed, kind == "wall"])
    friction, hardness = float(rng.uniform(0.2, 2.0)), float(10.0 ** rng.uniform(3.3, 4.3))
    held, bounciness = float(hardness * rng.uniform(0.3, 1.2)), float(rng.uniform(0.1, 0.9))
    shape = str(rng.choice(["triangle", "box", "rod", "ring"]))
    bounce: dict[str, Any] = {"hardness": hardness, "bounciness": bounciness}
    if kind == "wall":
        turn = float(rng.uniform(-0.5, 0.5))
        wall = Wall(
            point=(300.0, 400.0), normal=(math.sin(turn), -math.cos(turn)), friction=friction,
            tangential_hardness=held, **bounce,
        )  # fmt: skip
        velocity = float(rng.uniform(-300.0, 300.0)), float(rng.uniform(-100.0, 300.0))
        masses, springs, joints = thrown(rng, (300.0, 330.0), velocity, shape)
        contact = None
    else:
        wall = Wall(point=(300.0, 420.0), normal=(0.0, -1.0), friction=0.5, **bounce)
        masses, springs, joints = thrown(rng, (300.0, 370.0), (0.0, 0.0), "box")
        at = 300.0 + float(rng.uniform(-25.0, 25.0)), 260.0
        above = thrown(rng, at, (float(rng.uniform(-100.0, 100.0)), float(rng.uniform(0.0, 200.0))), shape)
        n, s = len(masses), len(springs)
        masses += above[0]
        joints += [replace(joint, a=joint.a + s, b=joint.b + s) for joint in above[2]]
        springs += [replace(spring, a=spring.a + n, b=spring.b + n) for spring in above[1]]
        contact = Contact(
            distance=8.0, stiffness=hardness, friction=friction, bounciness=bounciness,
            tangential_stiffness=held,
        )  # fmt: skip
    return Scene(
        name=kind, masses=tuple(masses), linear_springs=tuple(springs), angular_springs=tuple(joints),
        gravity=(0.0, 1000.0), walls=(wall,), contact=contact,
    )  # fmt: skip


def end_of(scene: Scene, method: Method, dt: float = 1.0 / 60.0, tolerance: float = 0.1) -> np.ndarray:
    simulation = Simulation(replace(scene, integrator=Integrator(method=method, dt=dt, tolerance=tolerance)))
    simulation.advance(SECONDS)
    assert simulation.divergence is None
    return simulation.positions


@pytest.mark.parametrize("kind", ["wall", "contact"])
def test_friction_that_holds_is_under_error_control(kind: str) -> None:
    ratios: list[float] = []
    for seed in part_of(range(WORLDS), 25):
        scene = world(kind, seed)
        right, roughly = (end_of(scene, "rk4", dt) for dt in (STEP, 2.0 * STEP))
        uncertain = float(np.abs(right - roughly).max())
        for tolerance in (1.0, 0.1, 1e-3):
            if uncertain > 0.1 * tolerance:
                continue  # it is too unpredictable to tell
            for method in ("auto", "adams"):
                off = float(np.abs(end_of(scene, method, tolerance=tolerance) - right).max())
                ratios.append(off / tolerance)
    assert max(ratios) < 20.0
    assert np.mean(np.array(ratios) <= 1.0) >= (0.98 if NIGHT else 0.85)
