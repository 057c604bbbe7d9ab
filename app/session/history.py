"""The moments of a session that are past, to go back to, and those that were once to come."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Mapping
from itertools import takewhile
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from sim import Moment
from sim.scene.types import Damage

SPAN = 3600
"""Frames that are kept: a minute at 60 Hz."""

MAX_BYTES = 64_000_000
"""What all moments of a page take at most."""

_OVERHEAD = 400
"""Bytes of a moment beside its numbers, about."""

_PER_PART = 250
"""Bytes of one mass or spring of a scene, about: moments share it until somebody moves a slider."""

_PER_NUMBER = 32
"""Bytes of a number of what has yielded and broken; moments share these, too, while nothing changes."""

BEFORE_RUNAWAY = 0.5
"""Simulated seconds before a runaway began, to which a user is taken."""

_SMOOTH = 5
"""Frames over which the largest kinetic energy is taken: springs that flip to and fro have pauses."""

_WIDEST = 120
"""Frames between two moments, at most, that both are long past."""

_CALM = 2.0
"""Speed of a body that is sound, at most, in sizes of the body per second, on average over its masses."""


class _Frame(NamedTuple):
    """What is kept of one frame.

    Attributes:
        number: of the frame, counted from when the history began.
        moment: of the body.
        beside: of what goes along with it, by name.
    """

    number: int
    moment: Moment
    beside: Mapping[str, Any]


class History:
    """A ring of moments, one for each frame in which time passed, and which of them is shown.

    A minute of a body of up to some 500 masses fits. Of larger ones every second moment of the older half is
    given up whenever they take too much: the last frames, which one goes through one by one, stay complete,
    and the minute stays within reach.

    Attributes:
        shown: index of the moment that the page shows.
        runs: counts how often it has begun anew.
    """

    def __init__(self) -> None:
        self.runs = 0
        self.clear()

    def clear(self) -> None:
        """Forget everything."""
        self.runs += 1
        self._frames: list[_Frame] = []
        self._number = 0
        self._bytes = 0
        self.shown = -1

    def __len__(self) -> int:
        return len(self._frames)

    def __getitem__(self, index: int) -> Moment:
        return self._frames[index].moment

    def beside(self, name: str, index: int, span: float) -> list[tuple[float, Any]]:
        """What was beside the body in a moment and in those before it without a gap, with their times, s.

        Args:
            name: what of all that is meant.
            index: of the moment.
            span: s before the moment that they cover at most.
        """
        found: list[tuple[float, Any]] = []
        for frame in reversed(self._frames[: index + 1]):
            if name not in frame.beside or frame.moment.time < self[index].time - span:
                break
            found.append((frame.moment.time, frame.beside[name]))
        return found[::-1]

    def forget(self, name: str) -> None:
        """What was beside the body is no longer the one that it was."""
        self._frames = [
            frame._replace(beside={key: kept for key, kept in frame.beside.items() if key != name})
            for frame in self._frames
        ]
        self._count()

    @property
    def last(self) -> int:
        """Index of the newest moment; -1 if there is none."""
        return len(self._frames) - 1

    @property
    def scrubbed(self) -> bool:
        """Whether another moment than the newest is shown."""
        return self.shown < self.last

    @property
    def start(self) -> float:
        """Time of the oldest moment, s; 0 if there is none."""
        return self._frames[0].moment.time if self._frames else 0.0

    @property
    def end(self) -> float:
        """Time of the newest moment, s; 0 if there is none."""
        return self._frames[-1].moment.time if self._frames else 0.0

    @property
    def bytes(self) -> int:
        """What all of it takes, about."""
        return self._bytes

    def add(self, moment: Moment, beside: Mapping[str, Any] | None = None) -> None:
        """The next frame's moment, and what is beside the body; it is shown.

        What is not before it is dropped.
        """
        frames = self._frames
        while frames and frames[-1].moment.time >= moment.time:
            self._drop_last()
        before = frames[-1] if frames else None
        self._number += 1
        frame = _Frame(self._number, moment, beside or {})
        self._bytes += _size(frame, before)
        frames.append(frame)
        if len(frames) > SPAN or frames[0].number <= self._number - SPAN:
            self._drop_first()
        if self._bytes > MAX_BYTES:
            self._thin()
        self.shown = self.last

    def amend(self, moment: Moment, beside: Mapping[str, Any] | None = None) -> None:
        """The newest moment is this one after all."""
        if self._frames:
            self._drop_last()
        self.add(moment, beside)

    def nearest(self, time: float) -> int:
        """Index of the moment nearest to a time, s; there must be one."""
        at = bisect_left(self._frames, time, key=lambda frame: frame.moment.time)
        if at == 0 or (at <= self.last and self[at].time - time < time - self[at - 1].time):
            return at
        return at - 1

    def back(self, seconds: float) -> int:
        """Index of the moment so many seconds before the one that is shown, and one frame at least."""
        before = max(self.shown - 1, 0)
        return min(before, self.nearest(self[self.shown].time - seconds)) if seconds > 0.0 else before

    def recent(self, seconds: float) -> list[tuple[Moment, Mapping[str, Any]]]:
        """The moments of so many seconds before the one that is shown, and that one, each with what was
        beside the body."""
        if self.shown < 0:
            return []
        # One more, so that all of the seconds are covered.
        first = max(self.nearest(self[self.shown].time - seconds) - 1, 0)
        return [(frame.moment, frame.beside) for frame in self._frames[first : self.shown + 1]]

    def cut(self) -> list[Moment]:
        """Drop what is newer than what is shown, and return it, the moment shown first; or nothing at all."""
        if not self.scrubbed:
            return []
        newer = [frame.moment for frame in self._frames[self.shown :]]
        while self.scrubbed:
            self._drop_last()
        return newer

    def before_runaway(self) -> int:
        """Index of the last moment at which a body that ran away was still sound; there must be one.

        A body that swings is slower again after every fast moment. One that runs away is not: the end of the
        ring at which the kinetic energy only grows is the runaway. Some time before that is a sound moment,
        unless the body was too fast for its size even then.
        """
        moments = [frame.moment for frame in self._frames]
        # Most share a scene; an edit may have added or removed masses.
        scenes = {id(m.scene): m.scene for m in moments}
        masses = {key: np.array([mass.mass for mass in scene.masses]) for key, scene in scenes.items()}
        squares = [float(masses[id(m.scene)] @ (m.rows[2] ** 2 + m.rows[3] ** 2)) for m in moments]
        smooth = [max(squares[max(0, i - _SMOOTH + 1) : i + 1]) for i in range(len(squares))]
        onset = self.last
        while onset > 0 and smooth[onset - 1] < smooth[onset]:
            onset -= 1
        index = self.nearest(moments[onset].time - BEFORE_RUNAWAY)
        # Some have been torn to and fro for long before they run away.
        sizes = [float(np.ptp(m.rows[:2], axis=1).max()) for m in moments[: index + 1]]
        calm = float(masses[id(moments[index].scene)].sum()) * (_CALM * float(np.median(sizes))) ** 2
        return next((i for i in range(index, -1, -1) if squares[i] <= calm), index)

    def _drop_last(self) -> None:
        frame = self._frames.pop()
        self._bytes -= _size(frame, self._frames[-1] if self._frames else None)

    def _drop_first(self) -> None:
        frame = self._frames.pop(0)
        after = self._frames[0]
        # The next one pays for the scene that they share.
        self._bytes -= _size(frame, None) - (_size(after, None) - _size(after, frame))

    def _thin(self) -> None:
        half, frames = len(self._frames) // 2, self._frames
        if half < 2:  # so large a body that hardly one moment of it fits
            if len(frames) > 1:
                self._drop_first()
            return
        keep: list[int] = [0]
        for i in range(1, half):
            if keep[-1] != i - 1 or frames[i + 1].number - frames[keep[-1]].number > _WIDEST:
                keep.append(i)
        if len(keep) == half:
            keep = keep[half // 2 :]  # it is as sparse as it may be
        self._frames[:half] = [frames[i] for i in keep]
        self._count()

    def _count(self) -> None:
        self._bytes = sum(map(_size, self._frames, [None, *self._frames[:-1]]))


class AbandonedFuture:
    """What would have come, had the user not gone back and changed something.

    Args:
        moments: ascending, from where the user went on.

    Attributes:
        start, end: of the time it covers, s.
    """

    def __init__(self, moments: list[Moment]) -> None:
        self._moments = moments
        self.start, self.end = moments[0].time, moments[-1].time

    @classmethod
    def of(cls, moments: list[Moment]) -> AbandonedFuture | None:
        """As far as the body has the same masses; None where that is no time at all."""
        n = len(moments[0].scene.masses)
        same = list(takewhile(lambda moment: len(moment.scene.masses) == n, moments))
        return cls(same) if len(same) > 1 else None

    def positions_at(self, time: float) -> NDArray[np.float64] | None:
        """(n, 2) positions, px, at a time, s, between two moments in a straight line; None outside them."""
        if not self.start <= time <= self.end:
            return None
        at = self._after(time)
        before, after = self._moments[at - 1], self._moments[at]
        share = (time - before.time) / (after.time - before.time)
        return (before.positions + share * (after.positions - before.positions)).copy()

    def damage_at(self, time: float) -> Damage | None:
        """What had yielded and broken by a time, s; None where nothing had, and outside the moments."""
        if not self.start <= time <= self.end:
            return None
        at = self._after(time)
        return self._moments[at if self._moments[at].time <= time else at - 1].damage

    def _after(self, time: float) -> int:
        """Index of the first moment at or after a time, but of one that has another before it."""
        return max(1, bisect_left(self._moments, time, key=lambda moment: moment.time))


def _size(frame: _Frame, before: _Frame | None) -> int:
    """Bytes of a frame, about, but for what it shares with the one before it."""
    moment, scene, damage = frame.moment, frame.moment.scene, frame.moment.damage
    size = moment.rows.nbytes + _OVERHEAD
    if before is None or scene is not before.moment.scene:
        parts = len(scene.masses) + len(scene.linear_springs) + len(scene.angular_springs)
        size += _PER_PART * parts
    if damage is not None and (before is None or damage is not before.moment.damage):
        numbers = damage.broken, damage.set_lengths, damage.hardened, damage.set_angles
        size += _PER_NUMBER * sum(map(len, numbers))
    if moment.grips is not None:
        size += 3 * _PER_NUMBER * (len(moment.grips.walls) + len(moment.grips.springs))
    # What goes along with the body is of the same size.
    return size * (1 + len(frame.beside))
