"""The commands of a session: small values that handlers post and the ticker applies.

Positions are in the scene's unit (px) and coordinates. Nothing here is trusted: every number is checked when
the command is applied.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Literal

from sim import Moment, Scene
from sim.edit.edit import Edit, Selection, carried, existing
from sim.edit.texts import as_own
from sim.errors import InputError
from sim.motion.simulation import KEYS
from sim.settings import CHOICES, settings_of

from ..stage.looks import SPEEDS
from ..words import say
from ..words.english import name_of
from ..words.keys import Key
from ..words.settings import label_of, label_of_choice
from . import log
from .ghost import Ghost
from .hand import DRAG_EVENT, FRAME
from .log import Log
from .notices import Notice
from .pacing import is_large
from .predictability import PredictabilityMeter
from .session import Command, Refresh, Session
from .versions import Versions

_MAX_STEPS = 1000
"""Single steps of one command, at most."""
_NOT_OF_REST = ("tempo", "dt", "tolerance")
"""Settings that do not change where a body rests."""


# ------------------------------------------------------------------------- by hand
class HoldKeys(Command):
    """Hold the arrow keys that are down now; repeated while any are."""

    keys: frozenset[str]

    def apply(self, session: Session, at: float) -> None:
        session.hold_keys(self.keys & KEYS, at)

    def takes_over(self, session: Session) -> bool:
        return bool(self.keys)


class Point(Command):
    """Move a hand's pointer: of a hand that holds a mass, or of hand 0 while a mass follows it.

    Attributes:
        late: whether the next report comes later than the next frame, as those of viser's own drags do.
    """

    x: float
    y: float
    hand: int = 0
    late: bool = False

    def apply(self, session: Session, at: float) -> None:
        # A mass that follows the pointer must not disturb a past moment.
        if session.hands.is_full(self.hand) or not session.history.scrubbed:
            session.hands.point(self.hand, self.x, self.y, at + (DRAG_EVENT if self.late else FRAME))


class Follow(Command):
    """Have the driven mass follow the pointer without a button, or not."""

    on: bool
    refresh = Refresh.SETTINGS

    def apply(self, session: Session, at: float) -> None:
        session.follow = self.on and session.driven is not None
        session.hands.forget_pointer()

    def takes_over(self, session: Session) -> bool:
        return self.on


class DragStart(Command):
    """Take a mass in a hand, with its pointer at (x, y); see `hand.GIZMO` for the hand of a gizmo."""

    mass: int
    x: float
    y: float
    hand: int = 0
    acts = True

    def apply(self, session: Session, at: float) -> None:
        session.hands.take(self.hand, self.mass, self.x, self.y)


class DragEnd(Command):
    """Let go of a hand's mass."""

    hand: int = 0

    def apply(self, session: Session, at: float) -> None:
        session.hands.let_go(self.hand, session.following)


# ------------------------------------------------------------------------- settings
class SetValue(Command):
    """Set a number, by its slider or box."""

    key: str
    value: float
    acts = True

    def apply(self, session: Session, at: float) -> None:
        setting = next((s for s in settings_of(session.simulation.scene) if s.key == self.key), None)
        if setting is None or not math.isfinite(self.value):
            return
        value = min(max(self.value, setting.low), setting.high)
        act = log.Set(key=self.key, value=value)
        session.change(lambda: session.recorder.do(act), label_of(setting), self.key)
        if self.key not in _NOT_OF_REST:
            session.rest_pose_preview.update(session.simulation, session.now())


class Visit(Command):
    """A slider was pressed, or a number box entered: begin another step of undo."""

    def apply(self, session: Session, at: float) -> None:
        session.versions.end_step()


class SetChoice(Command):
    """Make a choice, by its key in `sim.settings.CHOICES`."""

    key: str
    value: str
    acts = True
    refresh = Refresh.CONTROLS

    def apply(self, session: Session, at: float) -> None:
        label = label_of_choice(self.key) if self.key in CHOICES else self.key
        act = log.Choose(key=self.key, value=self.value)
        session.change(lambda: session.recorder.do(act), label)
        if self.key == "method" and session.follows_energy:
            # The residual is then the error of one method, not of two.
            session.recorder.do(log.FollowEnergy(on=False))
            session.recorder.do(log.FollowEnergy(on=True))


class RestoreSceneValues(Command):
    """Restore the settings that the scene was opened with, of the body or of the solver."""

    of: Literal["body", "solver"]
    acts = True
    refresh = Refresh.CONTROLS

    def apply(self, session: Session, at: float) -> None:
        session.restore_scene_values(self.of)


class Compare(Command):
    """Compare with a second body of another method, with a reference, or with none ("").

    Its time step, or its tolerance, is smaller by the factor `finer`; see `Ghost`.
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


class MeasurePredictability(Command):
    """Measure how fast errors grow, or not."""

    on: bool
    acts = True
    refresh = Refresh.SETTINGS

    def apply(self, session: Session, at: float) -> None:
        if self.on:
            session.companions.add(PredictabilityMeter(session.simulation, session.can_wait), session.history)
        else:
            session.companions.remove(PredictabilityMeter, session.history)


class FollowEnergy(Command):
    """Follow the energy, or not."""

    on: bool
    acts = True
    refresh = Refresh.SETTINGS

    def apply(self, session: Session, at: float) -> None:
        session.follows_energy = self.on
        session.recorder.do(log.FollowEnergy(on=self.on))


class SelectJoint(Command):
    """Read out the angle of a joint."""

    joint: int
    refresh = Refresh.SETTINGS

    def apply(self, session: Session, at: float) -> None:
        if 0 <= self.joint < len(session.simulation.scene.angular_springs):
            session.joint = self.joint


# ------------------------------------------------------------------------- editing
MakeEdit = Callable[[Moment, Selection], Edit]
"""Makes an edit of a moment's scene and of the selection; raises SceneError or SettingError if it cannot."""

FindParts = Callable[[Moment, Selection], Selection]
"""Finds the next selection, given a moment and the present one."""


class Change(Command):
    """Edit the body; edits with the same key in a row are one step of undo.

    Attributes:
        make: makes the edit.
        key: of those that are one step; a `Visit` ends it.
        within: seconds between two of them, at most.
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


class Select(Command):
    """Select other parts of the body."""

    find: FindParts

    def apply(self, session: Session, at: float) -> None:
        moment = session.simulation.capture()
        session.selection = existing(self.find(moment, session.selection), moment.scene)


class Undo(Command):
    """Take back the last change of the scene; the motion continues."""

    def apply(self, session: Session, at: float) -> None:
        _continue_at(session, session.versions.undo(session.simulation.capture()), "session-back-to.redo")

    def takes_over(self, session: Session) -> bool:
        return session.versions.has_undo(session.simulation.capture().scene)


class Redo(Command):
    """Do again what was taken back last."""

    def apply(self, session: Session, at: float) -> None:
        _continue_at(session, session.versions.redo(session.simulation.capture()), "session-back-to.undo")

    def takes_over(self, session: Session) -> bool:
        return session.versions.has_redo(session.simulation.capture().scene)


def _continue_at(session: Session, version: tuple[Moment, Edit | None] | None, back: Key) -> None:
    """Continue at another version of the scene, if there is one; say so where that is another scene.

    Args:
        session: whose scene it is.
        version: see `Session.continue_at`.
        back: says what leads back.
    """
    if version is not None:
        before = session.scene
        session.branch()
        session.continue_at(*version)
        now = session.scene
        if version[1] is None and now.name != before.name:
            text = say(back, scene=name_of(before))
            title = say("session-back-to", scene=name_of(now))
            session.notices.append(Notice("info", title, text))


# ------------------------------------------------------------------------- another body
class Open(Command):
    """Show another scene from its beginning.

    Attributes:
        begun: whether it is the beginning of a step of its lesson; otherwise the page begins one.
        waits: whether its clock is stopped until a question of its lesson is answered.
    """

    scene: Scene
    begun: bool = False
    waits: bool = False
    brings_body = True

    def apply(self, session: Session, at: float) -> None:
        # The clock was stopped because of the other body.
        stopped, answered = session.offer_back or session.awaits_answer, session.awaits_answer
        # The first step of a lesson replaces the scene that has just been opened.
        begins = self.begun and not session.lesson_begun
        before, base = session.simulation.capture(), session.lesson_base
        session.open(self.scene)
        if self.begun and base.lesson == self.scene.lesson:
            session.lesson_base = base
        session.lesson_begun = self.begun
        opened = session.simulation.capture()
        session.scenes += opened.scene.name != before.scene.name
        if begins:
            session.versions.amend_leap(opened)
        else:
            session.versions.add_leap(say("session-opening", scene=name_of(self.scene)), before, opened)
        # What was predicted is run because its user has asked for it.
        stands = session.stands and not (answered and self.begun)
        if stopped or stands or self.waits:
            session.play(not (stands or self.waits))
        session.awaits_answer = self.waits

    @property
    def is_heavy(self) -> bool:
        return is_large(self.scene)


class Replay(Command):
    """Play a log, at the pace of its simulated time."""

    log: Log
    brings_body = True

    def apply(self, session: Session, at: float) -> None:
        session.begin_replay(self.log)


class Resume(Command):
    """Continue from a keepsake; see `Session.resume`."""

    keepsake: bytes
    versions: Versions | None = None
    brings_body = True

    def apply(self, session: Session, at: float) -> None:
        session.resume(self.keepsake, self.versions)


# ------------------------------------------------------------------------- time
class Play(Command):
    """Run, from the moment that is shown; pause; or toggle (None)."""

    on: bool | None = None

    def apply(self, session: Session, at: float) -> None:
        session.play(self.playing_after(session.playing))

    def playing_after(self, playing: bool) -> bool:
        return not playing if self.on is None else self.on


class DoSteps(Command):
    """Pause, and do some steps."""

    steps: int
    acts = True

    def apply(self, session: Session, at: float) -> None:
        session.do_steps(max(0, min(self.steps, _MAX_STEPS)))

    def playing_after(self, playing: bool) -> bool:
        return False


class Reset(Command):
    """Return to the scene's start."""

    acts = True
    refresh = Refresh.SETTINGS

    def apply(self, session: Session, at: float) -> None:
        session.reset()


class Speed(Command):
    """Set the simulated seconds per second."""

    factor: float
    refresh = Refresh.SETTINGS

    def apply(self, session: Session, at: float) -> None:
        factor = self.factor if math.isfinite(self.factor) else 1.0
        session.pacer.speed = min(max(factor, SPEEDS[0]), SPEEDS[-1])


class GoTo(Command):
    """Pause, and show the moment nearest to a simulated time, s."""

    time: float

    def apply(self, session: Session, at: float) -> None:
        if not math.isfinite(self.time):
            raise InputError(f"t = {self.time} s: that is no time to go to")
        session.go_to(session.history.at(self.time))

    def is_overtaken_by(self, other: Command) -> bool:
        return isinstance(other, GoTo)


class GoBack(Command):
    """Pause, and show the moment some simulated seconds before the one shown; 0 is one frame."""

    seconds: float = 0.0

    def apply(self, session: Session, at: float) -> None:
        if not math.isfinite(self.seconds):
            raise InputError(f"{self.seconds} s: that is no time to go back by")
        session.go_to(session.history.back(self.seconds))


class GoForward(Command):
    """Pause, and show the moment one frame after the one shown."""

    def apply(self, session: Session, at: float) -> None:
        session.go_to(session.history.beside(1))


class ForgetFuture(Command):
    """Remove the abandoned future."""

    refresh = Refresh.SETTINGS

    def apply(self, session: Session, at: float) -> None:
        session.abandoned_future = None


class BackBeforeDivergence(Command):
    """Pause, and show the body as it was before it ran away.

    If the time step was too long, it keeps the settings of now: they are what is to be mended.
    """

    def apply(self, session: Session, at: float) -> None:
        found = session.simulation.divergence
        mends = found is not None and found.dt > found.stability.limit
        session.show(session.history.before_runaway(), session.simulation.capture().scene if mends else None)
