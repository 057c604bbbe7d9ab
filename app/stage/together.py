"""Several bodies drawn as one: the parts of all in one scene, which is never stepped."""

from __future__ import annotations

from collections.abc import Sequence
from functools import reduce
from itertools import accumulate, chain

import msgspec
import numpy as np

from sim.scene.types import Damage, Scene, shown_name

from .plan import Picture


def together(scenes: Sequence[Scene]) -> Scene:
    """All bodies in the surroundings and the view of the first.

    Args:
        scenes: at least one; a single one is returned as it is.
    """
    return reduce(_two, scenes)


def side_by_side(scenes: Sequence[Scene], pictures: Sequence[Picture]) -> Picture:
    """What is drawn of the bodies of `together` at the same time.

    Args:
        scenes: of each.
        pictures: of each; the time is that of the first.
    """
    if len(pictures) == 1:
        return pictures[0]
    places = np.concatenate([picture.positions for picture in pictures])
    return Picture(places, pictures[0].time, damage=_damages(scenes, [one.damage for one in pictures]))


def _two(one: Scene, other: Scene) -> Scene:
    """Both bodies in the surroundings and the view of the first, with rest lengths as they are in each."""
    changed = msgspec.structs.replace
    n, s = len(one.masses), len(one.linear_springs)
    # A scene has one beat: muscles that follow another one are drawn at rest.
    in_time = one.beat == other.beat
    beat = one.beat or other.beat
    rests = {} if in_time or not one.beat else {"muscle": msgspec.UNSET}
    scale, scales = one.rest_length_scale, other.rest_length_scale
    springs = chain(
        (changed(spring, rest_length=spring.rest_length * scale) for spring in one.linear_springs),
        (
            changed(spring, a=spring.a + n, b=spring.b + n, rest_length=spring.rest_length * scales, **rests)
            for spring in other.linear_springs
        ),
    )
    joints = (changed(j, a=j.a + s, b=j.b + s, **rests) for j in other.angular_springs)
    fillings = (changed(f, masses=tuple(m + n for m in f.masses)) for f in other.fillings)
    return changed(
        one,
        name=f"{one.name[:28]} - {other.name[:28]}",
        title=f"{shown_name(one)[:28]} - {shown_name(other)[:28]}",
        bodies=(),
        links=(),
        masses=(*one.masses, *other.masses),
        linear_springs=tuple(springs),
        angular_springs=(*one.angular_springs, *joints),
        anchors=(*one.anchors, *(changed(a, mass=a.mass + n, driven=False) for a in other.anchors)),
        fillings=(*one.fillings, *fillings),
        beat=beat,
        template=None,
        rest_length_scale=1.0,
        pose=None,
        lesson=None,
    )


def _damages(scenes: Sequence[Scene], damages: Sequence[Damage | None]) -> Damage | None:
    """What has yielded and broken of all."""
    if not any(damages):
        return None
    each = [(scene, damage or Damage()) for scene, damage in zip(scenes, damages, strict=True)]
    firsts = accumulate((len(scene.linear_springs) for scene in scenes), initial=0)

    def joined(field: str, parts: str) -> tuple[float, ...]:
        found = (getattr(damage, field) or (0.0,) * len(getattr(scene, parts)) for scene, damage in each)
        return tuple(chain.from_iterable(found))

    return Damage(
        broken=tuple(
            s + first for (_, damage), first in zip(each, firsts, strict=False) for s in damage.broken
        ),
        set_lengths=joined("set_lengths", "linear_springs"),
        hardened=joined("hardened", "linear_springs"),
        set_angles=joined("set_angles", "angular_springs"),
    )
