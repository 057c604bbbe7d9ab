"""Access to the numbers of a scene's settings: how each is read and written, and its range."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, NamedTuple

import msgspec
import numpy as np

from ..scene.columns import column
from ..scene.surroundings import STILL_AIR
from ..scene.types import AngularSpring, LinearSpring, Scene
from ..scene.validate import number_range
from .recipes import scaled

ROUNDING = 1e-9
"""Largest relative difference between numbers that count as equal. Doubled or halved, no test fails;
at 0, `test_a_setting_knows_whether_its_parts_differ` does."""


class Access(NamedTuple):
    """How a number of a scene is read and written, and its range; the attributes are those of `Setting`."""

    low: float
    high: float
    unit: str
    read: Callable[[Scene], float]
    write: Callable[[Scene, float], Scene]
    differs: Callable[[Scene], bool] = lambda _: False


def replaced(path: str) -> Callable[[Scene, Any], Scene]:
    """Return a function that writes a field of a scene, or of one of its parts, as in "gravity" or
    "wind.turbulence"."""
    *part, field = path.split(".")

    def write(scene: Scene, value: Any) -> Scene:
        owner = msgspec.structs.replace(getattr(scene, part[0]) if part else scene, **{field: value})
        return msgspec.structs.replace(scene, **{part[0]: owner}) if part else owner

    return write


def at(kind: type, path: str) -> Access:
    """Return access to the number at a path, see `replaced`; it reads 0 if the scene has no such part.

    Args:
        kind: type of the part, or of the scene.
        path: path to the number.
    """
    *part, field = path.split(".")

    def read(scene: Scene) -> float:
        owner = getattr(scene, part[0]) if part else scene
        return getattr(owner, field) if owner else 0.0

    return Access(*number_range(kind, field), read, replaced(path))


def largest(kind: type, parts: str, field: str) -> Access:
    """Return access to the value of the largest magnitude of a number among parts; the others keep their
    ratio to it, and parts without the number have none.

    Args:
        kind: type of the parts, or of what they have; the field may also have others.
        parts: the field of the scene with the parts.
        field: the number, or its path in a part, as in "motor.torque".
    """
    are_springs = kind in (LinearSpring, AngularSpring)
    *inner, name = field.split(".")

    def owner(part: Any) -> Any:
        """Return what has the number in a part; None if nothing has."""
        found = getattr(part, inner[0]) if inner else part
        return found if isinstance(found, kind) else None

    def values(scene: Scene) -> np.ndarray:
        every = getattr(scene, parts)
        if are_springs:
            found = column(every, field)
        else:
            numbers = [getattr(each, name) for each in map(owner, every) if each is not None]
            found = np.array([x for x in numbers if x is not msgspec.UNSET], float)
        return found[~np.isnan(found)]

    def read(scene: Scene) -> float:
        found = values(scene)
        return float(found[np.abs(found).argmax()]) if found.size else 0.0

    def write(scene: Scene, value: float) -> Scene:
        """Scale all to the new largest value; if all were zero, set all to it."""
        old = read(scene)
        if are_springs and scene.bodies:
            return scaled(scene, parts, field, value, old)

        def changed(part: Any) -> Any:
            own = owner(part)
            if own is None or (number := getattr(own, name)) in (None, msgspec.UNSET):
                return part
            new = msgspec.structs.replace(own, **{name: value * (number / old) if old else value})
            return msgspec.structs.replace(part, **{inner[0]: new}) if inner else new

        return msgspec.structs.replace(scene, **{parts: tuple(map(changed, getattr(scene, parts)))})

    def differ(scene: Scene) -> bool:
        """Return whether they differ by more than rounding after scaling."""
        found = values(scene)
        return found.size > 1 and float(np.ptp(found)) > ROUNDING * float(np.abs(found).max())

    return Access(*number_range(kind, name), read, write, differ)


# ------------------------------------------------------------------------- wind
def wind_speed(scene: Scene) -> float:
    """Return the wind speed, px/s; 0 without wind."""
    speed = math.hypot(*scene.wind.velocity) if scene.wind else 0.0
    return _neat(speed) if speed >= STILL_AIR else 0.0


def wind_direction(scene: Scene) -> float:
    """Return the direction in which the wind blows on the screen: degrees, 0 to the right, 90 upwards."""
    x, y = scene.wind.velocity if scene.wind else (0.0, 0.0)
    return _neat(math.degrees(math.atan2(-y if scene.view.y_down else y, x))) + 0.0  # not -0.0


def with_wind(scene: Scene, speed: float, direction: float) -> Scene:
    """Return the scene, which must have wind, with another speed, px/s, and direction, degrees."""
    angle = math.radians(direction if not scene.view.y_down else -direction)
    # A small speed remains, so that the direction is kept.
    size = speed if speed >= STILL_AIR else 0.5 * STILL_AIR
    return replaced("wind.velocity")(scene, (size * math.cos(angle), size * math.sin(angle)))


def _neat(value: float) -> float:
    """Return a number without the rounding errors of its computation."""
    return float(f"{value:.12g}")
