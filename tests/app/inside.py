"""The few looks that these tests take at an inside, viser's or the server's own; no other file takes any, but
`test_viser_inside.py`, whose subject is viser's."""

from __future__ import annotations

import asyncio
from types import SimpleNamespace
from typing import Any

import viser
from viser import _messages as viser_messages
from viser.infra import _infra as viser_infra
from viser.infra._messages import wire_field_names

from app.classroom.live import Class
from app.features.measure.panel import MeasurePanel
from app.gate.gate import Gate
from app.pages.sandbox.tab import Tab
from app.server.ticker import Ticker
from app.session.samples import Samples
from app.session.session import Session
from app.stage.sketch import Mapping
from app.ui import controls
from app.ui.queues import BoundedQueue
from tests.app.letters import Letters
from tests.app.pages import SessionPage
from tests.app.panels import page_of

__all__ = [
    "Bare",
    "fail_to_save",
    "first_plot",
    "guard",
    "only_page",
    "press",
    "room_of",
    "sandboxes",
    "uuid_of",
    "viser_infra",
    "viser_messages",
    "wire_field_names",
]


def uuid_of(element: Any) -> str:
    """The name of a control or a command on the wire."""
    return element._impl.uuid


def first_plot(panel: MeasurePanel) -> Any:
    """The first of the open plots of a tab."""
    return panel.plots._plots[0]


def room_of(samples: Samples) -> int:
    """The bytes that the samples of a plot take."""
    return sum(level._room.nbytes for level in samples._levels)


def fail_to_save(classroom: Class, error: OSError) -> None:
    """Have a class fail to save itself."""
    classroom._report(error)


def press(handle: Any, value: object = None) -> None:
    """Use one of viser's own controls as a page's user does: press it, or choose a value."""
    if value is not None:
        handle.value = value
    event: viser.GuiEvent[Any] = viser.GuiEvent(client=None, client_id=1, target=handle)
    for handler in tuple(handle._impl.update_cb):
        asyncio.run(handler(event))


def sandboxes(ticker: Ticker) -> dict[int, Tab]:
    """The tabs of a server's pages that are viser's, by their numbers."""
    return {number: tab for number, tab in list(ticker.tabs.items()) if isinstance(tab, Tab)}


def only_page(gate: Gate, client_id: int, request: Any) -> None:
    """Have a gate know of one page, by the request with which it came."""
    live = {client_id: SimpleNamespace(request=request, visitor="")}
    gate._server = SimpleNamespace(_websock_server=SimpleNamespace(_live_connections=live))  # type: ignore


def guard(session: Session, lock: Any) -> None:
    """Have another lock guard what waits for a session."""
    session._lock = lock


class Bare(Tab):
    """A tab with a session that only takes commands, and nothing that is shown."""

    def __init__(self, names: controls.Controls = controls.ALL) -> None:
        self.posted: list[Any] = []
        session = SessionPage("tutorial-3.3").session
        session.post = self.posted.append  # type: ignore
        self._session, self._page = session, page_of(session)
        self._page.controls = names
        self._role = None
        self._receivers = {}
        self._add_features()
        self._page.mapping = Mapping(center=(300.0, 300.0), scale=0.01, flip=-1.0)
        self._mail = Letters()
        self._requests = BoundedQueue(print)

    @property
    def done(self) -> list[Any]:
        """What it had done: commands, letters to the page, and requests to the ticker."""
        assert isinstance(self._mail, Letters)
        return [*self.posted, *self._mail.sent, *[self._requests.take() for _ in range(len(self._requests))]]
