"""The description of one part of a body, in the language that is spoken now."""

from __future__ import annotations

from collections.abc import Iterator

from sim.analysis.part_description import JointFound, MassFound, PartFound, SpringFound
from sim.scene.types import Scene

from ...words import listed, number, say
from .paragraph import way_in_words

_MANY = 8
"""Springs of a mass that are listed, at most."""
_ROUNDING = 1e-6
"""Angles, forces and torques below this are what rounding leaves of none; degrees, kg px/s², kg px²/s²."""


def of_part(found: PartFound, scene: Scene, is_in_hand: bool = False) -> str:
    """The sentences about a part.

    Args:
        found: what it is like.
        scene: its scene.
        is_in_hand: whether somebody holds it now.
    """
    unit = scene.view.unit
    match found:
        case MassFound():
            up = -1.0 if scene.view.y_down else 1.0
            return " ".join(_of_mass(found, unit, up, is_in_hand))
        case SpringFound():
            return " ".join(_of_spring(found, unit))
        case JointFound():
            return " ".join(_of_joint(found))


def _of_mass(found: MassFound, unit: str, up: float, is_in_hand: bool) -> Iterator[str]:
    x, y = (f"{number(place)} {unit}" for place in found.place)
    yield say("describe-part-mass", mass=str(found.number), weight=f"{number(found.mass)} kg", x=x, y=y)
    if is_in_hand:
        yield say("describe-part-held.hand")
    elif found.is_held:
        yield say("describe-part-held")
    if found.speed > 0.0:
        speed = f"{number(found.speed)} {unit}/s"
        yield say("describe-part-moves", way=way_in_words(found.velocity, up), speed=speed)
    else:
        yield say("describe-part-still")
    if not found.springs:
        yield say("describe-part-alone")
    elif len(found.springs) > _MANY:
        yield say("describe-part-joined-most", count=len(found.springs))
    else:
        springs, masses = (listed([str(each) for each in some]) for some in (found.springs, found.neighbours))
        yield say("describe-part-joined", count=len(found.springs), springs=springs, masses=masses)
    if found.touches:
        yield say("describe-part-touches")


def _of_spring(found: SpringFound, unit: str) -> Iterator[str]:
    one, other = map(str, found.ends)
    yield say("describe-part-spring", spring=str(found.number), one=one, other=other)
    if found.is_broken:
        yield say("describe-part-broken")
        return
    length, rest = (f"{number(each)} {unit}" for each in (found.length, found.rest_length))
    yield say("describe-part-length", length=length, rest=rest)
    if found.strain:
        sense = "stretched" if found.strain > 0.0 else "squeezed"
        yield say("describe-part-strain", sense=sense, percent=number(100.0 * abs(found.strain)))
    if abs(found.force) > _ROUNDING:
        sense = "pulls" if found.force > 0.0 else "pushes"
        yield say("describe-part-force", sense=sense, force=f"{number(abs(found.force))} {found.unit}")
    if found.has_yielded:
        yield say("describe-part-yielded")
    if found.muscle is not None:
        yield say("describe-part-muscle", percent=number(100.0 * abs(found.muscle.amplitude)))


def _of_joint(found: JointFound) -> Iterator[str]:
    one, other = map(str, found.springs)
    yield say("describe-part-joint", joint=str(found.number), mass=str(found.mass), one=one, other=other)
    if found.is_broken:
        yield say("describe-part-broken")
        return
    yield say("describe-part-corner", corner=f"{number(found.corner)}°")
    angle, rest, torque = (
        number(each if abs(each) > _ROUNDING else 0.0)
        for each in (found.angle, found.rest_angle, found.torque)
    )
    yield say("describe-part-angle", angle=f"{angle}°", rest=f"{rest}°")
    yield say("describe-part-torque", torque=f"{torque} {found.unit}")
    if found.has_yielded:
        yield say("describe-part-yielded")
    if found.muscle is not None:
        yield say("describe-part-bends", degrees=f"{number(abs(found.muscle.amplitude))}°")
    if found.motor is not None:
        yield say("describe-part-motor", speed=f"{number(abs(found.motor.speed))}°/s")
