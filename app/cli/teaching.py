"""`softrod class`: a class, with its teacher's page, its wall and its pupils' seats."""

from __future__ import annotations

import time
from dataclasses import dataclass
from datetime import datetime, timedelta
from typing import Annotated

from tyro.conf import Positional, arg

import sim

from ..command import Listening, fail


@dataclass
class TeachClass(Listening):
    """Hold a class: pupils predict, see it run, compare and hand in, each in their own browser."""

    scenes: Annotated[Positional[tuple[str, ...]], arg(metavar="SCENE")] = ()
    """What the class goes through, in order: presets by their names, files or links; lessons go step by
    step."""
    host: str = "0.0.0.0"
    """Address to listen on; 127.0.0.1 to try it alone."""
    new: bool = False
    """Forget a class that was not ended, with all that was handed in, instead of going on with it."""
    classes: Annotated[int, arg(metavar="N")] = 1
    """Classes at once, each with a teacher's page and a code of its own."""
    until: Annotated[str, arg(metavar="DATE")] = ""
    """Homework until then, as in 2027-01-15 or 2027-01-15T08:00: pupils come in without the teacher and go
    through the steps alone; what is right is told at that time, or when the teacher tells it."""

    def run(self) -> int:
        """Serve until told to stop."""
        # Imported here: the other commands do not need viser, whose import takes a second.
        from ..classroom.answers import Refused
        from ..classroom.live import MAX_CLASSES, Classes
        from ..gate.gate import GateError, PortBusy
        from ..server.serve import serve

        if not 1 <= self.classes <= MAX_CLASSES:
            return fail(f"--classes: a server holds 1 to {MAX_CLASSES} classes")
        try:
            until = _time_of(self.until) if self.until else 0.0
        except ValueError as error:
            return fail(f"--until: {error}")
        scenes = [sim.load_scene(name) for name in self.scenes]
        classes = Classes()
        try:
            classes.resume(scenes or None, self.classes, self.new, until)
        except Refused as error:
            return fail(error)
        except OSError as error:
            return fail(f"the class cannot be forgotten: {error}")
        first = next(iter(classes)).room.scenes[0]
        names, public = self.allow_host, self.public_url
        try:
            serve(first, self.host, self.port, self.open, (), names, public, classes=classes)
        except (GateError, PortBusy) as error:
            return fail(error)
        return 0


def _time_of(text: str) -> float:
    """The time that a date, or a date and a time of this computer's clock, names, s since 1970.

    Raises:
        ValueError: it is neither, or it has passed; one sentence.
    """
    try:
        at = datetime.fromisoformat(text)
    except ValueError:
        raise ValueError(f"{text} is no date; it is to be as 2027-01-15 or 2027-01-15T08:00") from None
    if "T" not in text and " " not in text:
        at += timedelta(hours=23, minutes=59)  # to the end of that day
    if at.timestamp() <= time.time():
        raise ValueError(f"{text} has passed")
    return at.timestamp()
