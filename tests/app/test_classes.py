"""Classes that go on: what is on the disk, what a restarted server knows, and what is left at the end."""

from __future__ import annotations

import base64
import time
from pathlib import Path

import msgspec
import pytest

import sim
from app.classroom import kept
from app.classroom.live import Class, Classes, is_key
from app.classroom.room import Phase, Refused, Vote
from tests.app.test_room import SECRETS, a_room, an_answer


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Where the classes are."""
    monkeypatch.setattr(kept, "classes_folder", lambda: tmp_path / "classes")
    return tmp_path / "classes"


def until_written(klass: Class) -> None:
    while klass.written != klass.room.version:
        klass.tend()
        time.sleep(0.001)


def test_a_class_goes_on_after_the_server_was_started_anew(folder: Path) -> None:
    classes = Classes()
    klass = classes.begin(a_room().scenes)
    seat = klass.room.enter(SECRETS[0])
    klass.room.go(0, Phase.ASK)
    klass.room.take(seat.number, an_answer(1, Vote(1)))
    klass.keep(seat.number, b"where it is")
    until_written(klass)
    # The server ends without a word.
    (after,) = Classes().go_on()
    assert msgspec.json.encode(after.room) == msgspec.json.encode(klass.room)
    assert after.room.bars(0, 0) == [0, 1, 0]
    assert after.room.enter(SECRETS[0]).name == seat.name
    assert is_key(after.room, klass.room.key)
    assert not is_key(after.room, "")
    # One that is told to end writes where the bodies are, too.
    classes.close()
    (after,) = Classes().go_on()
    assert after.body(seat.number) == b"where it is"
    after.room.go(1, Phase.TRY)
    assert after.body(seat.number) is None
    assert {path.stat().st_mode & 0o077 for path in folder.iterdir()} == {0}


def test_a_teacher_s_secret_cannot_be_guessed(folder: Path) -> None:
    classes = Classes()
    keys = {classes.begin(a_room().scenes).room.key for _ in range(5)}
    assert len(keys) == 5
    assert {len(base64.urlsafe_b64decode(key + "==")) for key in keys} == {16}
    classes.close()


def test_nothing_is_acknowledged_before_it_is_on_the_disk(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    klass = Classes().begin(a_room().scenes)
    monkeypatch.setattr(kept, "write", lambda *_: (_ for _ in ()).throw(OSError("no room")))
    klass.room.enter(SECRETS[0])
    for _ in range(200):
        klass.tend()
        time.sleep(0.001)
    assert klass.written < klass.room.version


def test_at_the_end_nothing_is_left(folder: Path) -> None:
    classes = Classes()
    klass = classes.begin(a_room().scenes)
    seat = klass.room.enter(SECRETS[0])
    klass.keep(seat.number, b"x")
    until_written(klass)
    assert any(folder.rglob("*.json"))
    klass.end()
    assert not list(folder.iterdir())
    assert classes.find(klass.room.code) is None
    assert not klass.room.seats
    classes.close()
    assert not list(folder.iterdir())


def test_a_file_that_makes_no_sense_is_left_alone(folder: Path) -> None:
    for code, text in (("ABCD", "{"), ("ABCE", '{"code": "ABCE"}'), ("notes", "")):
        (folder / code).mkdir(parents=True)
        (folder / code / kept.FILE).write_text(text)
    assert Classes().go_on() == []
    assert len(list(folder.rglob(kept.FILE))) == 3


def test_a_class_has_no_more_steps_than_a_page_can_list() -> None:
    with pytest.raises(Refused, match="60 steps"):
        Classes().begin((sim.rope(),) * 61)
