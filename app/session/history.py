"""The moments of a session that are past, to go back to, and those that were once to come."""

from __future__ import annotations

from bisect import bisect_left

import numpy as np
from numpy.typing import NDArray

from sim import Moment, Scene

SPAN = 3600
"""Frames that are kept: a minute at 60 Hz."""

MOST_BYTES = 64_000_000
"""What all moments of a page take at most."""

_OVERHEAD = 400
"""Bytes of a moment beside its numbers, about."""

_PER_PART = 250
"""Bytes of one mass or spring of a scene, about: moments share it until somebody moves a slider."""

BEFORE_RUNAWAY = 0.5
"""Simulated seconds before a runaway began, to which a user is taken."""

_SMOOTH = 5
"""Frames over which the largest kinetic energy is taken: springs that flip to and fro have pauses."""


_WIDEST = 120
"""Frames between two moments, at most, that both are long past."""

_CALM = 2.0
"""Speed of a body that is sound, at most, in sizes of the body per second, on average over its masses."""


class History:
    """A ring of moments, one for each frame in which time passed, and which of them is shown.

    A minute of a body of up to some 500 masses fits. Of larger ones every second moment of the older half is
    given up whenever they take too much: the last frames, which one goes through one by one, stay complete,
    and the minute stays within reach.

    Attributes:
        shown: index of the moment that the page shows.
    """

    def __init__(self) -> None:
        self.clear()

    def clear(self) -> None:
        """Forget everything."""
        self._moments: list[Moment] = []
        self._frames: list[int] = []
        self._frame = 0
        self._bytes = 0
        self.shown = -1

    def __len__(self) -> int:
        return len(self._moments)

    def __getitem__(self, index: int) -> Moment:
        return self._moments[index]

    @property
    def last(self) -> int:
        """Index of the newest moment; -1 if there is none."""
        return len(self._moments) - 1

    @property
    def scrubbed(self) -> bool:
        """Whether another moment than the newest is shown."""
        return self.shown < len(self._moments) - 1

    @property
    def start(self) -> float:
        """Time of the oldest moment, s; 0 if there is none."""
        return self._moments[0].time if self._moments else 0.0

    @property
    def end(self) -> float:
        """Time of the newest moment, s; 0 if there is none."""
        return self._moments[-1].time if self._moments else 0.0

    @property
    def bytes(self) -> int:
        """What all of it takes, about."""
        return self._bytes

    def add(self, moment: Moment) -> None:
        """The next frame's moment; it is shown. Moments that are not before it are dropped."""
        moments = self._moments
        while moments and moments[-1].time >= moment.time:
            self._drop_last()
        self._frame += 1
        before = moments[-1].scene if moments else None
        moments.append(moment)
        self._frames.append(self._frame)
        self._bytes += _size(moment, before)
        if len(moments) > SPAN or self._frames[0] <= self._frame - SPAN:
            self._drop_first()
        if self._bytes > MOST_BYTES:
            self._thin()
        self.shown = len(moments) - 1

    def amend(self, moment: Moment) -> None:
        """The newest moment is this one after all."""
        if self._moments:
            self._drop_last()
        self.add(moment)

    def nearest(self, time: float) -> int:
        """Index of the moment nearest to a time, s; there must be one."""
        at = bisect_left(self._moments, time, key=lambda moment: moment.time)
        if at == 0 or (at <= self.last and self._moments[at].time - time < time - self._moments[at - 1].time):
            return at
        return at - 1

    def back(self, seconds: float) -> int:
        """Index of the moment so many seconds before the one that is shown, and one frame at least."""
        before = max(self.shown - 1, 0)
        return (
            min(before, self.nearest(self._moments[self.shown].time - seconds)) if seconds > 0.0 else before
        )

    def cut(self) -> list[Moment]:
        """Drop what is newer than what is shown, and return it, the moment shown first; or nothing at all."""
        if not self.scrubbed:
            return []
        newer = self._moments[self.shown :]
        while self.scrubbed:
            self._drop_last()
        return newer

    def before_runaway(self) -> int:
        """Index of the last moment at which a body that ran away was still sound; there must be one.

        A body that swings is slower again after every fast moment. One that runs away is not: the end of the
        ring at which the kinetic energy only grows is the runaway. Some time before that is a sound moment,
        unless the body was too fast for its size even then.
        """
        mass = np.array([m.mass for m in self._moments[-1].scene.masses])
        squares = [float(mass @ (m.rows[2] ** 2 + m.rows[3] ** 2)) for m in self._moments]
        smooth = [max(squares[max(0, i - _SMOOTH + 1) : i + 1]) for i in range(len(squares))]
        onset = self.last
        while onset > 0 and smooth[onset - 1] < smooth[onset]:
            onset -= 1
        index = self.nearest(self._moments[onset].time - BEFORE_RUNAWAY)
        # Some have been torn to and fro for long before they run away.
        sizes = [float(np.ptp(m.rows[:2], axis=1).max()) for m in self._moments[: index + 1]]
        calm = float(mass.sum()) * (_CALM * float(np.median(sizes))) ** 2
        return next((i for i in range(index, -1, -1) if squares[i] <= calm), index)

    def _drop_last(self) -> None:
        moment = self._moments.pop()
        self._frames.pop()
        self._bytes -= _size(moment, self._moments[-1].scene if self._moments else None)

    def _drop_first(self) -> None:
        moment = self._moments.pop(0)
        self._frames.pop(0)
        after = self._moments[0]
        # The next one pays for the scene that they share.
        self._bytes -= _size(moment, None) - (_size(after, None) - _size(after, moment.scene))

    def _thin(self) -> None:
        half, frames = max(len(self._moments) // 2, 2), self._frames
        keep: list[int] = [0]
        for i in range(1, half):
            if keep[-1] != i - 1 or frames[i + 1] - frames[keep[-1]] > _WIDEST:
                keep.append(i)
        if len(keep) == half:
            keep = keep[half // 2 :]  # it is as sparse as it may be
        self._moments[:half] = [self._moments[i] for i in keep]
        self._frames[:half] = [frames[i] for i in keep]
        scenes = [None, *(moment.scene for moment in self._moments[:-1])]
        self._bytes = sum(map(_size, self._moments, scenes))


class OldFuture:
    """What would have come, had the user not gone back and changed something.

    Args:
        moments: ascending, from where the user went on.

    Attributes:
        start, end: of the time it covers, s.
    """

    def __init__(self, moments: list[Moment]) -> None:
        self._moments = moments
        self.start, self.end = moments[0].time, moments[-1].time

    def positions_at(self, time: float) -> NDArray[np.float64] | None:
        """(n, 2) positions, px, at a time, s, between two moments in a straight line; None outside them."""
        if not self.start <= time <= self.end:
            return None
        at = max(1, bisect_left(self._moments, time, key=lambda moment: moment.time))
        before, after = self._moments[at - 1], self._moments[at]
        share = (time - before.time) / (after.time - before.time)
        return (before.positions + share * (after.positions - before.positions)).copy()


def _size(moment: Moment, before: Scene | None) -> int:
    """Bytes of a moment that follows one of a scene."""
    size = moment.rows.nbytes + _OVERHEAD
    if moment.scene is not before:
        scene = moment.scene
        parts = len(scene.masses) + len(scene.linear_springs) + len(scene.angular_springs)
        size += _PER_PART * parts
    return size
