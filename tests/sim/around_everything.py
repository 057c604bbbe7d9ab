"""A scene that has everything that surrounds a body, and springs that break and yield."""

from __future__ import annotations

import msgspec

from sim import Scene
from sim.scene.surroundings import Contact, Gas, Ground, Liquid, Medium, Wall, Wind
from tests.sim.bodies import tangle

REPLACE = msgspec.structs.replace

OF_SURROUNDINGS = {
    "wind_speed", "wind_direction", "turbulence", "wall_friction", "bounciness", "gas_pressure",
    "liquid_stiffness", "contact_distance", "contact_stiffness", "contact_friction",
    "drag_across", "drag_along", "ground_forward", "ground_backward", "ground_sideways",
}  # fmt: skip
OF_STRENGTH = {"strength", "yield_force"}


def with_everything() -> Scene:
    """A tangle in gusts, among walls, with fillings, some of whose springs break or yield."""
    scene = tangle(4)
    springs = list(scene.linear_springs)
    springs[0] = REPLACE(springs[0], strength=800.0)
    springs[1] = REPLACE(springs[1], strength=400.0)
    springs[2] = REPLACE(springs[2], yield_force=300.0)
    return REPLACE(
        scene,
        linear_springs=tuple(springs),
        air_friction=0.01,
        wind=Wind(velocity=(300.0, -400.0), turbulence=0.2),
        medium=Medium(),
        ground=Ground(),
        walls=(
            Wall(point=(0.0, 900.0), normal=(0.0, -1.0), friction=0.4, bounciness=0.6),
            Wall(point=(-500.0, 0.0), normal=(1.0, 0.0), friction=0.2, bounciness=0.3),
        ),
        contact=Contact(distance=5.0, friction=0.3),
        fillings=(
            Gas(masses=(0, 1, 2), pressure=50.0, area=500.0),
            Gas(masses=(2, 1, 3), pressure=20.0, area=500.0),
            Liquid(masses=(0, 2, 3), bulk_modulus=90.0, area=500.0),
        ),
    )
