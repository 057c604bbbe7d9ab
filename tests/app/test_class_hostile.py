"""Pupils who mean harm: whatever they say, the class goes on for the others, and is whole on the disk."""

from __future__ import annotations

import itertools
import logging
import math
import random
import re
import time
import unicodedata
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import msgspec
import pytest
from msgspec import inspect

import sim
from app.classroom import kept
from app.classroom.answers import (
    MAX_LINE_LENGTH,
    MAX_MARKS_PER_LETTER,
    OWN_BODY,
    Phase,
    Prediction,
    Refused,
    Vote,
    Work,
    sanitize_line,
)
from app.classroom.live import Class, Classes
from app.classroom.room import MAX_ANSWERS, MAX_NAME_LENGTH, MAX_SEATS, Room, digest
from app.features.classroom import messages as class_messages
from app.features.classroom.desk import DeskRole
from app.features.classroom.seat import SeatRole
from app.features.classroom.wall import WallRole
from app.features.edit.messages import SetTexts
from app.server.serve import serving
from app.session.session import Session
from app.wire import from_page
from app.wire.messages import FromPage, messages, read
from tests.amount import NIGHT
from tests.app.classrooms import Pupil, Teacher, no_download
from tests.app.hostile import CAMERA, HostilePage, eventually
from tests.app.letters import Letters
from tests.app.line_page import LinePage
from tests.app.test_room import SECRETS, a_room, an_answer, asking

WRONG_KEYS = ("", "x", "0" * 22, "é", "x" * 100)


@pytest.fixture
def classes(class_folder: Path) -> Classes:
    classes = Classes()
    for _ in range(2):
        classes.begin(a_room().scenes)
    return classes


@pytest.fixture
def classroom(classes: Classes) -> Class:
    return next(iter(classes))


def anything(kind: inspect.Type, dice: random.Random) -> Any:
    """A value of a type, often at an end of its range."""
    match kind:
        case inspect.BoolType():
            return dice.random() < 0.5
        case inspect.IntType(ge=low, le=high):
            low, high = int(low or 0), int(high or 0)
            return dice.choice((low, high, dice.randint(low, high), dice.randint(low, min(low + 3, high))))
        case inspect.FloatType(ge=low, le=high):
            low, high = float(low or 0.0), float(high or 0.0)
            return dice.choice(
                (low, high, 0.0, -0.0, 1e-300, dice.uniform(low, high), dice.uniform(-3.0, 3.0))
            )
        case inspect.StrType(pattern=str(pattern)):
            length = re.search(r"\{(\d+)\}", pattern)
            return "".join(dice.choice("0123456789") for _ in range(int(length[1]) if length else 0))
        case inspect.StrType(max_length=most, min_length=least):
            letters = "a<é\u202e\u200b\U0001f595 '\"&\u0301\n"
            length = max(least or 0, dice.choice((0, 3, most or 0)))
            return "".join(dice.choice(letters) for _ in range(length))
        case inspect.LiteralType(values=values):
            return dice.choice(values)
        case inspect.TupleType(item_types=kinds):
            return tuple(anything(one, dice) for one in kinds)
        case inspect.VarTupleType(item_type=one, min_length=least, max_length=most):
            length = dice.choice((least or 0, 4, 5, min(most or 9, 200)))
            return tuple(anything(one, dice) for _ in range(max(least or 0, min(length, most or length))))
        case inspect.UnionType(types=kinds):
            return anything(dice.choice(kinds), dice)
    return None


def a_message(kind: type, dice: random.Random) -> str:
    """Something of a kind that a page says, as it travels; now and then more than that kind has."""
    info = inspect.type_info(kind)
    assert isinstance(info, inspect.StructType)
    fields = {field.encode_name: anything(field.type, dice) for field in info.fields}
    if dice.random() < 0.02:
        fields["found"] = 9000.0
    return msgspec.json.encode({"do": info.tag, **fields}).decode()


class Someone(HostilePage):
    """A page of a class, which says what it likes."""

    def __init__(self, port: int, path: str) -> None:
        super().__init__(port, path)
        self.send(CAMERA)
        assert eventually(lambda: self.told("pageState"))

    def say(self, *texts: str) -> None:
        """Say something."""
        self.send(*({"type": "SoftrodMessage", "text": text} for text in texts))

    def told(self, tell: str) -> list[dict[str, Any]]:
        """All of a kind that it was told."""
        texts = [str(message.get("text", "")) for message in list(self.messages)]
        return [msgspec.json.decode(text) for text in texts if text.startswith(f'{{"tell":"{tell}"')]


@pytest.fixture
def port(classes: Classes, caplog: pytest.LogCaptureFixture) -> Iterator[int]:
    """A server that holds the classes, of which no page may have stopped in the end."""
    with (
        caplog.at_level(logging.WARNING, "app"),
        serving(sim.rope(4), "127.0.0.1", 0, classes=classes) as (server, _, _),
    ):
        yield server.get_port()
    assert not [record for record in caplog.records if record.name.startswith("app")], caplog.text


def who(number: int, teacher: str = "") -> str:
    return msgspec.json.encode(from_page.Who(f"{number:032x}", "", teacher)).decode()


@pytest.mark.parametrize(
    ("taught", "alone", "query"),
    [
        ("lesson-hooke", True, "scene=lesson-hooke"),
        ("lesson-hooke", False, "scene=lesson-hooke"),
        ("lesson-hooke", True, "room={code}&scene=lesson-hooke"),
        ("lesson-hooke", True, "room=AAAA&scene=lesson-hooke"),
        ("lesson-laws", False, "scene=lesson-hooke"),  # which is nobody's but the page's
    ],
)
def test_only_the_class_tells_what_is_right_in_its_lesson(
    class_folder: Path, taught: str, alone: bool, query: str
) -> None:
    classes = Classes(alone)
    classroom = classes.begin([sim.load_scene(taught)])
    lesson = sim.load_scene("lesson-hooke").lesson
    assert lesson is not None
    because = [step.question.because for step in lesson.steps if step.question is not None]
    # That others could reach the server makes nobody the owner by chance.
    with serving(sim.rope(), "127.0.0.1", 0, allow_hosts=("laptop.local",), classes=classes) as (server, *_):
        page = Someone(server.get_port(), f"/at/{1:032x}?{query.format(code=classroom.room.code)}")
        page.say(who(1))
        assert eventually(lambda: len(page.told("keepsake") + page.told("seat")) > 0)
        page.say('{"do":"beginStep","step":0,"how":"run"}')
        is_told = taught == "lesson-laws"
        if is_told:
            assert eventually(lambda: page.told("lesson"))
        else:
            time.sleep(0.5)
        # What the browser keeps of its own page is nothing that is shown.
        shown = [message for message in page.messages if '"tell":"keepsake"' not in str(message.get("text"))]
        assert any(text in repr(shown) for text in because) is is_told
        page.socket.close()


def test_nor_does_a_pupil_s_own_page_before_the_class_is_there(port: int, classroom: Class) -> None:
    """All that it is told, phase by phase."""
    scene = sim.load_scene("lesson-hooke")
    assert scene.lesson is not None
    question = scene.lesson.steps[0].question
    assert question is not None
    classroom.room.scenes = (scene,)
    page = LinePage(port, f"room={classroom.room.code}").begin()
    page.say(who(1))
    assert eventually(lambda: page.told("seat")[-1]["code"])
    room, told = classroom.room, list[dict[str, Any]]()
    for phase, round in room.order(0):
        room.go(0, phase, round)
        assert eventually(lambda: page.told("seat")[-1]["asking"]["phase"] == phase.value)  # noqa: B023
        told = [seat["asking"] for seat in page.told("seat") if seat["asking"]]
        # The headline with the reveal, and all of it once each has written a line of their own.
        assert any(one["right"] >= 0 for one in told) == (phase in (Phase.REVEAL, Phase.EXPLAIN, *OWN_BODY))
        assert any(one["because"] == question.because for one in told) == (phase in OWN_BODY)
    assert any(one["because"] == "Twice the weight is twice the stretch." for one in told)
    page.close()


def test_that_a_lesson_is_a_class_s_is_said_once(class_folder: Path) -> None:
    classes = Classes(alone=False)
    classes.begin([sim.load_scene("lesson-hooke")])
    with serving(sim.rope(), "127.0.0.1", 0, allow_hosts=("laptop.local",), classes=classes) as (server, *_):
        page = Someone(server.get_port(), f"/at/{1:032x}?scene=lesson-hooke")
        page.say(who(1))
        assert eventually(lambda: page.told("keepsake"))

        def said(title: str) -> int:
            return sum(
                title == (m.get("props") or {}).get("title") for m in page.received("NotificationShowMessage")
            )

        assert eventually(lambda: said("A class goes through this lesson now"))
        for name in ("One", "Two"):
            # A new name has the panel made anew.
            page.say(msgspec.json.encode(SetTexts(name, "")).decode())
            assert eventually(lambda: name in repr(page.messages))  # noqa: B023
        time.sleep(0.2)
        assert said("A class goes through this lesson now") == 1
        page.socket.close()


def test_whatever_a_pupil_and_a_wall_say_the_others_answers_arrive(
    classroom: Class, classes: Classes, port: int
) -> None:
    dice = random.Random(5)
    room, query = classroom.room, f"room={classroom.room.code}"
    honest, pupil = (LinePage(port, query).begin() for _ in range(2))
    wall = LinePage(port, f"{query}&as=wall").begin()
    desk = Someone(port, f"/at/{4:032x}?{query}&as=desk")
    honest.say(who(1))
    pupil.say(who(2))
    desk.say(who(4, room.key))
    assert eventually(lambda: desk.told("desk") and len(room.seats) == 2)
    for number, (phase, round) in enumerate(room.order(0)):
        desk.say(msgspec.json.encode(class_messages.Stage(0, phase.value, round)).decode())
        assert eventually(lambda: room.phase is phase)  # noqa: B023
        for kind in messages(FromPage):
            if kind is not from_page.Who:
                pupil.say(*(a_message(kind, dice) for _ in range(12 if NIGHT else 4)))
                wall.say(*(a_message(kind, dice) for _ in range(3)))
        if (phase, round) == (Phase.ASK, 0):
            votes = (
                class_messages.GiveVote(f"{n + 4096:016x}", n, 0, 0, 0, n % 3)
                for n in range(2500 if NIGHT else 300)
            )
            pupil.say(*(msgspec.json.encode(vote).decode() for vote in votes))
        if phase in (Phase.ASK, Phase.EXPLAIN):
            head = f"{number + 1:016x}", number, 0, round, 0
            said = (
                class_messages.GiveVote(*head, 1)
                if phase is Phase.ASK
                else class_messages.GiveLine(*head, "Hm.")
            )
            honest.say(msgspec.json.encode(said).decode())
            assert eventually(lambda: any(head[0] in told["ids"] for told in honest.told("taken")))  # noqa: B023
        assert room.phase is phase
        assert room.is_open
        assert not (room.own_names or room.paused or classroom.ended)
    number = next(seat.number for seat in room.seats.values() if seat.token == digest(f"{1:032x}"))
    mine = [answer.id for answer in room.answers.values() if answer.seat == number]
    assert mine == [f"{1 + n:016x}" for n in (1, 3, 7)]
    assert len(room.answers) > len(mine), "some of what the other one said made sense"
    # What is on the disk can be read, whatever it was made of.
    assert eventually(lambda: classroom.written == room.version)
    assert room.code in kept.codes()
    for page in (honest, pupil, wall, desk):
        page.close()


def test_a_hundred_forged_acts_of_a_teacher_and_none_is_done(classes: Classes, classroom: Class) -> None:
    session, dice = Session(sim.rope(4), wait=False), random.Random(1)
    seat = classroom.room.enter(f"{7:032x}")
    classroom.room.go(0, Phase.ASK)
    classroom.room.take(seat.number, an_answer(1, Vote(1)))
    other = list(classes)[1].room
    keys = (*WRONG_KEYS, other.key, classroom.room.code, classroom.room.key[:-1], classroom.room.key + "x")
    before, tried = msgspec.json.encode((classroom.room, other)), 0
    Teacher(classroom)  # the true one is there meanwhile
    makes = (
        SeatRole,
        lambda room, mail: WallRole(room, mail, ""),
        lambda room, mail: DeskRole(room, mail, "", no_download),
    )
    for make, key, kind in itertools.product(makes, keys, messages(class_messages.Lead)):
        role = make(classroom, Letters())  # a page is another role after every connection
        role.introduce(from_page.Who(f"{7:032x}", key, key), session)
        for _ in range(3):
            said = read(a_message(kind, dice))
            if said is not None:
                tried += 1
                assert not role.allows(said)
                role.hear(said, session)
        role.leave()
    assert tried >= 100
    assert msgspec.json.encode((classroom.room, other)) == before
    assert not classroom.ended
    assert classroom.teachers == 1


def test_what_is_handed_in_is_read_off_by_the_server_alone(classroom: Class) -> None:
    head = '{"do":"giveWork","id":"000000000000000a","turn":1,"stop":0,"round":0,"twin":0'
    assert isinstance(read(head + "}"), class_messages.GiveWork)
    for more in (
        '"found":9000',
        '"reached":true',
        '"setting":1',
        '"doubt":""',
        '"log":"../x"',
        '"points":[]',
    ):
        assert read(f"{head},{more}}}") is None
    # Nor is there a run to hand in while all look at one body, or of another step.
    pupil = Pupil(classroom)
    classroom.room.go(0, Phase.COLLECT)
    pupil.say(class_messages.GiveWork("0" * 16, 1, 1, 0, 0))
    assert pupil.letters.sent[-1].refused == "There is no run to hand in now."
    assert not classroom.room.answers


def test_runs_are_handed_in_one_a_second_and_the_last_one_counts(classroom: Class) -> None:
    now = [100.0]
    pupil = Pupil(classroom, session=Session(sim.rope(4), clock=lambda: now[0], wait=False))
    classroom.room.go(0, Phase.COLLECT)
    pupil.say(*(class_messages.GiveWork(f"{number:016x}", number, 0, 0, 0) for number in range(200)))
    assert list(classroom.room.answers) == [f"{0:016x}"]
    now[0] += 1.1
    pupil.say(class_messages.GiveWork(f"{150:016x}", 150, 0, 0, 0))
    assert list(classroom.room.answers) == [f"{150:016x}"]
    classroom.close()
    logs = list(kept.folder_of(classroom.room.code).rglob("*.jsonl"))
    assert [path.stem for path in logs] == [f"{150:016x}"], "what was replaced is gone"


@pytest.mark.parametrize(
    "content",
    [
        Work(points=((math.nan, 1.0), (math.inf, 2.0))),
        Work(found=math.inf, setting=math.nan),
        Prediction(((7e8, 0.0),) * 4),
        Prediction(((math.nan, 0.0),) * 4),
        Prediction(((-math.inf, 0.0),) * 4),
    ],
)
def test_no_number_makes_a_class_that_cannot_be_read_again(content: Work | Prediction) -> None:
    room, seat = asking()
    room.go(0, Phase.COLLECT)
    try:
        room.take(seat.number, an_answer(1, content))
    except Refused as error:
        assert str(error) == "That is no place for this body."
    again = msgspec.json.decode(kept.encode(room), type=Room)
    assert msgspec.json.encode(again) == msgspec.json.encode(room)
    assert bool(room.answers) is isinstance(content, Work)


@pytest.mark.parametrize(
    ("typed", "shown"),
    [
        ("\u202eevil\u202c\u2066x", "evil x"),
        ("a\u200b\u200d\ufeffb\x00\x1b[31m", "a b [31m"),
        ("\u200b\u2028", ""),
        ("<img src=x onerror=alert(1)>", "<img src=x onerror=alert(1)>"),
        ("\U0001f595", "\U0001f595"),
        ("z" + "\u0301\u0323" * 30 + "a", None),
        ("  \n\t\u2003 ", ""),
        ("w" * 10_000, "w" * MAX_LINE_LENGTH),
    ],
)
def test_what_is_typed_is_one_line_of_what_can_be_seen(typed: str, shown: str | None) -> None:
    made = sanitize_line(typed, MAX_LINE_LENGTH)
    assert shown is None or made == shown
    assert len(made) <= MAX_LINE_LENGTH
    assert all(unicodedata.category(c)[0] != "C" for c in made)
    marks = re.findall("1+", "".join("01"[unicodedata.category(c)[0] == "M"] for c in made))
    assert all(len(run) <= MAX_MARKS_PER_LETTER for run in marks)
    room = a_room()
    seat = room.enter(SECRETS[0])
    room.own_names = True
    try:
        room.rename(seat.number, typed)
    except Refused as error:
        assert str(error) == "A name needs a letter."
    assert 0 < len(seat.name) <= MAX_NAME_LENGTH


def test_thousands_of_answers_from_one_seat_are_bounded() -> None:
    room, seat = asking()
    for number in range(3000):
        room.take(seat.number, an_answer(number, Vote(number % 3), turn=number))
    assert len(room.answers) == 1
    assert len(room.answers) < MAX_ANSWERS
    assert room.bars(0, 0) == [0, 0, 1]


def test_thousands_of_secrets_keep_nobody_out_and_a_closed_door_stops_them() -> None:
    room, honest = asking()
    room.take(honest.number, an_answer(1, Vote(1)))
    for number in range(2000):
        room.enter(f"{number + 1000:032x}", here=())
    assert len(room.seats) == MAX_SEATS
    late = room.enter(SECRETS[1], here=())
    assert late.number in room.seats
    assert room.enter(SECRETS[0]).number == honest.number, "who has given something stays"
    with pytest.raises(Refused, match="full"):
        room.enter(SECRETS[2], here=list(room.seats))
    room.is_open = False
    with pytest.raises(Refused, match="open the door"):
        room.enter(SECRETS[2], here=())
    assert room.enter(SECRETS[1]).number == late.number


def test_nobody_finds_the_digits_of_a_seat_by_trying_all(classroom: Class) -> None:
    moving = classroom.room.enter(SECRETS[0])
    classroom.room.offer_move(moving.number)
    moving.move = "77"
    pupil = Pupil(classroom, 9)
    pupil.say(*(class_messages.TakeOver(f"{number:02}") for number in range(100)))
    assert classroom.room.seats[moving.number].token == digest(SECRETS[0])
    assert "too many tries" in pupil.letters.sent[-1].refused


def test_one_page_takes_one_seat(classroom: Class) -> None:
    pupil = Pupil(classroom, 0)
    for number in range(50):
        pupil.introduce(number)
    assert len(classroom.room.seats) == 1
