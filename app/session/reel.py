"""The whole run, to be computed again: what was done, and checkpoints from which it is done once more.

Between two checkpoints is a *stretch*. Frames are counted from the start of the run; a frame of a stretch is
computed again, to the last bit, by resuming its checkpoint and doing what was done until then.
"""

from __future__ import annotations

import math
import zlib
from bisect import bisect_right
from collections.abc import Iterator
from time import perf_counter

import sim
from sim import Moment
from sim.motion.checkpoint import Checkpoint
from sim.store.files import encode_fields

from . import log
from .pacing import smoothed

MAX_BYTES = 52_000_000
"""Bytes of a page's reel, at most."""

STRETCH = 0.05
"""Seconds of computing after which a checkpoint is made, at least: to go to a frame takes half of it."""

LONGEST = 0.8
"""Seconds of computing of a stretch, at most, also where memory is scarce. Frames that would need more are
forgotten."""

WORTH = 50.0
"""Seconds of computing for each second that goes into checkpoints, at least."""

_PACKED = 1000
"""Lines that are compressed together."""

_OVERHEAD = 3000
"""Estimated bytes of a stretch besides its lines and the numbers of its checkpoint."""

_PER_PART = 250
"""Estimated bytes of a mass or spring of a scene, which stretches share until it changes."""

_PER_MOMENT = 400
"""Estimated bytes of a moment besides its numbers."""

BEFORE, AFTER = 150, 600
"""Frames before and after a wanted one that are stored with it, at most: to step on, and to compare."""

AGAIN_BYTES = 4_000_000
"""Bytes of these frames, at most."""

_PER_LINE = 41
"""Bytes of a line besides its text, until it is compressed."""

_MARK = b""
"""The line at the end of a frame."""


class Stretch:
    """What was done between two checkpoints.

    Args:
        start: the checkpoint.
        number: of the frame at which it was made.
        goes_on: whether the body comes there by what was done in the stretch before.
        shares: whether that one has the same scene.

    Attributes:
        start, goes_on: as above.
        first, last: numbers of the frames that it begins and ends with.
        seconds: computing time.
    """

    def __init__(self, start: Checkpoint, number: int, goes_on: bool, shares: bool) -> None:
        self.start, self.goes_on = start, goes_on
        self.first = self.last = number
        self.seconds = 0.0
        scene = start.scene
        parts = len(scene.masses) + len(scene.linear_springs) + len(scene.angular_springs)
        self._own = _OVERHEAD + start.nbytes + (0 if shares else _PER_PART * parts)
        self._packed: list[bytes] = []
        self._lines: list[bytes] = []
        self._open = 0  # bytes of the lines

    @property
    def bytes(self) -> int:
        """Estimated memory."""
        return self._own + self._open + self.packed_bytes

    @property
    def packed_bytes(self) -> int:
        """Bytes of its compressed lines."""
        return sum(map(len, self._packed))

    @property
    def has_frames(self) -> bool:
        """Whether time has passed in it."""
        return self.last > self.first

    def add(self, line: bytes) -> None:
        """Add a line: an entry, or a mark."""
        self._lines.append(line)
        self._open += len(line) + _PER_LINE
        if len(self._lines) >= _PACKED:
            self.pack()

    def pack(self) -> None:
        """Compress all lines."""
        if self._lines:
            self._packed.append(zlib.compress(b"\n".join(self._lines), 1))
            self._lines, self._open = [], 0

    def lines(self) -> Iterator[bytes]:
        """All lines so far."""
        packed, rest = tuple(self._packed), tuple(self._lines)
        for each in packed:
            yield from zlib.decompress(each).split(b"\n")
        yield from rest

    def may_take_in(self, after: Stretch) -> bool:
        """Whether the next stretch can become a part of it."""
        both = self.seconds + after.seconds
        return after.goes_on and after.first == self.last and both <= LONGEST

    def take_in(self, after: Stretch) -> None:
        """Make the next stretch a part of it; its checkpoint is forgotten."""
        self.pack()
        after.pack()
        self._packed += after._packed
        self.last, self.seconds = after.last, self.seconds + after.seconds


class Reel:
    """The stretches of a run, in order of time.

    A stretch is open while things are done. It ends with the next checkpoint, where the body is taken
    elsewhere, and where how it goes on depends on the compiler; frames from there until the next checkpoint
    cannot be computed again. Where memory is scarce, old checkpoints are forgotten as long as no stretch
    becomes longer than `LONGEST`, and then the oldest stretches.
    """

    def __init__(self) -> None:
        self.clear()

    def clear(self) -> None:
        """Forget everything."""
        self._closed: list[Stretch] = []
        self._closed_bytes = 0
        self._open: Stretch | None = None
        self._at_mark = False
        self._last_line = _MARK
        self._cost = 0.0  # of a checkpoint, s

    @property
    def stretches(self) -> list[Stretch]:
        """All that have frames."""
        there = self._open
        return [*self._closed, there] if there is not None and there.has_frames else self._closed

    @property
    def bytes(self) -> int:
        """Estimated memory."""
        return self._closed_bytes + (self._open.bytes if self._open is not None else 0)

    @property
    def start(self) -> float:
        """Time, s, of the first frame that can be computed again; infinite if there is none."""
        stretches = self.stretches
        return stretches[0].start.time if stretches else math.inf

    def at(self, time: float) -> Stretch | None:
        """The last stretch that begins at a time, s, or before; None if there is none."""
        found = bisect_right(self.stretches, time, key=lambda stretch: stretch.start.time)
        return self.stretches[found - 1] if found else None

    def of(self, number: int) -> Stretch | None:
        """The stretch that has the frame of a number; None if that cannot be computed again.

        Of two, it is the one that begins with the frame, since there the body may have been taken elsewhere.
        """
        stretches = self.stretches
        found = bisect_right(stretches, number, key=lambda stretch: stretch.first)
        return stretches[found - 1] if found and number <= stretches[found - 1].last else None

    def has(self, number: int) -> bool:
        """Whether the frame of a number can be computed again."""
        there = self._open
        if there is not None and there.first <= number <= there.last:
            return True
        return self.of(number) is not None

    # --------------------------------------------------------------------- while things are done
    def ready(self, simulation: sim.Simulation, complete: bool, number: int, time: float) -> None:
        """Make a checkpoint if there is to be one; called before anything is done.

        Args:
            simulation: the body.
            complete: whether how it goes on does not depend on the compiler.
            number, time: of the frame that is shown, and its time, s.
        """
        if not complete or simulation.divergence is not None:
            self.close()
            return
        there = self._open
        if there is not None:
            enough = min(max(STRETCH, WORTH * self._cost), 0.5 * LONGEST)
            if there.seconds < enough or not (self._at_mark and there.has_frames):
                return
        if simulation.time != time:
            return  # in the middle of a frame
        self.close()
        began = perf_counter()
        start = simulation.checkpoint()
        self._cost = smoothed(self._cost, perf_counter() - began)
        shares = bool(self._closed) and self._closed[-1].start.scene is start.scene
        self._open = Stretch(start, number, there is not None, shares)
        self._at_mark, self._last_line = True, _MARK

    def note(self, entry: log.Entry) -> None:
        """Note what was done."""
        if self._open is None or isinstance(entry, log.FollowEnergy):  # which changes no motion
            return
        line = encode_fields(entry)
        if line != self._last_line or not isinstance(entry, log.Move):  # of a hand at rest, while time stands
            self._open.add(line)
        self._at_mark, self._last_line = False, line

    def mark(self, number: int) -> None:
        """Note the end of the frame of a number; it may replace the one before."""
        if self._open is not None:
            self._open.add(_MARK)
            self._open.last = number
            self._at_mark, self._last_line = True, _MARK

    def spend(self, seconds: float) -> None:
        """Note computing time."""
        if self._open is not None:
            self._open.seconds += seconds

    def close(self) -> None:
        """End the open stretch: the body is taken elsewhere."""
        there, self._open = self._open, None
        if there is not None and there.has_frames:
            there.pack()
            self._closed.append(there)
            self._closed_bytes += there.bytes
            if self._closed_bytes > MAX_BYTES:
                self._thin()

    def cut(self, number: int) -> None:
        """Forget the frames after that of a number."""
        if self._open is not None and self._open.has_frames:
            self.close()
        while self._closed and self._closed[-1].first >= number:
            self._closed_bytes -= self._closed.pop().bytes
        if self._closed:
            self._closed[-1].last = min(self._closed[-1].last, number)

    def _thin(self) -> None:
        """Forget old checkpoints, or else the oldest stretches, until a tenth of the memory is free."""
        kept, enough = self._closed, int(0.9 * MAX_BYTES)
        at, merged = 0, True
        while self._closed_bytes > enough and merged:
            at, merged = 0, False
            while self._closed_bytes > enough and at + 1 < len(kept) - len(kept) // 4:
                one, next_ = kept[at], kept[at + 1]
                if one.may_take_in(next_):
                    before = one.bytes + next_.bytes
                    one.take_in(next_)
                    del kept[at + 1]
                    self._closed_bytes += one.bytes - before
                    merged = True
                at += 1
        gone = 0
        while self._closed_bytes > enough and gone + 1 < len(kept):
            self._closed_bytes -= kept[gone].bytes
            gone += 1
        del kept[:gone]


class Development:
    """Computes frames again, in slices of time.

    Args:
        reel: what was done.
        stretch: with which it begins.
        simulation: a body of its own.
        number: of the wanted frame; None for the one at a time.
        time: s; used without a number.

    Attributes:
        frames: all that are to be kept, so far, with their numbers: from some before the wanted one on.
        is_found: whether the wanted frame is among them.
        has_ended: whether there is nothing left to do.
    """

    def __init__(
        self,
        reel: Reel,
        stretch: Stretch,
        simulation: sim.Simulation,
        number: int | None = None,
        time: float = 0.0,
    ) -> None:
        self._reel, self._simulation = reel, simulation
        self.number, self.time = number, time
        self.frames: list[tuple[int, Moment]] = []
        self.is_found = self.has_ended = False
        self._after = 0
        self._spent = 0.0  # seconds of computing since it was found
        share = AGAIN_BYTES / (BEFORE + AFTER) / (32 * len(stretch.start.scene.masses) + _PER_MOMENT)
        self._most_before, self._most_after = (
            max(1, int(most * min(share, 1.0))) for most in (BEFORE, AFTER)
        )
        self._work = self._do(stretch)

    def advance(self, budget: float) -> None:
        """Go on for some seconds of computing."""
        end = perf_counter() + budget
        if self.is_found:
            self._spent += budget
            if self._spent > LONGEST:
                self.has_ended = True
                return
        for _ in self._work:
            if perf_counter() >= end:
                return
        self.is_found = self.has_ended = True

    def _do(self, stretch: Stretch) -> Iterator[None]:
        """Do the stretches from one on; stops after each entry."""
        simulation, there = self._simulation, stretch
        while True:
            simulation.resume(there.start)
            number, time = there.first, simulation.time
            self._take(number)
            yield
            for line in there.lines():
                if line:
                    entry = log.decode_entry(line)
                    if isinstance(entry, log.Step):
                        simulation.step(entry.n, entry.attempts)
                    elif isinstance(entry, log.Act):
                        entry.do(simulation)
                else:
                    if simulation.time > time:
                        number, time = number + 1, simulation.time
                    self._take(number)
                    if number >= there.last or self._after > self._most_after:
                        break
                yield
            next_ = self._reel.of(number)
            if self._after > self._most_after or next_ is None or next_ is there or next_.first != number:
                return
            there = next_

    def _take(self, number: int) -> None:
        """Take the present frame."""
        moment, frames = self._simulation.capture(), self.frames
        if frames and frames[-1][0] == number:
            frames.pop()
        frames.append((number, moment))
        passed = moment.time > self.time if self.number is None else number > self.number
        if passed:
            self.is_found = True
            self._after += 1
        elif len(frames) > self._most_before:
            del frames[0]
