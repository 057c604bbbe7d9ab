"""How much a page may send, and how fast."""

import os
import time
from collections.abc import Iterator

import pytest
from viser import UploadedFile
from websockets.exceptions import InvalidStatus

from app.gate import gate, uploads
from app.gate.messages import UPLOAD_PART_BYTES
from app.gate.uploads import MAX_UPLOAD_BYTES
from tests.app.hostile import HostilePage, Sandbox, User, eventually, pack, uuid_of

PART = UPLOAD_PART_BYTES


@pytest.fixture
def sandbox() -> Iterator[Sandbox]:
    sandbox = Sandbox()
    yield sandbox
    sandbox.close()


@pytest.mark.parametrize("size", [0, 1, 5_000, PART, PART + 1, MAX_UPLOAD_BYTES])
def test_an_honest_file_reaches_its_callback(sandbox: Sandbox, size: int) -> None:
    user = sandbox.user()
    content = os.urandom(size)
    user.page.send(user.upload_start(size), *user.upload_parts(content))
    assert user.next_event() == ("upload", UploadedFile("scene.json", content))
    assert not sandbox.server.gate.refused
    assert not sandbox.oversized


def test_one_file_after_another(sandbox: Sandbox) -> None:
    user = sandbox.user()
    for number in range(uploads.MAX_UPLOADS_PER_TAB + 3):
        content = os.urandom(100)
        transfer = f"file {number}"
        user.page.send(user.upload_start(100, transfer), user.upload_part(0, content, transfer))
        assert user.next_event() == ("upload", UploadedFile("scene.json", content))


def test_too_large_a_file_is_refused_before_any_of_it_is_stored(sandbox: Sandbox) -> None:
    user, honest = sandbox.user(), sandbox.user()
    content = bytes(MAX_UPLOAD_BYTES + 1)
    user.page.send(user.upload_start(len(content)), *user.upload_parts(content))
    assert eventually(lambda: sandbox.server.gate.refused["upload"] == len(user.upload_parts(content)))
    assert sandbox.server.gate.refused["oversized upload"] == 1
    assert sandbox.oversized == [(user.client.client_id, "scene.json")]
    assert not user.client.gui._current_file_upload_states
    # The page is told that the transfer is over, or its button would stay blocked.
    assert eventually(lambda: user.page.received("RemoveNotificationMessage"))
    assert user.page.received("RemoveNotificationMessage")[0]["uuid"] == "upload-one"
    assert user.page.received("FileTransferPartAck")[0]["source_component_uuid"] == uuid_of(user.upload)
    assert not honest.page.received("FileTransferPartAck")
    assert user.is_quiet()
    assert honest.is_quiet()
    user.page.send(user.upload_start(3, "two"), user.upload_part(0, b"abc", "two"))
    assert user.next_event() == ("upload", UploadedFile("scene.json", b"abc"))


def test_an_error_in_the_callback_costs_no_connection(sandbox: Sandbox) -> None:
    del sandbox.oversized
    user = sandbox.user()
    user.page.send(user.upload_start(MAX_UPLOAD_BYTES + 1))
    assert sandbox.refuses("oversized upload")
    assert user.is_quiet()


def test_a_file_larger_than_it_claims_is_not_stored(sandbox: Sandbox) -> None:
    user, honest = sandbox.user(), sandbox.user()
    user.page.send(user.upload_start(PART + 10))
    lies = [
        user.upload_part(1, bytes(PART)),
        user.upload_part(1, bytes(11)),
        user.upload_part(0, bytes(9)),
        user.upload_part(0, b""),
        user.upload_part(2, bytes(10)),
        user.upload_part(10**9, b""),
    ]
    user.page.send(*lies)
    assert sandbox.refuses("upload", len(lies))
    assert user.bytes_held() == 0
    user.page.send(user.upload_part(1, b"0123456789"), user.upload_part(1, b"0123456789"))
    assert sandbox.refuses("upload", len(lies) + 1)
    assert user.is_quiet()
    assert honest.is_quiet()
    assert user.bytes_held() == 10


@pytest.mark.parametrize(("size", "parts"), [(10, 10**9), (10, 0), (0, 1), (PART + 1, 1), (PART, 2)])
def test_a_file_of_an_odd_number_of_parts_is_refused(sandbox: Sandbox, size: int, parts: int) -> None:
    user = sandbox.user()
    user.page.send({**user.upload_start(size), "part_count": parts})
    assert sandbox.refuses("upload")
    assert not user.client.gui._current_file_upload_states


def test_uploads_under_way_are_limited(sandbox: Sandbox) -> None:
    user, honest = sandbox.user(), sandbox.user()
    starts = [user.upload_start(10, f"file {number}") for number in range(uploads.MAX_UPLOADS_PER_TAB + 2)]
    user.page.send(*starts)
    assert sandbox.refuses("upload", 2)
    honest.page.send(honest.upload_start(3, "mine"), honest.upload_part(0, b"abc", "mine"))
    assert honest.next_event() == ("upload", UploadedFile("scene.json", b"abc"))
    user.page.send(user.upload_part(0, bytes(10), "file 0"))
    assert user.next_event()[0] == "upload"
    user.page.send(user.upload_start(1, "later"), user.upload_part(0, b"x", "later"))
    assert user.next_event() == ("upload", UploadedFile("scene.json", b"x"))


def test_a_tab_that_leaves_gives_up_its_uploads(sandbox: Sandbox, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(uploads, "MAX_UPLOADS", 1)
    user, honest = sandbox.user(), sandbox.user()
    user.page.send(user.upload_start(10, "left behind"))
    assert user.works()
    honest.page.send(honest.upload_start(1, "blocked"))
    assert sandbox.refuses("upload")
    user.page.close()
    assert eventually(lambda: user.client.client_id not in sandbox.server.get_clients())
    honest.page.send(honest.upload_start(1, "mine"), honest.upload_part(0, b"x", "mine"))
    assert honest.next_event() == ("upload", UploadedFile("scene.json", b"x"))


def test_another_tabs_upload_is_out_of_reach(sandbox: Sandbox) -> None:
    shared = sandbox.server.gui.add_upload_button("shared")
    victim, hostile = sandbox.user(), sandbox.user()

    def of_shared(message: dict[str, object]) -> dict[str, object]:
        return {**message, "source_component_uuid": uuid_of(shared)}

    victim.page.send(of_shared(victim.upload_start(3)))
    assert victim.works()
    hostile.page.send(of_shared(hostile.upload_start(3)), of_shared(hostile.upload_part(0, b"bad")))
    assert sandbox.refuses("upload", 2)
    victim.page.send(of_shared(victim.upload_part(0, b"abc")))
    assert eventually(lambda: shared.value.content)
    assert shared.value == UploadedFile("scene.json", b"abc")


def test_only_an_upload_button_takes_a_file(sandbox: Sandbox) -> None:
    user = sandbox.user()
    slider = {"source_component_uuid": uuid_of(user.slider)}
    user.page.send({**user.upload_start(3), **slider})
    assert sandbox.refuses("handle")
    sandbox.server.gate.refused.clear()
    user.page.send(user.upload_start(3), {**user.upload_part(0, b"abc"), **slider})
    assert sandbox.refuses("upload")
    assert user.is_quiet()
    assert user.slider.value == 5.0


def flood(user: User, count: int) -> list[tuple[str, str]]:
    """Send many values at once; the events that must come of them."""
    values = [f"value {number}" for number in range(count)]
    user.page.send(*(user.update(user.text, value) for value in values))
    return [("text", value) for value in values]


def test_a_flood_is_slowed_down_and_nothing_is_lost(
    sandbox: Sandbox, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(gate, "MESSAGES_PER_SECOND", 500.0)
    monkeypatch.setattr(gate, "MESSAGE_BURST", 100.0)
    hasty, honest = sandbox.user(), sandbox.user()
    started = time.monotonic()
    expected = flood(hasty, 1100)
    answered = 0
    while hasty.events.qsize() < len(expected):
        assert honest.works()
        answered += 1
    assert [hasty.next_event() for _ in expected] == expected
    # The camera's message counts too. A slow machine takes longer, never less.
    assert time.monotonic() - started >= 0.95 * (len(expected) - 100) / 500
    assert answered > 1
    assert not sandbox.server.gate.refused


def test_large_messages_count_by_their_bytes(sandbox: Sandbox, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(gate, "MESSAGES_PER_SECOND", 100.0)
    monkeypatch.setattr(gate, "MESSAGE_BURST", 10.0)
    user, honest = sandbox.user(), sandbox.user()
    started = time.monotonic()
    user.page.send(*(user.upload_part(index, bytes(PART), "none") for index in range(10)))
    assert sandbox.refuses("upload", 10)
    assert user.works()
    assert time.monotonic() - started >= 0.7
    assert honest.works()


def test_what_a_page_does_in_a_second_is_not_slowed_down() -> None:
    # 240 pointer positions, twenty cameras and twenty values each of ten sliders, for ten seconds.
    assert gate.MESSAGES_PER_SECOND > 2 * (240 + 20 + 10 * 20)


def test_a_flood_of_refused_messages_disturbs_nobody(sandbox: Sandbox) -> None:
    hostile, honest = sandbox.user(), sandbox.user()
    hostile.page.send(*({"type": "ShareUrlRequest"} for _ in range(3000)))
    assert honest.works()
    assert sandbox.refuses("type", 3000)
    assert honest.is_quiet()
    assert hostile.is_quiet()


def test_a_flood_of_pings_cuts_only_its_own_connection(
    sandbox: Sandbox, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(gate, "EXTRA_FRAME_BURST", 50.0)
    hostile, honest = sandbox.user(), sandbox.user()
    for _ in range(10):
        assert hostile.page.socket.ping().wait(20)
    assert hostile.works()
    with pytest.raises(Exception, match="close"):
        while True:
            hostile.page.socket.ping()
    assert sandbox.refuses("frames")
    assert honest.works()


def test_an_endless_message_cuts_only_its_own_connection(
    sandbox: Sandbox, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(gate, "EXTRA_FRAME_BURST", 50.0)
    hostile, honest = sandbox.user(), sandbox.user()

    def nothing() -> Iterator[bytes]:
        while True:
            yield b""

    with pytest.raises(Exception, match="close"):
        hostile.page.socket.send(nothing())
    assert sandbox.refuses("frames")
    assert honest.works()


def test_a_message_in_pieces_is_put_together(sandbox: Sandbox) -> None:
    user = sandbox.user()
    content = os.urandom(PART)
    user.page.send(user.upload_start(PART))
    data = pack(user.upload_part(0, content))
    user.page.socket.send(data[start : start + 4096] for start in range(0, len(data), 4096))
    assert user.next_event() == ("upload", UploadedFile("scene.json", content))


def test_a_page_that_comes_back_takes_the_place_of_its_dead_connection(
    sandbox: Sandbox, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(gate, "MAX_TABS", 2)
    other = sandbox.user()
    old = HostilePage(sandbox.port, "/at/" + 32 * "a")
    sandbox.pages.append(old)
    # There is no room for a third, but the same page may come once more.
    with pytest.raises(InvalidStatus):
        HostilePage(sandbox.port, "/at/" + 32 * "b")
    new = HostilePage(sandbox.port, "/at/" + 32 * "a")
    sandbox.pages.append(new)
    assert old.is_cut()
    assert other.works()
    # Pages without a name, or with one that is none, are nobody's former selves.
    monkeypatch.setattr(gate, "MAX_TABS", 20)
    for path in ("", "/at/", "/at/AAAA", "/at/" + 33 * "a"):
        sandbox.pages.append(HostilePage(sandbox.port, path))
        sandbox.pages.append(HostilePage(sandbox.port, path))
    assert len(sandbox.server.gate._tabs) == 10
