"""Placing a body on the terrain of another one, with all of its surroundings."""

from __future__ import annotations

import math

import msgspec
import numpy as np
from numpy.typing import NDArray

from ..errors import SceneError
from ..scene.types import Scene, shown_name
from ..scene.validate import validate
from ..text import Text

TERRAIN = ("gravity", "air_friction", "air_law", "wind", "medium", "ground", "walls", "contact")
"""The fields of a scene that surround a body."""


def on_terrain(scene: Scene, terrain: Scene) -> Scene:
    """Return a scene with the surroundings of another one; a body that would begin in its walls is moved out.

    Raises:
        SceneError: the body does not fit the terrain.
    """
    name, (one, other) = shown_name(scene)[:80], (scene.view, terrain.view)
    if one.unit != other.unit:
        raise SceneError(
            Text(
                "{name!r} is measured in {unit}; on this terrain, a race needs {needed}",
                name=name,
                unit=one.unit,
                needed=other.unit,
            )
        )
    if one.y_down != other.y_down:
        raise SceneError(
            Text("{name!r} would stand on its head here: its y axis points the other way", name=name)
        )
    around = {field: getattr(terrain, field) for field in TERRAIN}
    placed = msgspec.structs.replace(scene, **around)
    return validate(placed if scene.walls == terrain.walls else _out_of_walls(placed))


def center(scene: Scene, positions: NDArray[np.float64]) -> float:
    """Return x of the centre of mass, px."""
    mass = np.array([one.mass for one in scene.masses])
    return float(mass @ positions[:, 0] / mass.sum()) if len(mass) else 0.0


def _out_of_walls(scene: Scene) -> Scene:
    """Return the scene with its body moved out of the walls in which it would begin, by the shortest way."""
    pose = scene.pose
    places = np.array(pose.positions if pose else [mass.position for mass in scene.masses]).reshape(-1, 2)
    way = np.zeros(2)
    for wall in scene.walls:
        normal = np.array(wall.normal) / math.hypot(*wall.normal)
        depth = float(((wall.point - places - way) @ normal).max(initial=0.0))
        way += depth * normal
    if not way.any():
        return scene
    moved = [(x, y) for x, y in (places + way).tolist()]
    if pose is not None:
        return msgspec.structs.replace(scene, pose=msgspec.structs.replace(pose, positions=tuple(moved)))
    masses = zip(scene.masses, moved, strict=True)
    return msgspec.structs.replace(
        scene,
        bodies=(),
        links=(),
        masses=tuple(msgspec.structs.replace(mass, position=place) for mass, place in masses),
    )
