"""What only some scenes have, by the names of `app.conditional`: programs and live files of others have no
line of it."""

from __future__ import annotations

from collections.abc import Callable

from sim.forces.motors import has_motors
from sim.forces.rails import has_rails
from sim.scene.columns import is_set_in_any
from sim.scene.types import Scene, is_muscular, is_pushed, steered_by


def _has_efforts(scene: Scene) -> bool:
    """Whether keys work muscles."""
    parts = (*scene.linear_springs, *scene.angular_springs)
    return is_muscular(scene) and any(part.muscle and part.muscle.keys for part in parts)


_FEATURES: dict[str, Callable[[Scene], bool]] = {
    "HAS_RAILS": has_rails,
    "HAS_BELTS": lambda scene: any(wall.speed for wall in scene.walls),
    "HAS_SOLID": lambda scene: is_set_in_any(scene.masses, "solid"),
    "HAS_STATIC": lambda scene: any(wall.static_friction for wall in scene.walls),
    "HAS_MOTORS": has_motors,
    "HAS_STEERING": lambda scene: bool(steered_by(scene)),
    "HAS_PUSHES": is_pushed,
    "HAS_EFFORTS": _has_efforts,
    "HAS_DRIVEN": lambda scene: has_motors(scene) or is_pushed(scene),
}


def features_of(*scenes: Scene) -> dict[str, bool]:
    """Whether any of some valid scenes has each feature."""
    return {name: any(map(has, scenes)) for name, has in _FEATURES.items()}
