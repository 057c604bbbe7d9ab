"""A session's past moments, to go back to, and the future that was abandoned by doing so."""

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
"""Frames that are stored: a minute at 60 Hz."""

MAX_BYTES = 64_000_000
"""Bytes of all moments of a page, at most."""

_OVERHEAD = 400
"""Estimated bytes of a moment besides its numbers."""

_PER_PART = 250
"""Estimated bytes of a mass or spring of a scene, which moments share until a slider moves."""

_PER_NUMBER = 32
"""Bytes of a number of the damage, which moments share until it changes."""

BEFORE_RUNAWAY = 0.5
"""Simulated seconds before the start of a runaway to which a user is taken."""

_SMOOTH = 5
"""Frames over which the kinetic energy's maximum is taken: springs that flip to and fro have pauses."""

_WIDEST = 120
"""Frames between two old moments, at most."""

_CALM = 2.0
"""Root mean square speed of a sound body, at most, in sizes of the body per second."""


class _Frame(NamedTuple):
    """One stored frame.

    Attributes:
        number: of the frame, counted from the start of the history.
        moment: of the body.
        companions: states of its companions, by name.
    """

    number: int
    moment: Moment
    companions: Mapping[str, Any]


class History:
    """A ring of moments, one for each frame in which time passed, and which of them is shown.

    It holds a minute of a body of up to some 500 masses. For larger ones, every second moment of the older
    half is dropped whenever the memory is full: the last frames, which users step through one by one, stay
    complete, and the minute stays within reach.

    Attributes:
        shown: index of the moment that the page shows.
        runs: counts how often it was cleared.
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

    def past_of(self, name: str, index: int, span: float) -> list[tuple[float, Any]]:
        """A companion's states at a moment and without a gap before it, with their times, s.

        Args:
            name: of the companion.
            index: of the moment.
            span: s before the moment that they cover at most.
        """
        found: list[tuple[float, Any]] = []
        for frame in reversed(self._frames[: index + 1]):
            if name not in frame.companions or frame.moment.time < self[index].time - span:
                break
            found.append((frame.moment.time, frame.companions[name]))
        return found[::-1]

    def forget(self, name: str) -> None:
        """Forget the states of a companion, which was removed or replaced."""
        self._frames = [
            frame._replace(companions={key: kept for key, kept in frame.companions.items() if key != name})
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
        """Estimated memory of all of it."""
        return self._bytes

    def add(self, moment: Moment, companions: Mapping[str, Any] | None = None) -> None:
        """Store and show the moment of the next frame; moments that are not before it are dropped."""
        frames = self._frames
        while frames and frames[-1].moment.time >= moment.time:
            self._drop_last()
        before = frames[-1] if frames else None
        self._number += 1
        frame = _Frame(self._number, moment, companions or {})
        self._bytes += _size(frame, before)
        frames.append(frame)
        if len(frames) > SPAN or frames[0].number <= self._number - SPAN:
            self._drop_first()
        if self._bytes > MAX_BYTES:
            self._thin()
        self.shown = self.last

    def amend(self, moment: Moment, companions: Mapping[str, Any] | None = None) -> None:
        """Replace the newest moment."""
        if self._frames:
            self._drop_last()
        self.add(moment, companions)

    def nearest(self, time: float) -> int:
        """Index of the moment nearest to a time, s; there must be one."""
        at = bisect_left(self._frames, time, key=lambda frame: frame.moment.time)
        if at == 0 or (at <= self.last and self[at].time - time < time - self[at - 1].time):
            return at
        return at - 1

    def back(self, seconds: float) -> int:
        """Index of the moment some seconds before the one that is shown, by at least one frame."""
        before = max(self.shown - 1, 0)
        return min(before, self.nearest(self[self.shown].time - seconds)) if seconds > 0.0 else before

    def recent(self, seconds: float) -> list[tuple[Moment, Mapping[str, Any]]]:
        """The moments of the last seconds up to the one that is shown, with the companions' states."""
        if self.shown < 0:
            return []
        # One more, so that all of these seconds are covered.
        first = max(self.nearest(self[self.shown].time - seconds) - 1, 0)
        return [(frame.moment, frame.companions) for frame in self._frames[first : self.shown + 1]]

    def cut(self) -> list[Moment]:
        """Drop the moments after the one shown; returns that one and these, or nothing if there are none."""
        if not self.scrubbed:
            return []
        newer = [frame.moment for frame in self._frames[self.shown :]]
        while self.scrubbed:
            self._drop_last()
        return newer

    def before_runaway(self) -> int:
        """Index of the last moment at which a body that ran away was still sound; there must be one.

        A swinging body slows down after every fast moment, one that runs away does not: the runaway is the
        end of the ring over which the kinetic energy only grows. A moment `BEFORE_RUNAWAY` is sound, unless
        the body was too fast for its size even then; in that case it is the last one that was not.
        """
        moments = [frame.moment for frame in self._frames]
        # Most moments share a scene, but an edit may have added or removed masses.
        scenes = {id(m.scene): m.scene for m in moments}
        masses = {key: np.array([mass.mass for mass in scene.masses]) for key, scene in scenes.items()}
        squares = [float(masses[id(m.scene)] @ (m.rows[2] ** 2 + m.rows[3] ** 2)) for m in moments]
        smooth = [max(squares[max(0, i - _SMOOTH + 1) : i + 1]) for i in range(len(squares))]
        onset = self.last
        while onset > 0 and smooth[onset - 1] < smooth[onset]:
            onset -= 1
        index = self.nearest(moments[onset].time - BEFORE_RUNAWAY)
        # A body may have been torn to and fro for a long time before it ran away.
        sizes = [float(np.ptp(m.rows[:2], axis=1).max()) for m in moments[: index + 1]]
        calm = float(masses[id(moments[index].scene)].sum()) * (_CALM * float(np.median(sizes))) ** 2
        return next((i for i in range(index, -1, -1) if squares[i] <= calm), index)

    def _drop_last(self) -> None:
        frame = self._frames.pop()
        self._bytes -= _size(frame, self._frames[-1] if self._frames else None)

    def _drop_first(self) -> None:
        frame = self._frames.pop(0)
        after = self._frames[0]
        # The next frame now counts the scene that they share.
        self._bytes -= _size(frame, None) - (_size(after, None) - _size(after, frame))

    def _thin(self) -> None:
        half, frames = len(self._frames) // 2, self._frames
        if half < 2:  # hardly one moment of so large a body fits
            if len(frames) > 1:
                self._drop_first()
            return
        keep: list[int] = [0]
        for i in range(1, half):
            if keep[-1] != i - 1 or frames[i + 1].number - frames[keep[-1]].number > _WIDEST:
                keep.append(i)
        if len(keep) == half:
            keep = keep[half // 2 :]  # it is as sparse as allowed
        self._frames[:half] = [frames[i] for i in keep]
        self._count()

    def _count(self) -> None:
        self._bytes = sum(map(_size, self._frames, [None, *self._frames[:-1]]))


class AbandonedFuture:
    """The moments that followed before the user went back and changed something.

    Args:
        moments: in order, from where the user continued.

    Attributes:
        start, end: of the time that they cover, s.
    """

    def __init__(self, moments: list[Moment]) -> None:
        self._moments = moments
        self.start, self.end = moments[0].time, moments[-1].time

    @classmethod
    def of(cls, moments: list[Moment]) -> AbandonedFuture | None:
        """The future as far as the body has the same masses; None if that is no time at all."""
        n = len(moments[0].scene.masses)
        same = list(takewhile(lambda moment: len(moment.scene.masses) == n, moments))
        return cls(same) if len(same) > 1 else None

    def positions_at(self, time: float) -> NDArray[np.float64] | None:
        """(n, 2) positions, px, at a time, s, interpolated linearly; None outside the moments."""
        if not self.start <= time <= self.end:
            return None
        at = self._after(time)
        before, after = self._moments[at - 1], self._moments[at]
        share = (time - before.time) / (after.time - before.time)
        return (before.positions + share * (after.positions - before.positions)).copy()

    def damage_at(self, time: float) -> Damage | None:
        """The damage at a time, s; None if there was none, and outside the moments."""
        if not self.start <= time <= self.end:
            return None
        at = self._after(time)
        return self._moments[at if self._moments[at].time <= time else at - 1].damage

    def _after(self, time: float) -> int:
        """Index of the first moment at or after a time, at least 1."""
        return max(1, bisect_left(self._moments, time, key=lambda moment: moment.time))


def _size(frame: _Frame, before: _Frame | None) -> int:
    """Estimated bytes of a frame, without what it shares with the one before it."""
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
    # Companions are about as large as the body.
    return size * (1 + len(frame.companions))
