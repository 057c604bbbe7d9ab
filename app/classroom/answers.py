"""What pupils give in a class: a class for each kind of answer.

A kind is all that the server knows of its answers in one place: when the class is asked for them, what makes
one valid, what it is called in pages and in files (its tag, and its cells in `answers.csv`), and how it
reads. Pages send it as a message with `Give` before its name, see app/wire/from_page.py.
"""

from __future__ import annotations

import enum
import math
import unicodedata
from typing import Annotated, ClassVar, Literal, Self

import msgspec
from msgspec import Meta, Struct

import sim
from sim.scene.lesson import Step
from sim.scene.types import Damage

from ..wire.messages import AnswerKind
from ..words import joined, number, say
from ..words.english import of

MAX_LINE_LENGTH = 140
"""Letters of a line that a pupil writes."""

MAX_MARKS_PER_LETTER = 3
"""Combining marks on one letter: no language needs more, and stacks of them cover other lines."""

MAX_COORDINATE = 1e7
"""Largest coordinate of a prediction, in the scene's units."""

Id = Annotated[str, Meta(pattern=r"^[0-9a-f]{16}$")]
Coordinate = Annotated[float, Meta(ge=-MAX_COORDINATE, le=MAX_COORDINATE)]
Points = Annotated[tuple[tuple[Coordinate, Coordinate], ...], Meta(min_length=1, max_length=2000)]


Cells = tuple[str, str | float, bool | None]
"""Of an answer in `answers.csv`: what it is called, what it says, and whether it is right, if it can be."""


class Refused(Exception):
    """A request cannot be met; the message is a sentence for whoever made it."""


class Phase(enum.Enum):
    """What the class is doing."""

    LOBBY = "lobby"
    """Pupils come in."""
    SHOW = "show"
    """All look at the teacher's body."""
    ASK = "ask"
    """Each one predicts, unseen by the others."""
    RESULTS = "results"
    """All look at what was predicted."""
    RUN = "run"
    """All see the same run."""
    REVEAL = "reveal"
    """All see what is right, with the body as it stands after the run."""
    EXPLAIN = "explain"
    """Each one writes a line."""
    TRY = "try"
    """Each one has a body of their own."""
    COLLECT = "collect"
    """Each one hands in what they found, with a body of their own."""


OWN_BODY = frozenset((Phase.TRY, Phase.COLLECT))
"""Phases in which each pupil has a body of their own; in the others all look at the teacher's."""

SEALED = frozenset((Phase.ASK, Phase.EXPLAIN))
"""Phases whose answers nobody else sees before the next phase."""


def sanitize_line(text: str, max_length: int) -> str:
    """Put typed text on one line, without invisible characters and without marks that cover other lines."""
    visible, marks = "", 0
    for c in unicodedata.normalize("NFC", text):
        category = unicodedata.category(c)[0]
        marks = marks + 1 if category == "M" else 0
        if marks <= MAX_MARKS_PER_LETTER:
            visible += " " if category in "CZ" else c
    return " ".join(visible.split())[:max_length].strip()


class Content(Struct, frozen=True, forbid_unknown_fields=True, tag_field="kind", tag=str.lower):
    """What an answer says.

    Attributes:
        kind: what pages call it.
        phase: in which the class is asked for it.
    """

    kind: ClassVar[AnswerKind]
    phase: ClassVar[Phase]

    @property
    def words(self) -> str:
        """The answer as text; empty for one that is no text."""
        return ""

    def checked(self, scene: sim.Scene, step: Step | None) -> Self:
        """Return the content as the class stores it.

        Args:
            scene: that the answer is about.
            step: of its lesson, if it has one.

        Raises:
            Refused: it does not answer what the step asks.
        """
        return self

    def cells(self, step: Step | None) -> Cells | None:
        """Return its cells in `answers.csv`; None if it has no row there."""
        return None


class Vote(Content, frozen=True):
    """One of the choices of a question, counted from 0."""

    kind: ClassVar = "vote"
    phase: ClassVar = Phase.ASK
    choice: Annotated[int, Meta(ge=0, le=4)]

    def checked(self, scene: sim.Scene, step: Step | None) -> Self:
        """See `Content`."""
        if step is None or step.question is None or not 0 <= self.choice < len(step.question.choices):
            raise Refused(say("class-refuse-no-choice"))
        return self

    def cells(self, step: Step | None) -> Cells | None:
        """See `Content`."""
        question = step.question if step is not None else None
        if question is None:
            return None
        return say("zip-vote"), of(question.choices[self.choice]), self.choice == question.answer


class Prediction(Content, frozen=True, tag="ghost"):
    """Where each mass will be, in the scene's units. Files call it a ghost."""

    kind: ClassVar = "prediction"
    phase: ClassVar = Phase.ASK
    points: Points

    def checked(self, scene: sim.Scene, step: Step | None) -> Self:
        """See `Content`."""
        asked = step is not None and step.predict is not None and len(self.points) == len(scene.masses)
        # NaN is within no bounds; a file with it could not be read again.
        if not asked or not all(abs(c) <= MAX_COORDINATE for point in self.points for c in point):
            raise Refused(say("class-refuse-no-such-place"))
        return self


class Line(Content, frozen=True):
    """An explanation, as text."""

    kind: ClassVar = "line"
    phase: ClassVar = Phase.EXPLAIN
    text: Annotated[str, Meta(min_length=1, max_length=MAX_LINE_LENGTH)]

    @property
    def words(self) -> str:
        """See `Content`."""
        return self.text

    def checked(self, scene: sim.Scene, step: Step | None) -> Self:
        """See `Content`."""
        if not (text := sanitize_line(self.text, MAX_LINE_LENGTH)):
            raise Refused(say("class-refuse-no-letter"))
        return msgspec.structs.replace(self, text=text)

    def cells(self, step: Step | None) -> Cells | None:
        """See `Content`."""
        return say("zip-line"), self.text, None


class Doubt(Struct, frozen=True, forbid_unknown_fields=True):
    """Why a log cannot be a pupil's own run, without the words of a language.

    Attributes:
        key: of the text.
        what: stands in its place.
    """

    key: Literal[
        "class-doubt-begins",
        "class-doubt-goes-on",
        "class-doubt-begins-other",
        "class-doubt-goes-on-other",
        "class-doubt-sets",
        "class-doubt-never",
        "class-doubt-long",
    ]
    what: str = ""


def doubt_text(doubt: Doubt | str) -> str:
    """A doubt in the language that is spoken now; one that is a text already is left as it is."""
    return doubt if isinstance(doubt, str) else say(doubt.key, what=doubt.what)


class Work(Content, frozen=True):
    """A run that a pupil handed in, and its results.

    Attributes:
        log: name of the file of the run's log in the class's folder; empty if it could not be stored.
        found: the reading that the step collects; None without one.
        setting: the first number that the step has a slider for: the abscissa of the class's plot.
        reached: whether the step's goal was reached; None without a goal.
        doubt: why the log cannot be a pupil's own run, a text where the
            simulation says why; empty if it can.
        points: final positions of the masses, and
        damage: what had yielded and broken, for a picture; empty if a position was not finite.
    """

    kind: ClassVar = "work"
    phase: ClassVar = Phase.COLLECT
    log: Annotated[str, Meta(max_length=40)] = ""
    found: float | None = None
    setting: float | None = None
    reached: bool | None = None
    doubt: Doubt | str = ""
    points: tuple[tuple[float, float], ...] = ()
    damage: Damage | None = None

    @property
    def words(self) -> str:
        """See `Content`."""
        goal = "" if self.reached is None else say("class-at-goal" if self.reached else "class-not-at-goal")
        found = "" if self.found is None else number(self.found, 4)
        return joined((found, goal))

    def checked(self, scene: sim.Scene, step: Step | None) -> Self:
        """See `Content`."""

        def finite(value: float | None) -> float | None:
            return value if value is not None and math.isfinite(value) else None

        # A body that has exploded may be handed in, but JSON has no NaN.
        is_somewhere = all(math.isfinite(c) for point in self.points for c in point)
        return msgspec.structs.replace(
            self,
            found=finite(self.found),
            setting=finite(self.setting),
            points=self.points if is_somewhere else (),
        )

    def cells(self, step: Step | None) -> Cells | None:
        """See `Content`."""
        return say("zip-work"), "" if self.found is None else self.found, self.reached


AnyContent = Vote | Prediction | Line | Work
"""All kinds: a new one is added here."""


def kinds_of(phase: Phase) -> tuple[type[Content], ...]:
    """Return the kinds of answers that a phase asks for."""
    return tuple(kind for kind in Content.__subclasses__() if kind.phase is phase)


class Answer(Struct, frozen=True):
    """One answer of one pupil.

    Attributes:
        id: made up by the pupil's page.
        turn: counts the answers of that page; of two to the same, the one with the larger turn counts,
            whichever arrives first.
        seat: number of the seat.
        twin: 0, or 1 for the second of two pupils at one seat.
        stop: the stop of the class that it is for.
        round: 0 for the first time that this is asked, 1 for the second.
        content: what it says.
        late: whether it arrived after the others' had been shown.
        starred: whether the teacher has picked it out.
    """

    id: Id
    turn: Annotated[int, Meta(ge=0, le=1_000_000)]
    seat: int
    twin: int
    stop: int
    round: int
    content: AnyContent
    late: bool = False
    starred: bool = False

    @property
    def slot(self) -> tuple[int, int, int, int, type]:
        """What it is the answer to; a later one to the same replaces it."""
        return self.seat, self.twin, self.stop, self.round, type(self.content)
