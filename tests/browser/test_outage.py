"""A connection that dies without a word: the page says so, takes nothing meanwhile, and comes back."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, BrowserContext

from app.session import commands
from tests.browser.conftest import DESKTOP, Serve
from tests.browser.driver import Desk, Served, rough_context
from tests.browser.wires import Wire, wire

NOT_CONNECTED = "Not connected: your body waits."
WITHIN = 20.0
"""Seconds within which the page must have noticed; it is three, and more on a busy machine."""

HURRY = 4
"""By what the times are divided after which a page loses its patience; `tests/page` tests the times."""


def hurry(context: BrowserContext) -> None:
    """Have the pages of a context lose their patience sooner."""
    context.add_init_script(f"window.__softrodHurry = {HURRY}")


@pytest.fixture
def led(serve: Serve, browser: Browser) -> Iterator[tuple[Desk, Wire]]:
    """A page whose server is at the other end of a wire."""
    served = serve("tutorial-3.3")
    assert served.scene is not None
    served.show_first(served.scene)
    context = rough_context(browser, viewport={"width": DESKTOP[0], "height": DESKTOP[1]})
    hurry(context)
    with wire(int(served.url.rpartition(":")[2])) as between:
        desk = Desk(Served(f"http://127.0.0.1:{between.port}", served.ticker), context)
        desk.open()
        yield desk, between
        context.close()
    assert not desk.errors


def is_away(desk: Desk) -> bool:
    """Whether the page says that it has no connection."""
    return desk.page.get_by_text(NOT_CONNECTED).is_visible()


def take_up(desk: Desk, known: int) -> None:
    """Look at the tab of the connection that came after a known one."""
    new = desk.until(
        lambda: [c for c in list(desk.served.ticker.tabs) if c > known], "the page connects anew"
    )
    desk.client = new[-1]
    desk.until(lambda: desk.tab.session is not None, "the tab has its session")


def test_a_path_that_dies_is_noticed_and_replaced(led: tuple[Desk, Wire]) -> None:
    desk, between = led
    desk.tell(commands.SetValue("gravity", 900.0))
    desk.until(desk.is_kept, "it is kept")
    desk.until(
        lambda: desk.page.evaluate("sessionStorage.getItem('softrod')?.includes('900')"), "by the page"
    )
    # In the middle of a drag.
    start = desk.place(0)
    desk.take(start)
    desk.until(lambda: desk.session.hands.masses == (0,), "the mass is in hand")
    old = desk.client
    between.mute = True
    desk.until(lambda: is_away(desk), "the page says so", limit=WITHIN)
    # Its clock stands, and what is pressed now is not done, neither now nor later.
    clock = desk.clock()
    for key in ("Space", "r", "o"):
        desk.page.keyboard.press(key)
    desk.page.get_by_role("button", name="Reset").dispatch_event("click")
    desk.pause(1.0)
    assert desk.clock() == clock
    assert not desk.page.get_by_role("dialog").is_visible()
    between.mute = False
    take_up(desk, old)
    desk.until(lambda: not is_away(desk), "the page is back")
    desk.until(lambda: desk.session.scene.gravity == (0.0, 900.0), "with what it had kept")
    assert not desk.session.hands.masses
    assert desk.session.playing
    # The server has not kept the dead connection, of which nobody told it.
    desk.until(lambda: old not in desk.served.ticker.tabs, "the dead connection is gone")
    desk.let_go()
    desk.wait_drawn()

    def drags() -> bool:
        # This page is impatient: on a busy machine it takes a late server for a stall, which ends a drag.
        before = float(desk.simulation.positions[0, 0])
        start = desk.place(0)
        desk.drag(start, (start[0] + 60.0, start[1] + 20.0))
        return float(desk.simulation.positions[0, 0]) > before + 20.0

    desk.until(drags, "a drag works")


def test_a_stall_ends_the_drag_and_keeps_the_connection(led: tuple[Desk, Wire]) -> None:
    desk, between = led
    old = desk.client
    start = desk.place(0)

    def holds() -> bool:
        # This page is impatient: on a busy machine it takes a late server for a stall, which ends a drag.
        desk.let_go()
        desk.take(start)
        return desk.session.hands.masses == (0,)

    desk.until(holds, "the mass is in hand")
    # A key is held as well: it leads the anchor, so the pointer has to have hold of it before.
    desk.page.keyboard.down("ArrowRight")
    between.held = True
    desk.until(lambda: is_away(desk), "the page says so", limit=WITHIN)
    desk.page.mouse.move(start[0] + 200.0, start[1])
    desk.page.keyboard.press("r")
    between.held = False
    desk.until(lambda: not is_away(desk), "the page is back")
    assert desk.client == old
    desk.until(lambda: not desk.session.hands.masses, "the drag has ended")
    desk.page.mouse.move(start[0] + 250.0, start[1])
    desk.pause(0.5)
    assert abs(desk.place(0)[0] - start[0]) < 20.0
    assert desk.simulation.time > 0.5, "it was not reset"
