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
from concurrent.futures import Future, ThreadPoolExecutor
from contextvars import copy_context
from typing import Any

import viser

from ..session.session import FRAME
from ..ui.ticked import CALM_FRAME, Ticked
from ..words import speaking

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
        make_tab: makes the tab of a page of viser's that has connected.
        after: called after the frames of all tabs.

    Attributes:
        tabs: by number, for viser's pages that of the client; only the ticker's thread changes it.
        drawn: set once the first page is drawn.
    """

    def __init__(
        self,
        make_tab: Callable[[viser.ClientHandle], Ticked],
        after: Callable[[], object] = lambda: None,
    ) -> None:
        self._make_tab, self._after = make_tab, after
        self._arrivals_and_departures: deque[tuple[int, Callable[[], Ticked] | None]] = deque()
        self._wake = threading.Event()
        self._stopping = False
        self._frame = FRAME
        self._workers = ThreadPoolExecutor(HEAVY_THREADS, thread_name_prefix="softrod-heavy")
        self._thread = threading.Thread(target=self._run, name="softrod-ticker", daemon=True)
        self._news = threading.Event()  # a page has sent something
        self._calm_due: dict[int, float] = {}
        self.tabs: dict[int, Ticked] = {}
        self.drawn = threading.Event()

    @property
    def asleep(self) -> bool:
        """Whether it does nothing until a page connects."""
        return not self._wake.is_set()

    def attach(self, server: viser.ViserServer) -> None:
        """Learn of pages that come and go, and start ticking."""

        @server.on_client_connect
        async def _(client: viser.ClientHandle) -> None:
            self.come(client.client_id, lambda: self._make_tab(client))

        @server.on_client_disconnect
        async def _(client: viser.ClientHandle) -> None:
            self.go(client.client_id)

        self._thread.start()

    def come(self, number: int, make: Callable[[], Ticked]) -> None:
        """Have a page made that has connected; any thread may call."""
        self._arrivals_and_departures.append((number, make))
        self._wake.set()
        self._news.set()

    def go(self, number: int) -> None:
        """Have a page dropped whose connection has ended; any thread may call."""
        self._arrivals_and_departures.append((number, None))
        self._wake.set()

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
            computing = max(1, sum(not tab.looks_on for tab in self.tabs.values()))
            for client_id, tab in list(self.tabs.items()):
                self._tick(client_id, tab, began, computing)
            self._after()
            now = time.monotonic()
            self._frame = next_frame(self._frame, now - began)
            due = max(due + self._frame, now - FRAME)
            if all(tab.is_calm for tab in self.tabs.values()):
                self._news.wait(CALM_LOOK)
            else:
                time.sleep(max(0.0, due - now))
            self._news.clear()

    def _tick(self, client_id: int, tab: Ticked, began: float, computing: int) -> None:
        """Give a tab its frame, unless it is calm and has had one lately.

        Args:
            client_id, tab: its number, and the tab.
            began: when this round began, s of wall time.
            computing: how many tabs share the time.
        """
        calm = tab.is_calm
        if calm and began < self._calm_due.get(client_id, 0.0):
            return
        self._calm_due[client_id] = began + CALM_FRAME
        try:
            share = BUDGET * (CALM_FRAME if calm else self._frame) / computing
            with speaking(tab.language):
                if tab.frame(share, self._beside):
                    tab.flush()
        except Exception:
            # The page left in the middle of a frame, or there is a defect: the other tabs continue.
            _log.exception("the tab %s is closed after an error", client_id)
            self.tabs.pop(client_id, None)
            tab.leave()
            with contextlib.suppress(Exception), speaking(tab.language):
                tab.stop()

    def _beside(self, work: Callable[..., Any], *arguments: Any, **named: Any) -> Future[Any]:
        """Run work in another thread, which speaks the language that is spoken here."""
        return self._workers.submit(copy_context().run, work, *arguments, **named)

    def _come_and_go(self) -> None:
        while self._arrivals_and_departures:
            number, make = self._arrivals_and_departures.popleft()
            try:
                if make is None:
                    self._calm_due.pop(number, None)
                    if (tab := self.tabs.pop(number, None)) is not None:
                        tab.leave()
                else:
                    self.tabs[number] = made = make()
                    made.flush()
                    self.drawn.set()
            except Exception:
                _log.exception("a page could not be set up, or taken out of its class")


def next_frame(frame: float, worked: float) -> float:
    """Length of the next frame, s, after one in which all tabs together took `worked` seconds."""
    wanted = min(max(worked / WORKED, FRAME), LONGEST_FRAME)
    return frame + 0.1 * (wanted - frame)
