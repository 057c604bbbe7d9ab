"""How much a page may send, and how fast."""

import os
import time
from collections.abc import Iterator
from types import SimpleNamespace

import pytest
from websockets.exceptions import InvalidStatus

from app.classroom.names import LETTERS
from app.gate import gate
from tests.app.hostile import HANDSHAKE, HostilePage, Sandbox, User, pack, status


@pytest.fixture
def sandbox() -> Iterator[Sandbox]:
    sandbox = Sandbox()
    yield sandbox
    sandbox.close()


def flood(user: User, count: int) -> list[tuple[str, str]]:
    """Send many values at once; the events that must come of them."""
    values = [f"value {number}" for number in range(count)]
    user.page.send(*(user.update(user.text, value) for value in values))
    return [("text", value) for value in values]


def test_who_was_quiet_has_saved_up_no_more_than_a_burst(monkeypatch: pytest.MonkeyPatch) -> None:
    moments = iter((0.0, 3600.0, 3600.5))
    monkeypatch.setattr(gate, "time", SimpleNamespace(monotonic=lambda: next(moments)))
    budget = gate.Budget(rate=10.0, burst=20.0)
    assert budget.spend(40.0) == 2.0  # seconds until it is paid back
    assert budget.left == -15.0


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
    user.page.send(*[user.update(user.text, "x" * 100_000)] * 45)
    assert sandbox.refuses("size", 45)
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
    text = os.urandom(30_000).hex()
    data = pack(user.update(user.text, text))
    user.page.socket.send(data[start : start + 4096] for start in range(0, len(data), 4096))
    assert user.next_event() == ("text", text)


def test_who_tries_the_letters_of_a_class_one_after_the_other_is_slowed_down(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(gate, "CONNECTION_BURST", 4.0)
    monkeypatch.setattr(gate, "CONNECTIONS_PER_SECOND", 1e-3)
    sandbox = Sandbox()
    try:
        own = f"127.0.0.1:{sandbox.port}"
        page = [("Host", own), ("Origin", f"http://{own}"), *HANDSHAKE]
        found = [status(sandbox.port, page, f"/?room=AAA{letter}") for letter in "ABCDEF"]
        assert found == [101, 101, 101, 101, 429, 429]
        assert sandbox.refuses("rate", 2)
        # A page that is turned away is told so; asking why costs nothing.
        asked = [("Host", own), ("X-Softrod-Origin", f"http://{own}")]
        assert [status(sandbox.port, asked, "/reach") for _ in range(3)] == [429, 429, 429]
        # Files are no connections.
        assert status(sandbox.port, [("Host", own)]) == 200
    finally:
        sandbox.close()


def test_a_full_server_s_pages_may_all_come_back_at_once_and_all_letters_take_hours() -> None:
    assert 3 * gate.MAX_TABS < gate.CONNECTION_BURST
    assert len(LETTERS) ** 4 / gate.CONNECTIONS_PER_SECOND > 12 * 3600


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
    # So there are ten now.
    monkeypatch.setattr(gate, "MAX_TABS", 10)
    with pytest.raises(InvalidStatus):
        sandbox.page()
    monkeypatch.setattr(gate, "MAX_TABS", 11)
    sandbox.page()
