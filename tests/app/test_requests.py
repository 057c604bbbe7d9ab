"""What a page's script asks for is done in order, and letters do not take each other's place."""

from __future__ import annotations

import base64
import codecs
import threading
import zlib
from pathlib import Path
from queue import Queue

import pytest

import sim
from app.features.edit.feature import EditFeature
from app.features.files.feature import FilesFeature
from app.features.files.panel import open_file
from app.features.gallery.messages import ListScenes
from app.pages.sandbox import requests
from app.session.notices import Notice
from app.ui import controls, queues
from app.ui.queues import MAX_WAITING, BoundedQueue, SerialQueue, too_much
from app.wire.from_page import Part, Unsent
from app.wire.to_page import Resumed
from sim.store import files
from tests.app.hostile import eventually
from tests.app.panels import page_of
from tests.app.recording import busy_page, log_of
from tests.app.test_gallery import Page

LIMIT = 20.0
"""Seconds, at most, until other threads have done their work."""


def wait(event: threading.Event) -> None:
    """Keep a thread busy until then."""
    event.wait(LIMIT)


def fail() -> None:
    """A defect."""
    raise ValueError


def test_a_request_that_fails_does_not_stop_those_after_it(caplog: pytest.LogCaptureFixture) -> None:
    line, end = SerialQueue(print), threading.Event()
    line.submit(fail)
    line.submit(end.set)
    assert end.wait(LIMIT)
    assert "a request of a page failed" in caplog.text


def test_a_page_that_asks_endlessly_keeps_neither_memory_nor_the_threads_of_others(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    told, done = list[Notice](), list[int]()
    line, others = (SerialQueue(told.append) for _ in range(2))
    busy, go, end = (threading.Event() for _ in range(3))
    line.submit(lambda: busy.set() or wait(go))
    assert busy.wait(LIMIT), "and so it waits in the line no more"
    with monkeypatch.context() as patch:
        patch.setattr(queues.threads, "submit", lambda *_: pytest.fail("it takes more of the threads' room"))
        for number in range(10 * MAX_WAITING):
            line.submit(done.append, number)
    others.submit(end.set)
    assert end.wait(LIMIT), "another page is answered meanwhile"
    go.set()
    assert eventually(lambda: len(done) == MAX_WAITING)
    # What there was room for is done in order, and one notice says that the rest is not.
    assert done == list(range(MAX_WAITING))
    assert told == [too_much()]
    last = threading.Event()
    line.submit(last.set)
    assert last.wait(LIMIT)


def test_a_full_queue_says_so_once_until_it_is_empty() -> None:
    told: list[Notice] = []
    queue: BoundedQueue[int] = BoundedQueue(told.append, 2)
    for _ in range(2):
        for number in range(5):
            queue.add(number)
        assert [queue.take(), queue.take()] == [0, 1]
        assert len(queue) == 0
    assert told == [too_much(), too_much()]


def test_texts_that_are_never_finished_are_bounded() -> None:
    page = Page()
    readers = (FilesFeature(page.page), EditFeature(page.page))
    answering = requests.RequestHandler(page.page, readers, print)
    letters = "A" * 48_000
    for kind in ("resume", "link", "file", "paste"):
        for number in range(1, 99):
            answering.take(Part(kind, number, 99, letters))  # type: ignore[arg-type]
            held = sum(parts.size for parts in answering.unfinished)
            assert held <= requests.MAX_UNFINISHED
    assert too_much() in page.notices


def test_no_event_takes_the_place_of_another(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path))
    files.save_user_scene(sim.rope(), "mine")
    page = Page()
    page.gallery.offer()
    page.gallery.list(ListScenes(dark=False))
    page.gallery.changed()
    page.gallery.changed()
    assert len(set(page.letters.keys)) == len(page.letters.keys) == 5


class Asking(Page):
    """A page whose requests are handled, with the files feature alone."""

    def __init__(self) -> None:
        super().__init__()
        self._noticed: Queue[Notice] = Queue()
        self.whole = page_of(self.session, None, self.letters, self._noticed.put)
        self.handler = requests.RequestHandler(self.whole, (FilesFeature(self.whole),), print)

    def notice(self) -> Notice:
        """Wait for a notice."""
        return self._noticed.get(timeout=LIMIT)


def test_what_the_page_cannot_send_is_told() -> None:
    asking = Asking()
    asking.handler.ask(Unsent("file"))
    notice = asking.notice()
    assert notice.title == "That cannot be opened"
    assert "at most 4.7 MB" in notice.text


def test_a_page_that_gives_back_nonsense_keeps_what_comes_after_it() -> None:
    page = Asking()
    page.handler.take(Part("resume", 1, 1, "bm9uc2Vuc2U="))
    assert page.letters.sent == [Resumed()]


def packed(name: str, data: bytes) -> str:
    """A file, as a page sends it."""
    return f"{name}:{base64.b64encode(zlib.compress(data)).decode()}"


def test_a_file_is_opened_where_there_is_a_share_tab_and_a_broken_one_is_told() -> None:
    page = Asking()
    for there, name, data in (
        (controls.Controls(("play",)), "hidden.json", b"{"),
        (controls.ALL, "rod%20one.json", files.encode_scene(sim.load_scene("rod"))),
        (controls.ALL, "b%C3%A4d.json", b"{"),
    ):
        page.whole.controls = there
        page.handler.take(Part("file", 1, 1, packed(name, data)))
    notice = page.notice()  # the only one
    page.session.drain()
    assert page.session.scene.name == "rod"
    assert notice.title == "That did not work"
    assert notice.text.startswith("bäd.json: ")


RING = files.encode_scene(sim.load_scene("ring"))


@pytest.mark.parametrize(
    ("name", "data", "said"),
    [
        ("newer.json", RING.replace(b'"format": ', b'"format": 9'), "newer"),
        ("range.json", RING.replace(b'"mass": ', b'"mass": -', 1), "masses[0].mass"),
        # Within what can be sent, over what a scene may have.
        ("large.json", b" " * 5_100_000, "5000000"),
        (
            "log.jsonl",
            b'{"do": "move", "mass": "x", "to": [0, 0]}\n',
            "mass: a whole number is expected, not 'x'",
        ),
    ],
)
def test_a_bad_file_is_one_sentence_and_changes_nothing(name: str, data: bytes, said: str) -> None:
    page = Page()
    if name.endswith(".jsonl"):
        data = log_of(page) + data
    scene = page.session.scene
    open_file(page.page, packed(name, data))
    page.frames(2)
    (notice,) = page.notices
    assert notice.title == "That did not work"
    assert name in notice.text and said in notice.text
    assert page.session.scene is scene


def test_a_log_that_an_editor_has_saved_is_played() -> None:
    page, other = busy_page(sim.load_scene("tutorial-3.3")), Page()
    open_file(other.page, packed("again.jsonl", codecs.BOM_UTF8 + log_of(page)))
    other.frames(500)
    assert "It agrees with the log" in other.told
    assert (other.simulation.positions == page.simulation.positions).all()
