"""A part of a body's motion, from which films, replays and keyframes are made."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable
from dataclasses import dataclass, replace

import numpy as np

import sim
from sim.errors import InputError
from sim.motion.moment import Moment

from ..stage.plan import Picture
from ..stage.sketch import Floats

SHORTEST = 0.2
"""Seconds of a clip at least: less is a picture."""

LONGEST = 60.0
"""Seconds of a clip at most."""


@dataclass(frozen=True)
class ClipFrame:
    """One moment of a clip.

    Attributes:
        scene: the body and its settings then.
        picture: what is drawn.
    """

    scene: sim.Scene
    picture: Picture

    @staticmethod
    def of(moment: Moment, ghost: Moment | None = None) -> ClipFrame:
        """A moment of a body, and one of a second body at the same time."""
        other = (ghost.positions, ghost.damage) if ghost is not None else (None, None)
        return ClipFrame(moment.scene, Picture.of(moment, *other))


class Clip:
    """Moments of one body, ascending in time.

    Args:
        frames: at least one; those before the body got other parts are left out.
        seconds: simulated seconds before the last one, beyond which they are left out, too.

    Raises:
        InputError: a position is not a finite number, or what is left is shorter than `SHORTEST`.
    """

    def __init__(self, frames: Iterable[ClipFrame], seconds: float = LONGEST) -> None:
        every = list(frames)
        if not every:
            raise InputError("there is no motion yet; press Play first")
        begin = len(every) - 1
        last = every[-1]
        while begin > 0 and _same_parts(every[begin - 1].scene, last.scene):
            if every[begin].picture.time <= last.picture.time - seconds + 1e-9:
                break
            begin -= 1
        self.frames = every[begin:]
        self._times = [frame.picture.time for frame in self.frames]
        # A step may be longer than what is asked for.
        self.seconds = min(self._times[-1] - self._times[0], seconds)
        if self.seconds < SHORTEST:
            raise InputError(
                f"there are only {self.seconds:.2g} s of motion, and {SHORTEST:g} s are needed; "
                "press Play, and try again a moment later"
            )
        if not all(np.isfinite(frame.picture.positions).all() for frame in self.frames):
            raise InputError("a position is not a finite number")

    @property
    def scene(self) -> sim.Scene:
        """The body as it is at the end."""
        return self.frames[-1].scene

    def places(self) -> Floats:
        """(k, 2) px, the corners of what each moment takes up."""
        corners = [(p.min(0), p.max(0)) for p in (frame.picture.positions for frame in self.frames)]
        return np.array(corners).reshape(-1, 2)

    def count(self, interval: float) -> int:
        """How many moments an interval of so many seconds apart there are, the last one among them."""
        return int(self.seconds / interval + 1e-6) + 1

    def at(self, interval: float) -> Iterable[ClipFrame]:
        """Moments an interval of so many seconds apart, ascending; the last is the last of all."""
        for k in range(self.count(interval) - 1, -1, -1):
            yield self._between(self._times[-1] - k * interval) if k else self.frames[-1]

    def frames_at(self, rate: float) -> Iterable[ClipFrame]:
        """Moments at so many a second, ascending; the first is where the clip begins."""
        begin = self._times[-1] - self.seconds
        return (self._between(begin + k / rate) for k in range(self.count(1.0 / rate)))

    def _between(self, time: float) -> ClipFrame:
        after = max(bisect_right(self._times, time), 1)
        if after == len(self.frames):
            return self.frames[-1]
        one, two = self.frames[after - 1], self.frames[after]
        share = (time - one.picture.time) / (two.picture.time - one.picture.time)
        before, later = one.picture, two.picture
        ghost = before.ghost
        if ghost is not None and later.ghost is not None:
            ghost = ghost + share * (later.ghost - ghost)
        positions = before.positions + share * (later.positions - before.positions)
        return replace(one, picture=replace(before, positions=positions, time=time, ghost=ghost))


def _same_parts(one: sim.Scene, other: sim.Scene) -> bool:
    """Whether two scenes have the same masses and springs, as far as a drawing goes."""
    if one is other:
        return True
    return len(one.masses) == len(other.masses) and [(s.a, s.b) for s in one.linear_springs] == [
        (s.a, s.b) for s in other.linear_springs
    ]
