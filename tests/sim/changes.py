"""Scenes with something else in them, as other numbers of all parts, a pose or a method; and their runs."""

from __future__ import annotations

from collections.abc import Iterable
from functools import partial
from typing import Any

import numpy as np
from msgspec.structs import replace

from sim import Integrator, Pose, Scene, Simulation
from sim.scene.types import Damage, Method


def _with_each(kind: str, scene: Scene, **fields: Any) -> Scene:
    """The scene with other numbers in all parts of a kind; a recipe is taken apart for that.

    Args:
        kind: the field of the scene that has the parts.
        scene: the scene.
        fields: of each part: a value, a list of one value for each, or a function of the index and the part.
    """

    def value(of: Any, i: int, part: Any) -> Any:
        return of(i, part) if callable(of) else of[i] if isinstance(of, list) else of

    parts = [
        replace(part, **{name: value(of, i, part) for name, of in fields.items()})
        for i, part in enumerate(getattr(scene, kind))
    ]
    return replace(scene, bodies=(), links=(), **{kind: tuple(parts)})


with_masses = partial(_with_each, "masses")
with_springs = partial(_with_each, "linear_springs")
with_joints = partial(_with_each, "angular_springs")
with_walls = partial(_with_each, "walls")


def pairs(rows: Any) -> tuple[tuple[float, float], ...]:
    """(n, 2) numbers as a scene has them."""
    return tuple((float(x), float(y)) for x, y in rows)


def posed(scene: Scene, places: Any = None, speeds: Any = None, **fields: Any) -> Scene:
    """The scene in a pose: at rest where it starts, unless places (px) or velocities (px/s) are given.

    Args:
        scene: the scene.
        places, speeds: (n, 2) of the masses.
        fields: further ones of the pose.
    """
    at = pairs(mass.position for mass in scene.masses) if places is None else pairs(places)
    moving = pairs(np.zeros((len(at), 2)) if speeds is None else speeds)
    return replace(scene, pose=Pose(positions=at, velocities=moving, **fields))


def with_broken(scene: Scene, springs: Iterable[int]) -> Scene:
    """The scene at rest where it starts, with these springs broken; all of its springs can break."""
    return posed(with_springs(scene, strength=1e9), damage=Damage(broken=tuple(springs)))


def by(scene: Scene, method: Method = "auto", **numbers: float) -> Scene:
    """The scene, moved by a method; `numbers` are of its integrator."""
    return replace(scene, integrator=Integrator(**{"method": method, **numbers}))


def after(scene: Scene, seconds: float) -> Simulation:
    """A simulation of the scene after a while; the energy is in balance from the start."""
    simulation = Simulation(scene)
    simulation.energy()
    simulation.advance(seconds)
    return simulation


def apart(one: Simulation, other: Simulation) -> float:
    """The largest difference of a coordinate of two simulations, px."""
    return float(np.abs(one.positions - other.positions).max())


def step_all(steps: int, *simulations: Simulation) -> None:
    """Do so many steps of each."""
    for simulation in simulations:
        simulation.step(steps)
