"""Bodies that touch each other and themselves."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from msgspec.structs import replace

from sim import Anchor, AngularSpring, LinearSpring, Mass, Scene
from sim.scene.surroundings import Contact
from tests.sim.arrays import Arrays, Floats
from tests.sim.bodies import body
from tests.sim.builders import built
from tests.sim.changes import by, posed

SOFT = Contact(distance=12.0, stiffness=50.0, friction=0.7, slip_speed=80.0, bounciness=0.6)
SMOOTH = replace(SOFT, friction=0.0, bounciness=1.0)
HARD = Contact(distance=6.0, stiffness=500.0, friction=0.4, bounciness=0.3)
CONSTANT = replace(SOFT, restitution="constant")
HELD = replace(CONSTANT, tangential_stiffness=900.0)
Pairs = set[tuple[int, int]]
"""Springs, and slots of masses."""


def crumpled(shape: str, seed: int = 0, contact: Contact = SOFT, **changes: Any) -> Scene:
    """A body of `tests.sim.bodies`, crumpled so that many of its parts touch; `changes` are of `body`."""
    scene = body(shape, seed=seed, **changes)
    rng = np.random.default_rng(seed)
    at = np.array([mass.position for mass in scene.masses])
    at, speed = 0.5 * at + rng.uniform(-25.0, 25.0, at.shape), rng.normal(0.0, 100.0, at.shape)
    # Not an explicit method with a fixed step: for that, contact is softened.
    return posed(replace(by(scene, "generalized_alpha", dt=1e-4), contact=contact), at, speed)


def joined(*scenes: Scene, **fields: Any) -> Scene:
    """Several bodies as one scene."""
    masses: list[Mass] = []
    springs: list[LinearSpring] = []
    joints: list[AngularSpring] = []
    anchors: list[Anchor] = []
    for scene in scenes:
        n, s = len(masses), len(springs)
        masses += scene.masses
        springs += [replace(spring, a=spring.a + n, b=spring.b + n) for spring in scene.linear_springs]
        joints += [replace(joint, a=joint.a + s, b=joint.b + s) for joint in scene.angular_springs]
        anchors += [replace(anchor, mass=anchor.mass + n) for anchor in scene.anchors]
    return Scene(
        name="bodies",
        masses=tuple(masses),
        linear_springs=tuple(springs),
        angular_springs=tuple(joints),
        anchors=tuple(anchors),
        **fields,
    )


def ring(
    centre: tuple[float, float], radius: float, count: int, velocity: tuple[float, float] = (0.0, 0.0)
) -> Scene:
    """A ring of masses of 0.1 kg, as one body."""
    turns = [math.tau * i / count for i in range(count)]
    x, y = centre
    pairs = [(i, (i + 1) % count) for i in range(count)]
    joint = AngularSpring(a=0, b=1, stiffness=2000.0, rest_angle=360.0 / count)
    return built(
        [(x + radius * math.cos(v), y + radius * math.sin(v)) for v in turns], pairs, mass=0.1,
        velocities=[velocity] * count, stiffness=3000.0, damping=0.5,
        rest_length=2.0 * radius * math.sin(math.pi / count),
        angular_springs=tuple(replace(joint, a=a, b=b) for a, b in pairs),
    )  # fmt: skip


def line(start: tuple[float, float], step: tuple[float, float], count: int, held: tuple[int, ...]) -> Scene:
    """A rope of masses of 0.1 kg in a straight line."""
    places = [(start[0] + step[0] * i, start[1] + step[1] * i) for i in range(count)]
    numbers: dict[str, Any] = {
        "mass": 0.1,
        "stiffness": 4000.0,
        "damping": 2.0,
        "rest_length": math.hypot(*step),
    }
    return built(places, **numbers, held=held)


def listed(arrays: Arrays) -> Pairs:
    contact = arrays.body.environment.contact
    springs = np.repeat(np.arange(arrays.body.springs), np.diff(contact.start))
    return set(zip(springs.tolist(), contact.member[: contact.start[-1]].tolist(), strict=True))


def nearer(arrays: Arrays, q: Floats, distance: float) -> Pairs:
    """All pairs nearer than a distance that may touch, without a grid."""
    body, contact = arrays.body, arrays.body.environment.contact
    at = np.stack((q[: arrays.slots], q[arrays.slots :]), 1)
    a, way = at[body.spring_a], at[body.spring_b] - at[body.spring_a]
    to = at[1 : body.masses + 1] - a[:, None]
    length = np.maximum((way * way).sum(1), 1e-300)
    t = np.clip((to * way[:, None]).sum(2) / length[:, None], 0.0, 1.0)
    near = np.hypot(*np.moveaxis(to - t[..., None] * way[:, None], 2, 0)) <= distance
    for s in range(body.springs):
        near[s, contact.apart[contact.apart_start[s] : contact.apart_start[s + 1]] - 1] = False
    return {(int(s), int(m) + 1) for s, m in np.argwhere(near)}
