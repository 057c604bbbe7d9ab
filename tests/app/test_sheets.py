"""Answers that were given in a file: what its script packs is what a class takes, once, and nothing else."""

from __future__ import annotations

import json
import random
import subprocess
from typing import Any

import msgspec
import pytest
import segno

import sim
from app.classroom.answers import Line, Phase, Prediction, Refused, Vote
from app.classroom.live import Class
from app.classroom.room import MAX_SEATS, Room
from app.classroom.sheets import import_sheet
from app.features.classroom import messages as class_messages
from app.features.classroom.desk import DeskRole
from app.features.classroom.messages import Brought
from app.lessons import lesson_code
from app.session.session import Session
from app.wire import from_page
from sim.scene.lesson import Lesson, Question, Step
from tests.app.letters import Letters
from tests.page.check import FOLDER, NODE

FRAME = {"left": 0.0, "top": 0.0, "width": 640.0, "height": 480.0}
PLACES = [[10.0, 20.0], [320.0, 240.0], [650.0, -30.0], [100.0, 470.0]]


def a_scene() -> sim.Scene:
    question = Question(text="Which way?", choices=("left", "right", "neither"), answer=1, because="It is.")
    steps = (
        Step(title="One", question=question, do="Look.", predict=2.0),
        Step(title="Two", question=question, do="Look."),
        Step(title="Three", do="Try."),
    )
    scene = msgspec.structs.replace(sim.rope(masses=4), lesson=Lesson(steps=steps))
    view = msgspec.structs.replace(scene.view, frame=(0.0, 0.0, 640.0, 480.0))
    return msgspec.structs.replace(scene, view=view)


def a_room() -> Room:
    """A class whose lesson is the second of its scenes."""
    return Room(code="ABCD", key="key", scenes=(sim.rope(), a_scene()))


def contents(room: Room, stop: int, round: int, kind: Any) -> list[Any]:
    return [content for _, content in room.given(stop, round, kind)]


def a_step(
    choice: int | None = None, line: str = "", places: Any = None, reached: bool = False
) -> dict[str, Any]:
    return {"choice": choice, "line": line, "places": places, "reached": reached}


def a_sheet(*steps: dict[str, Any], **more: Any) -> dict[str, Any]:
    steps = (*steps, *(a_step() for _ in range(3 - len(steps))))
    sheet = {"format": "softrod-answers", "version": 1, "lesson": lesson_code(a_scene()), "id": "00112233aa"}
    return {**sheet, "turn": 3, "name": "", "steps": steps, **more}


def packed(*sheets: dict[str, Any]) -> list[dict[str, Any]]:
    """Sheets as the script packs them, see `tests/page/answers.mjs`."""
    lines = "".join(json.dumps({"sheet": sheet, "frame": FRAME}) + "\n" for sheet in sheets)
    run = subprocess.run(
        [NODE, FOLDER / "answers.mjs"], input=lines, capture_output=True, text=True, check=False
    )
    assert run.returncode == 0, run.stderr
    return [json.loads(line) for line in run.stdout.splitlines()]


WHY = "Because it is soft – très molle 🧵"
FULL = a_sheet(
    a_step(1, WHY, PLACES),
    a_step(2, "x" * 140),
    a_step(reached=True),
    name="Zoë",
)


def test_a_class_takes_what_a_file_has_packed() -> None:
    small = a_sheet(a_step(0), a_step(2), name="Ann")
    for sheet, made in zip((FULL, small), packed(FULL, small), strict=True):
        assert len(made["text"]) <= 150
        room = a_room()
        imported = import_sheet(room, made["text"])
        assert imported.name == sheet["name"]
        assert all(answer.late for answer in room.answers.values())
        assert contents(room, 1, 0, Vote) == [Vote(sheet["steps"][0]["choice"])]
        assert contents(room, 2, 0, Vote) == [Vote(2)]
    made = packed(FULL)[0]
    room = a_room()
    assert import_sheet(room, made["text"]).reached == (3,)
    [prediction] = contents(room, 1, 0, Prediction)
    assert isinstance(prediction, Prediction)
    for point, right in zip(prediction.points, PLACES, strict=True):
        assert point == pytest.approx(right, abs=2.6)  # half of a 128th of the frame
    assert contents(room, 1, 0, Line) == [Line(WHY)]
    [cut] = contents(room, 2, 0, Line)
    assert isinstance(cut, Line)
    assert "x" * 140 != cut.text == "x" * len(cut.text)
    assert made["left"] == ["the end of the line of step 2"]


def test_the_code_is_the_one_that_another_program_makes() -> None:
    rng = random.Random(1)
    sheets = [
        a_sheet(a_step(i % 3, "".join(rng.choices("abc ÄΩ", k=5 * i))), name="N" * i) for i in range(12)
    ]
    for made in packed(*sheets):
        other = segno.make(
            made["text"], version=5, error="l", mask=0, mode="alphanumeric", boost_error=False, micro=False
        )
        assert made["code"] == [list(map(int, row)) for row in other.matrix]


def test_every_answer_counts_once_and_a_later_sheet_goes_before() -> None:
    room, text = a_room(), packed(FULL)[0]["text"]
    assert import_sheet(room, text)[1:3] == (5, 0)
    before = msgspec.json.encode(room.answers)
    assert import_sheet(room, text.lower())[1:3] == (0, 5)
    assert msgspec.json.encode(room.answers) == before
    # The file of the same moment has the whole line and the places as they were; then the code is old.
    assert import_sheet(room, json.dumps(FULL))[1:3] == (2, 3)
    assert contents(room, 2, 0, Line) == [Line("x" * 140)]
    assert import_sheet(room, text)[1:3] == (0, 5)
    later = {**FULL, "turn": 4, "steps": (a_step(0), *FULL["steps"][1:])}
    assert import_sheet(room, json.dumps(later)).new == 1
    assert contents(room, 1, 0, Vote) == [Vote(0)]
    assert import_sheet(room, json.dumps(FULL)).new == 0
    assert "Y" in text or "Z" in text
    assert import_sheet(room, text.translate(str.maketrans("YZ", "ZY"))).known == 5  # by a German keyboard
    assert len(room.seats) == 1
    assert import_sheet(room, json.dumps({**FULL, "id": "99112233aa"})).name == "Zoë 2"
    assert len(room.seats) == 2


def test_they_come_late_whatever_the_class_does_and_are_sealed_until_it_is_asked() -> None:
    room = a_room()
    room.is_open = False
    import_sheet(room, json.dumps(FULL))
    [(vote, _)] = room.given(1, 0, Vote)
    with pytest.raises(Refused):
        room.put_on_wall(vote.id)
    room.go(1, Phase.ASK)
    room.go(1, Phase.RESULTS)
    room.put_on_wall(vote.id)
    assert room.bars(1, 0) == [0, 1, 0]
    other = {**FULL, "id": "99112233aa"}
    assert import_sheet(room, json.dumps(other)).new == 5
    assert room.bars(1, 0) == [0, 2, 0]


def test_what_is_no_sheet_of_this_class_is_refused_in_a_sentence_and_changes_nothing() -> None:
    room, text, rng = a_room(), packed(FULL)[0]["text"], random.Random(2)
    import_sheet(room, json.dumps({**FULL, "id": "0000000001"}))
    before = msgspec.json.encode(room)
    wrong = [
        "", "{", "SR1", "hello", "SR1!!!!", "SR1" + "A" * 40, text[:-4], text + "AAAA",
        "SR1" + "7" * 190, "{" * 9000,
        json.dumps({**FULL, "lesson": "00000000"}),
        json.dumps({**FULL, "steps": FULL["steps"][:2]}),
        json.dumps(a_sheet()),
        json.dumps(a_sheet(a_step(3))),
        json.dumps(a_sheet(a_step(), a_step(), a_step(1))),
        json.dumps(a_sheet(a_step(1), a_step(places=PLACES))),
        json.dumps(a_sheet(a_step(places=PLACES[:3]))),
        json.dumps(a_sheet(a_step(1, "\u202e\u200b"))),
        json.dumps(a_sheet(a_step(1))).replace('"choice": 1', '"choice": 1e400'),
        json.dumps(a_sheet(a_step(places=[[float("nan"), 1]] * 4))),
        json.dumps({**FULL, "seat": 1}),
    ]  # fmt: skip
    for _ in range(300):
        at = rng.randrange(3, len(text))
        wrong.append(text[:at] + rng.choice("ABCDEFGH234567") + text[at + 1 :])
    for one in wrong:
        if one == text:
            continue
        with pytest.raises(Refused) as refused:
            import_sheet(room, one)
        assert str(refused.value).endswith(".")
        assert msgspec.json.encode(room) == before, one


def test_a_full_class_takes_no_more() -> None:
    room = a_room()
    for i in range(MAX_SEATS):
        import_sheet(room, json.dumps({**FULL, "id": f"{i:010x}", "name": f"N{i}"}))
    with pytest.raises(Refused, match="full"):
        import_sheet(room, json.dumps({**FULL, "id": "ffffffffff"}))


def test_the_teachers_page_alone_brings_answers() -> None:
    classroom, session = Class(a_room()), Session(sim.rope(4), wait=False)
    letters = Letters()
    role = DeskRole(classroom, letters, "", lambda *_: None)
    said = class_messages.Bring(json.dumps(FULL))
    assert not role.allows(said)
    role.hear(said, session)
    assert not classroom.room.answers
    role.introduce(from_page.Who("0" * 32, "", "key"), session)
    role.hear(said, session)
    role.hear(class_messages.Bring("{}"), session)
    told = [one for one in letters.sent if isinstance(one, Brought)]
    assert [one.refused for one in told] == [False, True]
    assert "Zoë: 5 answers" in told[0].told
    assert len(classroom.room.answers) == 5


def test_the_teachers_page_saves_the_lesson_as_a_file() -> None:
    classroom, session = Class(a_room()), Session(sim.rope(4), wait=False)
    saved: dict[str, bytes] = {}
    role = DeskRole(classroom, Letters(), "", saved.__setitem__)
    role.introduce(from_page.Who("0" * 32, "", "key"), session)
    classroom.room.go(1, Phase.SHOW)
    made = classroom.lesson_file()
    role.hear(class_messages.Arrange("lessonFile"), session)
    data = made.result(60.0)
    while not saved:
        role.frame(session)
    assert saved == {"rope.html": data}
    assert lesson_code(a_scene()) in data.decode()
    classroom.end()
