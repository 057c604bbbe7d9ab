"""Pages on which nothing happens cost next to nothing, and wake when somebody does something."""

from __future__ import annotations

import asyncio
import math
import time
from unittest.mock import MagicMock

import pytest

import sim
from app.features.hands.messages import Grab
from app.pages.sandbox import tab as tab_module
from app.server.ticker import Ticker
from app.session import commands
from app.session import session as session_module
from app.words import language
from sim.compiling.compiler import Compiler
from tests.app.hostile import eventually
from tests.app.whole import WholePage


def test_a_calm_page_has_a_frame_a_second_until_it_says_something() -> None:
    tab, server = MagicMock(is_calm=True), MagicMock()
    tab.frame.return_value = False
    tab.stir.side_effect = lambda: setattr(tab, "is_calm", False)
    ticker = Ticker(lambda _: tab)
    ticker.attach(server)
    (connected,) = server.on_client_connect.call_args.args
    try:
        asyncio.run(connected(MagicMock(client_id=7)))
        eventually(lambda: tab.frame.call_count == 1)
        time.sleep(0.4)
        assert tab.frame.call_count == 1
        ticker.hear(7)
        ticker.hear(8)  # which is gone
        eventually(lambda: tab.frame.call_count > 6)
        assert tab.stir.call_count == 1
    finally:
        ticker.stop()


def test_what_a_heavy_body_needs_is_computed_in_the_language_of_its_page() -> None:
    tab, server, heard = MagicMock(is_calm=False, language="de"), MagicMock(), []
    tab.frame.side_effect = lambda share, beside: heard.append(beside(language).result()) or False
    ticker = Ticker(lambda _: tab)
    ticker.attach(server)
    (connected,) = server.on_client_connect.call_args.args
    try:
        asyncio.run(connected(MagicMock(client_id=7)))
        eventually(lambda: heard != [])
    finally:
        ticker.stop()
    assert heard[0] == "de"


@pytest.fixture
def page(monkeypatch: pytest.MonkeyPatch) -> WholePage:
    monkeypatch.setattr(tab_module, "UNTOUCHED", -1.0)
    monkeypatch.setattr(Compiler, "progress", (1, 1))
    monkeypatch.setattr(session_module, "CHEAP", math.inf)  # however busy the machine is
    return WholePage(sim.load_scene("empty"))


def test_a_page_is_calm_once_its_body_rests_and_nobody_does_anything(page: WholePage) -> None:
    page.frames(10)
    assert not page.tab.is_calm
    page.frames(60)
    assert page.tab.is_calm
    # What is asked for ends it at once; what only the page's script says does so by `stir`.
    page.session.post(commands.Play(False))
    assert not page.tab.is_calm
    page.frames(90)
    assert page.tab.is_calm
    page.session.post(commands.SetValue("gravity", 500.0))
    assert not page.tab.is_calm


def test_a_body_that_moves_or_is_held_is_never_calm(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(tab_module, "UNTOUCHED", -1.0)
    monkeypatch.setattr(Compiler, "progress", (1, 1))
    rope = WholePage(sim.load_scene("rope"))
    for _ in range(120):
        rope.frames(1)
        assert not rope.tab.is_calm
    still = WholePage(sim.load_scene("rope"))
    still.frames(1, commands.Play(False))
    still.frames(90)
    assert still.tab.is_calm
    still.frames(1, commands.Play(True), Grab(0, 3, 0.0, 0.0))
    still.frames(90)
    assert not still.tab.is_calm


def test_a_touched_page_is_not_calm_for_a_while(page: WholePage, monkeypatch: pytest.MonkeyPatch) -> None:
    page.frames(90)
    assert page.tab.is_calm
    monkeypatch.setattr(tab_module, "UNTOUCHED", 3600.0)
    page.frames(90, commands.SetValue("gravity", 500.0))
    assert not page.tab.is_calm
    page.tab.stir()
    page.frames(90)
    assert not page.tab.is_calm


def test_a_calm_body_keeps_up_with_the_clock(page: WholePage) -> None:
    page.frames(90)
    assert page.tab.is_calm
    before = page.simulation.time
    page.wall.time += 1.0
    page.frames(1)
    assert page.simulation.time - before == pytest.approx(1.0, abs=0.05)
    assert page.session.pacer.behind == 0.0
