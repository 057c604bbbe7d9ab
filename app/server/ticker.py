"""The one thread that steps and draws all tabs, sixty times a second; without tabs it sleeps.

With many tabs the rate falls, down to 25 a second, and pages interpolate between frames. A calm page, where
nothing moves and nobody does anything, gets a frame a second until it sends something. Steps of heavy bodies
run in threads of their own, since kernels release the interpreter.
"""

from __future__ import annotations

import contextlib
import logging
import threading
import time
from collections import deque
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor

import viser

from ..pages.sandbox.tab import CALM_FRAME, Tab
from ..session.session import FRAME

BUDGET = 0.7
"""Part of a frame for the solver, for all tabs; the rest is for drawing and the network."""

LONGEST_FRAME = 1.0 / 25.0
"""Seconds of a frame, at most, regardless of the number of tabs."""

WORKED = 0.75
"""Part of a frame that the ticker may take; the rest is left to the event loop, which serves the network."""

CALM_LOOK = 0.1
"""Seconds between two checks for something to do, while all pages are calm and none sends anything."""

HEAVY_THREADS = 2
"""Threads for heavy bodies, all tabs together."""

_log = logging.getLogger(__name__)


class Ticker:
    """Makes, steps, draws and drops tabs.

    Args:
        make_tab: makes the tab of a page that has connected.

    Attributes:
        tabs: client id to tab; only the ticker's thread changes it.
        drawn: set once the first page is drawn.
    """

    def __init__(self, make_tab: Callable[[viser.ClientHandle], Tab]) -> None:
        self._make_tab = make_tab
        self._arrivals_and_departures: deque[viser.ClientHandle | int] = deque()  # of clients, and of ids
        self._wake = threading.Event()
        self._stopping = False
        self._frame = FRAME
        self._workers = ThreadPoolExecutor(HEAVY_THREADS, thread_name_prefix="softrod-heavy")
        self._thread = threading.Thread(target=self._run, name="softrod-ticker", daemon=True)
        self._news = threading.Event()  # a page has sent something
        self._calm_due: dict[int, float] = {}
        self.tabs: dict[int, Tab] = {}
        self.drawn = threading.Event()

    @property
    def asleep(self) -> bool:
        """Whether it does nothing until a page connects."""
        return not self._wake.is_set()

    def attach(self, server: viser.ViserServer) -> None:
        """Learn of pages that come and go, and start ticking."""

        @server.on_client_connect
        async def _(client: viser.ClientHandle) -> None:
            self._arrivals_and_departures.append(client)
            self._wake.set()
            self._news.set()

        @server.on_client_disconnect
        async def _(client: viser.ClientHandle) -> None:
            self._arrivals_and_departures.append(client.client_id)
            self._wake.set()

        self._thread.start()

    def hear(self, client_id: int) -> None:
        """Note that a page has sent something; any thread may call."""
        if (tab := self.tabs.get(client_id)) is not None:
            tab.stir()
        self._news.set()

    def stop(self) -> None:
        """Stop after the present frame, and wait for its end."""
        self._stopping = True
        self._wake.set()
        self._news.set()
        self._thread.join(timeout=10.0)
        self._workers.shutdown(wait=False, cancel_futures=True)

    def _run(self) -> None:
        due = time.monotonic()
        while not self._stopping:
            if not self.tabs:
                self._wake.clear()
                if not self._arrivals_and_departures and not self._stopping:
                    self._wake.wait()
                due = time.monotonic()
            began = time.monotonic()
            self._come_and_go()
            for client_id, tab in list(self.tabs.items()):
                self._tick(client_id, tab, began)
            now = time.monotonic()
            self._frame = next_frame(self._frame, now - began)
            due = max(due + self._frame, now - FRAME)
            if all(tab.is_calm for tab in self.tabs.values()):
                self._news.wait(CALM_LOOK)
            else:
                time.sleep(max(0.0, due - now))
            self._news.clear()

    def _tick(self, client_id: int, tab: Tab, began: float) -> None:
        """Give a tab its frame, unless it is calm and has had one lately."""
        calm = tab.is_calm
        if calm and began < self._calm_due.get(client_id, 0.0):
            return
        self._calm_due[client_id] = began + CALM_FRAME
        try:
            share = BUDGET * (CALM_FRAME if calm else self._frame) / len(self.tabs)
            if tab.frame(share, self._workers.submit):
                tab.client.flush()
        except Exception:
            # The page left in the middle of a frame, or there is a defect: the other tabs continue.
            _log.exception("the tab %s is closed after an error", client_id)
            self.tabs.pop(client_id, None)
            tab.leave()
            _say_stopped(tab.client)

    def _come_and_go(self) -> None:
        while self._arrivals_and_departures:
            client = self._arrivals_and_departures.popleft()
            try:
                if isinstance(client, int):
                    self._calm_due.pop(client, None)
                    if (tab := self.tabs.pop(client, None)) is not None:
                        tab.leave()
                else:
                    self.tabs[client.client_id] = self._make_tab(client)
                    client.flush()
                    self.drawn.set()
            except Exception:
                _log.exception("a page could not be set up, or taken out of its class")


def _say_stopped(client: viser.ClientHandle) -> None:
    """Tell a page, if it is still there, that it has stopped."""
    with contextlib.suppress(Exception):
        text = "There was an error on the server. Reload the page to go on."
        client.add_notification("This page has stopped", text, color="red")
        client.flush()


def next_frame(frame: float, worked: float) -> float:
    """Length of the next frame, s, after one in which all tabs together took `worked` seconds."""
    wanted = min(max(worked / WORKED, FRAME), LONGEST_FRAME)
    return frame + 0.1 * (wanted - frame)
