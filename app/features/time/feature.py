"""Time: play and pause, steps, going back in time, and speed."""

from __future__ import annotations

from typing import ClassVar

from ...session import commands
from ...stage.looks import ICONS
from ...ui.commands import Row
from ...ui.feature import Feature
from ...wire.messages import FromPage
from .messages import GoTo, Speed


class TimeFeature(Feature):
    """The bar of time of a page."""

    messages: ClassVar = {GoTo: "", Speed: ""}
    controls: ClassVar = {"play": "the bar of time under the body"}
    commands: ClassVar = {
        "play": Row(commands.Play(), ("Space",), icon=ICONS["play"]),
        "step": Row(commands.DoSteps(1), ("N",), icon="M6 5v14l9-7zM16 5h2v14h-2z"),
        "steps": Row(commands.DoSteps(10), ("Shift N",)),
        "back": Row(commands.GoBack(), (",",), icon="M18 5v14l-9-7zM6 5h2v14H6z"),
        "forward": Row(commands.GoForward(), (".",), icon="M6 5v14l9-7zM16 5h2v14h-2z"),
        "second": Row(commands.GoBack(1.0), ("J",), icon="M20 5v14l-8-7zM11 5v14l-8-7z"),
        "before": Row(commands.BackBeforeDivergence()),
        "reset": Row(commands.Reset(), ("R",), icon=ICONS["reset"]),
        "pause": Row(commands.Play(False), ("Esc",), icon=ICONS["pause"]),
        "run": Row(commands.Play(True), palette=False),
        "forget": Row(commands.ForgetFuture(), palette=False),
    }

    def hear(self, said: FromPage) -> None:
        """See `Feature`."""
        match said:
            case GoTo(time):
                self.session.post(commands.GoTo(time))
            case Speed(speed):
                self.session.post(commands.Speed(speed))
            case _:
                pass
