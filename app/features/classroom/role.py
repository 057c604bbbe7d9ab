"""What a page is in a class, and what all of these have in common."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from typing import Any, Literal
from weakref import WeakKeyDictionary

import numpy as np
import viser

import sim
from app.classroom.law import power_law
from app.classroom.live import Class, Front
from app.classroom.room import Answer, Content, Ghost, Line, Phase, Room, Vote, Work
from sim.errors import SettingError
from sim.settings import CHOICES, setting_of

from ...lessons import goal_text, reading_text
from ...session.session import Session
from ...stage.plan import own_rest_angles
from ...stage.sketch import Mapping
from ...ui.controls import Controls
from ...ui.view import picture_of
from ...wire import from_page
from ...wire.carrier import Mail
from ...wire.to_page import Asking, ClassEnded, Found, Law, Predictions, Seat
from .front import looks_alike, send

Kind = Literal["vote", "ghost", "line", "work"]
_KINDS: dict[type[Content], Kind] = {Vote: "vote", Ghost: "ghost", Line: "line", Work: "work"}

NOTHING = Controls(())

MAX_PLACES = 60
"""Masses in a small picture of a body."""

MAX_OPENINGS = 1_000_000
"""Bodies that one page has in turn, at most, for their numbers to be those of no other page."""

_numbers = itertools.count()

plan_numbers = itertools.count(1_000_000)
"""Of plans that several pages of a class have: no page has so many of its own."""


class Role:
    """What one page is, where it is no page of its own. The ticker alone calls it, but for `allows`.

    Attributes:
        place: HTML above the panel's sliders, where the page's script finds room.
    """

    place = '<div id="softrod-class-place"></div>'

    @property
    def controls(self) -> Controls | None:
        """The controls that the page has now; None for those that it would have anyway."""
        return NOTHING

    @property
    def front(self) -> Front | None:
        """What the page shows instead of a body of its own, or None."""
        return None

    def allows(self, said: from_page.FromPage) -> bool:
        """Whether the page may say that, whoever is behind it; any thread may ask."""
        return isinstance(said, from_page.Who)

    def introduce(self, who: from_page.Who, session: Session) -> None:
        """The page says whose it is."""

    def hear(self, said: from_page.FromPage, session: Session) -> None:
        """Do what the page says in the class."""

    def frame(self, session: Session) -> None:
        """Between two frames: tell the page what has changed."""

    def keep(self, keepsake: bytes) -> bool:
        """Keep what the page needs to come back to where it is; False if its browser is to keep it."""
        return True

    def leave(self) -> None:
        """The page is gone."""


class Entrance(Role):
    """The page of somebody who has not said which class they come to, or came to one that there is not.

    Args:
        mail: to the page's script.
        problem: why the page is in no class; empty if none was named.
    """

    def __init__(self, mail: Mail, problem: str) -> None:
        self._mail, self._problem = mail, problem

    def frame(self, session: Session) -> None:
        self._mail.send(Seat(problem=self._problem))


class ClassRole(Role):
    """What one page is in a class.

    Args:
        klass: the class.
        mail: to the page's script.

    Attributes:
        klass: as above.
    """

    def __init__(self, klass: Class, mail: Mail) -> None:
        self.klass = klass
        self._mail = mail
        self._told_end = False
        self._known: tuple[Any, ...] = ()
        self._first_opening = MAX_OPENINGS * next(_numbers)
        self._plan = -1, -1  # of the session, when it was shown last
        self._plan_number = 0
        self._angles = np.empty(0)

    @property
    def room(self) -> Room:
        """The class's state."""
        return self.klass.room

    @property
    def front(self) -> Front | None:
        return self.klass.front

    def _shown(self, session: Session, before: Front | None, audience: set[viser.ClientHandle]) -> Front:
        """What the page shows of its own body, for others to look at; its picture is sent to them.

        Args:
            session: of the page.
            before: what it showed last, which is given back where nobody can tell it from what it shows now.
            audience: the pages that look at it.
        """
        plan = session.openings, session.revision
        if plan != self._plan:
            self._plan, self._plan_number = plan, next(plan_numbers)
            self._angles = own_rest_angles(session.simulation)
        front = Front(
            self._plan_number,
            audience,
            session.scene,
            self._first_opening + session.openings,
            self._angles,
            picture_of(session),
            session.playing,
            session.pacer.speed,
        )
        if before is not None and looks_alike(before, front):
            return before
        send(front, session.now())
        return front

    def _is_new(self, *things: Any) -> bool:
        """Whether the class, or one of these things, is another than the last time that this was asked."""
        known, klass = self._known, self.klass
        self._known = (self.room.version, klass.teachers, len(klass.pupils), *things)
        return known != self._known

    def _tell_end(self) -> bool:
        """Whether the class is over; the page is told once."""
        if self.klass.ended and not self._told_end:
            self._told_end = True
            self._mail.send(ClassEnded())
        return self.klass.ended


def kind_of(content: Content) -> Kind:
    """What an answer is, as the pages call it."""
    return _KINDS[type(content)]


def text_of(content: Content) -> str:
    """What an answer says, in words; empty where it is no text."""
    match content:
        case Line(text):
            return text
        case Work(found=found, reached=reached):
            told = {None: "", True: "goal reached", False: "goal not reached"}[reached]
            return ", ".join(text for text in (f"{found:.4g}" if found is not None else "", told) if text)
    return ""


def asking(room: Room, all_of_it: bool = False) -> Asking:
    """What the class looks at.

    Args:
        all_of_it: whether it may be known what is right, as by the teacher.
    """
    step = room.step
    scene = room.scenes[room.stops[room.at].scene]
    question = step.question if step is not None else None
    told = question is not None and (all_of_it or room.has_told)
    return Asking(
        stop=room.at,
        phase=room.phase.value,
        round=room.round,
        title=step.title if step is not None else scene.title or scene.name,
        do=step.do if step is not None else "",
        watch=step.watch if step is not None else "",
        question=question.text if question is not None else "",
        choices=question.choices if question is not None else (),
        right=question.answer if question is not None and told else -1,
        because=question.because if question is not None and told else "",
        predict=(step.predict or 0.0) if step is not None else 0.0,
        goal=goal_text(step.goal, scene) if step is not None and step.goal is not None else "",
        collects=reading_text(step.collect, scene) if step is not None and step.collect is not None else "",
    )


def predictions(klass: Class) -> Predictions:
    """The predictions that may be seen now; one alone, if that is on the wall."""
    room = klass.room
    if room.phase not in (Phase.RESULTS, Phase.RUN, Phase.EXPLAIN):
        return Predictions()
    given = room.given(room.at, room.round if room.phase is Phase.RESULTS else 0, Ghost)
    shown = tuple(answer for answer in given if answer.id == room.on_wall) or tuple(given)
    known = _known.get(klass)
    if known is None or known[0] != shown:
        mapping = Mapping.of(klass.scene(room.at))
        points = (answer.content.points for answer in shown if isinstance(answer.content, Ghost))
        _known[klass] = known = shown, Predictions(bodies=tuple(_in_world(mapping, one) for one in points))
    return known[1]


_known: WeakKeyDictionary[Class, tuple[tuple[Answer, ...], Predictions]] = WeakKeyDictionary()
"""The predictions that each class saw last: all of its pages ask for the same."""


def found_by(room: Room) -> tuple[Found, ...]:
    """The points of the class's plot: what was handed in at the present stop, over what was set."""
    return tuple(
        Found(setting=work.setting, found=work.found)
        for answer in room.given(room.at, 0, Work)
        if isinstance(work := answer.content, Work)
        and work.setting is not None
        and work.found is not None
        and not work.doubt
    )


def law_of(found: Sequence[Found]) -> Law | None:
    """The power law of the class's plot; None where it has none."""
    law = power_law([(one.setting, one.found) for one in found])
    return None if law is None else Law(factor=law.factor, exponent=law.exponent)


def over(klass: Class) -> str:
    """What the class's plot is over: what the first slider of the present step sets."""
    step = klass.room.step
    for key in step.controls if step is not None else ():
        if key not in CHOICES:
            try:
                return setting_of(klass.scene(klass.room.at), key).label.lower()
            except SettingError:
                return key
    return ""


def places_of(positions: np.ndarray, scene: sim.Scene) -> tuple[tuple[int, int], ...]:
    """Where masses are, for a small picture: thousandths of the scene's frame from its left and upper edge.

    Args:
        positions: (n, 2), in the scene's units.
        scene: that they are of.

    Returns:
        of the first `MAX_PLACES` masses; nothing where one is nowhere.
    """
    xmin, ymin, xmax, ymax = scene.view.frame
    positions = positions[:MAX_PLACES]
    if not np.isfinite(positions).all():
        return ()
    x = (positions[:, 0] - xmin) / (xmax - xmin)
    y = (positions[:, 1] - ymin) / (ymax - ymin)
    if not scene.view.y_down:
        y = 1.0 - y
    rounded = np.clip(np.rint(1000.0 * np.column_stack((x, y))), -1000, 2000).astype(int)
    return tuple((x, y) for x, y in rounded.tolist())


def _in_world(mapping: Mapping, points: Sequence[tuple[float, float]]) -> tuple[tuple[float, float], ...]:
    """Points of the page's world, for points of a scene; rounded to what can be seen."""
    world = mapping.to_world(np.array(points))
    return tuple((round(float(x), 4), round(float(y), 4)) for x, y, _ in world)
