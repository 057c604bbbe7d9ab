"""Lines: what travels to the pages of a class, and what becomes of it where a page is slow."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.wire import line as lines
from app.wire.carrier import Letter
from app.wire.line import Line, batch, unbatched


@given(st.lists(st.tuples(st.text(), st.none() | st.lists(st.floats(width=32, allow_nan=False), min_size=1))))
def test_a_batch_is_read_as_it_was_written(letters: list[tuple[str, list[float] | None]]) -> None:
    made = [Letter(text, None if n is None else np.array(n, np.float32), "") for text, n in letters]
    data = batch(made)
    assert len(data) % 4 == 0
    read = unbatched(data)
    assert [one.text for one in read] == [one.text for one in made]
    for one, other in zip(read, made, strict=True):
        assert (one.numbers is None) == (other.numbers is None)
        if one.numbers is not None and other.numbers is not None:
            np.testing.assert_array_equal(one.numbers, other.numbers)


class Network:
    """A connection whose other end takes what it likes.

    Attributes:
        sent: batches.
        unread: bytes that the other end has not taken yet.
        cut: whether it was cut.
    """

    def __init__(self) -> None:
        self.sent: list[bytes] = []
        self.unread, self.cut = 0, False
        self.transport = SimpleNamespace(
            is_closing=lambda: self.cut,
            get_write_buffer_size=lambda: self.unread,
            abort=lambda: setattr(self, "cut", True),
        )

    def texts(self) -> list[list[str]]:
        return [[letter.text for letter in unbatched(data)] for data in self.sent]


@pytest.fixture
def network(monkeypatch: pytest.MonkeyPatch) -> Network:
    made = Network()

    def send(connections: Any, data: bytes) -> None:
        for connection in connections:
            connection.sent.append(data)

    monkeypatch.setattr(lines, "broadcast", send)
    return made


Flush = Callable[[], Awaitable[None]]


def in_a_loop(network: Network, act: Callable[[Line, Flush], Awaitable[None]]) -> None:
    """Act on a line by this network; the second argument flushes it."""

    async def go() -> None:
        connection: Any = network
        line = Line(connection, asyncio.get_running_loop())

        async def flush() -> None:
            lines.flush((line,))
            await asyncio.sleep(0)

        await act(line, flush)

    asyncio.run(go())


def test_of_letters_with_one_key_the_last_is_sent_and_late_ones_are_later(network: Network) -> None:
    async def act(line: Line, flush: Flush) -> None:
        for text, key in (("a1", "a"), ("b", "b"), ("a2", "a")):
            line.post(Letter(text, None, key))
        assert line.waits
        await flush()
        await flush()
        assert network.texts() == [["b", "a2"]]
        assert not line.waits

    in_a_loop(network, act)


def test_a_page_that_does_not_read_gets_what_is_new_once_it_does(network: Network) -> None:
    async def act(line: Line, flush: Flush) -> None:
        network.unread = 1
        for text in ("old", "new"):
            line.post(Letter(text, None, "state"))
            await flush()
        assert not network.sent
        assert line.waits
        network.unread = 0
        await flush()
        assert network.texts() == [["new"]]

    in_a_loop(network, act)


def test_a_page_for_which_too_much_waits_is_cut(network: Network) -> None:
    async def act(line: Line, flush: Flush) -> None:
        network.unread = 1
        for i in range(lines.MAX_WAITING + 1):
            line.post(Letter("event", None, str(i)))
        await flush()
        assert network.cut
        assert not network.sent

    in_a_loop(network, act)


def test_a_picture_for_all_leaves_out_whoever_is_behind(network: Network) -> None:
    async def act(line: Line, flush: Flush) -> None:
        picture = Letter("picture", np.ones(3, np.float32), "frame")
        for behind in (False, True):
            network.unread = int(behind)
            lines.send_at_once((line,), picture)
            await asyncio.sleep(0)
        network.unread = 0
        line.post(Letter("plan", None, "plan"))
        lines.send_at_once((line,), picture)  # the plan that it belongs to is still to be sent
        await asyncio.sleep(0)
        assert network.texts() == [["picture"]]
        lines.send_at_once((), picture)

    in_a_loop(network, act)
