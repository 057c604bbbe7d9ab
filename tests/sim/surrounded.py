"""Bodies of many shapes among walls, in wind or a medium, on the ground, with fillings, and in contact."""

from __future__ import annotations

from typing import Any

import msgspec
import numpy as np
from msgspec.structs import fields, replace

from sim import Anchor, AngularSpring, LinearSpring, Mass, Scene, Simulation
from sim.edit.build import wrapped_degrees
from sim.scene.parts import Motor
from sim.scene.surroundings import Contact, Gas, Ground, Liquid, Medium, Wall, Wind
from sim.scene.types import Damage, Method
from tests.sim.arrays import Arrays, Floats
from tests.sim.bodies import body, tangle
from tests.sim.changes import by, with_joints, with_springs
from tests.sim.checks import known
from tests.sim.touching import CONSTANT, HELD, SOFT, crumpled

KINDS: dict[str, dict[str, Any]] = {
    # Walls that the body is in, at both sides of which there are masses; one is entered, one left.
    "walls": {
        "walls": (
            Wall(point=(0.0, 10.0), normal=(0.2, -1.0), hardness=50.0, friction=0.6, bounciness=0.4),
            Wall(
                point=(60.0, 0.0),
                normal=(-3.0, 1.0),
                hardness=200.0,
                friction=1.5,
                slip_speed=80.0,
            ),
        )
    },
    "walls of a constant restitution": {
        "walls": (
            Wall(point=(0.0, 10.0), normal=(0.2, -1.0), hardness=50.0, friction=0.6, restitution="constant"),
            Wall(
                point=(60.0, 0.0), normal=(-3.0, 1.0), hardness=200.0, bounciness=0.9, restitution="constant"
            ),
        )
    },
    "belts": {
        "walls": (
            Wall(point=(0.0, 10.0), normal=(0.2, -1.0), hardness=50.0, friction=0.6, speed=150.0),
            Wall(
                point=(60.0, 0.0),
                normal=(-3.0, 1.0),
                hardness=200.0,
                friction=0.5,
                static_friction=0.8,
                tangential_hardness=900.0,
                speed=-40.0,
            ),
        )
    },
    "air of the tutorial": {"air_law": "tutorial"},
    "air of the linear law": {"air_law": "linear"},
    "steady wind": {"wind": Wind(velocity=(300.0, -80.0))},
    "gusts": {"wind": Wind(velocity=(300.0, -80.0), turbulence=0.5, length_scale=150.0, seed=3)},
    "gas": {"fillings": (Gas(masses=(0, 2, 4, 5, 3, 1), pressure=90.0, outside=20.0),)},
    "fillings": {
        "fillings": (
            Liquid(masses=(0, 2, 4, 5, 3, 1), bulk_modulus=300.0, area=2800.0),
            Gas(masses=(4, 6, 7, 5), pressure=40.0, area=2000.0),
        )
    },
    # One is so large that not all of its masses are joined in the matrix.
    "fillings of two sizes": {
        "fillings": (
            Gas(masses=(0, 2, 4, 6, 8, 10, 11, 9, 7, 5, 3, 1), pressure=60.0, outside=10.0),
            Liquid(masses=(4, 6, 7, 5), bulk_modulus=300.0, area=2000.0),
        )
    },
}
"""Fields of a scene."""

KINDS["gusts by the tutorial's law"] = {**KINDS["gusts"], **KINDS["air of the tutorial"]}
KINDS["gusts by the linear law"] = {**KINDS["gusts"], **KINDS["air of the linear law"]}
KINDS["medium"] = {"medium": Medium(across=3.0, along=1.2)}
KINDS["current"] = {**KINDS["gusts"], **KINDS["medium"]}
KINDS["ground"] = {"ground": Ground(gravity=800.0, forward=0.3, backward=0.5, sideways=0.9, slip_speed=90.0)}
KINDS["all"] = {**KINDS["walls"], **KINDS["current"], **KINDS["ground"], **KINDS["fillings"]}


def surrounded(kind: str, shape: str = "girder", seed: int = 0, **changes: Any) -> Scene:
    """A body of `tests.sim.bodies` in surroundings of a kind; `changes` are arguments of `body`."""
    # Not an explicit method with a fixed step: for that, walls are softened.
    return replace(by(body(shape, seed=seed, **changes), "generalized_alpha", dt=1e-4), **KINDS[kind])


TOUCHING = {
    f"{shape} in {kind}": (shape, contact)
    for kind, contact in (("contact", SOFT), ("contact of a constant restitution", CONSTANT))
    for shape in ("girder", "cloth", "ring", "chain")
}
"""Shapes that are crumpled so that they touch themselves, and their contact."""
TOUCHING["girder that sticks to itself"] = ("girder", HELD)
BROKEN = "girder in contact, partly broken"
TOUCHING[BROKEN] = ("girder", SOFT)
SOLID = "girder of solid masses that touch themselves and walls"
TOUCHING[SOLID] = ("girder", SOFT)
ALONE = "girder of solid masses that touch each other only"
TOUCHING[ALONE] = ("girder", CONSTANT)

ONE_SIDED = "springs and joints of one side"

ON_RAILS = "girder on rails in walls and a medium, with a gas"
MOTORISED = "girder of motors"
STEERED = "girder of motors and forces that keys work"
AROUND = [*KINDS, *TOUCHING, ONE_SIDED, ON_RAILS, MOTORISED, STEERED]


def block_on_a_belt(speed: float = 30.0) -> Scene:
    """A block of 1 kg that a spring holds back, which sticks and slips: it breaks away at 8 px."""
    return Scene(
        name="block",
        masses=(Mass(position=(100.0, 300.35)), Mass(position=(0.0, 300.35))),
        linear_springs=(LinearSpring(a=0, b=1, stiffness=100.0, rest_length=100.0),),
        anchors=(Anchor(mass=1),),
        walls=(
            Wall(
                point=(0.0, 300.0),
                normal=(0.0, -1.0),
                friction=0.3,
                static_friction=0.8,
                tangential_hardness=4e4,
                restitution="constant",
                speed=speed,
            ),
        ),
        gravity=(0.0, 1000.0),
    )


def around(kind: str, seed: int = 0, **changes: Any) -> Scene:
    """A body in surroundings of a kind, in contact with itself, or of parts that act on one side.

    `changes` are arguments of `body`.
    """
    if kind == ONE_SIDED:
        scene = by(body("girder", seed=seed, **changes), "generalized_alpha", dt=1e-4)
        scene = with_joints(
            with_springs(scene, only=lambda i, _: ("pull", "push", msgspec.UNSET)[i % 3]),
            only=[("above", "below", msgspec.UNSET)[i % 3] for i in range(len(scene.angular_springs))],
        )
        # A knee: two springs with a stop on either side.
        first = scene.angular_springs[0]
        rest_angle = wrapped_degrees(40.0 - first.rest_angle)
        stop = replace(first, a=first.b, b=first.a, rest_angle=rest_angle, only="above")
        return replace(scene, angular_springs=(*scene.angular_springs, stop))
    if kind in (MOTORISED, STEERED):
        scene = by(body("girder", seed=seed, **changes), "generalized_alpha", dt=1e-4)
        motors = [Motor(speed=90.0, torque=2e5, slip=300.0), Motor(speed=-200.0, torque=5e4, slip=500.0)]
        joints = scene.angular_springs
        if kind == STEERED:
            keys = "left-right", "up-down"
            motors = [replace(motor, keys=key) for motor, key in zip(motors, keys, strict=True)]
            forces = [(3e3 - 900.0 * i, 500.0 * i) for i in range(len(scene.masses))]
            pushed = zip(scene.masses, forces, strict=True)
            masses = [replace(one, force=force, keys=keys[i % 2]) for i, (one, force) in enumerate(pushed)]
            scene = replace(scene, masses=tuple(masses))
        return with_joints(scene, motor=[(*motors, msgspec.UNSET)[i % 3] for i in range(len(joints))])
    if kind == ON_RAILS:
        scene = by(body("girder", seed=seed, **changes), "generalized_alpha", dt=1e-4)
        rails = {0: (1.0, 0.3), 3: (0.0, 2.0), 6: (1.0, -1.0)}
        masses = [replace(one, rail=rails.get(i, msgspec.UNSET)) for i, one in enumerate(scene.masses)]
        around = {**KINDS["walls"], **KINDS["medium"], **KINDS["gas"]}
        return replace(scene, masses=tuple(masses), **around)
    if kind not in TOUCHING:
        return surrounded(kind, seed=seed, **changes)
    shape, contact = TOUCHING[kind]
    scene = crumpled(shape, seed, contact, **changes)
    if kind == BROKEN:
        pose = replace(known(scene.pose), damage=Damage(broken=(0, 1, 2, 3)))
        return replace(with_springs(scene, strength=1e9), pose=pose)
    if kind in (SOLID, ALONE):
        # Small in the scene's own places, so that they are not neighbours that never touch.
        masses = [replace(one, solid=i % 4 > 0, radius=8.0 + i % 3) for i, one in enumerate(scene.masses)]
        scene = replace(scene, masses=tuple(masses))
        return replace(scene, **KINDS["walls"]) if kind == SOLID else replace(scene, contact=None)
    return scene


def bare(scene: Scene) -> Scene:
    """The scene without anything that surrounds or touches the body, whose parts act on both sides.

    Of two joints of the same springs, the first.
    """
    added = {name for kind in KINDS.values() for name in kind} | {"contact"}
    scene = replace(
        scene, masses=tuple(replace(mass, solid=msgspec.UNSET, rail=msgspec.UNSET) for mass in scene.masses)
    )
    joints: dict[frozenset[int], AngularSpring] = {}
    for joint in scene.angular_springs:
        joints.setdefault(frozenset((joint.a, joint.b)), joint)
    scene = replace(scene, bodies=(), links=(), angular_springs=(*joints.values(),))
    scene = with_joints(with_springs(scene, only=msgspec.UNSET), only=msgspec.UNSET, motor=msgspec.UNSET)
    return replace(scene, **{each.name: each.default for each in fields(Scene) if each.name in added})


def force_around(scene: Scene) -> tuple[Floats, Floats]:
    """(n, 2) positions, and the forces of all that surrounds or touches the body."""
    forces = [
        arrays.pairs_of(arrays.weight * arrays.accelerations(arrays.q, arrays.v))
        for arrays in (Arrays(scene), Arrays(bare(scene)))
    ]
    at = [mass.position for mass in scene.masses] if scene.pose is None else scene.pose.positions
    return np.array(at), forces[0] - forces[1]


OF_SURROUNDINGS = {
    "wind_speed", "wind_direction", "turbulence", "wall_friction", "static_friction",
    "belt_speed", "bounciness", "gas_pressure", "liquid_stiffness", "contact_distance",
    "contact_stiffness", "contact_friction",
    "drag_across", "drag_along", "ground_forward", "ground_backward", "ground_sideways",
}  # fmt: skip
OF_STRENGTH = {"strength", "yield_force"}


def with_everything() -> Scene:
    """A tangle in gusts, among walls, with fillings, some of whose springs break or yield."""
    strengths, yields = {0: 800.0, 1: 400.0}, {2: 300.0}
    return replace(
        with_springs(
            tangle(4), strength=lambda s, _: strengths.get(s), yield_force=lambda s, _: yields.get(s)
        ),
        air_friction=0.01,
        wind=Wind(velocity=(300.0, -400.0), turbulence=0.2),
        medium=Medium(),
        ground=Ground(),
        walls=(
            Wall(point=(0.0, 900.0), normal=(0.0, -1.0), friction=0.4, bounciness=0.6),
            Wall(
                point=(-500.0, 0.0),
                normal=(1.0, 0.0),
                friction=0.2,
                bounciness=0.3,
                tangential_hardness=900.0,
                static_friction=0.3,
                speed=-40.0,
            ),
        ),
        contact=Contact(distance=5.0, friction=0.3),
        fillings=(
            Gas(masses=(0, 1, 2), pressure=50.0, area=500.0),
            Gas(masses=(2, 1, 3), pressure=20.0, area=500.0),
            Liquid(masses=(0, 2, 3), bulk_modulus=90.0, area=500.0),
        ),
    )


def run(scene: Scene, seconds: float, method: Method = "auto", **numbers: float) -> Simulation:
    """The simulation of a scene after a while, by a method; `numbers` are of its integrator."""
    simulation = Simulation(by(scene, method, **{"dt": 1e-3, "tolerance": 1e-6, **numbers}))
    simulation.advance(seconds)
    return simulation
