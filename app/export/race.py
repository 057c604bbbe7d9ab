"""Two bodies on one terrain, each by itself, in one film or replay."""

from __future__ import annotations

import math
from bisect import bisect_right
from dataclasses import replace
from itertools import chain, pairwise

import msgspec
import numpy as np

import sim
from sim.edit.terrain import center
from sim.scene.types import Damage, shown_name

from ..session.finish import arrival, finish_of
from ..stage.plan import Picture
from .clip import ClipFrame


def race(moments: list[sim.Moment], others: list[sim.Moment]) -> list[ClipFrame]:
    """The frames of two bodies in one scene, which is only drawn.

    Args:
        moments: of the one, ascending in time.
        others: of the other, which last as long; each by its own method and time step.
    """
    one, other = moments[-1].scene, others[-1].scene
    drawn, times = _together(one, other), [moment.time for moment in others]

    def rival_at(time: float) -> Picture:
        after = bisect_right(times, time)
        if not 0 < after < len(others):
            return Picture.of(others[min(after, len(others) - 1)])
        before, later = Picture.of(others[after - 1]), others[after].positions
        share = (time - times[after - 1]) / (times[after] - times[after - 1])
        return replace(before, positions=before.positions + share * (later - before.positions))

    return [
        ClipFrame(drawn, _side_by_side(one, other, Picture.of(moment), rival_at(moment.time)))
        for moment in moments
    ]


def result(moments: list[sim.Moment]) -> str:
    """How far a body has come, along x, as its centre of mass moves."""
    scene = moments[-1].scene
    first, last = (center(scene, moment.positions) for moment in (moments[0], moments[-1]))
    seconds = moments[-1].time - moments[0].time
    return f"{shown_name(scene)}: {last - first:.0f} {scene.view.unit} in {seconds:g} s"


def winner(moments: list[sim.Moment], others: list[sim.Moment]) -> str:
    """Which body was first at the finish of a race in the page, measured from where each begins."""
    one, other = moments[0].scene, others[0].scene
    finish = finish_of(one, other)
    mine, theirs = _arrived(moments, finish), _arrived(others, finish)
    line = f"the finish at {abs(finish):g} {one.view.unit}"
    if mine is None and theirs is None:
        return f"Nobody came to {line}"
    times = [math.inf if seconds is None else round(seconds, 2) for seconds in (mine, theirs)]
    lead = abs(times[0] - times[1])
    if lead == 0.0:
        return f"Both came to {line} at once, after {times[0]:.2f} s"
    first = shown_name(one if times[0] < times[1] else other)
    return f"{first} was first at {line}, after {min(times):.2f} s" + (
        f", by {lead:.2f} s" if math.isfinite(lead) else ""
    )


def _arrived(moments: list[sim.Moment], finish: float) -> float | None:
    """Seconds from the first moment until the centre of mass has come to the finish; None if it does not."""
    scene, began = moments[0].scene, moments[0].time
    line = center(scene, moments[0].positions) + finish
    for before, after in pairwise(moments):
        if (center(scene, after.positions) - line) * finish >= 0.0:
            seconds = arrival(before, after.step_count - before.step_count, line)
            return (after.time if seconds is None else before.time + seconds) - began
    return None


def _together(one: sim.Scene, other: sim.Scene) -> sim.Scene:
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


def _side_by_side(one: sim.Scene, other: sim.Scene, mine: Picture, theirs: Picture) -> Picture:
    """What is drawn of both at the same time."""
    return Picture(
        np.concatenate((mine.positions, theirs.positions)),
        mine.time,
        damage=_damages(one, other, mine.damage, theirs.damage),
    )


def _damages(one: sim.Scene, other: sim.Scene, mine: Damage | None, theirs: Damage | None) -> Damage | None:
    """What has yielded and broken of both."""
    if mine is None and theirs is None:
        return None
    mine, theirs = mine or Damage(), theirs or Damage()

    def both(field: str, parts: str) -> tuple[float, ...]:
        found = [
            getattr(damage, field) or (0.0,) * len(getattr(scene, parts))
            for damage, scene in ((mine, one), (theirs, other))
        ]
        return (*found[0], *found[1])

    return Damage(
        broken=(*mine.broken, *(s + len(one.linear_springs) for s in theirs.broken)),
        set_lengths=both("set_lengths", "linear_springs"),
        hardened=both("hardened", "linear_springs"),
        set_angles=both("set_angles", "angular_springs"),
    )
