"""What a page is in a class, and what all of these have in common."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Literal
from weakref import WeakKeyDictionary

import numpy as np

import sim
from app.classroom.live import Class, Front
from app.classroom.room import Answer, Content, Ghost, Line, Phase, Room, Vote, Work
from sim.errors import InputError
from sim.motion.quantities import quantity
from sim.scene.lesson import Goal, Reading

from ...drawing.sketch import Mapping
from ...session.session import Session
from ...wire import from_page
from ...wire.carrier import Mail
from ...wire.to_page import Asking, ClassEnded, Predictions, Seat
from ..controls import Controls

Kind = Literal["vote", "ghost", "line", "work"]
_KINDS: dict[type[Content], Kind] = {Vote: "vote", Ghost: "ghost", Line: "line", Work: "work"}

NOTHING = Controls(())


class Role:
    """What one page is, where it is no page of its own. The ticker alone calls it, but for `allows`.

    Attributes:
        place: HTML above the panel's sliders, where the page's script finds room.
    """

    place = ""

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
        self._mail.tell(Seat(problem=self._problem))


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

    @property
    def room(self) -> Room:
        """The class's state."""
        return self.klass.room

    @property
    def front(self) -> Front | None:
        return self.klass.front

    def _is_new(self, *things: Any) -> bool:
        """Whether the class, or one of these things, is another than the last time that this was asked."""
        known, klass = self._known, self.klass
        self._known = (self.room.version, klass.teachers, len(klass.pupils), *things)
        return known != self._known

    def _tell_end(self) -> bool:
        """Whether the class is over; the page is told once."""
        if self.klass.ended and not self._told_end:
            self._told_end = True
            self._mail.tell(ClassEnded())
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


def reading_text(reading: Reading, scene: sim.Scene) -> str:
    """A reading in words, as in "period of mass1.y"."""
    return f"period of {reading.quantity}" if reading.of == "period" else reading.quantity


def goal_text(goal: Goal, scene: sim.Scene) -> str:
    """A goal in words, as in "period of mass1.y: 1.98 to 2.02 s"."""
    try:
        unit = "s" if goal.of == "period" else quantity(goal.quantity, scene).unit
    except InputError:
        unit = ""
    low, high = (None if bound is None else f"{bound:.6g}" for bound in (goal.low, goal.high))
    span = f"{low} to {high}" if low and high else f"at least {low}" if low else f"at most {high}"
    held = f", for {goal.seconds:g} s" if goal.seconds else ""
    return f"{reading_text(goal, scene)}: {span} {unit}".rstrip() + held


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


def _in_world(mapping: Mapping, points: Sequence[tuple[float, float]]) -> tuple[tuple[float, float], ...]:
    """Points of the page's world, for points of a scene; rounded to what can be seen."""
    world = mapping.to_world(np.array(points))
    return tuple((round(float(x), 4), round(float(y), 4)) for x, y, _ in world)
