"""A race of the body against that of another scene, on one terrain and one clock."""

from __future__ import annotations

import re
import urllib.parse
from typing import ClassVar

import viser

import sim
from sim.edit.terrain import on_terrain
from sim.errors import InputError, SceneError
from sim.scene.types import shown_name
from sim.store import files
from sim.store.files import read_scene

from ...session.finish import finish_of
from ...session.pacing import is_large
from ...session.session import Command, Refresh, Session
from ...ui.commands import Row
from ...ui.feature import Drawn, Feature, LongText
from ...ui.opening import asked_scene
from ...ui.page import Page
from .messages import Race, RaceAnswer
from .rival import Rival

READ_EVERY = 0.1
"""Seconds between two readings while the bodies move; faster ones would only flicker."""

_ADDRESS = re.compile(r"\S+\?(\S+)")


class BeginRace(Command):
    """Race against the body of another scene: both are put at their starts, and wait.

    Attributes:
        scene: the other one.
        finish: way from the start to the finish along x, px.
    """

    scene: sim.Scene
    finish: float
    acts = True
    refresh = Refresh.SETTINGS

    def apply(self, session: Session, at: float) -> None:
        rival = Rival(session.simulation, self.scene, self.finish, session.can_wait)
        session.play(False)
        session.companions.add(rival, session.history)
        session.reset()

    @property
    def is_heavy(self) -> bool:
        return is_large(self.scene)

    def playing_after(self, playing: bool) -> bool:
        return False


class LeaveRace(Command):
    """End the race; the body goes on."""

    refresh = Refresh.SETTINGS

    def apply(self, session: Session, at: float) -> None:
        session.companions.remove(Rival, session.history)


class RaceFeature(Feature):
    """Finds a page's rivals, and reports how far each body has come."""

    texts: ClassVar = {"rival": LongText(needs="chooser", verb="raced against")}
    commands: ClassVar = {
        "race": Row(
            "Race against another body", "page", ("A",),
            "race against another body; in a race, start again",
            hint="both on this terrain, started together", needs="chooser",
            share=("Race against …", viser.Icon.FLAG),
        ),
        "leaveRace": Row("Leave the race", LeaveRace(), needs="chooser"),
    }  # fmt: skip

    def __init__(self, page: Page) -> None:
        super().__init__(page)
        self._on = False
        self._due = 0.0

    def read(self, kind: str, letters: str) -> None:
        """Begin a race against the body of a scene, or say why not.

        Args:
            kind: "rival".
            letters: a link to it, its short address or its name, as in an address.
        """
        session = self.session
        try:
            rival = self._find(urllib.parse.unquote(letters).strip())
            own = session.snapshot(session.scene.name, with_pose=False)
            finish = finish_of(own, on_terrain(rival, own), session.can_wait)
        except (SceneError, InputError) as error:
            text = str(error)
            self.page.mail.send(RaceAnswer(problem=f"{text[:1].upper()}{text[1:]}."))
            return
        session.post(BeginRace(rival, finish))
        self.page.mail.send(RaceAnswer(problem=""))

    def _find(self, text: str) -> sim.Scene:
        """Return the scene that a text names.

        Raises:
            SceneError: there is none; one sentence.
        """
        if "#" in text:
            return files.decode_link(text.partition("#")[2])
        address = _ADDRESS.fullmatch(text)
        if address is not None and (scene := asked_scene(address[1])) is not None:
            return scene
        # Only what is listed: a name could be the path of any file.
        info = self.page.shelf.find(text)
        if info is None:
            raise SceneError(f"{text[:80]!r} is neither a link to a scene nor the name of one")
        return read_scene(info.path)

    def frame(self, drawn: Drawn) -> None:
        """See `Feature`."""
        session = self.session
        rival = session.companions.get(Rival)
        if rival is None:
            if self._on:
                self._on = False
                self.page.mail.send(Race())
            return
        now = session.now()
        if now < self._due:
            return
        self._on, self._due = True, now + READ_EVERY
        one, other = rival.ways(session.simulation)
        mine, theirs = rival.runners
        self.page.mail.send(
            Race(
                on=True,
                names=(shown_name(session.scene), shown_name(rival.scene)),
                ways=(float(f"{one:.4g}"), float(f"{other:.4g}")),
                seconds=round(rival.seconds, 1),
                fair=rival.fair,
                finish=rival.finish,
                lines=rival.lines,
                arrived=(_hundredths(mine.arrived), _hundredths(theirs.arrived)),
                outs=(mine.out, theirs.out),
            )
        )


def _hundredths(seconds: float | None) -> float | None:
    """A time as it is shown."""
    return None if seconds is None else round(seconds, 2)
