"""`softrod bench class`: what a class costs beside as many strangers, and what it survives.

The server is a process of its own, as in a school; pupils, the teacher and the wall are pages without a
browser. What is random goes by a seed.
"""

from __future__ import annotations

import asyncio
import contextlib
import math
import os
import random
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import AsyncIterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import msgspec
from rich.console import Console
from rich.table import Table
from websockets.asyncio.client import ClientConnection, connect
from websockets.exceptions import WebSocketException

import sim
from app.classroom import kept
from app.classroom.room import Room, digest
from app.wire import from_page
from app.wire.messages import tag_of
from sim.scene.lesson import Lesson, Question, Reading, Step
from sim.store.files import encode_scene

from .client import CAMERA, FRAME_TIME, Decoder, is_frame, options_of, saying
from .serving import served, warm
from .tabs import SETTLE, SPAN, STEER_EVERY, Visitor, visit_all

PUPILS = 30
MASSES = 12
"""Of the rope, as many as the bodies of a lesson have, about."""

AGAIN_EVERY, AFTER_WHO = 2.0, 0.2
"""Seconds between two sayings of what is not acknowledged, and from saying who one is to the first: as in
app/features/classroom/outbox.js."""


def a_lesson(masses: int = MASSES) -> sim.Scene:
    """A rope as that of `softrod bench tabs`, with a step that asks for all that a class can be asked."""
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
    """A class's server in a process of its own, which can be killed and started anew; a context manager.

    Args:
        scene: what the class goes through.
        folder: for the scene, and for what the server keeps of the class.
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
        """Processor time that it has used so far, s."""
        assert self._process.stdin is not None
        self._process.stdin.write("\n")
        self._process.stdin.flush()
        return float(self._line())

    def kill(self) -> None:
        """Have it end without a word."""
        self._process.kill()
        self._process.communicate()

    def stop(self) -> None:
        """Have it end as it does when it is told to."""
        self._process.terminate()
        self._process.communicate(timeout=60.0)

    def room(self) -> Room:
        """The class as it is on the disk."""
        file = self._data / "softrod" / "classes" / self.code / kept.FILE
        return msgspec.json.decode(file.read_bytes(), type=Room)

    def _line(self) -> str:
        assert self._process.stdout is not None
        return self._process.stdout.readline()


class Talk:
    """One connection of one page of a class.

    Attributes:
        told: the last of each kind that it was told, by its tag.
        bytes: received.
    """

    def __init__(self, connection: ClientConnection) -> None:
        self._connection, self._decoder = connection, Decoder()
        self.told: dict[str, dict[str, Any]] = {}
        self.bytes = 0

    async def say(self, message: from_page.FromPage) -> None:
        """Say something, if the page is there to be heard."""
        with contextlib.suppress(WebSocketException):
            await self._connection.send(self._decoder.encode(saying(message)))

    async def hear(self) -> AsyncIterator[dict[str, Any]]:
        """What the page is told until the connection ends: frames, and messages by their tags."""
        try:
            async for data in self._connection:
                assert isinstance(data, bytes)
                self.bytes += len(data)
                for message in self._decoder.decode(data):
                    if is_frame(message):
                        yield {"tell": "frame", "time": float(message["numbers"][FRAME_TIME])}
                    elif message.get("type") == "SoftrodMessage":
                        told = msgspec.json.decode(message["text"])
                        self.told[told["tell"]] = told
                        yield told
        except WebSocketException:
            return

    def cut(self) -> None:
        """Cut the connection, of which the other end is not told in words."""
        self._connection.transport.abort()


@contextlib.asynccontextmanager
async def talking(host: Host, name: str, kind: str = "") -> AsyncIterator[Talk]:
    """A page's connection.

    Args:
        host: the class's server.
        name: of the page, by which it takes the place of a connection of its own that has died.
        kind: "desk" or "wall"; nothing for a pupil's.

    Raises:
        OSError, WebSocketException: there is nobody, or the gate refuses.
    """
    address = f"127.0.0.1:{host.port}"
    path = f"/at/{name}?room={host.code}" + (f"&as={kind}" if kind else "")
    async with connect(f"ws://{address}{path}", **options_of(address)) as connection:
        talk = Talk(connection)
        await connection.send(talk._decoder.encode(CAMERA))
        yield talk


def a_name(dice: random.Random) -> str:
    """A secret, or the name of a page."""
    return f"{dice.getrandbits(128):032x}"


# ------------------------------------------------------------------------- what it costs
async def _look_on(
    host: Host, visitor: Visitor, number: int, leads: asyncio.Event, stop: asyncio.Event
) -> None:
    """Be a pupil who leads a body in a circle once each one has their own, and notes what comes."""
    dice = random.Random(f"pupil {number}")
    async with talking(host, a_name(dice)) as talk:

        async def lead() -> None:
            await leads.wait()
            await _lead(talk, number, stop)

        leading = asyncio.create_task(lead())
        introduced = False
        async for told in talk.hear():
            visitor.bytes, talk.bytes = visitor.bytes + talk.bytes, 0
            if told["tell"] == "frame":
                visitor.arrivals.append(time.monotonic())
                visitor.times.append(told["time"])
            elif told["tell"] == "pageState" and not introduced:
                introduced = True
                await talk.say(from_page.Who(a_name(dice)))
            if stop.is_set():
                break
        await leading


async def _lead(talk: Talk, number: int, stop: asyncio.Event) -> None:
    """Lead the driven mass in a circle, as the pages of `tabs` do."""
    await talk.say(from_page.Perform("follow"))
    while not stop.is_set():
        angle = 2.0 * time.monotonic() + number
        await talk.say(from_page.At(((0, 0.6 * math.cos(angle), 1.0 + 0.6 * math.sin(angle)),)))
        await asyncio.sleep(STEER_EVERY)


async def _until(talk: Talk, tell: str, wanted: Any, patience: float = 60.0) -> None:
    """Wait until the page has been told something for which `wanted(told)` holds; somebody else hears it.

    Raises:
        TimeoutError: it was not.
    """
    deadline = time.monotonic() + patience
    while not (tell in talk.told and wanted(talk.told[tell])):
        if time.monotonic() > deadline:
            raise TimeoutError(f"the server has not told {tell}")
        await asyncio.sleep(0.02)


async def _hear_all(talk: Talk) -> None:
    async for _ in talk.hear():
        pass


async def cost(host: Host, pupils: int, own: bool) -> tuple[list[Visitor], float, float, float]:
    """A class that moves: its pupils as visitors, the span that was measured, the server's share of a core.

    Args:
        host: the class's server.
        pupils: how many.
        own: whether each one has a body of their own; else all follow the teacher's.
    """
    dice = random.Random(f"teacher {own}")
    visitors = [Visitor() for _ in range(pupils)]
    stop, leads = asyncio.Event(), asyncio.Event()
    async with talking(host, a_name(dice), "desk") as desk, talking(host, a_name(dice), "wall") as wall:
        tasks = [asyncio.create_task(_hear_all(desk)), asyncio.create_task(_hear_all(wall))]
        await _until(desk, "pageState", lambda _: True)
        await desk.say(from_page.Who(a_name(dice), "", host.key))
        await _until(desk, "desk", lambda _: True)
        await desk.say(from_page.Stage(0, "show"))
        for number, visitor in enumerate(visitors):
            tasks.append(asyncio.create_task(_look_on(host, visitor, number, leads, stop)))
            await asyncio.sleep(0.1)
        await _until(desk, "desk", lambda told: sum(seat["here"] for seat in told["seats"]) == pupils)
        if own:
            await desk.say(from_page.Stage(0, "try"))
            await asyncio.sleep(1.0)
            leads.set()
        else:
            await desk.say(from_page.Perform("run"))
            await _until(desk, "pageState", lambda told: told.get("playing"))
            tasks.append(asyncio.create_task(_lead(desk, 0, stop)))
        await asyncio.sleep(SETTLE)
        for visitor in visitors:
            visitor.bytes = 0
        begin, before = time.monotonic(), host.used()
        await asyncio.sleep(SPAN)
        end, after = time.monotonic(), host.used()
        stop.set()
        leads.set()
        desk.cut()
        wall.cut()
        await asyncio.gather(*tasks)
    return visitors, begin, end, (after - before) / (end - begin)


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


PLAN = (
    ("ask", 0), ("results", 0), ("run", 0), ("explain", 0), ("ask", 1), ("results", 1), ("try", 0),
    ("collect", 0),
)  # fmt: skip
"""Where the class goes; the server ends in the middle of "explain"."""

Place = tuple[int, int, str]
"""What an answer is to: stop, round, and what is said."""


def _place(said: from_page.Give) -> Place:
    return said.stop, said.round, tag_of(type(said).__name__)


class Teacher:
    """A teacher's page, which comes back whenever its connection ends.

    Attributes:
        talk: its connection, while it has one.
        since: when each of its connections came about, s of wall time.
        seen: when it first had each answer, by its id.
    """

    def __init__(self, host: Host, dice: random.Random) -> None:
        self._host, self._secret, self._name = host, a_name(dice), a_name(dice)
        self.talk: Talk | None = None
        self.since: list[float] = []
        self.seen: dict[str, float] = {}

    async def live(self) -> None:
        """Be there until cancelled."""
        while True:
            with contextlib.suppress(OSError, WebSocketException):
                async with talking(self._host, self._name, "desk") as talk:
                    self.talk = talk
                    self.since.append(time.monotonic())
                    introduced = False
                    async for told in talk.hear():
                        if told["tell"] == "pageState" and not introduced:
                            introduced = True
                            await talk.say(from_page.Who(self._secret, "", self._host.key))
                        elif told["tell"] == "desk":
                            for answer in told["answers"]:
                                self.seen.setdefault(answer["id"], time.monotonic())
            await asyncio.sleep(0.1)

    async def go(self, phase: Any, round: int) -> None:
        """Take the class somewhere, and wait until it is there."""
        while True:
            talk = self.talk
            asking = talk.told.get("desk", {}).get("asking", {}) if talk is not None else {}
            if (asking.get("phase"), asking.get("round")) == (phase, round):
                return
            if talk is not None and asking:
                await talk.say(from_page.Stage(0, phase, round))
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
        self.given: dict[str, from_page.Give] = {}
        self.waiting: list[from_page.Give] = []
        self.accepted: set[str] = set()
        self.refused: set[str] = set()
        self.back: dict[str, float] = {}
        self.cuts = self.reloads = 0
        self.is_over = False

    async def live(self) -> None:
        """Be there until it is over and nothing waits."""
        dice, name = self._dice, a_name(self._dice)
        while not (self.is_over and not self.waiting):
            try:
                async with talking(self._host, name) as talk:
                    await self._visit(talk)
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

    async def _visit(self, talk: Talk) -> None:
        """One connection, from its begin to its cut."""
        now = time.monotonic()
        for said in self.waiting:
            if said.id not in self._teacher.seen:
                self.back[said.id] = now
        acting = asyncio.create_task(self._act(talk))
        async for told in talk.hear():
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

    async def _act(self, talk: Talk) -> None:
        dice = self._dice
        until = time.monotonic() + dice.uniform(*self._storm.there)
        await _until(talk, "pageState", lambda _: True)
        await talk.say(from_page.Who(self.secret))
        await asyncio.sleep(AFTER_WHO)
        again = 0.0
        while self.is_over or time.monotonic() < until:
            if time.monotonic() >= again:
                again = time.monotonic() + AGAIN_EVERY
                for said in self.waiting:
                    await talk.say(said)
            await asyncio.sleep(dice.uniform(0.05, 0.5))
            if not self.is_over and dice.random() < 0.2:
                await self._give(talk)
            if self.given and dice.random() < 0.05:
                # As a message that was on its way for long.
                await talk.say(dice.choice(list(self.given.values())))
        talk.cut()

    async def _give(self, talk: Talk | None) -> None:
        """Give something that the class asks for, as far as the page knows; now and then say it twice."""
        dice, asking, masses = self._dice, self._asking, self._storm.masses
        phase = asking.get("phase")
        kinds = {"ask": ("vote", "places"), "explain": ("line",), "collect": ("work",)}.get(str(phase), ())
        if not kinds:
            return
        self._turn += 1
        head = f"{dice.getrandbits(64):016x}", self._turn, asking["stop"], asking["round"], 0
        match dice.choice(kinds):
            case "vote":
                said = from_page.GiveVote(*head, dice.randrange(3))
            case "places":
                points = tuple((dice.uniform(-3.0, 3.0), dice.uniform(-3.0, 3.0)) for _ in range(masses))
                said = from_page.GivePrediction(*head, points)
            case "line":
                said = from_page.GiveLine(*head, f"Because {self._turn}.")
            case _:
                said = from_page.GiveWork(*head)
        self.given[said.id] = said
        self.waiting = [old for old in self.waiting if _place(old) != _place(said)] + [said]
        if talk is not None:
            for _ in range(2 if dice.random() < 0.2 else 1):
                await talk.say(said)

    def _take(self, ids: list[str], refused: bool) -> None:
        self.waiting = [said for said in self.waiting if said.id not in ids]
        if not refused:
            self.accepted.update(ids)
        else:
            self.refused.update(set(ids) - self.accepted)


@dataclass(frozen=True)
class Outcome:
    """What became of what pupils gave.

    Attributes:
        given: answers that were given.
        replaced: those that their pupils replaced before or after they had come.
        once, twice, lost: questions of which the last accepted answer, and no other, is in the class's file;
            of which more than one is; of which another one is, or none.
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
    """What became of what pupils gave; `room` is the class as it is on the disk."""
    numbers = {seat.token: seat.number for seat in room.seats.values()}
    once = twice = lost = replaced = 0
    for pupil in pupils:
        number = numbers.get(digest(pupil.secret))
        places: dict[Place, list[from_page.Give]] = {}
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
            last = [max(accepted, key=lambda said: said.turn).id] if accepted else has[:1]
            if len(has) > 1:
                twice += 1
            elif has and has == last and not waits:
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
    """Hold a class in a storm; its server has ended afterwards."""
    dice = random.Random(storm.seed)
    teacher = Teacher(host, random.Random(f"{storm.seed} teacher"))
    pupils = [
        Pupil(host, random.Random(f"{storm.seed} {number}"), storm, teacher) for number in range(storm.pupils)
    ]

    async def wall() -> None:
        name = a_name(dice)
        while True:
            with contextlib.suppress(OSError, WebSocketException):
                async with talking(host, name, "wall") as talk:
                    await _hear_all(talk)
            await asyncio.sleep(0.1)

    others = [asyncio.create_task(one) for one in (teacher.live(), wall())]
    lives = [asyncio.create_task(pupil.live()) for pupil in pupils]
    for phase, round in PLAN:
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
    """What a class costs beside as many strangers, and what it survives."""
    with tempfile.TemporaryDirectory() as cache:
        warm(cache)
        _bench_cost(console, repeats, cache)
        with tempfile.TemporaryDirectory() as folder, Host(a_lesson(), Path(folder), cache) as host:
            outcome = asyncio.run(survive(host, Storm()))
    _tell(console, outcome)


def _bench_cost(console: Console, repeats: int, cache: str) -> None:
    table = Table(
        "pages", "fewest frames/s", "slowest clock", "server, % of a core", "beside strangers", "kB/s",
        box=None,
    )  # fmt: skip
    best: dict[str, tuple[float, ...]] = {}
    names = ("strangers", "pupils", "followers")
    for _ in range(repeats):
        for name in names:
            if name == names[0]:
                with served("softrod", MASSES, cache) as server:
                    visitors, begin, end, share = asyncio.run(visit_all(server, PUPILS))
            else:
                with tempfile.TemporaryDirectory() as folder, Host(a_lesson(), Path(folder), cache) as host:
                    visitors, begin, end, share = asyncio.run(cost(host, PUPILS, name == names[1]))
            rates, _, clocks = zip(*(visitor.within(begin, end) for visitor in visitors), strict=True)
            size = sum(visitor.bytes for visitor in visitors) / PUPILS / (end - begin) / 1e3
            row = share, min(rates), min(clocks), size
            best[name] = min(best.get(name, row), row)
    for name, (share, rate, clock, size) in best.items():
        table.add_row(
            name, f"{rate:.1f}", f"{clock:.2f}", f"{100 * share:.0f}",
            f"{share / best[names[0]][0]:.2f}", f"{size:.0f}",
        )  # fmt: skip
    console.print(table)
    console.print(
        f"{PUPILS} pages each: strangers and pupils with a rope of {MASSES} masses of their own, followers "
        "with the teacher's. The server of a class has the teacher's page and the wall, too."
    )


def _tell(console: Console, outcome: Outcome) -> None:
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
