"""What a page can ask of its session: small values that callbacks enqueue and the ticker applies.

Positions are in the scene's unit (px), in the scene's own coordinates. Nothing here is trusted: the session
checks every number when it applies the command.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from concurrent.futures import Future
from dataclasses import dataclass
from typing import Literal

from sim import Moment, Scene
from sim.edit.edit import Edit, Selection

from .log import Log
from .versions import Versions


@dataclass(frozen=True)
class HoldKeys:
    """The arrow keys that are down now; it is repeated while any are."""

    keys: frozenset[str]


@dataclass(frozen=True)
class Point:
    """Where a hand's pointer is; used while it has a mass, and that of hand 0 while something follows."""

    x: float
    y: float
    hand: int = 0


@dataclass(frozen=True)
class Points:
    """Where the pointers of several hands are."""

    points: tuple[Point, ...]


@dataclass(frozen=True)
class Follow:
    """Whether the driven mass follows the pointer without a button."""

    on: bool


@dataclass(frozen=True)
class DragStart:
    """A hand took hold of a mass, with its pointer at (x, y); see `hand.GIZMO` for that of a gizmo."""

    mass: int
    x: float
    y: float
    hand: int = 0


@dataclass(frozen=True)
class DragTo:
    """As `Point`, from whom the next report comes later."""

    x: float
    y: float
    hand: int = 0


@dataclass(frozen=True)
class DragEnd:
    """A hand let go of its mass."""

    hand: int = 0


@dataclass(frozen=True)
class SetValue:
    """A setting's slider or box has a new value."""

    key: str
    value: float


@dataclass(frozen=True)
class Visit:
    """A slider was pressed, or a number box entered: what is changed from here on is another step of undo."""


@dataclass(frozen=True)
class SetChoice:
    """Something of a list was chosen, by its key in `sim.settings.CHOICES`."""

    key: str
    value: str


@dataclass(frozen=True)
class OwnValues:
    """The settings are to be those that the scene was opened with, of the body or of the solver."""

    of: Literal["body", "solver"]


@dataclass(frozen=True)
class Compare:
    """A second body is wanted that does the same by another method, or a reference, or none ("").

    Its time step, or its tolerance, is to be so many times smaller.
    """

    method: str
    law: str
    finer: int = 1


@dataclass(frozen=True)
class Foretell:
    """Whether it is to be told how fast errors grow."""

    on: bool


@dataclass(frozen=True)
class KeepBooks:
    """Whether the energy is to be followed."""

    on: bool


MakeEdit = Callable[[Moment, Selection], Edit]
"""Makes an edit of a moment's scene and of what is selected; raises SceneError or SettingError where that
cannot be done.
"""

FindParts = Callable[[Moment, Selection], Selection]
"""Finds what is to be selected, from a moment and what is selected now."""

StepVersions = Callable[[Moment], tuple[Moment, Edit | None] | None]
"""Leads from the present moment to that of another version of the scene, if there is one, and says over which
edit; None for another body.
"""


@dataclass(frozen=True)
class Change:
    """The body is to be edited; edits with the same key that follow each other are one step of undo.

    Attributes:
        make: makes the edit.
        key: of those that are one step.
        within: seconds between two of them, at most; or until the next `Visit`.
    """

    make: MakeEdit
    key: str = ""
    within: float = math.inf


@dataclass(frozen=True)
class Select:
    """Other parts of the body are to be selected."""

    find: FindParts


@dataclass(frozen=True)
class Undo:
    """The last change of the scene is to be taken back; the run goes on."""


@dataclass(frozen=True)
class Redo:
    """What was taken back last is to be done again."""


@dataclass(frozen=True)
class Open:
    """Another scene is to be shown from its beginning.

    Attributes:
        begun: whether it is as a step of its lesson begins; otherwise the page is to begin one.
        waits: whether it is to stand until a question of its lesson is answered.
    """

    scene: Scene
    begun: bool = False
    waits: bool = False


@dataclass(frozen=True)
class Play:
    """Run, from the moment that is shown; pause; or the other of the two (None)."""

    on: bool | None = None


@dataclass(frozen=True)
class DoSteps:
    """Pause, and do some steps."""

    steps: int


@dataclass(frozen=True)
class Reset:
    """Back to the scene's start."""


@dataclass(frozen=True)
class Speed:
    """Simulated seconds per second."""

    factor: float


@dataclass(frozen=True)
class SelectJoint:
    """The joint whose angle is read out."""

    joint: int


@dataclass(frozen=True)
class Snapshot:
    """The scene as it is now is wanted, to be saved; the result is set between two frames."""

    name: str
    with_pose: bool
    result: Future[Scene]


@dataclass(frozen=True)
class Recent:
    """The moments of the last simulated seconds before the one that is shown are wanted, each with the second
    body's, or None."""

    seconds: float
    result: Future[list[tuple[Moment, Moment | None]]]


@dataclass(frozen=True)
class GoTo:
    """Pause, and show the moment nearest to a simulated time, s."""

    time: float


@dataclass(frozen=True)
class GoBack:
    """Pause, and show the moment so many simulated seconds before the one shown; 0 is one frame."""

    seconds: float = 0.0


@dataclass(frozen=True)
class GoForward:
    """Pause, and show the moment one frame after the one shown."""


@dataclass(frozen=True)
class ForgetFuture:
    """The old future is no longer wanted."""


@dataclass(frozen=True)
class BackBeforeDivergence:
    """Pause, and show the body as it was before it ran away."""


@dataclass(frozen=True)
class SaveLog:
    """The log until now is wanted, as a file's bytes; the result is set between two frames."""

    result: Future[bytes]


@dataclass(frozen=True)
class Replay:
    """A log is to be played, at the pace at which time passed in it."""

    log: Log


@dataclass(frozen=True)
class Resume:
    """A page is to go on where a keepsake was made, see `Session.keepsake`.

    Attributes:
        keepsake: as above.
        versions: what it had to undo, if that is known; the session's own from then on.
    """

    keepsake: bytes
    versions: Versions | None = None


Command = (
    HoldKeys | Point | Points | Follow | DragStart | DragTo | DragEnd | SetValue | Visit | SetChoice
    | OwnValues
    | Compare | Foretell | KeepBooks | Change | Select | Undo | Redo | Open | Play | DoSteps | Reset | Speed
    | SelectJoint | Snapshot | Recent
    | GoTo | GoBack | GoForward | ForgetFuture | BackBeforeDivergence | SaveLog | Replay | Resume
)  # fmt: skip
