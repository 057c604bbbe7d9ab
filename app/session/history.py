"""A session's past: its last moments, what leads to all others, and the future that was abandoned."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Callable, Mapping, Sequence
from itertools import takewhile
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from sim import Moment, Scene, Simulation
from sim.scene.types import Damage

from .reel import Development, Reel

SPAN = 3600
"""Frames that are stored: a minute at 60 Hz."""

MAX_BYTES = 20_000_000
"""Bytes of a page's moments, at most, besides those that are computed again; an abandoned future may have as
many."""

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
        number: of the frame, counted from the start of the run.
        moment: of the body.
        companions: states of its companions, by name.
        again: whether it was computed again, since somebody wanted to see it.
    """

    number: int
    moment: Moment
    companions: Mapping[str, Any]
    again: bool = False


class Wanted(NamedTuple):
    """A frame that is not stored, but can be computed again: that of a number, or the one at a time, s."""

    number: int | None
    time: float


class History:
    """Moments, one for each frame in which time passed, and which of them is shown; a reel of all others.

    It stores a minute of a body of up to some 160 masses. For larger ones, every second moment of the older
    half is dropped whenever the memory is full: the last frames, which users step through one by one, stay
    complete, and the minute stays within reach. What is not stored is computed again from the reel, if it has
    it; what it lacks is stored for longer than a minute.

    Attributes:
        reel: what was done in the whole run.
        shown: index of the moment that the page shows.
        runs: counts how often it was cleared.
    """

    def __init__(self) -> None:
        self.runs = 0
        self.reel = Reel()
        self.clear()

    def clear(self) -> None:
        """Forget everything."""
        self.runs += 1
        self.reel.clear()
        self._frames: list[_Frame] = []
        self._kept = 0  # number of the first frames that are stored since the reel lacks them
        self._again = False  # whether frames were computed again
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
        """Time of the oldest moment that can be shown, s; 0 if there is none."""
        return min(self._frames[0].moment.time, self.reel.start) if self._frames else 0.0

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
        self._put(moment, companions)
        frames, number = self._frames, self._frames[-1].number
        kept = min(self._kept, self.last)
        while frames[kept].number <= number - SPAN:
            if self.reel.has(frames[kept].number) and not frames[kept].again:
                self._drop(kept)
            else:
                kept += 1
        self._kept = kept
        if self._bytes > MAX_BYTES:
            self._thin()
        self.shown = self.last

    def amend(self, moment: Moment, companions: Mapping[str, Any] | None = None) -> None:
        """Replace the newest moment; all others keep their indices."""
        if self._frames:
            self._drop_last()
        self._put(moment, companions)

    def _put(self, moment: Moment, companions: Mapping[str, Any] | None) -> None:
        """Store and show a moment; those that are not before it are dropped."""
        frames = self._frames
        number = frames[-1].number + 1 if frames else 0
        if frames and frames[-1].moment.time >= moment.time:  # it is another body's
            while frames and frames[-1].moment.time >= moment.time:
                number = frames[-1].number
                self._drop_last()
            self.reel.cut(number)
        before = frames[-1] if frames else None
        frame = _Frame(number, moment, companions or {})
        self._bytes += _size(frame, before)
        frames.append(frame)
        self.reel.mark(number)
        self.shown = self.last

    def ready(self, simulation: Simulation, complete: bool) -> None:
        """See `Reel.ready`."""
        if self._frames:
            frame = self._frames[self.shown]
            self.reel.ready(simulation, complete, frame.number, frame.moment.time)

    # --------------------------------------------------------------------- frames that are not stored
    def at(self, time: float) -> int | Wanted:
        """The frame nearest to a time, s: its index, or what has to be computed first."""
        index = self.nearest(time)
        frames, there = self._frames, self._frames[index].moment.time
        one, other = (index - 1, index) if time < there else (index, index + 1)
        if time == there or other > self.last:
            return index
        if one < 0:
            return Wanted(None, max(time, self.reel.start)) if self.reel.start < there else index
        stretch = self.reel.at(time)
        lacks = stretch is not None and stretch.last > frames[one].number
        return Wanted(None, time) if lacks and frames[other].number > frames[one].number + 1 else index

    def beside(self, step: int) -> int | Wanted:
        """The frame before the one that is shown (-1), or after it (1), as `at`."""
        number, index = self._frames[self.shown].number + step, self.shown + step
        if not 0 <= index <= self.last:
            return Wanted(number, 0.0) if step < 0 and self.reel.of(number) is not None else self.shown
        if self._frames[index].number != number and self.reel.of(number) is not None:
            return Wanted(number, 0.0)
        return index

    def back(self, seconds: float) -> int | Wanted:
        """The frame some seconds before the one that is shown, by at least one, as `at`."""
        before = self.beside(-1)
        if not seconds > 0.0:
            return before
        found = self.at(self[self.shown].time - seconds)
        if isinstance(found, int) and found >= self.shown:
            return before
        return found

    def development(self, wanted: Wanted, body: Callable[[Scene], Simulation]) -> Development | None:
        """What computes a frame again; None if that cannot be.

        Args:
            wanted: the frame.
            body: makes a body of a scene.
        """
        number, time = wanted
        stretch = self.reel.at(time) if number is None else self.reel.of(number)
        if stretch is None:
            return None
        return Development(self.reel, stretch, body(stretch.start.scene), number, time)

    def take(self, frames: Sequence[tuple[int, Moment]], first: bool) -> None:
        """Store frames that were computed again, with their numbers.

        Args:
            frames: in order of time.
            first: whether those that were taken earlier are to be forgotten, except for the one shown.
        """
        shown = self._frames[self.shown]
        there = {
            frame.number: frame for frame in self._frames if not (first and frame.again) or frame is shown
        }
        for number, moment in frames:
            there.setdefault(number, _Frame(number, moment, {}, True))
        self._again = True
        self._frames = [there[number] for number in sorted(there)]
        self._count()
        self.shown = next(i for i, frame in enumerate(self._frames) if frame.number == shown.number)

    def index_of(self, number: int | None, time: float) -> int:
        """Index of the stored frame nearest to a number, or else (None) to a time, s."""
        if number is None:
            return self.nearest(time)
        at = bisect_left(self._frames, number, key=lambda frame: frame.number)
        return min(at, self.last)

    def forget_again(self) -> None:
        """Forget the frames that were computed again; called while the newest is shown."""
        if self._again:
            self._frames = [frame for frame in self._frames if not frame.again]
            self._again, self.shown = False, self.last
            self._count()

    def nearest(self, time: float) -> int:
        """Index of the moment nearest to a time, s; there must be one."""
        at = bisect_left(self._frames, time, key=lambda frame: frame.moment.time)
        if at == 0 or (at <= self.last and self[at].time - time < time - self[at - 1].time):
            return at
        return at - 1

    def recent(self, seconds: float) -> list[tuple[Moment, Mapping[str, Any]]]:
        """The moments of the last seconds up to the one that is shown, with the companions' states."""
        if self.shown < 0:
            return []
        # One more, so that all of these seconds are covered.
        first = max(self.nearest(self[self.shown].time - seconds) - 1, 0)
        gaps = (i for i in range(self.shown, first, -1) if self._is_gap(i))
        first = next(gaps, first)
        return [(frame.moment, frame.companions) for frame in self._frames[first : self.shown + 1]]

    def cut(self) -> list[Moment]:
        """Drop the moments after the one shown; returns that one and these, or nothing if there are none."""
        if not self.scrubbed:
            self.forget_again()
            return []
        end = next((i for i in range(self.shown + 1, len(self)) if self._is_gap(i)), len(self))
        newer = [frame.moment for frame in self._frames[self.shown : end]]
        while self.scrubbed:
            self._drop_last()
        self._frames = [frame._replace(again=False) for frame in self._frames]
        self._again = False
        self.reel.cut(self._frames[self.shown].number)
        return newer

    def _is_gap(self, index: int) -> bool:
        """Whether more than thinning leaves out was left out before a moment."""
        return self._frames[index].number - self._frames[index - 1].number > _WIDEST + 1

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

    def _drop(self, index: int) -> None:
        """Drop a moment that is not the newest."""
        before = self._frames[index - 1] if index else None
        frame = self._frames.pop(index)
        after = self._frames[index]
        # The next frame now counts the scene that they share.
        self._bytes -= _size(frame, before) - (_size(after, before) - _size(after, frame))

    def _thin(self) -> None:
        half, frames = len(self._frames) // 2, self._frames
        if half < 2:  # hardly one moment of so large a body fits
            if len(frames) > 1:
                self._drop(0)
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
        """Count the memory anew, after frames were taken out or put in."""
        self._kept = 0
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
