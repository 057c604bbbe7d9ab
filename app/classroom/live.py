"""The classes of a server while they go on: their rooms, who is there, and what is on the disk.

All of it is the ticker's, but for the writing of files.
"""

from __future__ import annotations

import contextlib
import logging
import secrets
import time
from collections import deque
from collections.abc import Callable, Collection, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal, Protocol

import msgspec
from filelock import BaseFileLock

import sim
from sim.scene.lesson import Lesson, Step
from sim.settings import scene_of_step

from ..session.log import decode_log
from ..stage.plan import Picture
from ..stage.sketch import Floats
from . import kept, names
from .judge import Verdict, judge
from .room import MAX_STOPS, Answer, Refused, Room, Work, digest
from .takeaway import pack

if TYPE_CHECKING:
    import viser

WRITE_EVERY = 0.1
"""Seconds between two writings of a class; what was given in between is acknowledged together."""

AGAIN_AFTER = 2.0
"""Seconds until a writing that failed is tried again."""

BODIES_EVERY = 5.0
"""Seconds between two writings of where the pupils' bodies are."""

MAX_TOLD = 5
"""Sentences for the teacher that wait until a teacher's page is there."""

MAX_TRIED = 5
"""Devices that tried whether they can take part, of which the teacher is told."""

_log = logging.getLogger(__name__)


@dataclass(frozen=True)
class Front:
    """What the teacher's page shows, for all who look at it: none of it changes any more.

    Attributes:
        number: of the plan of what is drawn: another one for everything that changed but the motion.
        audience: the pages that have that plan or an earlier one, and are sent the pictures.
        scene: of the body.
        opening: another number for every body that took the place of another, on whatever page.
        rest_angles: (J,) degrees, as the page draws them.
        picture: where the masses are.
        playing: whether the clock runs.
        speed: simulated seconds per second.
    """

    number: int
    audience: set[viser.ClientHandle]
    scene: sim.Scene
    opening: int
    rest_angles: Floats
    picture: Picture
    playing: bool
    speed: float


Word = Literal["", "moving", "at rest", "paused", "exploded", "goal reached"]
"""What a body does, as the teacher reads it; nothing while all look at one body."""


@dataclass(frozen=True)
class Doing:
    """What a pupil's body does.

    Attributes:
        word: in a word.
        places: of its masses, thousandths of the scene's frame from its left and upper edge.
        begun: whether anything has been done to it.
    """

    word: Word = ""
    places: tuple[tuple[int, int], ...] = ()
    begun: bool = False


@dataclass(frozen=True)
class Tried:
    """What a device found that tried whether it can take part; see `app.wire.from_page.Checked`."""

    trip: int
    rate: int
    works: bool
    doubts: bool


class Pupil(Protocol):
    """A pupil's page, as the teacher's can turn to it."""

    def begin(self) -> None:
        """Begin anew with the body of the present stop."""

    def show(self, scene: sim.Scene) -> None:
        """Have this scene instead."""


class Class:
    """A class that goes on.

    Args:
        room: its state.
        bodies: where the pupils' bodies are, if it goes on.
        lock: what keeps other servers from the class, if anything does.
        clock: wall time, s.

    Attributes:
        room, lock: as above.
        front: what the teacher's page shows; None until there was one.
        audience: the pages that look at it.
        teachers: how many pages of teachers there are.
        desk: the teacher's page whose body all look at.
        pupils: the page that each seat has, by its number; the last one, where there are several.
        given: by visitor, the numbers of the seats that were given to them by this server.
        doing: what each seat's body does.
        tried: what the last devices found that tried whether they can take part.
        lent: what the wall shows of the seat that is on it; None without one.
        run: the log of the present stop's run, once that has stood; empty before.
        written: version of the room that is on the disk.
        trouble: why nothing can be kept now, in the system's words; empty while all is kept.
        told: what the teacher has to be told once: a title and a sentence each.
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
        self._bodies: kept.Bodies = bodies or {}
        self._bodies_are_new = False
        self._bodies_due = 0.0
        self.front: Front | None = None
        self.audience: set[viser.ClientHandle] = set()
        self.teachers = 0
        self.desk: object | None = None
        self.pupils: dict[int, Pupil] = {}
        self.given: dict[str, set[int]] = {}
        self.doing: dict[int, Doing] = {}
        self.tried: deque[Tried] = deque(maxlen=MAX_TRIED)
        self.lent: Front | None = None
        self.run = b""
        self._judged: list[tuple[str, Future[Verdict | None]]] = []
        self.ended = False
        self._clock = clock
        self._scenes: dict[int, sim.Scene] = {}
        # What answers wait for has a thread of its own; so has what takes longer, and what nobody waits for.
        self._writer = ThreadPoolExecutor(1, thread_name_prefix=f"softrod-class-{room.code}")
        self._maker = ThreadPoolExecutor(1, thread_name_prefix=f"softrod-maker-{room.code}")
        self._judge = ThreadPoolExecutor(1, thread_name_prefix=f"softrod-judge-{room.code}")
        self._writing: _Writing | None = None
        self._writing_bodies: Future[None] | None = None
        self._ending: Future[None] | None = None
        self._logs: dict[str, bytes] = {}  # that were handed in and are not on the disk yet
        self._gone: set[str] = set()  # logs on the disk that the room speaks of no more
        self._due = 0.0
        self.written = -1
        self.trouble = ""
        self.told: deque[tuple[str, str]] = deque(maxlen=MAX_TOLD)

    def scene(self, stop: int) -> sim.Scene:
        """The scene of a stop, as its step begins.

        Raises:
            SettingError: the step cannot begin.
        """
        if stop not in self._scenes:
            place = self.room.stops[stop]
            scene = self.room.scenes[place.scene]
            self._scenes[stop] = scene if place.step is None else scene_of_step(scene, place.step)
        return self._scenes[stop]

    def keep(self, seat: int, body: bytes) -> None:
        """Keep what a pupil's body does at the present stop, a keepsake, for when its page comes back."""
        self._bodies[seat] = self.room.at, body
        self._bodies_are_new = True

    def body(self, seat: int) -> bytes | None:
        """What was kept of a pupil's body at the present stop."""
        stop, keepsake = self._bodies.get(seat, (-1, b""))
        return keepsake if stop == self.room.at else None

    def hand_in(
        self, answer: Answer, log: bytes, step: Step, scene: sim.Scene, been: Collection[str] = ()
    ) -> None:
        """Take what a pupil hands in: the log is written with the class, and judged once more by itself.

        Args:
            answer: with what the server saw of the run.
            log: of the run.
            step, scene: that it is of.
            been: see `judge`.

        Raises:
            Refused: see `Room.take`.
        """
        name = f"{answer.id}.jsonl"
        content = answer.content
        if isinstance(content, Work):
            answer = msgspec.structs.replace(answer, content=msgspec.structs.replace(content, log=name))
        before = self.room.before(answer)
        if not self.room.take(answer.seat, answer):
            return
        self._logs[name] = log
        if before is not None and isinstance(before.content, Work):
            self._logs.pop(before.content.log, None)
            self._gone.add(before.content.log)

        def look() -> Verdict | None:
            is_last = answer.id in self.room.answers
            return judge(decode_log(log, "the log"), scene, step, been) if is_last else None

        self._judged.append((answer.id, self._judge.submit(look)))

    def _take_verdicts(self) -> None:
        """What the logs say goes before what was seen of the runs."""
        for id, future in [one for one in self._judged if one[1].done()]:
            self._judged.remove((id, future))
            answer = self.room.answers.get(id)
            if (error := future.exception()) is not None:
                _log.error("a log of the class %s was not judged: %s", self.room.code, error)
            elif (
                answer is not None
                and isinstance(answer.content, Work)
                and (verdict := future.result()) is not None
            ):
                content = msgspec.structs.replace(
                    answer.content,
                    reached=verdict.reached and not verdict.refused,
                    found=verdict.found,
                    doubt=verdict.refused,
                )
                if content != answer.content:
                    self.room.answers[id] = msgspec.structs.replace(answer, content=content)
                    self.room.version += 1

    def pack(self) -> Future[bytes]:
        """Have made what the teacher takes home: it takes longer than other pages can wait for."""
        present = msgspec.json.decode(kept.encode(self.room), type=Room)
        return self._maker.submit(pack, present, dict(self._logs))

    def lesson_file(self) -> Future[bytes]:
        """Have the scene of the present stop made into a file that lives without a server.

        The future fails with a `SettingError` where a step of its lesson cannot begin.
        """
        scene = self.room.scenes[self.room.stops[self.room.at].scene]
        return self._maker.submit(_live_file, scene)

    def tend(self) -> None:
        """Have written what is new, if it is time; whatever is acknowledged is on the disk before."""
        self._take_verdicts()
        self._take_written()
        self._take_end()
        if self.ended or self._ending is not None:
            return
        now = self._clock()
        if self._bodies_are_new and now >= self._bodies_due and self._writing_bodies is None:
            self._bodies_are_new, self._bodies_due = False, now + BODIES_EVERY
            seats = self.room.seats
            here = (number for number in self._bodies if number in seats and not seats[number].removed)
            self._bodies = {number: self._bodies[number] for number in here}
            self._writing_bodies = self._maker.submit(kept.write_bodies, self._bodies.copy(), self.room.code)
        if self._writing is not None or self.written == self.room.version or now < self._due:
            return
        self._due = now + WRITE_EVERY
        logs, gone = self._logs.copy(), self._gone.copy()
        future = self._writer.submit(kept.write, kept.encode(self.room), self.room.code, logs, gone)
        self._writing = _Writing(self.room.version, logs, gone, future)

    def _take_written(self) -> None:
        """See what has become of what was being written."""
        if self._writing_bodies is not None and self._writing_bodies.done():
            error, self._writing_bodies = self._writing_bodies.exception(), None
            if error is not None and not self.trouble:
                # Nothing that anybody gave: a body begins anew.
                _log.warning("where the bodies of the class %s are was not kept: %s", self.room.code, error)
        if self._writing is None or not self._writing.future.done():
            return
        writing, self._writing = self._writing, None
        error = writing.future.exception()
        if error is None:
            self.written = writing.version
            self._logs = {name: log for name, log in self._logs.items() if name not in writing.logs}
            self._gone -= writing.gone
        else:
            self._due = self._clock() + AGAIN_AFTER
        self._tell_trouble(error)

    def _tell_trouble(self, error: BaseException | None) -> None:
        """Tell the teacher, and the server's log, once that nothing can be kept, and once that all is."""
        trouble = "" if error is None else why(error)
        if trouble == self.trouble:
            return
        self.trouble = trouble
        if trouble:
            _log.error("the class %s cannot be written: %s", self.room.code, error)
            self.told.append(
                (
                    "The class is not being kept",
                    f"{trouble}. What pupils give now waits on their pages, and is gone if those are closed. "
                    "Make room on the disk of the computer that holds the class, or take the zip home now.",
                )
            )
        else:
            _log.error("the class %s is being written again", self.room.code)
            self.told.append(("The class is being kept again", "All that was given is on the disk."))

    def close(self) -> None:
        """Write what is new, and wait for it; the server ends."""
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
        """Have the class ended: nothing that anybody gave is kept, here or on the disk.

        `tend` sees to it. Where something of it cannot be taken from the disk, the class goes on, and the
        teacher is told.
        """
        if self._ending is None and not self.ended:
            self._ending = self._writer.submit(kept.forget, self.room.code)

    def _take_end(self) -> None:
        """See what has become of the end."""
        if self._ending is None or not self._ending.done():
            return
        error, self._ending = self._ending.exception(), None
        if error is not None:
            self.written = -1  # some of it may be gone
            _log.error("the class %s cannot be ended: %s", self.room.code, error)
            folder = kept.folder_of(self.room.code)
            self.told.append(("The class goes on", f"Its folder {folder} cannot be deleted: {why(error)}."))
            return
        self.ended = True
        for executor in (self._judge, self._maker, self._writer):
            executor.shutdown(wait=False, cancel_futures=True)
        kept.remove_lock(self.lock)
        self.room.seats.clear()
        self.room.answers.clear()
        self._bodies.clear()
        self._logs.clear()
        self.room.version += 1


@dataclass(frozen=True)
class _Writing:
    """What is being written of a class: its version, the logs that go with it, and those that go away."""

    version: int
    logs: dict[str, bytes]
    gone: set[str]
    future: Future[None]


def why(error: BaseException) -> str:
    """Why something could not be written, as in "No space left on device"."""
    return (error.strerror if isinstance(error, OSError) else None) or str(error) or type(error).__name__


def _live_file(scene: sim.Scene) -> bytes:
    from ..export.live.live import live_html

    return live_html(sim.Simulation(scene).capture())[0]


FIRST = "lesson-hooke"
"""What a class goes through for which no scene is named."""

MAX_CLASSES = 20
"""Classes that go on at once on a server."""


class Classes:
    """The classes of one server, by their codes.

    Args:
        alone: whether the server is for classes alone: whoever else comes is asked to which one.
    """

    def __init__(self, alone: bool = True) -> None:
        self.alone = alone
        self._classes: dict[str, Class] = {}

    def __iter__(self) -> Iterator[Class]:
        self._classes = {code: one for code, one in self._classes.items() if not one.ended}
        return iter(list(self._classes.values()))

    def begin(self, scenes: Sequence[sim.Scene]) -> Class:
        """Begin a class with these scenes.

        Raises:
            Refused: they have too many steps, or there are too many classes.
        """
        taken = {one.room.code for one in self}
        if len(taken) >= MAX_CLASSES:
            raise Refused(f"A server holds {MAX_CLASSES} classes at most.")
        room = Room(code="", key=secrets.token_urlsafe(16), scenes=tuple(scenes))
        if len(room.stops) > MAX_STOPS:
            raise Refused(f"A class has {MAX_STOPS} steps at most; these scenes have {len(room.stops)}.")
        while True:
            room.code = names.new_code(taken)
            with contextlib.suppress(kept.Held):
                lock = kept.hold(room.code)
                if not kept.folder_of(room.code).exists():
                    return self._add(Class(room, lock=lock))
                kept.release(lock)
            taken.add(room.code)

    def take_up(self, scenes: Sequence[sim.Scene] | None, count: int, new: bool = False) -> None:
        """Go on with the classes on the disk, and begin those that are missing.

        Args:
            scenes: that they go through; None for whatever they have.
            count: how many there are to be at least.
            new: whether to forget those on the disk instead, but for what another server goes on with.

        Raises:
            Refused: a class on the disk has other scenes, another server goes on with it, or one cannot be
                begun.
            OSError: a class cannot be forgotten.
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
            elif scenes is None or room.begun_with == tuple(scenes):
                if not is_free:
                    raise Refused(
                        f"Another softrod on this computer goes on with class {code}: end that one first, or "
                        "begin another class by --new."
                    )
                self._add(Class(room, kept.read_bodies(code), lock))
            elif is_free:
                kept.release(lock)
                raise Refused(
                    f"Class {code}, which has other scenes, has not been ended: go on with it without naming "
                    "scenes, or forget it by --new."
                )
        more = scenes or next((one.room.begun_with for one in self), None) or (sim.load_scene(FIRST),)
        for _ in range(count - len(list(self))):
            self.begin(more)

    def go_through(self, lesson: Lesson) -> bool:
        """Whether one of the classes that go on goes through a lesson."""
        return any(scene.lesson == lesson for one in self for scene in one.room.scenes)

    def find(self, code: str) -> Class | None:
        """The class with that code, if it goes on."""
        found = self._classes.get(code)
        return None if found is None or found.ended else found

    def close(self) -> None:
        """Have everything written; the server ends."""
        for one in self:
            one.close()

    def _add(self, made: Class) -> Class:
        self._classes[made.room.code] = made
        return made


def is_key(room: Room, key: str) -> bool:
    """Whether somebody has the teacher's secret of a class."""
    return secrets.compare_digest(digest(key), digest(room.key))
