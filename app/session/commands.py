"""What a page can ask of its session: small values that callbacks enqueue and the ticker applies.

Positions are in the scene's unit (px), in the scene's own coordinates. Nothing here is trusted: every number
is checked when the command is applied.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

from sim import Moment, Scene
from sim.edit.edit import Edit, Selection, carried, existing
from sim.edit.texts import as_own
from sim.errors import InputError
from sim.motion.simulation import KEYS
from sim.scene.types import shown_name
from sim.settings import CHOICES, settings_of

from ..stage.looks import SPEEDS
from . import log
from .ghost import Ghost
from .hand import DRAG_EVENT, FRAME
from .log import Log
from .pacing import is_large
from .predictability import PredictabilityMeter
from .session import Command, Refresh, Session
from .versions import Versions

_MAX_STEPS = 1000
"""Single steps that are done at once, at most."""
_NOT_OF_REST = ("tempo", "dt", "tolerance")
"""Settings that have nothing to do with where a body rests."""


# ------------------------------------------------------------------------- by hand
@dataclass(frozen=True)
class HoldKeys(Command):
    """The arrow keys that are down now; it is repeated while any are."""

    keys: frozenset[str]

    def apply(self, session: Session, at: float) -> None:
        session.hold_keys(self.keys & KEYS, at)

    def takes_over(self, session: Session) -> bool:
        return bool(self.keys)


@dataclass(frozen=True)
class Point(Command):
    """Where a hand's pointer is; used while it has a mass, and that of hand 0 while something follows.

    Attributes:
        late: whether the next report comes later than the next frame, as of viser's own drags.
    """

    x: float
    y: float
    hand: int = 0
    late: bool = False

    def apply(self, session: Session, at: float) -> None:
        # What follows the pointer must not disturb a moment that was gone back to.
        if session.hands.is_full(self.hand) or not session.history.scrubbed:
            session.hands.point(self.hand, self.x, self.y, at + (DRAG_EVENT if self.late else FRAME))


@dataclass(frozen=True)
class Follow(Command):
    """Whether the driven mass follows the pointer without a button."""

    on: bool
    refresh = Refresh.SETTINGS

    def apply(self, session: Session, at: float) -> None:
        session.follow = self.on and session.driven is not None
        session.hands.forget_pointer()

    def takes_over(self, session: Session) -> bool:
        return self.on


@dataclass(frozen=True)
class DragStart(Command):
    """A hand took hold of a mass, with its pointer at (x, y); see `hand.GIZMO` for that of a gizmo."""

    mass: int
    x: float
    y: float
    hand: int = 0
    acts = True

    def apply(self, session: Session, at: float) -> None:
        session.hands.take(self.hand, self.mass, self.x, self.y)


@dataclass(frozen=True)
class DragEnd(Command):
    """A hand let go of its mass."""

    hand: int = 0

    def apply(self, session: Session, at: float) -> None:
        session.hands.let_go(self.hand, session.following)


# ------------------------------------------------------------------------- settings
@dataclass(frozen=True)
class SetValue(Command):
    """A setting's slider or box has a new value."""

    key: str
    value: float
    acts = True

    def apply(self, session: Session, at: float) -> None:
        setting = next((s for s in settings_of(session.simulation.scene) if s.key == self.key), None)
        if setting is None or not math.isfinite(self.value):
            return
        value = min(max(self.value, setting.low), setting.high)
        act = log.Set(key=self.key, value=value)
        session.change(lambda: session.recorder.do(act), setting.label, self.key)
        if self.key not in _NOT_OF_REST:
            session.rest_pose_preview.look(session.simulation, session.now())


@dataclass(frozen=True)
class Visit(Command):
    """A slider was pressed, or a number box entered: what is changed from here on is another step of undo."""

    def apply(self, session: Session, at: float) -> None:
        session.versions.end_step()


@dataclass(frozen=True)
class SetChoice(Command):
    """Something of a list was chosen, by its key in `sim.settings.CHOICES`."""

    key: str
    value: str
    acts = True
    refresh = Refresh.CONTROLS

    def apply(self, session: Session, at: float) -> None:
        label = CHOICES[self.key].label if self.key in CHOICES else self.key
        act = log.Choose(key=self.key, value=self.value)
        session.change(lambda: session.recorder.do(act), label)
        if self.key == "method" and session.follows_energy:
            # What is left over is the error of one method, not of two.
            session.recorder.do(log.FollowEnergy(on=False))
            session.recorder.do(log.FollowEnergy(on=True))


@dataclass(frozen=True)
class RestoreSceneValues(Command):
    """The settings are to be those that the scene was opened with, of the body or of the solver."""

    of: Literal["body", "solver"]
    acts = True
    refresh = Refresh.CONTROLS

    def apply(self, session: Session, at: float) -> None:
        session.restore_scene_values(self.of)


@dataclass(frozen=True)
class Compare(Command):
    """A second body is wanted that does the same by another method, or a reference, or none ("").

    Its time step, or its tolerance, is to be so many times smaller.
    """

    method: str
    law: str
    finer: int = 1
    acts = True
    refresh = Refresh.SETTINGS

    def apply(self, session: Session, at: float) -> None:
        if not self.method:
            session.companions.remove(Ghost, session.history)
            return
        ghost = Ghost(session.simulation, self.method, self.law, self.finer, session.can_wait)
        session.companions.add(ghost, session.history)


@dataclass(frozen=True)
class MeasurePredictability(Command):
    """Whether it is to be told how fast errors grow."""

    on: bool
    acts = True
    refresh = Refresh.SETTINGS

    def apply(self, session: Session, at: float) -> None:
        if self.on:
            session.companions.add(PredictabilityMeter(session.simulation, session.can_wait), session.history)
        else:
            session.companions.remove(PredictabilityMeter, session.history)


@dataclass(frozen=True)
class FollowEnergy(Command):
    """Whether the energy is to be followed."""

    on: bool
    acts = True
    refresh = Refresh.SETTINGS

    def apply(self, session: Session, at: float) -> None:
        session.follows_energy = self.on
        session.recorder.do(log.FollowEnergy(on=self.on))


@dataclass(frozen=True)
class SelectJoint(Command):
    """The joint whose angle is read out."""

    joint: int
    refresh = Refresh.SETTINGS

    def apply(self, session: Session, at: float) -> None:
        if 0 <= self.joint < len(session.simulation.scene.angular_springs):
            session.joint = self.joint


# ------------------------------------------------------------------------- editing
MakeEdit = Callable[[Moment, Selection], Edit]
"""Makes an edit of a moment's scene and of what is selected; raises SceneError or SettingError where that
cannot be done.
"""

FindParts = Callable[[Moment, Selection], Selection]
"""Finds what is to be selected, from a moment and what is selected now."""


@dataclass(frozen=True)
class Change(Command):
    """The body is to be edited; edits with the same key that follow each other are one step of undo.

    Attributes:
        make: makes the edit.
        key: of those that are one step.
        within: seconds between two of them, at most; or until the next `Visit`.
        heavy: whether it may take longer than other pages can wait for.
    """

    make: MakeEdit
    key: str = ""
    within: float = math.inf
    heavy: bool = False
    acts = True

    @property
    def is_heavy(self) -> bool:
        return self.heavy

    def apply(self, session: Session, at: float) -> None:
        before = session.simulation.capture()
        edit = as_own(self.make(before, session.selection), before.scene)
        if edit.scene is not before.scene:
            session.branch()
            session.versions.add_edit(edit, before, self.key, session.now(), self.within)
            session.continue_at(carried(edit, before), edit)


@dataclass(frozen=True)
class Select(Command):
    """Other parts of the body are to be selected."""

    find: FindParts

    def apply(self, session: Session, at: float) -> None:
        moment = session.simulation.capture()
        session.selection = existing(self.find(moment, session.selection), moment.scene)


@dataclass(frozen=True)
class Undo(Command):
    """The last change of the scene is to be taken back; the run goes on."""

    def apply(self, session: Session, at: float) -> None:
        _go_on_at(session, session.versions.undo(session.simulation.capture()))

    def takes_over(self, session: Session) -> bool:
        return session.versions.has_undo(session.simulation.capture().scene)


@dataclass(frozen=True)
class Redo(Command):
    """What was taken back last is to be done again."""

    def apply(self, session: Session, at: float) -> None:
        _go_on_at(session, session.versions.redo(session.simulation.capture()))

    def takes_over(self, session: Session) -> bool:
        return session.versions.has_redo(session.simulation.capture().scene)


def _go_on_at(session: Session, version: tuple[Moment, Edit | None] | None) -> None:
    """Go on at another version of the scene, if there is one."""
    if version is not None:
        session.branch()
        session.continue_at(*version)


# ------------------------------------------------------------------------- another body
@dataclass(frozen=True)
class Open(Command):
    """Another scene is to be shown from its beginning.

    Attributes:
        begun: whether it is as a step of its lesson begins; otherwise the page is to begin one.
        waits: whether it is to stand until a question of its lesson is answered.
    """

    scene: Scene
    begun: bool = False
    waits: bool = False
    brings_body = True

    def apply(self, session: Session, at: float) -> None:
        # What stopped the clock was the other body's.
        stopped = session.simulation.divergence is not None or session.waits
        # The first step of a lesson is no other scene than the one that has just been opened.
        begins = self.begun and not session.lesson_begun
        before = session.simulation.capture()
        session.open(self.scene)
        session.lesson_begun = self.begun
        opened = session.simulation.capture()
        if begins:
            session.versions.amend_leap(opened)
        else:
            session.versions.add_leap(f"opening {shown_name(self.scene)}", before, opened)
        if stopped or self.waits:
            session.play(not self.waits)
        session.waits = self.waits

    @property
    def is_heavy(self) -> bool:
        return is_large(self.scene)


@dataclass(frozen=True)
class Replay(Command):
    """A log is to be played, at the pace at which time passed in it."""

    log: Log
    brings_body = True

    def apply(self, session: Session, at: float) -> None:
        session.begin_replay(self.log)


@dataclass(frozen=True)
class Resume(Command):
    """A page is to go on where a keepsake was made, see `Session.resume`."""

    keepsake: bytes
    versions: Versions | None = None
    brings_body = True

    def apply(self, session: Session, at: float) -> None:
        session.resume(self.keepsake, self.versions)


# ------------------------------------------------------------------------- time
@dataclass(frozen=True)
class Play(Command):
    """Run, from the moment that is shown; pause; or the other of the two (None)."""

    on: bool | None = None

    def apply(self, session: Session, at: float) -> None:
        session.play(self.playing_after(session.playing))

    def playing_after(self, playing: bool) -> bool:
        return not playing if self.on is None else self.on


@dataclass(frozen=True)
class DoSteps(Command):
    """Pause, and do some steps."""

    steps: int
    acts = True

    def apply(self, session: Session, at: float) -> None:
        session.do_steps(max(0, min(self.steps, _MAX_STEPS)))

    def playing_after(self, playing: bool) -> bool:
        return False


@dataclass(frozen=True)
class Reset(Command):
    """Back to the scene's start."""

    acts = True
    refresh = Refresh.SETTINGS

    def apply(self, session: Session, at: float) -> None:
        session.reset()


@dataclass(frozen=True)
class Speed(Command):
    """Simulated seconds per second."""

    factor: float
    refresh = Refresh.SETTINGS

    def apply(self, session: Session, at: float) -> None:
        factor = self.factor if math.isfinite(self.factor) else 1.0
        session.pacer.speed = min(max(factor, SPEEDS[0]), SPEEDS[-1])


@dataclass(frozen=True)
class GoTo(Command):
    """Pause, and show the moment nearest to a simulated time, s."""

    time: float

    def apply(self, session: Session, at: float) -> None:
        if not math.isfinite(self.time):
            raise InputError(f"t = {self.time} s: that is no time to go to")
        session.show(session.history.nearest(self.time))


@dataclass(frozen=True)
class GoBack(Command):
    """Pause, and show the moment so many simulated seconds before the one shown; 0 is one frame."""

    seconds: float = 0.0

    def apply(self, session: Session, at: float) -> None:
        if not math.isfinite(self.seconds):
            raise InputError(f"{self.seconds} s: that is no time to go back by")
        session.show(session.history.back(self.seconds))


@dataclass(frozen=True)
class GoForward(Command):
    """Pause, and show the moment one frame after the one shown."""

    def apply(self, session: Session, at: float) -> None:
        session.show(min(session.history.shown + 1, session.history.last))


@dataclass(frozen=True)
class ForgetFuture(Command):
    """The old future is no longer wanted."""

    refresh = Refresh.SETTINGS

    def apply(self, session: Session, at: float) -> None:
        session.abandoned_future = None


@dataclass(frozen=True)
class BackBeforeDivergence(Command):
    """Pause, and show the body as it was before it ran away."""

    def apply(self, session: Session, at: float) -> None:
        session.show(session.history.before_runaway())
