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
        "play": Row("Play or pause", commands.Play(), ("Space",), "play or pause", icon=ICONS["play"]),
        "step": Row(
            "1 step", commands.DoSteps(1), ("N",), "one step; with Shift ten", word="Step",
            icon="M6 5v14l9-7zM16 5h2v14h-2z",
        ),
        "steps": Row("10 steps", commands.DoSteps(10), ("Shift N",)),
        "back": Row(
            "Back 1 frame", commands.GoBack(), (",",), "one frame back, one frame forward", word="Frame",
            icon="M18 5v14l-9-7zM6 5h2v14H6z",
        ),
        "forward": Row(
            "Forward 1 frame", commands.GoForward(), (".",), "one frame back, one frame forward",
            word="Frame", icon="M6 5v14l9-7zM16 5h2v14h-2z",
        ),
        "second": Row(
            "Back 1 second", commands.GoBack(1.0), ("J",), "one second back", word="1 s",
            icon="M20 5v14l-8-7zM11 5v14l-8-7z",
        ),
        "before": Row(
            "Go back to just before it exploded", commands.BackBeforeDivergence(),
            word="Go back to just before it",
        ),
        "reset": Row("Reset", commands.Reset(), ("R",), "reset", word="Reset", icon=ICONS["reset"]),
        "pause": Row(
            "Pause", commands.Play(False), ("Esc",), "pause; close this help, or a question", word="Pause",
            icon=ICONS["pause"],
        ),
        "run": Row("Play", commands.Play(True), palette=False),
        "forget": Row("Take the line away", commands.ForgetFuture(), palette=False),
    }  # fmt: skip

    def hear(self, said: FromPage) -> None:
        """See `Feature`."""
        match said:
            case GoTo(time):
                self.session.post(commands.GoTo(time))
            case Speed(speed):
                self.session.post(commands.Speed(speed))
            case _:
                pass
