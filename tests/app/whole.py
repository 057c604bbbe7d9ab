"""A whole page without a browser, for tests: the server's side of it, whose script is the test."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import Future
from typing import Any
from unittest import mock

import sim
from app.pages.sandbox import tab
from app.pages.sandbox.tab import Tab
from app.session import commands
from app.session.session import Session
from app.ui.viser import slider_box
from app.wire.messages import FromPage
from app.wire.to_page import Hud
from sim.compiling.compiler import Compiler
from tests.app.pages import BUDGET, FRAME, Wall
from tests.app.panels import Client, Gui


def beside(work: Callable[..., Any], *arguments: Any, **options: Any) -> Future[Any]:
    """What another thread would do, done at once."""
    done: Future[Any] = Future()
    done.set_result(work(*arguments, **options))
    return done


class WholePage:
    """A page with its panel, at 60 frames a second.

    Args:
        scene: what it shows first; a preset's name, or a scene.
        query: of its address.
    """

    def __init__(self, scene: str | sim.Scene = "tutorial-3.3", query: str = "") -> None:
        self.wall, self.client = Wall(), Client()
        first = sim.load_scene(scene) if isinstance(scene, str) else scene
        client: Any = self.client
        self.tab = Tab(client, first, Compiler(), query, owned=True)
        with mock.patch.object(
            tab, "Session", lambda scene, wait, stands: Session(scene, clock=self.wall, stands=stands)
        ):
            self._frame()

    def _frame(self) -> None:
        # Nobody is still typing when the next frame comes.
        with mock.patch.object(slider_box, "TOUCHED", -1.0):
            self.wall.time += FRAME
            self.tab.frame(BUDGET, beside)

    def frames(self, count: int, *said: FromPage | commands.Command) -> None:
        """Have the page's script say something, or post commands, then let frames pass."""
        for one in said:
            if isinstance(one, FromPage):
                self.client.say(one)
            else:
                self.session.post(one)
        for _ in range(count):
            self._frame()

    def shown(self, *said: FromPage | commands.Command) -> None:
        """The same, until the panel shows what came of it."""
        self.frames(10, *said)

    def enter(self, label: str, value: object = None) -> None:
        """Set a control, or press a button, and see what comes of it."""
        self.gui[label].enter(value)
        self.shown()

    @property
    def session(self) -> Session:
        session = self.tab.session
        assert session is not None
        return session

    @property
    def simulation(self) -> sim.Simulation:
        return self.session.simulation

    @property
    def scene(self) -> sim.Scene:
        return self.session.scene

    @property
    def gui(self) -> Gui:
        return self.client.gui

    @property
    def hud(self) -> str:
        """The head-up display."""
        return self.client.mail.last(Hud).html

    @property
    def notices(self) -> Sequence[Any]:
        """The notices that are up."""
        return self.client.notices
