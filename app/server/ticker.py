"""The one thread that steps and draws all tabs, sixty times a second; with no tab it sleeps.

With many tabs it is fewer times a second, down to 25, and the pages glide from one picture to the next. A
calm page, where nothing moves and nobody does anything, has a frame a second, until it says something. The
time steps of heavy bodies are done by threads beside it, since the kernels do not hold the interpreter.
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
"""Computing time of all tabs, as a part of a frame; the rest is for drawing and the network."""

LONGEST_FRAME = 1.0 / 25.0
"""Seconds of a frame at most, however many tabs there are."""

WORKED = 0.75
"""Part of a frame that the ticker may work; the rest is the event loop's, which has the network."""

CALM_LOOK = 0.1
"""Seconds between two looks for something to do, where all pages are calm and none says anything."""

HEAVY_THREADS = 2
"""Threads for heavy bodies, all tabs together."""

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
        self._frame = FRAME
        self._workers = ThreadPoolExecutor(HEAVY_THREADS, thread_name_prefix="softrod-heavy")
        self._thread = threading.Thread(target=self._run, name="softrod-ticker", daemon=True)
        self._news = threading.Event()  # that a page has said something
        self._calm_due: dict[int, float] = {}
        self.tabs: dict[int, Tab] = {}
        self.drawn = threading.Event()

    @property
    def asleep(self) -> bool:
        """Whether it does nothing until a page comes."""
        return not self._wake.is_set()

    def attach(self, server: viser.ViserServer) -> None:
        """Hear of pages that come and go, and start ticking."""

        @server.on_client_connect
        async def _(client: viser.ClientHandle) -> None:
            self._arrivals.append(client)
            self._wake.set()
            self._news.set()

        @server.on_client_disconnect
        async def _(client: viser.ClientHandle) -> None:
            self._departures.append(client.client_id)
            self._wake.set()

        self._thread.start()

    def hear(self, client_id: int) -> None:
        """A page has said something; any thread may call."""
        if (tab := self.tabs.get(client_id)) is not None:
            tab.stir()
        self._news.set()

    def stop(self) -> None:
        """Stop after the present frame, and wait for it."""
        self._stopping = True
        self._wake.set()
        self._news.set()
        self._thread.join(timeout=10.0)
        self._workers.shutdown(wait=False, cancel_futures=True)

    def _run(self) -> None:
        due = time.monotonic()
        while not self._stopping:
            if not self.tabs and not self._arrivals:
                self._wake.clear()
                if not self._arrivals and not self._departures and not self._stopping:
                    self._wake.wait()
                due = time.monotonic()
            began = time.monotonic()
            self._come_and_go()
            for client_id, tab in list(self.tabs.items()):
                calm = tab.is_calm
                if calm and began < self._calm_due.get(client_id, 0.0):
                    continue
                self._calm_due[client_id] = began + CALM_FRAME
                try:
                    share = BUDGET * (CALM_FRAME if calm else self._frame) / len(self.tabs)
                    if tab.frame(share, self._workers.submit):
                        tab.client.flush()
                except Exception:
                    # A page that went away in the middle of a frame, or a defect: the other tabs go on.
                    _log.exception("the tab %s is closed after an error", client_id)
                    self.tabs.pop(client_id, None)
                    tab.leave()
                    _say_stopped(tab.client)
            now = time.monotonic()
            self._frame = next_frame(self._frame, now - began)
            due = max(due + self._frame, now - FRAME)
            if all(tab.is_calm for tab in self.tabs.values()):
                self._news.wait(CALM_LOOK)
            else:
                time.sleep(max(0.0, due - now))
            self._news.clear()

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
            client_id = self._departures.popleft()
            gone = self.tabs.pop(client_id, None)
            self._calm_due.pop(client_id, None)
            if gone is not None:
                try:
                    gone.leave()
                except Exception:
                    _log.exception("a page that is gone could not be taken out of its class")


def _say_stopped(client: viser.ClientHandle) -> None:
    """Tell a page, if it is still there, that nothing more will come."""
    with contextlib.suppress(Exception):
        text = "There was an error on the server. Reload the page to go on."
        client.add_notification("This page has stopped", text, color="red")
        client.flush()


def next_frame(frame: float, worked: float) -> float:
    """Seconds of the next frame, after one in which all tabs together took so long."""
    wanted = min(max(worked / WORKED, FRAME), LONGEST_FRAME)
    return frame + 0.1 * (wanted - frame)
