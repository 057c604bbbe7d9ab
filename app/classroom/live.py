"""The classes of a server while they go on: their rooms, who is there, and what is on the disk.

All of it is the ticker's, but for the writing of files.
"""

from __future__ import annotations

import logging
import secrets
import time
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal, Protocol

import msgspec

import sim
from sim.scene.lesson import Step
from sim.settings import scene_of_step
from sim.store.files import write_atomically

from ..drawing.plan import Picture
from ..drawing.sketch import Floats
from ..session.log import decode_log
from . import kept, names
from .judge import Verdict, judge
from .room import MOST_STOPS, Answer, Refused, Room, Work, digest
from .takeaway import log_path, pack

if TYPE_CHECKING:
    import viser

WRITE_EVERY = 0.1
"""Seconds between two writings of a class; what was given in between is acknowledged together."""

BODIES_EVERY = 5.0
"""Seconds between two writings of where the pupils' bodies are."""

MOST_TRIED = 5
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
        clock: wall time, s.

    Attributes:
        room: as above.
        front: what the teacher's page shows; None until there was one.
        audience: the pages that look at it.
        teachers: how many pages of teachers there are.
        desk: the teacher's page whose body all look at.
        pupils: the page that each seat has, by its number; the last one, where there are several.
        doing: what each seat's body does.
        tried: what the last devices found that tried whether they can take part.
        lent: what the wall shows of the seat that is on it; None without one.
        run: the log of the present stop's run, once that has stood; empty before.
        written: version of the room that is on the disk.
        ended: whether it is over.
    """

    def __init__(
        self, room: Room, bodies: kept.Bodies | None = None, clock: Callable[[], float] = time.monotonic
    ) -> None:
        self.room = room
        self._bodies: kept.Bodies = bodies or {}
        self._bodies_are_new = False
        self._bodies_due = 0.0
        self.front: Front | None = None
        self.audience: set[viser.ClientHandle] = set()
        self.teachers = 0
        self.desk: object | None = None
        self.pupils: dict[int, Pupil] = {}
        self.doing: dict[int, Doing] = {}
        self.tried: deque[Tried] = deque(maxlen=MOST_TRIED)
        self.lent: Front | None = None
        self.run = b""
        self._judged: list[tuple[str, Future[Verdict | None]]] = []
        self.ended = False
        self._clock = clock
        self._scenes: dict[int, sim.Scene] = {}
        self._writer = ThreadPoolExecutor(1, thread_name_prefix=f"softrod-class-{room.code}")
        self._judge = ThreadPoolExecutor(1, thread_name_prefix=f"softrod-judge-{room.code}")
        self._writing: tuple[int, Future[None]] | None = None
        self._due = 0.0
        self.written = -1

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

    def keep(self, seat: int, keepsake: bytes) -> None:
        """Keep what a pupil's body does at the present stop, for when its page comes back."""
        self._bodies[seat] = self.room.at, keepsake
        self._bodies_are_new = True

    def body(self, seat: int) -> bytes | None:
        """What was kept of a pupil's body at the present stop."""
        stop, keepsake = self._bodies.get(seat, (-1, b""))
        return keepsake if stop == self.room.at else None

    def hand_in(self, answer: Answer, log: bytes, step: Step, scene: sim.Scene) -> None:
        """Take what a pupil hands in: the log is written, and judged once more by itself.

        Args:
            answer: with what the server saw of the run.
            log: of the run.
            step, scene: that it is of.

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
        # Before the class's file, which says that it is there; nothing waits until it is judged.
        written = self._writer.submit(_keep_log, self.room.code, name, log)
        if before is not None and isinstance(before.content, Work):
            self._writer.submit(log_path(self.room.code, before.content.log).unlink, missing_ok=True)

        def look() -> Verdict | None:
            written.result()
            is_last = answer.id in self.room.answers
            return judge(decode_log(log, "the log"), scene, step) if is_last else None

        self._judged.append((answer.id, self._judge.submit(look)))

    def _take_verdicts(self) -> None:
        """What the logs say goes before what was seen of the runs."""
        for id, future in [one for one in self._judged if one[1].done()]:
            self._judged.remove((id, future))
            answer = self.room.answers.get(id)
            if (error := future.exception()) is not None:
                _log.error("a log of the class %s was not kept: %s", self.room.code, error)
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
        return self._writer.submit(pack, present)

    def lesson_file(self) -> Future[bytes]:
        """Have the scene of the present stop made into a file that lives without a server.

        The future fails with a `SettingError` where a step of its lesson cannot begin.
        """
        scene = self.room.scenes[self.room.stops[self.room.at].scene]
        return self._writer.submit(_live_file, scene)

    def tend(self) -> None:
        """Have written what is new, if it is time; whatever is acknowledged is on the disk before."""
        self._take_verdicts()
        if self._writing is not None:
            version, future = self._writing
            if not future.done():
                return
            self._writing = None
            if (error := future.exception()) is None:
                self.written = version
            else:
                _log.error("the class %s cannot be written: %s", self.room.code, error)
        now = self._clock()
        if self._bodies_are_new and now >= self._bodies_due and not self.ended:
            self._bodies_are_new, self._bodies_due = False, now + BODIES_EVERY
            self._writer.submit(kept.write_bodies, dict(self._bodies), self.room.code)
        if self.ended or self.written == self.room.version or now < self._due:
            return
        self._due = now + WRITE_EVERY
        data, version = kept.encode(self.room), self.room.version
        self._writing = version, self._writer.submit(kept.write, data, self.room.code)

    def close(self) -> None:
        """Write what is new, and wait for it; the server ends."""
        self._judge.shutdown(wait=False, cancel_futures=True)
        self._writer.shutdown(wait=True)
        if not self.ended:
            kept.write(kept.encode(self.room), self.room.code)
            kept.write_bodies(self._bodies, self.room.code)

    def end(self) -> None:
        """End the class: nothing that anybody gave is kept, here or on the disk.

        Raises:
            OSError: something of it is still on the disk; the class goes on.
        """
        self._judge.shutdown(wait=False, cancel_futures=True)
        self._writer.shutdown(wait=True)
        kept.forget(self.room.code)
        self.ended = True
        self.room.seats.clear()
        self.room.answers.clear()
        self._bodies.clear()
        self.room.version += 1


def _live_file(scene: sim.Scene) -> bytes:
    from ..export.live.live import live_html

    return live_html(sim.Simulation(scene).capture())[0]


def _keep_log(code: str, name: str, data: bytes) -> None:
    """Write a log that was handed in."""
    path = log_path(code, name)
    path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
    write_atomically(path, data)


MOST_CLASSES = 20
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
        return iter(list(self._classes.values()))

    def begin(self, scenes: Sequence[sim.Scene]) -> Class:
        """Begin a class with these scenes.

        Raises:
            Refused: they have too many steps, or there are too many classes.
        """
        if sum(not klass.ended for klass in self) >= MOST_CLASSES:
            raise Refused(f"A server holds {MOST_CLASSES} classes at most.")
        code = names.new_code(self._classes)
        room = Room(code=code, key=secrets.token_urlsafe(16), scenes=tuple(scenes))
        if len(room.stops) > MOST_STOPS:
            raise Refused(f"A class has {MOST_STOPS} steps at most; these scenes have {len(room.stops)}.")
        return self._add(room)

    def go_on(self) -> list[Class]:
        """Go on with the classes on the disk that have not been ended."""
        rooms = [room for room in kept.read_all() if room.code not in self._classes]
        return [self._add(room, kept.read_bodies(room.code)) for room in rooms]

    def find(self, code: str) -> Class | None:
        """The class with that code, if it goes on."""
        found = self._classes.get(code)
        return None if found is None or found.ended else found

    def close(self) -> None:
        """Have everything written; the server ends."""
        for one in self._classes.values():
            one.close()

    def _add(self, room: Room, bodies: kept.Bodies | None = None) -> Class:
        self._classes[room.code] = made = Class(room, bodies)
        return made


def is_key(room: Room, key: str) -> bool:
    """Whether somebody has the teacher's secret of a class."""
    return secrets.compare_digest(digest(key), digest(room.key))
