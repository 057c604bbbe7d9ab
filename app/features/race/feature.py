"""A race of the body against those of other scenes, on one terrain and one clock."""

from __future__ import annotations

import re
import urllib.parse
from typing import ClassVar

import viser

import sim
from sim.edit.terrain import on_terrain
from sim.errors import InputError, SceneError
from sim.store import files
from sim.store.files import read_scene

from ...session.finish import finish_of
from ...session.pacing import is_large
from ...session.session import Command, Refresh, Session
from ...ui.commands import Row
from ...ui.feature import Drawn, Feature
from ...ui.opening import asked_scene
from ...ui.page import Page
from ...words import quoted, say
from ...words.english import name_of, refusal
from .messages import Race, RaceAnswer
from .rivals import Rivals

READ_EVERY = 0.1
"""Seconds between two readings while the bodies move; faster ones would only flicker."""

MAX_RIVALS = 3
"""More would be neither seen nor computed in time."""

_ADDRESS = re.compile(r"\S+\?(\S+)")


class BeginRace(Command):
    """Race against the bodies of other scenes: all are put at their starts, and wait.

    Attributes:
        scenes: the others.
        finish: way from the start to the finish along x, px.
    """

    scenes: tuple[sim.Scene, ...]
    finish: float
    acts = True
    refresh = Refresh.SETTINGS

    def apply(self, session: Session, at: float) -> None:
        rivals = Rivals(session.simulation, self.scenes, self.finish, session.can_wait)
        session.play(False)
        session.companions.add(rivals, session.history)
        session.reset()

    @property
    def is_heavy(self) -> bool:
        return any(map(is_large, self.scenes))

    def playing_after(self, playing: bool) -> bool:
        return False


class LeaveRace(Command):
    """End the race; the body goes on."""

    refresh = Refresh.SETTINGS

    def apply(self, session: Session, at: float) -> None:
        session.companions.remove(Rivals, session.history)


class RaceFeature(Feature):
    """Finds a page's rivals, and reports how far each body has come."""

    texts: ClassVar = {"rival": "chooser"}
    commands: ClassVar = {
        "race": Row("page", ("A",), needs="chooser", share=viser.Icon.FLAG),
        "leaveRace": Row(LeaveRace(), needs="chooser"),
    }

    def __init__(self, page: Page) -> None:
        super().__init__(page)
        self._on = False
        self._due = 0.0

    def read(self, kind: str, letters: str) -> None:
        """Begin a race against the body of a scene, or add it to the race that is on; or say why not.

        Args:
            kind: "rival".
            letters: a link to it, its short address or its name, as in an address.
        """
        session = self.session
        try:
            rivals = (*self._rivals(), self._find(urllib.parse.unquote(letters).strip()))
            own = session.snapshot(session.scene.name, with_pose=False)
            ways = [finish_of(own, on_terrain(rival, own), session.can_wait) for rival in rivals]
        except (SceneError, InputError) as error:
            self.page.mail.send(RaceAnswer(problem=refusal(error)))
            return
        session.post(BeginRace(rivals, max(ways, key=abs)))
        self.page.mail.send(RaceAnswer(problem=""))

    def _rivals(self) -> tuple[sim.Scene, ...]:
        """Return the scenes of the race that is on.

        Raises:
            SceneError: no other body has room in it; one sentence.
        """
        race = self.session.companions.get(Rivals)
        if race is not None and len(race.scenes) >= MAX_RIVALS:
            raise SceneError(say("race-full", count=str(MAX_RIVALS + 1)))
        return race.scenes if race is not None else ()

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
            raise SceneError(say("race-unknown", text=quoted(text[:80])))
        return read_scene(info.path)

    def frame(self, drawn: Drawn) -> None:
        """See `Feature`."""
        session = self.session
        rivals = session.companions.get(Rivals)
        if rivals is None:
            if self._on:
                self._on = False
                self.page.mail.send(Race())
            return
        now = session.now()
        if now < self._due:
            return
        self._on, self._due = True, now + READ_EVERY
        self.page.mail.send(
            Race(
                on=True,
                names=tuple(map(name_of, (session.scene, *rivals.scenes))),
                ways=tuple(float(f"{way:.4g}") for way in rivals.ways(session.simulation)),
                seconds=round(rivals.seconds, 1),
                fair=rivals.fair,
                finish=rivals.finish,
                lines=rivals.lines,
                arrived=tuple(_hundredths(runner.arrived) for runner in rivals.runners),
                outs=tuple(runner.out for runner in rivals.runners),
                masses=tuple(len(scene.masses) for scene in rivals.scenes),
                more=len(rivals.scenes) < MAX_RIVALS,
            )
        )


def _hundredths(seconds: float | None) -> float | None:
    """A time as it is shown."""
    return None if seconds is None else round(seconds, 2)
