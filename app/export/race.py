"""Two bodies on one terrain, each by itself, in one film or replay."""

from __future__ import annotations

import math
from bisect import bisect_right
from dataclasses import replace
from itertools import pairwise

import sim
from sim.edit.terrain import center

from ..session.finish import arrival, finish_of
from ..stage.plan import Picture
from ..stage.together import side_by_side, together
from ..words.english import name_of
from .clip import ClipFrame


def race(moments: list[sim.Moment], others: list[sim.Moment]) -> list[ClipFrame]:
    """The frames of two bodies in one scene, which is only drawn.

    Args:
        moments: of the one, ascending in time.
        others: of the other, which last as long; each by its own method and time step.
    """
    one, other = moments[-1].scene, others[-1].scene
    drawn, times = together((one, other)), [moment.time for moment in others]

    def rival_at(time: float) -> Picture:
        after = bisect_right(times, time)
        if not 0 < after < len(others):
            return Picture.of(others[min(after, len(others) - 1)])
        before, later = Picture.of(others[after - 1]), others[after].positions
        share = (time - times[after - 1]) / (times[after] - times[after - 1])
        return replace(before, positions=before.positions + share * (later - before.positions))

    return [
        ClipFrame(drawn, side_by_side((one, other), (Picture.of(moment), rival_at(moment.time))))
        for moment in moments
    ]


def result(moments: list[sim.Moment]) -> str:
    """How far a body has come, along x, as its centre of mass moves."""
    scene = moments[-1].scene
    first, last = (center(scene, moment.positions) for moment in (moments[0], moments[-1]))
    seconds = moments[-1].time - moments[0].time
    return f"{name_of(scene)}: {last - first:.0f} {scene.view.unit} in {seconds:g} s"


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
    first = name_of(one if times[0] < times[1] else other)
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
