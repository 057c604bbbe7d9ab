"""How much a page may send, and how fast."""

import itertools
import os
import socket
import time
from types import SimpleNamespace

import pytest
from websockets.exceptions import InvalidStatus
from websockets.protocol import State

from app.classroom.names import LETTERS
from app.gate import gate
from app.gate.address import visitor
from tests.app.hostile import HostilePage, Sandbox, User, eventually, own, pack, served, status


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


@pytest.mark.parametrize("flood_of", ["pings", "pieces of a message"])
def test_a_flood_of_other_frames_cuts_only_its_own_connection(
    sandbox: Sandbox, monkeypatch: pytest.MonkeyPatch, flood_of: str
) -> None:
    monkeypatch.setattr(gate, "EXTRA_FRAME_BURST", 50.0)
    hostile, honest = sandbox.user(), sandbox.user()
    for _ in range(10):
        assert hostile.page.socket.ping().wait(20)
    assert hostile.works()
    with pytest.raises(Exception, match="close"):
        while flood_of == "pings":
            hostile.page.socket.ping()
        hostile.page.socket.send(itertools.repeat(b""))
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
    with served() as server:
        port = server.get_port()
        found = [status(port, own(port), f"/?room=AAA{letter}") for letter in "ABCDEF"]
        assert found == [101, 101, 101, 101, 429, 429]
        assert server.gate.refused == {"rate": 2}
        # A page that is turned away is told so; asking why costs nothing.
        here = ("Host", f"127.0.0.1:{port}")
        asked = [here, ("X-Softrod-Origin", f"http://127.0.0.1:{port}")]
        assert [status(port, asked, "/reach") for _ in range(3)] == [429, 429, 429]
        # Files are no connections.
        assert status(port, [here]) == 200


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


def test_who_opens_page_after_page_keeps_nobody_out(
    sandbox: Sandbox, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(gate, "MAX_TABS", 6)
    many = [sandbox.page() for _ in range(6)]
    with pytest.raises(InvalidStatus):
        sandbox.page()
    others = [HostilePage(sandbox.port, source=f"127.0.0.{number}") for number in (2, 3)]
    sandbox.pages += others
    # The newest pages of who has the most have given way, and do not come back in the others' places.
    assert all(page.is_cut() for page in many[4:])
    with pytest.raises(InvalidStatus):
        sandbox.page()
    sandbox.pages.append(HostilePage(sandbox.port, source="127.0.0.2"))
    with pytest.raises(InvalidStatus):  # that would be three, and nobody has more
        HostilePage(sandbox.port, source="127.0.0.2")
    assert all(page.socket.state is State.OPEN for page in [*many[:3], *others])


def test_who_connects_too_often_leaves_the_others_their_share(
    sandbox: Sandbox, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(gate, "VISITOR_CONNECTION_BURST", 3.0)
    monkeypatch.setattr(gate, "VISITOR_CONNECTIONS_PER_SECOND", 1e-3)
    for _ in range(3):
        sandbox.pages.append(HostilePage(sandbox.port, source="127.0.0.2"))
    with pytest.raises(InvalidStatus, match="429"):
        HostilePage(sandbox.port, source="127.0.0.2")
    sandbox.pages.append(HostilePage(sandbox.port, source="127.0.0.3"))
    # From this machine come its owner's pages, and those of a proxy that does not say for whom it speaks.
    for _ in range(5):
        sandbox.page()
    assert 1.5 * gate.MAX_TABS < 100.0 <= gate.CONNECTION_BURST / 2, "a school may be one address"


def test_who_opens_connections_and_says_nothing_keeps_nobody_out(
    sandbox: Sandbox, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(gate, "MAX_KNOCKING", 5)
    silent = [socket.create_connection(("127.0.0.1", sandbox.port)) for _ in range(6)]
    try:
        assert sandbox.refuses("knocking")
        assert HostilePage(sandbox.port, source="127.0.0.2").socket.state is State.OPEN
        silent.pop(0).close()
        eventually(lambda: status(sandbox.port, [("Host", f"127.0.0.1:{sandbox.port}")]) == 200)
    finally:
        for one in silent:
            one.close()


@pytest.mark.parametrize(
    ("peer", "own", "forwarded", "public", "whose"),
    [
        ("192.168.1.7", "192.168.1.2", [], False, "192.168.1.7"),
        ("::ffff:192.168.1.7", "::", [], False, "192.168.1.7"),
        # Anybody can say that they speak for somebody else; only a proxy is believed, and what it said last.
        ("192.168.1.7", "192.168.1.2", ["1.2.3.4"], False, "192.168.1.7"),
        ("127.0.0.1", "127.0.0.1", ["9.9.9.9, 1.2.3.4", "5.6.7.8"], True, "5.6.7.8"),
        ("127.0.0.1", "127.0.0.1", [], True, "127.0.0.1"),
        ("127.0.0.1", "127.0.0.1", ["nonsense"], True, "127.0.0.1"),
        # All addresses of a customer, but each one of the own network.
        ("127.0.0.1", "127.0.0.1", ["2001:db8:1:2:3::4"], True, "2001:db8:1:2::/64"),
        ("2001:db8:1:2:3::4", "2001:db8:9:9::1", [], False, "2001:db8:1:2::/64"),
        ("2001:db8:1:2:3::4", "2001:db8:1:2::1", [], False, "2001:db8:1:2:3::4"),
    ],
)
def test_whose_share_a_connection_takes(
    peer: str, own: str, forwarded: list[str], public: bool, whose: str
) -> None:
    assert visitor(peer, own, forwarded, public) == whose
