"""Restitution and static friction on everything that bodies touch: walls and each other."""

from __future__ import annotations

import math
from typing import Any

import msgspec
import numpy as np

from ..scene.columns import column
from ..scene.surroundings import Contact, Wall
from ..scene.types import Scene

_MIN_GRAVITY = 1000.0
"""Smallest gravity, px/s², that is assumed in choosing the stiffness of tangential springs. Doubled or
halved, no test fails."""


def touched(scene: Scene) -> list[Wall | Contact]:
    """Return the walls of a scene, and its contact, if it has any."""
    return [*scene.walls, *([scene.contact] if scene.contact else [])]


def with_restitution(scene: Scene, restitution: Any) -> Scene:
    """Return the scene with the same restitution, see `Wall`, everywhere."""
    replace = msgspec.structs.replace
    walls = tuple(replace(wall, restitution=restitution) for wall in scene.walls)
    contact = replace(scene.contact, restitution=restitution) if scene.contact else None
    return replace(scene, walls=walls, contact=contact)


def holds(scene: Scene) -> bool:
    """Return whether there is static friction on a wall or in contact."""
    on_walls = any(wall.tangential_hardness for wall in scene.walls)
    return on_walls or bool(scene.contact and scene.contact.tangential_stiffness)


def with_grip(scene: Scene, grips: bool) -> Scene:
    """Return the scene with static friction everywhere or nowhere.

    A tangential spring is as stiff as the push that supports the weight of a mass: k d² = m g gives
    2 k d = 2 sqrt(k m g), with the median mass m of the scene; for walls, whose push m H d² is proportional
    to each mass, it is 2 sqrt(H g) m.
    """
    replace = msgspec.structs.replace
    gravity = max(math.hypot(*scene.gravity), _MIN_GRAVITY) if grips else 0.0
    weight = gravity * float(np.median(column(scene.masses, "mass")))

    def of_wall(wall: Wall) -> Wall:
        static = wall.static_friction if grips else msgspec.UNSET
        hardness = 2.0 * math.sqrt(wall.hardness * gravity)
        return replace(wall, tangential_hardness=hardness, static_friction=static)

    def of_contact(contact: Contact) -> Contact:
        return replace(contact, tangential_stiffness=2.0 * math.sqrt(contact.stiffness * weight))

    contact = of_contact(scene.contact) if scene.contact else None
    return replace(scene, walls=tuple(map(of_wall, scene.walls)), contact=contact)
