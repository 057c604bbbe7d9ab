"""Adding masses, springs, joints and anchors to a scene, and removing them."""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from dataclasses import replace
from statistics import median
from typing import TypeVar

import msgspec
import numpy as np

from ..errors import SceneError
from ..motion.moment import Moment
from ..scene.numbers import MAX_COORDINATE, Vector
from ..scene.parts import Anchor, AngularSpring, LinearSpring, Mass
from ..scene.recipes.assembly import wrapped
from ..scene.types import Scene
from ..scene.validate import SHORTEST
from ..text import Text
from .edit import Edit, Map, Selection, counted, of_parts, refuse_missing, with_added, without

P = TypeVar("P", Mass, LinearSpring, AngularSpring)

NEW_MASS = Mass(position=(0.0, 0.0))
NEW_SPRING = LinearSpring(a=0, b=1, stiffness=10_000.0, damping=20.0, rest_length=1.0)
NEW_JOINT = AngularSpring(a=0, b=1, stiffness=10_000.0)
"""Parts that are added to a scene without any of their kind."""


def add_mass(scene: Scene, at: Vector, held: bool = False) -> Edit:
    """Add a mass at rest, as heavy and as large as the scene's others (by the median).

    Args:
        scene: the scene to extend.
        at: its start position, px.
        held: whether it is held there.

    Raises:
        SceneError: there are too many, or the position is out of range.
    """
    scene = of_parts(scene)
    mass = msgspec.structs.replace(_typical(scene.masses, NEW_MASS, "mass", "radius"), position=place(at))
    anchors = [Anchor(mass=len(scene.masses))] if held else []
    return with_added("mass added", scene, masses=[mass], anchors=anchors)


def add_springs(
    scene: Scene,
    pairs: Sequence[tuple[int, int]],
    positions: Sequence[Vector],
    scale: float | None = None,
) -> Edit:
    """Add springs between masses, at rest as they are; skip pairs that are already connected.

    Args:
        scene: the scene to extend.
        pairs: the masses that each connects.
        positions: of all masses, px, which give the rest lengths.
        scale: the present factor of all rest lengths, by which they are divided; None for the scene's.

    Raises:
        SceneError: a mass does not exist, two masses coincide, or there are too many springs.
    """
    scene = of_parts(scene)
    scale = scene.rest_length_scale if scale is None else scale
    taken = {(spring.a, spring.b) for spring in scene.linear_springs}
    typical, springs = _typical(scene.linear_springs, NEW_SPRING, "stiffness", "damping"), []
    for a, b in pairs:
        refuse_missing((a, b), len(scene.masses))
        if a == b or (a, b) in taken or (b, a) in taken:
            continue
        taken.add((a, b))
        length = math.dist(positions[a], positions[b]) / scale
        apart = math.dist(scene.masses[a].position, scene.masses[b].position)
        if scene.pose is not None:
            apart = min(apart, math.dist(scene.pose.positions[a], scene.pose.positions[b]))
        if not min(length, apart) > SHORTEST or length > 1e6:
            raise SceneError(
                Text(
                    "masses {a} and {b} are, or start, in the same place, so no spring can join them",
                    a=a,
                    b=b,
                )
                if length <= 1e6
                else Text(
                    "masses {a} and {b} are too far apart for a spring: its rest length is 1e6 px at most",
                    a=a,
                    b=b,
                )
            )
        springs.append(msgspec.structs.replace(typical, a=a, b=b, rest_length=length))
    return with_added(f"{counted(len(springs), 'spring')} added", scene, springs=springs)


def add_joints(
    scene: Scene, pairs: Sequence[tuple[int, int]], angles: Sequence[float], stiffness: float | None = None
) -> Edit:
    """Add angular springs between pairs of linear springs; skip pairs that already have one.

    Args:
        scene: the scene to extend.
        pairs: the linear springs that each connects.
        angles: the rest angle of each, degrees; `angle_between` gives the present one.
        stiffness: of each, kg/s², or None for that of the scene's others (by the median).

    Raises:
        SceneError: a spring does not exist, the two share no mass, or there are too many joints.
    """
    scene = of_parts(scene)
    taken = {(joint.a, joint.b) for joint in scene.angular_springs}
    typical, joints = _typical(scene.angular_springs, NEW_JOINT, "stiffness", "damping"), []
    springs = scene.linear_springs
    if stiffness is not None:
        typical = msgspec.structs.replace(typical, stiffness=stiffness)
    for (a, b), angle in zip(pairs, angles, strict=True):
        refuse_missing((a, b), len(springs), "spring")
        if a == b or not {springs[a].a, springs[a].b} & {springs[b].a, springs[b].b}:
            raise SceneError(
                Text("springs {a} and {b} share no mass, so no angular spring can hold them", a=a, b=b)
            )
        if (a, b) in taken or (b, a) in taken:
            continue
        taken.add((a, b))
        joints.append(msgspec.structs.replace(typical, a=a, b=b, rest_angle=wrapped_degrees(angle)))
    return with_added(f"{counted(len(joints), 'joint')} added", scene, joints=joints)


def extend(
    scene: Scene, mass: int, to: Vector, positions: Sequence[Vector], scale: float | None = None
) -> Edit:
    """Add a mass and a spring from an existing mass to it.

    Args:
        scene: the scene to extend.
        mass: where the spring begins.
        to: position of the new mass, px.
        positions: of the scene's masses, px.
        scale: see `add_springs`.

    Raises:
        SceneError: as `add_mass` and `add_springs`.
    """
    scene, (x, y) = of_parts(scene), place(to)
    n = len(scene.masses)
    refuse_missing([mass], n)
    # Its position relative to the other mass is the same at the start as now.
    here = positions[mass]
    start = scene.masses[mass].position if scene.pose is None else scene.pose.positions[mass]
    begins = (start[0] + (x - here[0]), start[1] + (y - here[1]))
    first = add_mass(scene, begins)
    second = add_springs(first.scene, [(mass, n)], [*positions, (x, y)], scale)
    edit = joined("mass and spring added", first, second)
    shift = np.zeros((2, n + 1))
    shift[:, n] = x - begins[0], y - begins[1]
    return replace(edit, shift=shift if shift.any() else None)


def joined(label: str, first: Edit, second: Edit) -> Edit:
    """Combine two successive edits into one; the second must not move masses."""
    return Edit(
        label,
        second.scene,
        _after(first.masses, second.masses),
        _after(first.springs, second.springs),
        _after(first.joints, second.joints),
        shift=first.shift,
    )


def _after(first: Map, second: Map) -> Map:
    if first is None or second is None:
        return second if first is None else first
    return tuple(first[i] if i >= 0 else -1 for i in second)


def remove(scene: Scene, gone: Selection) -> Edit:
    """Remove some parts, and those that depend on them.

    Raises:
        SceneError: no mass would be left.
    """
    scene = of_parts(scene)
    left, masses, springs, joints = without(scene, gone)
    numbers = [
        (len(scene.masses) - len(left.masses), "mass"),
        (len(scene.linear_springs) - len(left.linear_springs), "spring"),
        (len(scene.angular_springs) - len(left.angular_springs), "joint"),
    ]
    # Parts removed along with others are not mentioned.
    label = next((counted(count, what) for count, what in numbers if count), "nothing")
    return Edit(f"{label} removed", left, masses, springs, joints)


def pin(scene: Scene, masses: Collection[int], on: bool) -> Edit:
    """Hold some masses where they are, or let them go.

    Raises:
        SceneError: one of them does not exist.
    """
    scene = of_parts(scene)
    refuse_missing(masses, len(scene.masses))
    held = {anchor.mass for anchor in scene.anchors}
    if on:
        anchors = (*scene.anchors, *(Anchor(mass=i) for i in sorted(set(masses) - held)))
    else:
        anchors = tuple(anchor for anchor in scene.anchors if anchor.mass not in masses)
    label = f"{counted(len(masses), 'mass')} {'pinned' if on else 'let go'}"
    return Edit(label, msgspec.structs.replace(scene, anchors=anchors))


# ------------------------------------------------------------------------- numbers
def place(at: Vector) -> Vector:
    """Return a position as a scene can have it.

    Raises:
        SceneError: it is out of range or not a number.
    """
    x, y = float(at[0]), float(at[1])
    if not (abs(x) <= MAX_COORDINATE and abs(y) <= MAX_COORDINATE):
        raise SceneError(Text("({x:g}, {y:g}) is not in the range -1e6..1e6 px", x=x, y=y))
    return x, y


def _typical(parts: Sequence[P], new: P, *fields: str) -> P:
    """Return a new part whose numbers in some fields are the medians of existing parts, if there are any."""
    if not parts:
        return new
    return msgspec.structs.replace(new, **{f: median(getattr(part, f) for part in parts) for f in fields})


def angle_between(scene: Scene, a: int, b: int, positions: Sequence[Vector]) -> float:
    """Return the present angle from linear spring a to b, degrees in (-180, 180], as in `AngularSpring`."""
    (ax, ay), (bx, by) = (
        (
            positions[spring.b][0] - positions[spring.a][0],
            positions[spring.b][1] - positions[spring.a][1],
        )
        for spring in (scene.linear_springs[a], scene.linear_springs[b])
    )
    return math.degrees(math.atan2(ax * by - ay * bx, ax * bx + ay * by))


def wrapped_degrees(angle: float) -> float:
    """Wrap an angle, degrees, into (-180, 180]."""
    return wrapped(math.remainder(angle, 360.0))


def positions_of(moment: Moment) -> list[Vector]:
    """Return the positions of the masses, px."""
    return [(x, y) for x, y in moment.positions.tolist()]
