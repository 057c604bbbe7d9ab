"""Reading and writing the numbers of a scene's surroundings, and of what springs bear, for `sim.settings`."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import msgspec
import numpy as np
from numpy.typing import ArrayLike

from ..scene.types import Scene

STILL_AIR = 1e-6
"""px/s below which there is no wind; a little is left of it, so that its direction is kept."""

ROUNDING = 1e-9
"""Part of a number by which others may differ from it and still count as equal."""


def _neat(value: float) -> float:
    """A number without the rounding of what it was made from."""
    return float(f"{value:.12g}")


def wind_speed(scene: Scene) -> float:
    """px/s; 0 without wind."""
    speed = math.hypot(*scene.wind.velocity) if scene.wind else 0.0
    return _neat(speed) if speed >= STILL_AIR else 0.0


def wind_direction(scene: Scene) -> float:
    """The direction to which it blows on the screen: degrees, 0 to the right, 90 upwards."""
    x, y = scene.wind.velocity if scene.wind else (0.0, 0.0)
    return _neat(math.degrees(math.atan2(-y if scene.view.y_down else y, x))) + 0.0  # without a sign of zero


def with_wind(scene: Scene, speed: float, direction: float) -> Scene:
    """The scene, which has wind, with one of another speed, px/s, and direction, degrees."""
    assert scene.wind is not None
    angle = math.radians(direction if not scene.view.y_down else -direction)
    size = speed if speed >= STILL_AIR else 0.5 * STILL_AIR
    wind = msgspec.structs.replace(scene.wind, velocity=(size * math.cos(angle), size * math.sin(angle)))
    return msgspec.structs.replace(scene, wind=wind)


def with_turbulence(scene: Scene, value: float) -> Scene:
    """The scene, which has wind, with other gusts."""
    assert scene.wind is not None
    return msgspec.structs.replace(scene, wind=msgspec.structs.replace(scene.wind, turbulence=value))


def of_contact(field: str) -> Callable[[Scene], float]:
    """A number of a scene's contact; 0 where there is none."""
    return lambda scene: getattr(scene.contact, field) if scene.contact else 0.0


def with_contact(field: str) -> Callable[[Scene, float], Scene]:
    """The scene, which has contact, with another number of it."""

    def write(scene: Scene, value: float) -> Scene:
        assert scene.contact is not None
        contact = msgspec.structs.replace(scene.contact, **{field: value})
        return msgspec.structs.replace(scene, contact=contact)

    return write


def largest_of(parts: str, kind: type, field: str) -> Callable[[Scene], float]:
    """The largest of a number of those parts of a scene that are of a kind and have the number."""

    def read(scene: Scene) -> float:
        numbers = [getattr(part, field) for part in getattr(scene, parts) if isinstance(part, kind)]
        return max((number for number in numbers if number is not None), default=0.0)

    return read


def differ_of(parts: str, kind: type, field: str) -> Callable[[Scene], bool]:
    """Whether those parts of a scene that are of a kind and have a number have different ones."""

    def differ(scene: Scene) -> bool:
        numbers = [getattr(part, field) for part in getattr(scene, parts) if isinstance(part, kind)]
        return are_different([number for number in numbers if number is not None])

    return differ


def are_different(numbers: ArrayLike) -> bool:
    """Whether numbers differ by more than they do after being scaled; one that is NaN is none."""
    values = np.asarray(numbers, float)
    values = values[~np.isnan(values)]
    return values.size > 1 and float(np.ptp(values)) > ROUNDING * float(np.abs(values).max())


def scaled_of(parts: str, kind: type, field: str) -> Callable[[Scene, float], Scene]:
    """Set the largest to the value and scale the others in proportion; if all were zero, set all."""

    def write(scene: Scene, value: float) -> Scene:
        old = largest_of(parts, kind, field)(scene)

        def changed(part: Any) -> Any:
            number = getattr(part, field) if isinstance(part, kind) else None
            if number is None:
                return part
            return msgspec.structs.replace(part, **{field: value * (number / old) if old else value})

        return msgspec.structs.replace(scene, **{parts: tuple(map(changed, getattr(scene, parts)))})

    return write
