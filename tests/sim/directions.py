"""The same body with some of its springs written the other way round."""

from __future__ import annotations

from collections.abc import Collection

import msgspec
import numpy as np

from sim import Scene
from sim.edit.build import in_turn


def flipped(scene: Scene, springs: Collection[int]) -> Scene:
    """The scene whose springs of these indices go from b to a. Angles with one of them are 180° larger."""
    angular = tuple(
        msgspec.structs.replace(j, rest_angle=in_turn(j.rest_angle + 180.0))
        if (j.a in springs) != (j.b in springs)
        else j
        for j in scene.angular_springs
    )
    linear = tuple(
        msgspec.structs.replace(s, a=s.b, b=s.a) if i in springs else s
        for i, s in enumerate(scene.linear_springs)
    )
    return msgspec.structs.replace(scene, linear_springs=linear, angular_springs=angular)


def some_flipped(scene: Scene, seed: int) -> Scene:
    """The scene with about half of its springs flipped."""
    rng = np.random.default_rng(seed)
    return flipped(scene, set(np.flatnonzero(rng.random(len(scene.linear_springs)) < 0.5).tolist()))
