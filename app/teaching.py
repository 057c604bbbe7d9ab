"""`softrod class`: a class, with its teacher's page, its wall and its pupils' seats."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from tyro.conf import Positional, UseAppendAction, arg

import sim

from .command import fail


@dataclass
class TeachClass:
    """Hold a class: pupils predict, see it run, compare and hand in, each in their own browser."""

    scenes: Annotated[Positional[tuple[str, ...]], arg(metavar="SCENE")] = ()
    """What the class goes through, in order: presets by their names, files or links; lessons go step by
    step."""
    host: str = "0.0.0.0"
    """Address to listen on; 127.0.0.1 to try it alone."""
    port: int = 8080
    """Port to listen on; 0 for any free one."""
    open: bool = True
    """Open the teacher's page in a browser."""
    new: bool = False
    """Forget a class that was not ended, with all that was handed in, instead of going on with it."""
    classes: Annotated[int, arg(metavar="N")] = 1
    """Classes at once, each with a teacher's page and a code of its own."""
    allow_host: Annotated[UseAppendAction[tuple[str, ...]], arg(metavar="NAME")] = ()
    """A further name by which browsers may reach the page; may be repeated."""
    public_url: Annotated[str | None, arg(metavar="URL")] = None
    """The address by which others reach the page through a proxy, as in https://school.example/lab/."""

    def run(self) -> int:
        """Serve until told to stop."""
        # Here, not above: the other commands have no use for viser, which takes a second to import.
        from .classroom.kept import forget, read_all
        from .classroom.live import Classes
        from .classroom.room import Refused
        from .gate.gate import GateError, PortBusy
        from .server.serve import serve

        if not 1 <= self.classes <= 20:
            return fail("--classes: a server holds 1 to 20 classes")
        scenes = [sim.load_scene(name) for name in self.scenes or ("lesson-hooke",)]
        classes = Classes()
        if self.new:
            for room in read_all():
                forget(room.code)
        going_on = classes.go_on()
        if going_on and self.scenes:
            codes = ", ".join(klass.room.code for klass in going_on)
            return fail(
                f"class {codes} has not been ended: go on without naming scenes, or forget it by --new"
            )
        try:
            for _ in range(0 if going_on else self.classes):
                classes.begin(scenes)
            serve(
                scenes[0],
                self.host,
                self.port,
                self.open,
                (),
                self.allow_host,
                self.public_url,
                classes=classes,
            )
        except (GateError, PortBusy, Refused) as error:
            return fail(error)
        return 0
