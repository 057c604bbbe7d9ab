"""The one thread that steps and draws all tabs, sixty times a second; with no tab it sleeps."""

from __future__ import annotations

import logging
import threading
import time
from collections import deque
from collections.abc import Callable

import viser

from ..page.tab import Tab
from ..session.session import FRAME

BUDGET = 0.7 * FRAME
"""Computing time of a frame, for all tabs together; the rest of the frame is for drawing and the network."""

_log = logging.getLogger(__name__)


class Ticker:
    """Makes, steps, draws and drops tabs.

    Args:
        make_tab: a tab for a page that connected.

    Attributes:
        tabs: client id to tab; the ticker's thread alone changes it.
        drawn: set once the first page has its picture.
    """

    def __init__(self, make_tab: Callable[[viser.ClientHandle], Tab]) -> None:
        self._make_tab = make_tab
        self._arrivals: deque[viser.ClientHandle] = deque()
        self._departures: deque[int] = deque()
        self._wake = threading.Event()
        self._stopping = False
        self._thread = threading.Thread(target=self._run, name="softrod-ticker", daemon=True)
        self.tabs: dict[int, Tab] = {}
        self.drawn = threading.Event()

    def attach(self, server: viser.ViserServer) -> None:
        """Hear of pages that come and go, and start ticking."""

        @server.on_client_connect
        async def _(client: viser.ClientHandle) -> None:
            self._arrivals.append(client)
            self._wake.set()

        @server.on_client_disconnect
        async def _(client: viser.ClientHandle) -> None:
            self._departures.append(client.client_id)
            self._wake.set()

        self._thread.start()

    def stop(self) -> None:
        """Stop after the present frame, and wait for it."""
        self._stopping = True
        self._wake.set()
        self._thread.join(timeout=10.0)

    def _run(self) -> None:
        due = time.monotonic()
        while not self._stopping:
            if not self.tabs and not self._arrivals:
                self._wake.clear()
                if not self._arrivals and not self._departures and not self._stopping:
                    self._wake.wait()
                due = time.monotonic()
            self._come_and_go()
            for client_id, tab in list(self.tabs.items()):
                try:
                    tab.frame(BUDGET / len(self.tabs))
                    tab.client.flush()
                except Exception:
                    # A page that went away in the middle of a frame, or a defect: the other tabs go on.
                    _log.exception("the tab %s is closed after an error", client_id)
                    self.tabs.pop(client_id, None)
            due = max(due + FRAME, time.monotonic() - FRAME)
            time.sleep(max(0.0, due - time.monotonic()))

    def _come_and_go(self) -> None:
        while self._arrivals:
            client = self._arrivals.popleft()
            try:
                self.tabs[client.client_id] = self._make_tab(client)
                client.flush()
                self.drawn.set()
            except Exception:
                _log.exception("a page could not be set up")
        while self._departures:
            self.tabs.pop(self._departures.popleft(), None)
