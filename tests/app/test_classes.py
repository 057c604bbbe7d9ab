"""Classes that go on: what is on the disk, what a restarted server knows, and what is left at the end."""

from __future__ import annotations

import base64
import errno
import io
import itertools
import random
import threading
import time
import zipfile
from collections.abc import Callable, Sequence
from pathlib import Path

import msgspec
import pytest

import sim
from app.classroom import kept, live
from app.classroom.answers import Line, Phase, Prediction, Refused, Vote, Work
from app.classroom.live import Class, Classes, is_key
from tests.app.test_room import SECRETS, a_room, an_answer


def until_written(classroom: Class) -> None:
    while classroom.written != classroom.room.version:
        classroom.poll_writer()
        time.sleep(0.001)


def kill(classes: Classes) -> None:
    """What the end of its process does to a server: its locks go."""
    for classroom in classes:
        kept.release(classroom.lock)


def taken_up(scenes: Sequence[sim.Scene] | None = None, count: int = 1, new: bool = False) -> list[Class]:
    """The classes of a server that is started."""
    classes = Classes()
    classes.resume(scenes, count, new)
    return list(classes)


def tended(classroom: Class, until: Callable[[], bool]) -> None:
    """Tend a class as its pages do."""
    deadline = time.monotonic() + 10.0
    while not until():
        assert time.monotonic() < deadline
        classroom.poll_writer()
        time.sleep(0.001)


def test_a_class_goes_on_after_the_server_was_started_anew(class_folder: Path) -> None:
    classes = Classes()
    classroom = classes.begin(a_room().scenes)
    seat = classroom.room.enter(SECRETS[0])
    classroom.room.go(0, Phase.ASK)
    classroom.room.take(seat.number, an_answer(1, Vote(1)))
    classroom.keep_body(seat.number, b"where it is")
    until_written(classroom)
    kill(classes)
    (after,) = taken_up()
    assert msgspec.json.encode(after.room) == msgspec.json.encode(classroom.room)
    assert after.room.bars(0, 0) == [0, 1, 0]
    assert after.room.enter(SECRETS[0]).name == seat.name
    assert is_key(after.room, classroom.room.key)
    assert not is_key(after.room, "")
    # One that is told to end writes where the bodies are, too.
    kept.release(after.lock)
    classes.close()
    (after,) = taken_up()
    assert after.body(seat.number) == b"where it is"
    after.room.go(1, Phase.TRY)
    assert after.body(seat.number) is None
    assert {path.stat().st_mode & 0o077 for path in class_folder.iterdir()} == {0}


def test_a_class_that_an_older_server_wrote_goes_on_with_all_that_was_given(class_folder: Path) -> None:
    data = (Path(__file__).parent / "class.json").read_bytes()
    (class_folder / "ABCD").mkdir(parents=True)
    (class_folder / "ABCD" / kept.FILE).write_bytes(data)
    room = kept.read("ABCD")
    assert room is not None
    given = [type(answer.content) for answer in room.answers.values()]
    assert given == [Vote, Prediction, Vote, Line, Work, Work]
    # It is written as it was, but for its language, and its scenes, which keep the tutorial's air.
    old, new = msgspec.json.decode(data), msgspec.json.decode(kept.encode(room))
    old["language"] = "en"
    old["scenes"] = [{**scene, "format": 4, "air_law": "tutorial"} for scene in old["scenes"]]
    assert {**old, **new} == old
    assert old.keys() - new.keys() == {"pushed"}, "which nothing can set any more"


def test_a_class_goes_on_by_the_command_that_began_it(class_folder: Path) -> None:
    scenes = [sim.load_scene("lesson-hooke"), sim.rope(masses=4)]
    (classroom,) = taken_up(scenes)
    until_written(classroom)
    kept.release(classroom.lock)
    (after,) = taken_up([sim.load_scene("lesson-hooke"), sim.rope(masses=4)])
    assert after.room.code == classroom.room.code
    kept.release(after.lock)
    for others in ([sim.rope(masses=4)], scenes[:1], [*scenes, sim.rope(masses=7)]):
        with pytest.raises(Refused, match=f"Class {classroom.room.code}, which has other scenes"):
            taken_up(others)
    one, two = taken_up(None, 2)  # one more, with the same scenes
    assert one.room.code == classroom.room.code
    assert two.room.scenes == tuple(scenes)
    until_written(two)
    for held in (one, two):
        kept.release(held.lock)
    (anew,) = taken_up(scenes, new=True)
    assert anew.room.code not in (one.room.code, two.room.code)
    assert kept.codes() == []


def test_a_class_has_one_server(class_folder: Path) -> None:
    scenes = [sim.rope(masses=4)]
    (classroom,) = taken_up(scenes)
    until_written(classroom)
    code = classroom.room.code
    for named in (scenes, None):
        with pytest.raises(Refused, match=f"Another softrod on this computer goes on with class {code}"):
            taken_up(named)
    (other,) = taken_up([sim.rope(masses=5)])  # which that class has nothing to do with
    (anew,) = taken_up(scenes, new=True)
    assert len({code, other.room.code, anew.room.code}) == 3
    assert kept.read(code) is not None


def test_a_teacher_s_secret_cannot_be_guessed(class_folder: Path) -> None:
    classes = Classes()
    keys = {classes.begin(a_room().scenes).room.key for _ in range(5)}
    assert len(keys) == 5
    assert {len(base64.urlsafe_b64decode(key + "==")) for key in keys} == {16}
    classes.close()


def test_nothing_is_acknowledged_before_it_is_on_the_disk(
    class_folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    classroom = Classes().begin(a_room().scenes)
    monkeypatch.setattr(kept, "write", lambda *_: (_ for _ in ()).throw(OSError("no room")))
    classroom.room.enter(SECRETS[0])
    for _ in range(200):
        classroom.poll_writer()
        time.sleep(0.001)
    assert classroom.written < classroom.room.version


def hand_in_a_run(classroom: Class, number: int) -> str:
    """Have a run handed in; returns the name of its log."""
    answer = msgspec.structs.replace(an_answer(number, Work()), seat=1)
    step = classroom.room.step
    assert step is not None
    classroom.hand_in(answer, b"a log", step, classroom.scene(0))
    return f"{answer.id}.jsonl"


def test_a_full_disk_is_told_once_and_what_was_given_meanwhile_is_kept_when_there_is_room(
    class_folder: Path, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    seconds = itertools.count()
    classroom = Class(a_room(), clock=lambda: float(next(seconds)))
    classroom.room.enter(SECRETS[0])
    classroom.room.go(0, Phase.COLLECT)
    until_written(classroom)
    tries = 0

    def full(*_: object) -> None:
        nonlocal tries
        tries += 1
        raise OSError(errno.ENOSPC, "No space left on device")

    with monkeypatch.context() as patched:
        patched.setattr(kept, "write_atomically", full)
        log = hand_in_a_run(classroom, 1)
        tended(classroom, lambda: tries > 5)
        assert classroom.written < classroom.room.version
        assert classroom.trouble == "No space left on device"
        assert [notice()[0] for notice in classroom.notices] == ["The class is not being kept"]
        with zipfile.ZipFile(io.BytesIO(classroom.pack().result())) as file:
            assert b"a log" in [file.read(name) for name in file.namelist()]
    assert sum("cannot be written" in record.message for record in caplog.records) == 1
    until_written(classroom)
    assert kept.log_path(classroom.room.code, log).read_bytes() == b"a log"
    assert [notice()[0] for notice in classroom.notices][1:] == ["The class is being kept again"]
    assert not classroom.trouble
    # Of two runs, the later one stays.
    hand_in_a_run(classroom, 2)
    until_written(classroom)
    assert len(list(class_folder.rglob("*.jsonl"))) == 1


def test_answers_do_not_wait_for_the_zip(class_folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    classroom = Classes().begin(a_room().scenes)
    made = threading.Event()
    monkeypatch.setattr(live, "pack", lambda *_: made.wait(10.0) and b"")
    zipped = classroom.pack()
    classroom.room.enter(SECRETS[0])
    classroom.keep_body(1, b"x")
    tended(classroom, lambda: classroom.written == classroom.room.version)
    assert not zipped.done()
    made.set()


def test_a_server_that_ends_does_not_wait_for_the_bounds_of_a_motion(
    class_folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    classes = Classes()
    classroom = classes.begin(a_room().scenes)
    begun, ended = threading.Event(), threading.Event()
    monkeypatch.setattr(live, "motion_bounds", lambda _: begun.set() or ended.wait(10.0))
    assert classroom.bounds(0) is None
    assert begun.wait(10.0)
    began = time.monotonic()
    classes.close()
    assert not ended.is_set()
    assert time.monotonic() - began < 5.0  # it would be ten
    ended.set()


@pytest.mark.parametrize("ends", [False, True])
def test_bodies_that_wait_behind_the_zip_as_everything_ends_are_no_error(
    class_folder: Path, monkeypatch: pytest.MonkeyPatch, ends: bool
) -> None:
    classes = Classes()
    classroom = classes.begin(a_room().scenes)
    until_written(classroom)
    begun, made = threading.Event(), threading.Event()
    monkeypatch.setattr(live, "pack", lambda *_: begun.set() or (made.wait(10.0) and b""))
    classroom.pack()
    assert begun.wait(10.0)
    classroom.keep_body(classroom.room.enter(SECRETS[0]).number, b"where it is")
    classroom.poll_writer()
    if ends:
        classroom.end()
        tended(classroom, lambda: classroom.ended)
        classroom.poll_writer()
    made.set()
    classes.close()
    if not ends:
        assert kept.read_bodies(classroom.room.code) == {1: (0, b"where it is")}
        (after,) = taken_up()
        assert after.body(1) == b"where it is"


def test_where_a_body_is_is_kept_only_for_seats_that_there_are(
    class_folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(live, "BODIES_EVERY", 0.1)
    classroom = Classes().begin(a_room().scenes)
    for secret in SECRETS[:3]:
        classroom.keep_body(classroom.room.enter(secret).number, b"x")
    classroom.room.remove(2)
    classroom.keep_body(99, b"of a seat that was given away")
    until_written(classroom)
    classroom.keep_body(3, b"y")
    tended(classroom, lambda: sorted(kept.read_bodies(classroom.room.code)) == [1, 3])


def test_at_the_end_nothing_is_left(class_folder: Path) -> None:
    classes = Classes()
    classroom = classes.begin(a_room().scenes)
    seat = classroom.room.enter(SECRETS[0])
    classroom.keep_body(seat.number, b"x")
    until_written(classroom)
    assert any(class_folder.rglob("*.json"))
    classroom.end()
    tended(classroom, lambda: classroom.ended)
    assert not list(class_folder.iterdir())
    assert classes.find(classroom.room.code) is None
    assert not classroom.room.seats
    assert not list(classes)  # its server forgets it
    classes.close()
    assert not list(class_folder.iterdir())


def test_a_class_that_cannot_be_deleted_goes_on(class_folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    classes = Classes()
    classroom = classes.begin(a_room().scenes)
    classroom.room.enter(SECRETS[0])
    until_written(classroom)

    def refuse(path: Path) -> None:
        (path / kept.FILE).unlink()  # some of it went
        raise PermissionError(errno.EACCES, "Permission denied")

    with monkeypatch.context() as patched:
        patched.setattr("shutil.rmtree", refuse)
        classroom.end()
        tended(classroom, lambda: bool(classroom.notices))
    title, text = classroom.notices.popleft()()
    assert title == "The class goes on"
    assert text == f"Its folder {class_folder / classroom.room.code} cannot be deleted: Permission denied."
    # Answers are taken and kept as before, and it can be ended later.
    classroom.room.enter(SECRETS[1])
    until_written(classroom)
    assert kept.read(classroom.room.code) is not None
    assert classroom.lesson_file().result()
    classroom.end()
    tended(classroom, lambda: classroom.ended)
    assert not list(class_folder.iterdir())


def test_what_a_killed_server_was_forgetting_is_forgotten(
    class_folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    classroom = Classes().begin(a_room().scenes)
    until_written(classroom)
    with monkeypatch.context() as patched:
        patched.setattr("shutil.rmtree", lambda _: None)
        kept.forget(classroom.room.code)
    assert list(class_folder.rglob(kept.FILE))
    taken_up([sim.rope(masses=4)])
    assert not list(class_folder.rglob(kept.FILE))


def bent(data: bytes, dice: random.Random) -> bytes:
    """A file of which a disk or a program has kept something else."""
    cut, made = dice.randrange(len(data)), bytearray(data)
    match dice.randrange(5):
        case 0:
            return data[:cut]
        case 1:
            made[cut] = dice.randrange(256)
        case 2:
            made[cut:cut] = data[cut : cut + dice.randrange(1, 40)]
        case 3:
            del made[cut : cut + dice.randrange(1, 40)]
        case _:
            made[cut:cut] = b"[" * 100_000
    return bytes(made)


def test_a_file_that_makes_no_sense_is_left_alone(
    class_folder: Path, caplog: pytest.LogCaptureFixture
) -> None:
    """Its class does not go on, and the log says so; no server stops at it."""
    classroom = Classes().begin(a_room().scenes)
    classroom.room.enter(SECRETS[0])
    until_written(classroom)
    classroom.keep_body(1, b"x")
    tended(classroom, lambda: (kept.folder_of(classroom.room.code) / kept.BODIES).exists())
    kept.release(classroom.lock)
    whole = {
        name: (class_folder / classroom.room.code / name).read_bytes() for name in (kept.FILE, kept.BODIES)
    }
    dice, read = random.Random(1), 0
    for _ in range(200):
        for name, data in whole.items():
            (class_folder / classroom.room.code / name).write_bytes(bent(data, dice))
        room = kept.read(classroom.room.code)
        kept.read_bodies(classroom.room.code)
        read += room is not None  # what was bent was a name, or white space
    assert read < 100
    for code, text in (("ABCD", "{"), ("ABCE", '{"code": "ABCE"}'), ("notes", "")):
        (class_folder / code).mkdir(parents=True)
        (class_folder / code / kept.FILE).write_text(text)
    (class_folder / classroom.room.code / kept.FILE).write_text("[" * 100_000)
    caplog.clear()
    (other,) = taken_up([sim.rope(masses=4)])
    assert other.room.code not in ("ABCD", "ABCE", classroom.room.code)
    assert sum("cannot go on" in record.message for record in caplog.records) == 3


def test_a_class_has_no_more_steps_than_a_page_can_list() -> None:
    with pytest.raises(Refused, match="60 steps"):
        Classes().begin((sim.rope(),) * 61)
