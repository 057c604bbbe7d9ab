"""What a page is in a class, and what all of these have in common."""

from __future__ import annotations

import itertools
import re
from collections.abc import Sequence
from datetime import datetime
from functools import cache
from typing import Any
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import ArrayLike

import sim
from app.classroom.answers import OWN_BODY, Answer, Phase, Points, Prediction, Work
from app.classroom.law import power_law
from app.classroom.live import Class, PupilStatus, SharedView
from app.classroom.plotted import Plotted
from app.classroom.room import Place, Room
from sim.scene.lesson import Question, Step
from sim.store.files import built_in_folder

from ...lessons import goal_text, read_masses, reading_text, run_text
from ...session.framing import Bounds
from ...session.session import Session
from ...stage.plan import own_rest_angles
from ...stage.sketch import Mapping
from ...ui.controls import Controls
from ...ui.view import picture_of
from ...wire import from_page
from ...wire.carrier import Mail
from ...wire.line import Line
from ...words import number, say
from ...words.english import name_of, step_of
from ..files.sharing import qr_code
from .messages import Asking, ClassEnded, Found, Law, LessonName, Predictions, Seat
from .shared_view import broadcast, same_view

NOTHING = Controls(())

SHOWN = frozenset((Phase.RESULTS, Phase.RUN, Phase.REVEAL, Phase.EXPLAIN))
"""Phases in which all see what was predicted."""

HEADLINE = 64
"""Letters of a first sentence that says why, up to which it stands on the wall with the right answer."""

MAX_PLACES = 60
"""Masses in a small picture of a body."""

MAX_OPENINGS = 1_000_000
"""Bodies that one page opens at most, so that no two pages number theirs alike."""

_numbers = itertools.count()

plan_numbers = itertools.count(1_000_000)
"""Of plans that several pages of a class have: no page has so many of its own."""


class Role:
    """What one page is, if it is not an ordinary page. Only the ticker calls it, except for `allows`."""

    @property
    def controls(self) -> Controls | None:
        """The controls that the page has now; None for those that it would have anyway."""
        return NOTHING

    @property
    def bounds(self) -> Bounds | None:
        """(2, 2) px, where the body moves that the page shows; None while that is not known."""
        return None

    @property
    def plots(self) -> tuple[str, ...]:
        """The plots of the page's own body, as `app.session.plots.parse_plot` reads them."""
        return ()

    @property
    def front_plots(self) -> Plotted | None:
        """The plots of the body that all look at, if the page shows them."""
        return None

    @property
    def shared_view(self) -> SharedView | None:
        """What the page shows instead of a body of its own, or None."""
        return None

    @property
    def describes(self) -> bool:
        """Whether the body of the page's own session is the one that it shows, and may be described."""
        return False

    def allows(self, said: from_page.FromPage) -> bool:
        """Whether the page may say that, whoever is behind it; called from any thread."""
        return isinstance(said, from_page.Who)

    def introduce(self, who: from_page.Who, session: Session) -> None:
        """Take the secrets of the page's browser."""

    def hear(self, said: from_page.FromPage, session: Session) -> None:
        """Do what the page says in the class."""

    def frame(self, session: Session) -> None:
        """Between two frames: tell the page what has changed."""

    def keep(self, keepsake: bytes) -> bool:
        """Store the state of the page's body; False if its browser is to store it."""
        return True

    def leave(self) -> None:
        """The page is gone."""


class Entrance(Role):
    """The page of somebody who has named no class, or one that does not exist.

    Args:
        mail: to the page's script.
        problem: why the page is in no class; empty if none was named.
    """

    def __init__(self, mail: Mail, problem: str) -> None:
        self._mail, self._problem = mail, problem

    def frame(self, session: Session) -> None:
        self._mail.send(Seat(problem=self._problem))


def lesson_names() -> tuple[LessonName, ...]:
    """Return the lessons that come with softrod, in the order of their titles' numbers."""
    return tuple(LessonName(name=scene.name, title=name_of(scene)) for scene in _lessons())


@cache
def _lessons() -> list[sim.Scene]:
    scenes = [sim.load_scene(path.stem) for path in sorted((built_in_folder() / "lessons").glob("*.json"))]
    return sorted(scenes, key=lambda scene: [int(n) for n in re.findall(r"\d+", scene.title)][:1])


class ClassRole(Role):
    """What one page is in a class.

    Args:
        classroom: the class.
        mail: to the page's script.
        address: by which pupils come in, with a slash at its end.

    Attributes:
        classroom: as above.
    """

    def __init__(self, classroom: Class, mail: Mail, address: str = "") -> None:
        self.classroom = classroom
        self._mail, self._own_address = mail, address
        self._told_end = False
        self._known: tuple[Any, ...] = ()
        self._first_opening = MAX_OPENINGS * next(_numbers)
        self._plan = -1, -1  # of the session, when it was shown last
        self._plan_number = 0
        self._angles = np.empty(0)

    @property
    def address(self) -> str:
        """By which pupils come in, with a slash at its end."""
        return self.classroom.base or self._own_address

    @property
    def qr(self) -> str:
        """A picture of the QR code of the class's address, as an address."""
        return qr_code(f"{self.address}?room={self.room.code}")

    @property
    def bounds(self) -> Bounds | None:
        return self.classroom.bounds(self.room.at)

    @property
    def room(self) -> Room:
        """The class's state."""
        return self.classroom.room

    @property
    def shared_view(self) -> SharedView | None:
        return self.classroom.shared_view

    def frame(self, session: Session) -> None:
        if not self.classroom.ended:
            self.classroom.poll_writer()
            self._update(session)
        elif not self._told_end:
            self._told_end = True
            self._mail.send(ClassEnded())

    def _update(self, session: Session) -> None:
        """Tell the page what has changed in the running class."""
        raise NotImplementedError

    def _share(self, session: Session, before: SharedView | None, audience: set[Line]) -> SharedView:
        """Return the view of the page's own body for others, and send its picture to them.

        Args:
            session: of the page.
            before: its last view, which is returned if nobody can tell the two apart.
            audience: the pages that look at it.
        """
        plan = session.openings, session.revision
        if plan != self._plan:
            self._plan, self._plan_number = plan, next(plan_numbers)
            self._angles = own_rest_angles(session.simulation)
        opening = self._first_opening + session.openings
        picture, playing, speed = picture_of(session), session.playing, session.pacer.speed
        view = SharedView(
            self._plan_number, audience, session.scene, opening, self._angles, picture, playing, speed
        )
        if before is not None and same_view(before, view):
            return before
        broadcast(view, session.now())
        return view

    def _is_new(self, *things: Any) -> bool:
        """Whether the class, or one of these things, has changed since the last call."""
        known, classroom = self._known, self.classroom
        self._known = (self.room.version, classroom.teachers, len(classroom.pupils), *things)
        return known != self._known


def asking(room: Room, reveal: bool = False, place: Place | None = None) -> Asking:
    """Return what the class looks at.

    Args:
        room: of the class.
        reveal: whether to tell the right answer while pupils may not know it.
        place: of a pupil who is elsewhere than the class; None for the class's.
    """
    stop, phase, round = place = place or room.place
    own, scene = room.step_at(stop), room.scenes[room.stops[stop].scene]
    step = step_of(own) if own is not None else None
    question = step.question if step is not None else None
    is_told = question is not None and (reveal or room.may_reveal(place))
    return Asking(
        stop=stop,
        phase=phase.value,
        round=round,
        title=room.title(stop),
        do=step.do if step is not None else "",
        watch=step.watch if step is not None else "",
        question=question.text if question is not None else "",
        choices=question.choices if question is not None else (),
        right=question.answer if question is not None and is_told else -1,
        because=_because(question, phase, reveal) if question is not None and is_told else "",
        runs=run_text(step.run, scene) if step is not None and step.run else "",
        predict=(step.predict or 0.0) if step is not None else 0.0,
        masses=read_masses(step, scene) if step is not None and step.predict else (),
        goal=goal_text(step.goal, scene) if step is not None and step.goal is not None else "",
        collects=reading_text(step.collect, scene) if step is not None and step.collect is not None else "",
    )


def _because(question: Question, phase: Phase, reveal: bool) -> str:
    """Why an answer is right: until all have written their own line, a headline alone, if there is one."""
    if reveal or phase not in (Phase.REVEAL, Phase.EXPLAIN):
        return question.because
    first = re.split(r"(?<=[.?!])\s", question.because, maxsplit=1)[0]
    return first if len(first) <= HEADLINE else ""


def home_text(room: Room) -> str:
    """Return when what is right in homework is told, as "15 January, 08:00"; empty for a class."""
    if not room.is_home:
        return ""
    at = datetime.fromtimestamp(room.until or 0.0)
    return say("class-told-at", day=at.day, month=at.month, time=f"{at:%H:%M}")


def predictions(classroom: Class) -> Predictions:
    """Return the predictions that may be seen now; one alone, if that is on the wall."""
    room = classroom.room
    if room.phase not in SHOWN or room.is_home:
        return Predictions()
    given = room.given(room.at, 0, Prediction)
    shown = [one for one in given if one[0].id == room.on_wall] or given
    answers = tuple(answer for answer, _ in shown)
    known = _known.get(classroom)
    if known is None or known[0] != answers:
        mapping = Mapping.of(classroom.scene(room.at))
        bodies = tuple(in_world(mapping, prediction.points) for _, prediction in shown)
        _known[classroom] = known = answers, Predictions(bodies=bodies)
    return known[1]


_known: WeakKeyDictionary[Class, tuple[tuple[Answer, ...], Predictions]] = WeakKeyDictionary()
"""The predictions that each class saw last: all of its pages ask for the same."""


def found_by(room: Room, stop: int) -> tuple[Found, ...]:
    """Return the points of the class's plot: what was handed in at a stop, over what was set."""
    return tuple(
        Found(setting=work.setting, found=work.found)
        for _, work in room.given(stop, 0, Work)
        if work.setting is not None and work.found is not None and not work.doubt
    )


def law_of(found: Sequence[Found]) -> Law | None:
    """Return the power law of the class's plot; None where it has none."""
    law = power_law([(one.setting, one.found) for one in found])
    return None if law is None else Law(factor=law.factor, exponent=law.exponent)


def count_bodies(classroom: Class) -> dict[str, int]:
    """Count the bodies that explode, stand untouched or do neither, while each seat that is here has its own.

    Those that have handed in are not among them. With a goal, all that have reached it are counted as well.
    """
    room = classroom.room
    if room.phase not in OWN_BODY:
        return {}
    here, answered = classroom.present(), room.answered()
    bodies = {number: classroom.statuses.get(number, PupilStatus()) for number in here}
    busy = [body for number, body in bodies.items() if number not in answered]
    exploded = sum(body.word == "exploded" for body in busy)
    idle = sum(body.is_untouched for body in busy)
    counts = {"trying": len(busy) - exploded - idle, "exploded": exploded, "untouched": idle}
    if (step := room.step) is not None and step.goal is not None:
        counts["at the goal"] = sum(body.word == "goal reached" for body in bodies.values())
    return counts


def places_of(positions: np.ndarray, scene: sim.Scene) -> tuple[tuple[int, int], ...]:
    """Return places for a small picture: thousandths of the scene's frame from its left and upper edge.

    Args:
        positions: (n, 2), in the scene's units.
        scene: that they are of.

    Returns:
        of the first `MAX_PLACES` masses; nothing if one is not finite.
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


def predicted(answer: Prediction, scene: sim.Scene, step: Step | None) -> tuple[list[int], Points]:
    """Return the masses that a prediction moves, and where it puts each.

    Args:
        answer: the prediction.
        scene: the scene as its step begins.
        step: the step, which may ask for some masses only.
    """
    held = {anchor.mass for anchor in scene.anchors}
    asked = (read_masses(step, scene) if step is not None else ()) or range(len(scene.masses))
    free = [mass for mass in asked if mass not in held]
    return free, tuple(answer.points[mass] for mass in free)


def moved_text(scene: sim.Scene, masses: Sequence[int], points: Sequence[tuple[float, float]]) -> str:
    """Return how far a mass has been moved from its start, as in "87.2 px lower"; empty for several masses.

    Args:
        scene: as it starts.
        masses: indices of those that were moved.
        points: where each of them is now, in the scene's units.
    """
    if len(masses) != 1:
        return ""
    (x, y), (to_x, to_y) = scene.masses[masses[0]].position, points[0]
    across, down = to_x - x, (to_y - y) if scene.view.y_down else y - to_y
    if abs(down) >= abs(across):
        length = f"{number(abs(down))} {scene.view.unit}"
        return say("class-moved.lower" if down > 0.0 else "class-moved.higher", length=length)
    length = f"{number(abs(across))} {scene.view.unit}"
    return say("class-moved.right" if across > 0.0 else "class-moved.left", length=length)


def in_world(mapping: Mapping, points: ArrayLike) -> tuple[tuple[float, float], ...]:
    """Convert points of a scene to the page's world, rounded to what can be seen."""
    world = mapping.to_world(np.array(points))
    return tuple((round(float(x), 4), round(float(y), 4)) for x, y, _ in world)
