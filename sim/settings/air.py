"""The law of air friction."""

from __future__ import annotations

import math

import msgspec

from ..scene.types import AirLaw, Scene


def with_air_law(scene: Scene, law: AirLaw) -> Scene:
    """Return the scene with another law of air friction.

    To and from the linear law, whose friction has another unit, the friction is converted so that both brake
    equally at a typical speed: the power of ten that is nearest to that of a fall over half of the view, or
    without gravity, to half of the view per second.
    """
    if (law == "linear") == (scene.air_law == "linear"):
        return msgspec.structs.replace(scene, air_law=law)
    x, y, to_x, to_y = scene.view.frame
    half, gravity = 0.5 * max(abs(to_x - x), abs(to_y - y)), math.hypot(*scene.gravity)
    speed = 10.0 ** round(math.log10(max(math.sqrt(gravity * half) or half, 1e-3)))
    friction = scene.air_friction * speed if law == "linear" else scene.air_friction / speed
    return msgspec.structs.replace(scene, air_law=law, air_friction=min(friction, 1000.0))
