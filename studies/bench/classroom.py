"""`softrod bench class`: the cost of a class compared with as many strangers, and what it survives.

The server is a process of its own, as in a school; pupils, the teacher and the wall are pages without a
browser. Random events depend on a seed.
"""

from __future__ import annotations

import asyncio
import contextlib
import os
import random
import statistics
import subprocess
import sys
import tempfile
import time
from contextlib import AbstractAsyncContextManager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import msgspec
from rich.console import Console
from websockets.exceptions import WebSocketException

import sim
from app.classroom import kept
from app.classroom.room import Room, digest
from app.features.classroom import messages as class_messages
from app.wire import from_page
from app.wire.messages import tag_of
from sim.scene.lesson import Lesson, Question, Reading, Step
from sim.store.files import encode_scene

from ..reporting.report import Table
from .pages import Connection, Crowd, Visitor, connected, measure_crowd
from .serving import served, warm
from .tabs import visit_all

CLASSES = (30, 60)
"""Pupils of a class, as many as it has in one room, and as many as it has seats."""

PUPILS = 30
MASSES = 12
"""Of the rope, as many as the bodies of a lesson have, about."""

RESEND_EVERY = 2.0
"""Seconds between two sendings of an unacknowledged answer, as in app/features/classroom/outbox.js."""

FIRST_SENDING = 0.2
"""Seconds from saying who one is to the first sending, as there."""


def a_lesson(masses: int = MASSES) -> sim.Scene:
    """Return the rope of `softrod bench tabs`, with a lesson step that asks for all that a class can give."""
    euler = sim.Integrator(method="symplectic_euler")
    rope = sim.rope(masses, length=300.0, force_law="tutorial", integrator=euler)
    step = Step(
        title="Rope",
        question=Question(text="Where?", choices=("left", "right", "down"), answer=1, because="It is."),
        do="Move it.",
        predict=1.0,
        collect=Reading(quantity=f"mass{masses - 1}.y"),
    )
    # The joints turn all the time, so that every frame is drawn.
    return msgspec.structs.replace(sim.set_value(rope, "rest_angle", 4.0), lesson=Lesson(steps=(step,)))


class Host:
    """A class's server in a process of its own, which can be killed and restarted; a context manager.

    Args:
        scene: with the lesson.
        folder: for the scene, and for what the server stores of the class.
        cache: folder of compiled kernels; None for this user's.

    Attributes:
        port: where it listens, the same after every start.
        code, key: the class's code and its teacher's secret.
    """

    def __init__(self, scene: sim.Scene, folder: Path, cache: str | None = None) -> None:
        self._file = folder / "lesson.json"
        self._file.write_bytes(encode_scene(scene))
        self._data = folder / "data"
        self._environment = {**os.environ, "XDG_DATA_HOME": str(self._data)}
        if cache is not None:
            self._environment["XDG_CACHE_HOME"] = cache
        self.port, self.code, self.key = 0, "", ""

    def __enter__(self) -> Host:
        self.start()
        return self

    def __exit__(self, *_: object) -> None:
        self.stop()

    def start(self) -> None:
        """Start it, and wait until it listens."""
        words = [sys.executable, "-m", "studies.bench.bare", str(self._file), "class", str(self.port)]
        self._process = subprocess.Popen(
            words, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, env=self._environment
        )
        port, self.code, self.key = self._line().split()
        self.port = int(port)

    def used(self) -> float:
        """Return the processor time that it has used so far, s."""
        assert self._process.stdin is not None
        self._process.stdin.write("\n")
        self._process.stdin.flush()
        return float(self._line())

    def kill(self) -> None:
        """Kill it."""
        self._process.kill()
        self._process.communicate()

    def stop(self) -> None:
        """Let it shut down."""
        self._process.terminate()
        self._process.communicate(timeout=60.0)

    def room(self) -> Room:
        """Return the class as it is on the disk."""
        file = self._data / "softrod" / "classes" / self.code / kept.FILE
        return msgspec.json.decode(file.read_bytes(), type=Room)

    def _line(self) -> str:
        assert self._process.stdout is not None
        return self._process.stdout.readline()


def visiting(
    host: Host, name: str, kind: str = "", source: str = "127.0.0.1"
) -> AbstractAsyncContextManager[Connection]:
    """Connect a page of a class.

    Args:
        host: the class's server.
        name: of the page, by which it takes the place of a connection of its own that has died.
        kind: "desk" or "wall"; nothing for a pupil's.
        source: see `connected`.

    Raises:
        OSError, WebSocketException: no server answers, or the gate refuses.
    """
    way = "at" if kind == "desk" else "line"
    return connected(host.port, f"/{way}/{name}?room={host.code}" + (f"&as={kind}" if kind else ""), source)


def a_name(dice: random.Random) -> str:
    """Return a secret, or the name of a page."""
    return f"{dice.getrandbits(128):032x}"


# ------------------------------------------------------------------------- what it costs
async def _look_on(
    host: Host, visitor: Visitor, number: int, leads: asyncio.Event, stop: asyncio.Event
) -> None:
    """Be a pupil, who leads a body in a circle as soon as each one has a body of their own."""
    dice = random.Random(f"pupil {number}")
    # One address gets 40 seats.
    async with visiting(host, a_name(dice), source=f"127.0.0.{1 + number // 30}") as page:

        async def lead() -> None:
            await leads.wait()
            await page.lead(number, stop)

        leading = asyncio.create_task(lead())
        introduced = False
        async for told in page.hear():
            visitor.note(told, page)
            if told["tell"] == "pageState" and not introduced:
                introduced = True
                await page.say(from_page.Who(a_name(dice)))
            if stop.is_set():
                break
        await leading


async def _until(page: Connection, tell: str, wanted: Any, patience: float = 60.0) -> None:
    """Wait until the page has got a message for which `wanted(told)` holds; another task receives it.

    Raises:
        TimeoutError: it did not come.
    """
    deadline = time.monotonic() + patience
    while not (tell in page.told and wanted(page.told[tell])):
        if time.monotonic() > deadline:
            raise TimeoutError(f"the server has not told {tell}")
        await asyncio.sleep(0.02)


async def _hear_all(page: Connection) -> None:
    async for _ in page.hear():
        pass


async def cost(host: Host, pupils: int, own: bool) -> Crowd:
    """Measure a class that moves, as its pupils see it.

    Args:
        host: the class's server.
        pupils: how many.
        own: whether each one has a body of their own; else all follow the teacher's.
    """
    dice = random.Random(f"teacher {own}")
    visitors = [Visitor() for _ in range(pupils)]
    stop, leads = asyncio.Event(), asyncio.Event()
    async with visiting(host, a_name(dice), "desk") as desk, visiting(host, a_name(dice), "wall") as wall:
        tasks = [asyncio.create_task(_hear_all(page)) for page in (desk, wall)]
        await _until(desk, "pageState", lambda _: True)
        await desk.say(from_page.Who(a_name(dice), "", host.key))
        await _until(desk, "desk", lambda _: True)
        await desk.say(class_messages.Stage(0, "show"))
        for number, visitor in enumerate(visitors):
            tasks.append(asyncio.create_task(_look_on(host, visitor, number, leads, stop)))
            await asyncio.sleep(0.1)
        await _until(desk, "desk", lambda told: sum(seat["here"] for seat in told["seats"]) == pupils)
        if own:
            await desk.say(class_messages.Stage(0, "try"))
            await asyncio.sleep(1.0)
            leads.set()
        else:
            await desk.say(from_page.Perform("run"))
            await _until(desk, "pageState", lambda told: told.get("playing"))
            tasks.append(asyncio.create_task(desk.lead(0, stop)))
        crowd = await measure_crowd(visitors, host.used)
        stop.set()
        leads.set()
        desk.cut()
        wall.cut()
        await asyncio.gather(*tasks)
    return crowd


# ------------------------------------------------------------------------- what it survives
@dataclass(frozen=True)
class Storm:
    """What happens to a class.

    Attributes:
        pupils: how many.
        there, away: seconds between a page's coming back and its next cut, and of a cut; each at random
            within a range.
        asked: seconds for which each thing is asked.
        seed: of all that is random.
        masses: of the class's body.
    """

    pupils: int = PUPILS
    there: tuple[float, float] = (3.0, 45.0)
    away: tuple[float, float] = (1.0, 90.0)
    asked: float = 40.0
    seed: int = 1
    masses: int = MASSES


PHASES = (
    ("ask", 0), ("results", 0), ("ask", 1), ("results", 1), ("run", 0), ("reveal", 0), ("explain", 0),
    ("try", 0), ("collect", 0),
)  # fmt: skip
"""Phases and rounds of the class; the server ends in the middle of "explain"."""

Place = tuple[int, int, str]
"""What an answer belongs to: stop, round, and kind of answer."""


def _place(said: class_messages.Give) -> Place:
    return said.stop, said.round, tag_of(type(said).__name__)


class Teacher:
    """A teacher's page, which comes back whenever its connection ends.

    Attributes:
        page: its connection, while it has one.
        since: when each of its connections came about, s of wall time.
        seen: when it first had each answer, by its id.
    """

    def __init__(self, host: Host, dice: random.Random) -> None:
        self._host, self._secret, self._name = host, a_name(dice), a_name(dice)
        self.page: Connection | None = None
        self.since: list[float] = []
        self.seen: dict[str, float] = {}

    async def live(self) -> None:
        """Stay connected until cancelled."""
        while True:
            with contextlib.suppress(OSError, WebSocketException):
                async with visiting(self._host, self._name, "desk") as page:
                    self.page = page
                    self.since.append(time.monotonic())
                    introduced = False
                    async for told in page.hear():
                        if told["tell"] == "pageState" and not introduced:
                            introduced = True
                            await page.say(from_page.Who(self._secret, "", self._host.key))
                        elif told["tell"] == "desk":
                            for answer in told["answers"]:
                                self.seen.setdefault(answer["id"], time.monotonic())
            await asyncio.sleep(0.1)

    async def go(self, phase: Any, round: int) -> None:
        """Lead the class to a phase, and wait until it is there."""
        while True:
            page = self.page
            asking = page.told.get("desk", {}).get("asking", {}) if page is not None else {}
            if (asking.get("phase"), asking.get("round")) == (phase, round):
                return
            if page is not None and asking:
                await page.say(class_messages.Stage(0, phase, round))
            await asyncio.sleep(0.2)


class Pupil:
    """A pupil's page, which is cut, reloaded, and says things twice, as its outbox would.

    Args:
        host: the class's server.
        dice: what is random.
        storm: what happens to it.
        teacher: of the class.

    Attributes:
        secret: of its browser.
        given: all that it gave, by id.
        waiting: what is not acknowledged, in order.
        accepted, refused: ids of what was.
        back: by the id of what waited then, when its page had come back.
        cuts, reloads: how many there were.
        is_over: whether nothing more is to be given.
    """

    def __init__(self, host: Host, dice: random.Random, storm: Storm, teacher: Teacher) -> None:
        self._host, self._dice, self._storm, self._teacher = host, dice, storm, teacher
        self.secret = a_name(dice)
        self._turn = 0
        self._asking: dict[str, Any] = {}
        self.given: dict[str, class_messages.Give] = {}
        self.waiting: list[class_messages.Give] = []
        self.accepted: set[str] = set()
        self.refused: set[str] = set()
        self.back: dict[str, float] = {}
        self.cuts = self.reloads = 0
        self.is_over = False

    async def live(self) -> None:
        """Stay until the class is over and all answers are acknowledged."""
        dice, name = self._dice, a_name(self._dice)
        while not (self.is_over and not self.waiting):
            try:
                async with visiting(self._host, name) as page:
                    await self._visit(page)
            except (OSError, WebSocketException):
                await asyncio.sleep(0.3)
                continue
            if self.is_over:
                continue
            if dice.random() < 0.3:
                self.reloads += 1
                name = a_name(dice)
            else:
                self.cuts += 1
                if dice.random() < 0.5:
                    await self._give(None)
                await asyncio.sleep(dice.uniform(*self._storm.away))

    async def _visit(self, page: Connection) -> None:
        """One connection, from its begin to its cut."""
        now = time.monotonic()
        for said in self.waiting:
            if said.id not in self._teacher.seen:
                self.back[said.id] = now
        acting = asyncio.create_task(self._act(page))
        async for told in page.hear():
            if told["tell"] == "seat" and told["asking"]:
                self._asking = told["asking"]
                self._turn = max(self._turn, told["turn"])
            elif told["tell"] == "taken":
                self._take(told["ids"], bool(told.get("refused")))
            if self.is_over and not self.waiting:
                break
        acting.cancel()
        with contextlib.suppress(asyncio.CancelledError):
            await acting

    async def _act(self, page: Connection) -> None:
        dice = self._dice
        until = time.monotonic() + dice.uniform(*self._storm.there)
        await _until(page, "pageState", lambda _: True)
        await page.say(from_page.Who(self.secret))
        await asyncio.sleep(FIRST_SENDING)
        again = 0.0
        while self.is_over or time.monotonic() < until:
            if time.monotonic() >= again:
                again = time.monotonic() + RESEND_EVERY
                for said in self.waiting:
                    await page.say(said)
            await asyncio.sleep(dice.uniform(0.05, 0.5))
            if not self.is_over and dice.random() < 0.2:
                await self._give(page)
            if self.given and dice.random() < 0.05:
                # Like a message that was delayed.
                await page.say(dice.choice(list(self.given.values())))
        page.cut()

    async def _give(self, page: Connection | None) -> None:
        """Give an answer that the class asks for, as far as the page knows; send it twice now and then."""
        dice, asking, masses = self._dice, self._asking, self._storm.masses
        phase = asking.get("phase")
        kinds = {"ask": ("vote", "places"), "explain": ("line",), "collect": ("work",)}.get(str(phase), ())
        if not kinds:
            return
        self._turn += 1
        head = f"{dice.getrandbits(64):016x}", self._turn, asking["stop"], asking["round"], 0
        match dice.choice(kinds):
            case "vote":
                said = class_messages.GiveVote(*head, dice.randrange(3))
            case "places":
                points = tuple((dice.uniform(-3.0, 3.0), dice.uniform(-3.0, 3.0)) for _ in range(masses))
                said = class_messages.GivePrediction(*head, points)
            case "line":
                said = class_messages.GiveLine(*head, f"Because {self._turn}.")
            case _:
                said = class_messages.GiveWork(*head)
        self.given[said.id] = said
        self.waiting = [old for old in self.waiting if _place(old) != _place(said)] + [said]
        if page is not None:
            for _ in range(2 if dice.random() < 0.2 else 1):
                await page.say(said)

    def _take(self, ids: list[str], refused: bool) -> None:
        self.waiting = [said for said in self.waiting if said.id not in ids]
        if not refused:
            self.accepted.update(ids)
        else:
            self.refused.update(set(ids) - self.accepted)


@dataclass(frozen=True)
class Outcome:
    """What became of the pupils' answers.

    Attributes:
        given: answers that were given.
        replaced: answers that their pupils replaced, before or after they had arrived.
        once: questions whose last accepted answer, and no other, is in the class's file.
        twice: questions with more than one answer in it.
        lost: questions with another answer in it, or none.
        refused: changes that came when the answers had been shown, and were refused with a sentence.
        delays: seconds from a page's coming back, or the teacher's if that was later, until the teacher's
            page had the answer that had waited.
        cuts, reloads: how many there were.
    """

    given: int
    replaced: int
    once: int
    twice: int
    lost: int
    refused: int
    delays: tuple[float, ...]
    cuts: int
    reloads: int


def counted(pupils: list[Pupil], teacher: Teacher, room: Room) -> Outcome:
    """Count what became of the pupils' answers; `room` is the class as it is on the disk."""
    numbers = {seat.token: seat.number for seat in room.seats.values()}
    once = twice = lost = replaced = 0
    for pupil in pupils:
        number = numbers.get(digest(pupil.secret))
        places: dict[Place, list[class_messages.Give]] = {}
        for said in pupil.given.values():
            places.setdefault(_place(said), []).append(said)
        for place, all_said in places.items():
            has = [
                answer.id
                for answer in room.answers.values()
                if answer.seat == number
                and (answer.stop, answer.round, f"give{type(answer.content).__name__}") == place
            ]
            accepted = [said for said in all_said if said.id in pupil.accepted]
            waits = any(said in pupil.waiting for said in all_said)
            replaced += len(all_said) - 1
            # A change that came too late was refused: then the one before it counts, acknowledged or not.
            counts = [said.turn for said in all_said if said.id in has]
            if len(has) > 1:
                twice += 1
            elif counts and all(said.turn <= counts[0] for said in accepted) and not waits:
                once += 1
            else:
                lost += 1
    back = {id: at for pupil in pupils for id, at in pupil.back.items()}
    delays = tuple(
        at - max(back[id], *(begin for begin in teacher.since if begin <= at))
        for id, at in teacher.seen.items()
        if id in back
    )
    return Outcome(
        sum(len(pupil.given) for pupil in pupils),
        replaced,
        once,
        twice,
        lost,
        sum(len(pupil.refused) for pupil in pupils),
        delays,
        sum(pupil.cuts for pupil in pupils),
        sum(pupil.reloads for pupil in pupils),
    )


async def survive(host: Host, storm: Storm) -> Outcome:
    """Hold a class in a storm, and stop its server."""
    dice = random.Random(storm.seed)
    teacher = Teacher(host, random.Random(f"{storm.seed} teacher"))
    pupils = [
        Pupil(host, random.Random(f"{storm.seed} {number}"), storm, teacher) for number in range(storm.pupils)
    ]

    async def wall() -> None:
        name = a_name(dice)
        while True:
            with contextlib.suppress(OSError, WebSocketException):
                async with visiting(host, name, "wall") as page:
                    await _hear_all(page)
            await asyncio.sleep(0.1)

    others = [asyncio.create_task(one) for one in (teacher.live(), wall())]
    lives = [asyncio.create_task(pupil.live()) for pupil in pupils]
    for phase, round in PHASES:
        await teacher.go(phase, round)
        asks = phase in ("ask", "explain", "collect")
        await asyncio.sleep(0.5 * storm.asked if asks else 0.1 * storm.asked)
        if phase == "explain":
            await asyncio.to_thread(dice.choice((host.kill, host.stop)))
            await asyncio.to_thread(host.start)
        await asyncio.sleep(0.5 * storm.asked if asks else 0.0)
    for pupil in pupils:
        pupil.is_over = True
    await asyncio.wait(lives, timeout=2.0 * storm.away[1] + 30.0)
    for task in (*lives, *others):
        task.cancel()
    await asyncio.gather(*lives, *others, return_exceptions=True)
    await asyncio.to_thread(host.stop)
    return counted(pupils, teacher, host.room())


# ------------------------------------------------------------------------- the tables
def bench_class(console: Console, repeats: int) -> None:
    """Measure the cost of a class compared with as many strangers, and what it survives."""
    with tempfile.TemporaryDirectory() as cache:
        warm(cache)
        _bench_cost(console, repeats, cache)
        with tempfile.TemporaryDirectory() as folder, Host(a_lesson(), Path(folder), cache) as host:
            outcome = asyncio.run(survive(host, Storm()))
    _print_outcome(console, outcome)


def _bench_cost(console: Console, repeats: int, cache: str) -> None:
    best: dict[str, Crowd] = {}
    strangers = f"{PUPILS} strangers"
    kinds = [("pupils", count) for count in CLASSES] + [("followers", count) for count in CLASSES]
    for _ in range(repeats):
        with served("softrod", MASSES, cache) as server:
            crowd = asyncio.run(visit_all(server, PUPILS))
        best[strangers] = min(best.get(strangers, crowd), crowd, key=lambda crowd: crowd.share)
        for kind, count in kinds:
            name = f"{count} {kind}"
            with tempfile.TemporaryDirectory() as folder, Host(a_lesson(), Path(folder), cache) as host:
                crowd = asyncio.run(cost(host, count, kind == "pupils"))
            best[name] = min(best.get(name, crowd), crowd, key=lambda crowd: crowd.share)
    rows = []
    for name, crowd in best.items():
        shares = f"{100 * crowd.share:.0f}", f"{crowd.share / best[strangers].share:.2f}"
        rows.append((name, f"{crowd.fewest:.1f}", f"{crowd.clock:.2f}", *shares, f"{crowd.traffic:.0f}"))
    headings = "fewest frames/s", "slowest clock", "server, % of a core", "beside strangers", "kB/s"
    console.print(Table(("pages", *headings), rows))
    console.print(
        f"Strangers and pupils have a rope of {MASSES} masses of their own, followers the teacher's. "
        "The server of a class has the teacher's page and the wall, too."
    )


def _print_outcome(console: Console, outcome: Outcome) -> None:
    console.print(
        f"{outcome.given} answers in {outcome.cuts} cuts and {outcome.reloads} reloads, with one restart of "
        f"the server; {outcome.replaced} were changes of the pupils' own, of which {outcome.refused} came "
        f"too late and were refused. Counted exactly once: {outcome.once}; twice: {outcome.twice}; lost: "
        f"{outcome.lost}."
    )
    if outcome.delays:
        delays = sorted(outcome.delays)
        console.print(
            f"Until the teacher's page had what had waited for the network ({len(delays)}): "
            f"median {statistics.median(delays):.2f} s, 95 % {delays[int(0.95 * len(delays))]:.2f} s, "
            f"most {delays[-1]:.2f} s."
        )
