"""Bodies in surroundings, and bodies that break, for tests of the page."""

from __future__ import annotations

import math

import msgspec

import sim
from sim.scene.surroundings import Gas, Liquid, Wall, Wind

FLOOR = Wall(point=(0.0, 580.0), normal=(0.0, -2.0))


def chain_under_load(strength: float = 1500.0, **changes: object) -> sim.Scene:
    """Five masses in a row that hang from the first; the second spring from the top breaks as they fall."""
    masses = tuple(sim.Mass(position=(300.0, 60.0 + 50.0 * i)) for i in range(5))
    springs = tuple(
        sim.LinearSpring(
            a=i,
            b=i + 1,
            stiffness=2000.0,
            damping=2.0,
            rest_length=50.0,
            strength=strength if i == 1 else None,
        )
        for i in range(4)
    )
    joints = tuple(sim.AngularSpring(a=i, b=i + 1, stiffness=20.0) for i in range(3))
    scene = sim.Scene(
        name="load",
        masses=masses,
        linear_springs=springs,
        angular_springs=joints,
        anchors=(sim.Anchor(mass=0),),
        gravity=(0.0, 500.0),
        walls=(FLOOR,),
    )
    return msgspec.structs.replace(scene, **changes)


def balloon(liquid: bool = False, **changes: object) -> sim.Scene:
    """A loop of springs over a floor, full of gas or of a liquid."""
    n, radius = 10, 80.0
    turns = [math.tau * i / n for i in range(n)]
    inside = tuple(range(n))
    fill = Liquid(masses=inside, bulk_modulus=2e4) if liquid else Gas(masses=inside, pressure=400.0)
    scene = sim.Scene(
        name="balloon",
        masses=tuple(
            sim.Mass(position=(300.0 + radius * math.cos(t), 300.0 + radius * math.sin(t)), mass=0.3)
            for t in turns
        ),
        linear_springs=tuple(
            sim.LinearSpring(a=i, b=(i + 1) % n, stiffness=3000.0, damping=3.0, rest_length=45.0)
            for i in range(n)
        ),
        gravity=(0.0, 500.0),
        walls=(FLOOR,),
        fillings=(fill,),
    )
    return msgspec.structs.replace(scene, **changes)


GUSTS = Wind(velocity=(300.0, -100.0), turbulence=0.4, length_scale=200.0, seed=3)
