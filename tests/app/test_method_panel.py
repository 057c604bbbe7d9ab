"""Which method suits a scene, in a page: a sentence and a figure, as long as the scene is the same."""

from __future__ import annotations

import time
from typing import Any

import pytest
from msgspec.structs import replace

import sim
from app.features.solver import method_panel
from app.features.solver.job import MAX_MASSES
from app.features.solver.method_panel import MethodPanel
from app.session import commands
from app.session.notices import Notice
from sim.compiling.compiler import ENTRY_POINTS, fetch
from tests.app.pages import SessionPage
from tests.app.panels import Client, page_of


class AskingPage(SessionPage):
    """A session with the panel of its page."""

    def __init__(self, scene: sim.Scene) -> None:
        fetch(ENTRY_POINTS)
        super().__init__(scene)
        self.notices: list[Notice] = []
        client: Any = Client()
        self.made = client.gui
        self.panel = MethodPanel(page_of(self.session, client, notify=self.notices.append), 0.0)
        self.panel.build(True)
        self.panel.refresh()

    def ask(self) -> str:
        """Press the button, and what is told when there is no more to tell."""
        self.made["Which method?"].enter()
        assert self.panel.waits
        end = time.monotonic() + 60.0
        while self.panel.waits and time.monotonic() < end:
            self.frames(1)
            self.panel.refresh()
            time.sleep(0.005)
        assert not self.panel.waits
        return self.made.text()


def test_it_says_what_to_take_and_shows_all_methods() -> None:
    page = AskingPage(sim.rope(4))
    told = page.ask()
    assert "To 1 px, take " in told
    assert "To 0.1 px, take " in told
    assert told.count("<svg") == 1
    assert "currentColor" in told and "#010203" not in told
    # It holds for any method of the same scene, and for no other scene.
    page.frames(1, commands.SetChoice("method", "rk4"))
    page.panel.refresh()
    assert page.made.text() == told
    page.frames(1, commands.SetValue("linear_stiffness", 500.0))
    page.panel.refresh()
    assert not page.made.text()


def test_what_cannot_be_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    assert not AskingPage(sim.rope(MAX_MASSES + 1)).ask()
    page = AskingPage(replace(sim.rope(4), name="x"))

    def defect(*_: object, **__: object) -> None:
        raise RuntimeError("a defect")

    monkeypatch.setattr(method_panel, "compare_methods", defect)
    assert not page.ask()
    assert [notice.text for notice in page.notices] == ["There was an error on the server."]
