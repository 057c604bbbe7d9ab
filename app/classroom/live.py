"""The classes of a server while they run: their rooms, who is there, and what is on the disk.

All of it belongs to the ticker's thread, except the writing of files.
"""

from __future__ import annotations

import contextlib
import contextvars
import logging
import secrets
import time
from collections import deque
from collections.abc import Callable, Collection, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal, NamedTuple, ParamSpec, Protocol

import msgspec
import numpy as np
from filelock import BaseFileLock

import sim
from sim.errors import SceneError
from sim.scene.lesson import Lesson, Step
from sim.settings import scene_of_run, scene_of_step

from ..session.framing import Bounds, motion_bounds
from ..session.log import decode_log
from ..stage.plan import Picture
from ..stage.sketch import Floats
from ..words import say
from . import kept, names
from .answers import Answer, Refused, Work
from .judge import Verdict, judge
from .plotted import Plotted
from .room import MAX_STOPS, Room, digest
from .takeaway import pack

if TYPE_CHECKING:
    from ..wire.line import Line

WRITE_EVERY = 0.1
"""Seconds between two writes of a class; all answers given in between are acknowledged together."""

RETRY_AFTER = 2.0
"""Seconds after which a failed write is repeated."""

BODIES_EVERY = 5.0
"""Seconds between two writes of the pupils' bodies."""

MAX_NOTICES = 5
"""Notices for the teacher that wait until a teacher's page is there."""

MAX_CHECKS = 5
"""Devices whose checks the teacher's page lists."""

_log = logging.getLogger(__name__)
_P = ParamSpec("_P")


@dataclass(frozen=True)
class SharedView:
    """What one page shows to all others that look at it; immutable.

    Attributes:
        number: of the plan of what is drawn: another one for every change but motion.
        audience: the pages that have that plan or an earlier one, and are sent the pictures.
        scene: of the body.
        opening: another number for every body that replaced another, on any page.
        rest_angles: (J,) degrees, as the page draws them.
        picture: where the masses are.
        playing: whether the clock runs.
        speed: simulated seconds per second.
    """

    number: int
    audience: set[Line]
    scene: sim.Scene
    opening: int
    rest_angles: Floats
    picture: Picture
    playing: bool
    speed: float


Word = Literal["", "moving", "at rest", "paused", "exploded", "goal reached"]
"""The state of a body, as the teacher reads it; empty while all look at one body."""


@dataclass(frozen=True)
class PupilStatus:
    """What a pupil's body does.

    Attributes:
        word: in a word.
        places: of its masses, thousandths of the scene's frame from its left and upper edge.
        begun: whether anything has been done to it.
    """

    word: Word = ""
    places: tuple[tuple[int, int], ...] = ()
    begun: bool = False

    @property
    def is_untouched(self) -> bool:
        """Whether nothing has happened to it."""
        return not self.begun and self.word != "exploded"


@dataclass(frozen=True)
class DeviceCheck:
    """What a device found out about whether it can take part; see `messages.Checked`."""

    trip: int
    rate: int
    works: bool
    doubts: bool


class Pupil(Protocol):
    """A pupil's page, as the teacher's page uses it."""

    def begin(self) -> None:
        """Start again with the body of the present stop."""

    def show(self, scene: sim.Scene) -> None:
        """Replace the body by this scene's."""


class _Write(NamedTuple):
    """A write under way: the room's version, the logs that go with it, and the logs that it deletes."""

    version: int
    logs: dict[str, bytes]
    gone: set[str]
    future: Future[None]


class Class:
    """A running class.

    Args:
        room: its state.
        bodies: where the pupils' bodies are, if it was resumed.
        lock: keeps other servers from the class; None if nothing does.
        clock: wall time, s.

    Attributes:
        room, lock: as above.
        shared_view: what the teacher's page shows; None until there has been one.
        audience: the pages that look at it.
        teachers: how many pages of teachers there are.
        desk: the teacher's page whose body all look at.
        pupils: the page of each seat, by its number; the last one, where there are several.
        granted: by visitor, the numbers of the seats that this server gave them.
        statuses: what each seat's body does, by its number.
        checks: the last devices that checked whether they can take part.
        wall_feed: what the wall shows of the seat that is on it; None without one.
        base: the address by which pupils come in, if the teacher has chosen one of several networks; else the
            one by which each page was opened.
        plots: of the body that all look at.
        run: the log of the present stop's run, once that has stopped; empty before.
        written: version of the room that is on the disk.
        trouble: why nothing can be stored now, in the system's words; empty while all is stored.
        notices: for the teacher to read once; each says a title and a sentence in the language of the page.
        ended: whether it is over.
    """

    def __init__(
        self,
        room: Room,
        bodies: kept.Bodies | None = None,
        lock: BaseFileLock | None = None,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self.room = room
        self.lock = lock
        self.shared_view: SharedView | None = None
        self.audience: set[Line] = set()
        self.teachers = 0
        self.desk: object | None = None
        self.pupils: dict[int, Pupil] = {}
        self.granted: dict[str, set[int]] = {}
        self.statuses: dict[int, PupilStatus] = {}
        self.checks: deque[DeviceCheck] = deque(maxlen=MAX_CHECKS)
        self.wall_feed: SharedView | None = None
        self.base = ""
        self.plots = Plotted()
        self.run = b""
        self.written = -1
        self.trouble = ""
        self.notices: deque[Callable[[], tuple[str, str]]] = deque(maxlen=MAX_NOTICES)
        self.ended = False
        self._clock = clock
        self._scenes: dict[tuple[int, Callable[[sim.Scene, int], sim.Scene]], sim.Scene] = {}
        # Pupils wait for the writer alone; what takes longer, and what nobody waits for, has its own threads.
        self._writer, self._maker, self._judge = (
            ThreadPoolExecutor(1, thread_name_prefix=f"softrod-{name}-{room.code}")
            for name in ("class", "maker", "judge")
        )
        self._judged: list[tuple[str, Future[Verdict | None]]] = []
        self._write: _Write | None = None
        self._due = 0.0
        self._bounds: dict[int, Future[Bounds]] = {}
        self._logs: dict[str, bytes] = {}  # that were handed in and are not on the disk yet
        self._gone: set[str] = set()  # logs on the disk that the room no longer refers to
        self._bodies: kept.Bodies = bodies or {}
        self._bodies_are_new = False
        self._bodies_due = 0.0
        self._writing_bodies: Future[None] | None = None
        self._ending: Future[None] | None = None

    def scene(self, stop: int) -> sim.Scene:
        """Return the scene of a stop as its step begins, without its lesson: pages have cards of the class's.

        Raises:
            SettingError: the step cannot begin.
        """
        return self._scene(stop, scene_of_step)

    def run_scene(self, stop: int) -> sim.Scene:
        """Return the scene of a stop as its run begins, see `scene`."""
        return self._scene(stop, scene_of_run)

    def _scene(self, stop: int, made_by: Callable[[sim.Scene, int], sim.Scene]) -> sim.Scene:
        if (stop, made_by) not in self._scenes:
            place = self.room.stops[stop]
            scene = self.room.scenes[place.scene]
            scene = scene if place.step is None else made_by(scene, place.step)
            self._scenes[stop, made_by] = msgspec.structs.replace(scene, lesson=None)
        return self._scenes[stop, made_by]

    def choose(self, name: str) -> None:
        """Have the class go through a scene of that name instead, while nothing has begun.

        Raises:
            Refused: the class has begun, or there is no such scene.
        """
        try:
            self.room.choose((sim.load_scene(name),))
        except SceneError as error:
            raise Refused(str(error)) from None
        self._scenes.clear()
        self._bounds.clear()

    def bounds(self, stop: int) -> Bounds | None:
        """Return (2, 2) px, the box around the motion of a stop's body as its step and its run begin.

        None until that is known, which takes a moment in another thread, and where the step cannot begin.
        """
        if stop not in self._bounds:
            self._bounds[stop] = self._judge.submit(self._find_bounds, stop)
        found = self._bounds[stop]
        return found.result() if found.done() and found.exception() is None else None

    def _find_bounds(self, stop: int) -> Bounds:
        one, other = (motion_bounds(scene(stop)) for scene in (self.scene, self.run_scene))
        return np.array((np.minimum(one[0], other[0]), np.maximum(one[1], other[1])))

    def present(self) -> set[int]:
        """Return the numbers of the seats that somebody sits at."""
        seats = self.room.seats
        return {number for number in self.pupils if number in seats and not seats[number].removed}

    def keep_body(self, seat: int, keepsake: bytes) -> None:
        """Store the state of a pupil's body at its stop, for when its page comes back."""
        self._bodies[seat] = self.room.place_of(seat).stop, keepsake
        self._bodies_are_new = True

    def body(self, seat: int) -> bytes | None:
        """Return the keepsake of a pupil's body at its stop."""
        stop, keepsake = self._bodies.get(seat, (-1, b""))
        return keepsake if stop == self.room.place_of(seat).stop else None

    def hand_in(
        self, answer: Answer, log: bytes, step: Step, scene: sim.Scene, been: Collection[str] = ()
    ) -> None:
        """Take what a pupil hands in: the log is written with the class, and judged again by itself.

        Args:
            answer: with what the server saw of the run.
            log: of the run.
            step, scene: that it is of.
            been: see `judge`.

        Raises:
            Refused: see `Room.take`.
        """
        name = f"{answer.id}.jsonl"
        previous = self.room.previous(answer)
        if not self.room.take(answer.seat, _with_work(answer, log=name)):
            return
        self._logs[name] = log
        if previous is not None and isinstance(previous.content, Work):
            self._logs.pop(previous.content.log, None)
            self._gone.add(previous.content.log)

        def verdict() -> Verdict | None:
            is_last = answer.id in self.room.answers
            return judge(decode_log(log, "the log"), scene, step, been) if is_last else None

        self._judged.append((answer.id, self._judge.submit(verdict)))

    def _take_verdicts(self) -> None:
        """Correct what was seen of the runs by what their logs say."""
        for id, future in [one for one in self._judged if one[1].done()]:
            self._judged.remove((id, future))
            if (error := future.exception()) is not None:
                _log.error("a log of the class %s was not judged: %s", self.room.code, error)
                continue
            answer, verdict = self.room.answers.get(id), future.result()
            if answer is None or verdict is None:
                continue
            reached = verdict.reached and not verdict.refused
            judged = _with_work(answer, reached=reached, found=verdict.found, doubt=verdict.refused)
            if judged != answer:
                self.room.answers[id] = judged
                self.room.version += 1

    def pack(self) -> Future[bytes]:
        """Make the zip that the teacher takes home, in a thread: it takes longer than a frame."""
        present = msgspec.json.decode(kept.encode(self.room), type=Room)
        return self._make(pack, present, dict(self._logs))

    def teacher_sheet(self) -> Future[bytes]:
        """Make the present lesson into a sheet to print, in a thread.

        The future fails with an `InputError` where the scene has no lesson.
        """
        return self._make(_sheet, self.room.scenes[self.room.stops[self.room.at].scene])

    def lesson_file(self) -> Future[bytes]:
        """Make the scene of the present stop into a file that works without a server, in a thread.

        The future fails with a `SettingError` where a step of its lesson cannot begin.
        """
        return self._make(_live_file, self.room.scenes[self.room.stops[self.room.at].scene])

    def _make(self, make: Callable[_P, bytes], *given: _P.args, **named: _P.kwargs) -> Future[bytes]:
        """Make a file in a thread, in the language that is spoken now."""
        return self._maker.submit(contextvars.copy_context().run, make, *given, **named)

    def poll_writer(self) -> None:
        """Write what is new, if it is time, and see what has been written: only that is acknowledged."""
        if self.ended:
            return  # what was under way is cancelled
        if self.room.is_home and not self.room.told and time.time() >= (self.room.until or 0.0):
            self.room.tell()
        self._take_verdicts()
        self._take_written()
        self._take_end()
        if self.ended or self._ending is not None:
            return
        now, code = self._clock(), self.room.code
        if self._bodies_are_new and now >= self._bodies_due and self._writing_bodies is None:
            self._bodies_are_new, self._bodies_due = False, now + BODIES_EVERY
            seats = self.room.seats
            here = (number for number in self._bodies if number in seats and not seats[number].removed)
            self._bodies = {number: self._bodies[number] for number in here}
            self._writing_bodies = self._maker.submit(kept.write_bodies, self._bodies.copy(), code)
        if self._write is None and self.written != self.room.version and now >= self._due:
            self._due = now + WRITE_EVERY
            logs, gone = self._logs.copy(), self._gone.copy()
            future = self._writer.submit(kept.write, kept.encode(self.room), code, logs, gone)
            self._write = _Write(self.room.version, logs, gone, future)

    def _take_written(self) -> None:
        """Take the results of writes that are done."""
        bodies = self._writing_bodies
        if bodies is not None and bodies.done():
            self._writing_bodies = None
            # As the server ends it may have been cancelled, for another file was being made.
            error = None if bodies.cancelled() else bodies.exception()
            if error is not None and not self.trouble:
                # No answer is lost: a body starts again.
                _log.warning("the bodies of the class %s were not stored: %s", self.room.code, error)
        if self._write is None or not self._write.future.done():
            return
        write, self._write = self._write, None
        if (error := write.future.exception()) is None:
            self.written = write.version
            self._logs = {name: log for name, log in self._logs.items() if name not in write.logs}
            self._gone -= write.gone
        else:
            self._due = self._clock() + RETRY_AFTER
        self._report(error)

    def _report(self, error: BaseException | None) -> None:
        """Tell the teacher and the server's log once that nothing can be stored, and once that all is."""
        trouble = "" if error is None else reason_of(error)
        if trouble == self.trouble:
            return
        self.trouble = trouble
        if trouble:
            _log.error("the class %s cannot be written: %s", self.room.code, error)
            self.notices.append(
                lambda: (say("desk-unkept-title"), say("desk-unkept", reason=trouble)),
            )
        else:
            _log.error("the class %s is being written again", self.room.code)
            self.notices.append(lambda: (say("desk-kept-title"), say("desk-kept")))

    def close(self) -> None:
        """Write what is new, and wait for it; the server is shutting down."""
        self._judge.shutdown(wait=False, cancel_futures=True)
        self._maker.shutdown(wait=True, cancel_futures=True)
        self._writer.shutdown(wait=True)
        self._take_written()
        self._take_end()
        if self.ended:
            return
        try:
            kept.write(kept.encode(self.room), self.room.code, self._logs, self._gone)
            kept.write_bodies(self._bodies, self.room.code)
        except OSError as error:
            _log.error("the last of the class %s was not kept: %s", self.room.code, error)
        kept.release(self.lock)

    def end(self) -> None:
        """Begin to end the class: all that anybody gave is deleted, here and on the disk.

        `poll_writer` completes it. If anything cannot be deleted, the class goes on, and the teacher
        is told.
        """
        if self._ending is None and not self.ended:
            self._ending = self._writer.submit(kept.forget, self.room.code)

    def _take_end(self) -> None:
        """Complete the end of the class, once its folder is deleted."""
        if self._ending is None or not self._ending.done():
            return
        error, self._ending = self._ending.exception(), None
        if error is not None:
            self.written = -1  # some of it may be gone
            _log.error("the class %s cannot be ended: %s", self.room.code, error)
            folder, reason = str(kept.folder_of(self.room.code)), reason_of(error)
            self.notices.append(
                lambda: (say("desk-goes-on-title"), say("desk-goes-on", folder=folder, reason=reason)),
            )
            return
        self.ended = True
        for executor in (self._judge, self._maker, self._writer):
            executor.shutdown(wait=False, cancel_futures=True)
        kept.remove_lock(self.lock)
        for stored in (self.room.seats, self.room.answers, self._bodies, self._logs):
            stored.clear()
        self.room.version += 1


def reason_of(error: BaseException) -> str:
    """Return why something could not be written, as in "No space left on device"."""
    return (error.strerror if isinstance(error, OSError) else None) or str(error) or type(error).__name__


def _with_work(answer: Answer, **changes: object) -> Answer:
    """Return an answer whose run has other values; one that is no run as it is."""
    if not isinstance(answer.content, Work):
        return answer
    return msgspec.structs.replace(answer, content=msgspec.structs.replace(answer.content, **changes))


def _live_file(scene: sim.Scene) -> bytes:
    from ..export.live.live import live_html

    return live_html(sim.Simulation(scene).capture())[0]


def _sheet(scene: sim.Scene) -> bytes:
    from ..export.teacher_sheet import sheet_html

    return sheet_html(scene)


DEFAULT_SCENE = "lesson-hooke"
"""The scene of a class for which none is named."""

MAX_CLASSES = 20
"""Running classes of a server."""


class Classes:
    """The classes of one server, by their codes.

    Args:
        alone: whether the server is for classes alone: anybody else is asked which one they come to.
    """

    def __init__(self, alone: bool = True) -> None:
        self.alone = alone
        self._classes: dict[str, Class] = {}

    def __iter__(self) -> Iterator[Class]:
        self._classes = {code: one for code, one in self._classes.items() if not one.ended}
        return iter(list(self._classes.values()))

    def begin(self, scenes: Sequence[sim.Scene], until: float = 0.0) -> Class:
        """Begin a class with these scenes, or homework until a time, s since 1970.

        Raises:
            Refused: they have too many steps, or there are too many classes.
        """
        taken = {one.room.code for one in self}
        if len(taken) >= MAX_CLASSES:
            raise Refused(say("class-refuse-classes", most=MAX_CLASSES))
        room = Room(code="", key=secrets.token_urlsafe(16), scenes=tuple(scenes))
        if until:
            # Nobody is there to see who sits where, so they say who they are.
            room.until, room.own_names = until, True
        if len(room.stops) > MAX_STOPS:
            raise Refused(say("class-refuse-scenes", most=MAX_STOPS, steps=len(room.stops)))
        while True:
            room.code = names.new_code(taken)
            with contextlib.suppress(kept.Held):
                lock = kept.hold(room.code)
                if not kept.folder_of(room.code).exists():
                    return self._add(Class(room, lock=lock))
                kept.release(lock)
            taken.add(room.code)

    def resume(
        self, scenes: Sequence[sim.Scene] | None, count: int, new: bool = False, until: float = 0.0
    ) -> None:
        """Resume the classes on the disk, and begin those that are missing.

        Args:
            scenes: their scenes; None for whatever they have.
            count: how many there are to be at least.
            until: begins homework until then, s since 1970; 0 for classes. Homework that is resumed gets the
                new time.
            new: whether to delete those on the disk instead, except for those that another server runs.

        Raises:
            Refused: a class on the disk has other scenes, another server runs it, or one cannot be begun.
            OSError: a class cannot be deleted.
        """
        kept.sweep()
        for code in kept.codes():
            lock, is_free = None, True
            try:
                lock = kept.hold(code)
            except kept.Held:
                is_free = False
            room = kept.read(code)
            if room is None or (new and not is_free):
                kept.release(lock)
            elif new:
                kept.forget(code)
                kept.remove_lock(lock)
            elif scenes is None or room.scenes == tuple(scenes):
                if not is_free:
                    raise Refused(
                        f"Another softrod on this computer goes on with class {code}: end that one first, or "
                        "begin another class by --new."
                    )
                if until and not room.is_home:
                    kept.release(lock)
                    raise Refused(f"Class {code} is no homework: end it first, or forget it by --new.")
                if until:
                    room.until, room.told = until, msgspec.UNSET
                self._add(Class(room, kept.read_bodies(code), lock))
            elif is_free:
                kept.release(lock)
                raise Refused(
                    f"Class {code}, which has other scenes, has not been ended: go on with it without naming "
                    "scenes, or forget it by --new."
                )
        more = scenes or next((one.room.scenes for one in self), None) or (sim.load_scene(DEFAULT_SCENE),)
        for _ in range(count - len(list(self))):
            self.begin(more, until)

    def teach(self, lesson: Lesson) -> bool:
        """Whether one of the running classes goes through a lesson."""
        return any(scene.lesson == lesson for one in self for scene in one.room.scenes)

    def find(self, code: str) -> Class | None:
        """Return the running class with that code."""
        found = self._classes.get(code)
        return None if found is None or found.ended else found

    def close(self) -> None:
        """Write everything; the server is shutting down."""
        for one in self:
            one.close()

    def _add(self, made: Class) -> Class:
        self._classes[made.room.code] = made
        return made


def is_key(room: Room, key: str) -> bool:
    """Whether a text is the teacher's secret of a class."""
    return secrets.compare_digest(digest(key), digest(room.key))
