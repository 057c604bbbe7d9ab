"""One page's simulation, without the page: commands go in, a state to draw comes out.

Handlers only call `post` and the methods under "any thread". Everything else belongs to the ticker's thread.
"""

from __future__ import annotations

import enum
import math
import threading
import time
from collections import deque
from collections.abc import Callable
from concurrent.futures import Future
from dataclasses import dataclass, replace
from functools import partial
from typing import ClassVar, Generic, Literal, TypeVar, dataclass_transform

import msgspec

import sim
from sim.edit.edit import Edit, Selection, still_selected
from sim.errors import InputError, SceneError, SettingError
from sim.model.system import same_topology
from sim.motion.stability import StabilityEstimate

from ..words import say
from ..words.keys import Key
from . import keepsakes, log
from .companions import Companions
from .driving import Driving
from .ghost import Ghost
from .hand import FRAME, PointerHands
from .history import AbandonedFuture, History, Wanted
from .log import Log
from .modes import ModesWatch
from .notices import About, Notice, runaway_notice, shape_notice
from .pacing import HEAVY_UNIT, LONGEST_FRAME, Costs, Pacer, is_large
from .predictability import PredictabilityMeter
from .record import Recorder
from .reel import Development
from .replay import Player
from .rest_pose import RestPosePreview
from .stability import StabilityWatch
from .versions import Versions

__all__ = ["FRAME", "KEYS_FORGOTTEN_AFTER", "Notice", "Session"]

CHEAP = 0.3
"""Milliseconds in the solver per frame up to which a body at rest costs next to nothing."""

KEYS_FORGOTTEN_AFTER = 0.5
"""Seconds of silence after which held keys, and the drive of a mode, count as released: the connection may be
lost."""

MAX_QUEUE = 4000
"""Commands that may wait. No person sends more; the oldest are dropped."""

MAX_SECONDS = 0.5
"""Seconds of computing, estimated, for single steps or for one call of a replay."""

MIN_SLICE = 0.004
"""Seconds of computing that a frame gets for computing past frames again, at least."""

_AFTER_REPLAY = "it begins where a replay was left"

T = TypeVar("T")


class Refresh(enum.Enum):
    """What the page has to show again; it looks only when it is asked to."""

    NOTHING = enum.auto()
    SETTINGS = enum.auto()
    """Numbers and switches; the body is drawn exactly."""
    CONTROLS = enum.auto()
    """Also the nodes and controls, since they are those of another body or method."""
    BODY = enum.auto()
    """Also the view, since another body takes the place of the one before."""


@dataclass_transform(frozen_default=True)
class Command:
    """Something that a page asks of its session; the ticker applies it between two frames.

    Every subclass is a frozen dataclass.

    Attributes:
        refresh: what the page has to show again.
        acts: whether it does something to the body, which ends a replay.
        brings_body: whether it brings another body. It then replaces any other such command that still waits,
            since each may have many megabytes.
    """

    refresh: ClassVar[Refresh] = Refresh.NOTHING
    acts: ClassVar[bool] = False
    brings_body: ClassVar[bool] = False

    def __init_subclass__(cls) -> None:
        dataclass(frozen=True)(cls)

    def apply(self, session: Session, at: float) -> None:
        """Apply it.

        Args:
            session: of the page.
            at: wall time at which it was posted, s.

        Raises:
            InputError, SettingError, SceneError: it cannot be done; the user is notified.
        """
        raise NotImplementedError

    def takes_over(self, session: Session) -> bool:
        """Whether it ends a replay that is going on."""
        return self.acts

    @property
    def is_heavy(self) -> bool:
        """Whether it may take longer than other pages can wait for."""
        return self.brings_body

    def playing_after(self, playing: bool) -> bool:
        """Whether the clock runs after it, given whether it runs before."""
        return playing

    def is_overtaken_by(self, other: Command) -> bool:
        """Whether it need not be applied if another comes right after it."""
        return False


class _Question(Command, Generic[T]):
    """A question that only the ticker can answer, between two frames."""

    find: Callable[[], T]
    result: Future[T]

    def apply(self, session: Session, at: float) -> None:
        try:
            self.result.set_result(self.find())
        except (InputError, SceneError) as error:
            self.result.set_exception(error)


class Session:
    """The simulation of one page, and what its user is doing with it.

    Args:
        scene: what it shows first.
        clock: wall time, s.
        wait: whether a step may wait for the compiler. In a page it may not: bodies move by NumPy until then.

    Attributes:
        simulation: the body in motion; for the ticker alone.
        playing: whether the clock runs.
        follow: whether the driven mass follows the pointer.
        joint: the angular spring that is read out.
        generation: counts bodies and methods; with a new number, the page makes other nodes and controls.
        openings: counts bodies that replaced another; the view is fitted to a new one.
        scenes: counts scenes that were opened in the place of one of another name.
        revision: counts changes of settings, other than by the arrow keys.
        notices: what the user has still to be notified of.
        pacer: the clock.
        companions: bodies that are stepped with this one.
        stability_watch: keeps `stability` up to date.
        versions: the steps of undo and redo.
        selection: the parts of the body that are selected.
        follows_energy: whether the energy is followed.
        fallbacks: fallback steps since the scene was opened or reset.
        recorder: acts on the body and records a log; not while a log is played.
        history: past moments, and which of them is shown.
        development: computes a past frame again that is not stored, and those beside it; or None.
        abandoned_future: what came next before the user went back and on from there; or None.
        refusal: why the body could not keep its shape, until something else is done to it; or None.
        refused_shape: (n, 2) that shape, px.
        offer_back: whether the body ran away and can be taken back to just before that.
        replay: the log that is played, if one is.
        opened: the scene as it was opened.
        lesson_base: what the steps of its lesson begin from: the scene before its first step was opened.
        lesson_begun: whether a step of the scene's lesson has begun; if not, the page begins one.
        awaits_answer: whether the clock is stopped only until a question of the lesson is answered.
        hands: the pointers, and what they hold.
        preparing: what is being compiled, for the page to show; empty when nothing is.
        rest_pose_preview: where the body will rest, while a slider moves.
        modes: the body's slow modes, while somebody looks at them; else None.
        driving: drives one of them.
    """

    def __init__(
        self,
        scene: sim.Scene,
        clock: Callable[[], float] = time.monotonic,
        wait: bool = True,
        stands: bool = False,
    ) -> None:
        self.clock, self.can_wait, self.stands = clock, wait, stands
        self._lock = threading.Lock()
        self._queue: deque[tuple[float, Command]] = deque(maxlen=MAX_QUEUE)
        self._keys_at = -math.inf
        self.playing = not stands
        self.lesson_begun = self.awaits_answer = self.follows_energy = False
        self.generation = self.openings = self.scenes = self.revision = 0
        self.history, self.versions = History(), Versions()
        self.development: Development | None = None
        self.notices: list[Notice] = []
        self.preparing = ""
        self.pacer = Pacer()
        self._load(scene)
        self.stability_watch = StabilityWatch()
        self.refusal: sim.DesignError | None = None
        self.refused_shape = self.simulation.positions
        self.rest_pose_preview = RestPosePreview()
        self.modes: ModesWatch | None = None
        self.hands = PointerHands(lambda: self.simulation, self.do, clock)
        self.driving = Driving(lambda: self.simulation, self.do)

    def _load(self, scene: sim.Scene) -> None:
        """Replace the body, and forget all that belongs to the one before."""
        self.simulation = sim.Simulation(scene, wait=self.can_wait)
        self.opened = self.lesson_base = self.simulation.capture().scene
        self.recorder = Recorder(self.simulation, history=self.history)
        self.companions = Companions()
        self.replay: Player | None = None
        self._viewer: sim.Simulation | None = None  # shows the past of a replay
        self.follow = False
        self.joint = self.fallbacks = 0
        self.selection = Selection()
        self.pacer, self.costs = Pacer(self.pacer.speed), Costs()
        self._begin_history()

    # --------------------------------------------------------------------- what the page looks at
    def now(self) -> float:
        """Wall time, s, by the session's clock."""
        return self.clock()

    @property
    def scene(self) -> sim.Scene:
        """The scene as it is now, including the effect of the arrow keys."""
        return self.simulation.scene

    @property
    def driven(self) -> int | None:
        """The mass that the pointer drives, if the scene has one."""
        return next((a.mass for a in self.simulation.anchors if a.driven), None)

    @property
    def following(self) -> int | None:
        """The mass that follows the pointer without a button."""
        return self.driven if self.follow else None

    @property
    def ghost(self) -> Ghost | None:
        """The body of another method that is compared, if there is one."""
        return self.companions.get(Ghost)

    @property
    def predictability(self) -> PredictabilityMeter | None:
        """The meter of how fast errors grow, if it is on."""
        return self.companions.get(PredictabilityMeter)

    @property
    def stability(self) -> StabilityEstimate:
        """The last estimate of the stability limit."""
        return self.stability_watch.estimate

    @property
    def is_heavy(self) -> bool:
        """Whether the next frame may take longer than other pages can wait for."""
        costs = [self.costs.unit, *(one.costs.unit for one in self.companions)]
        return (
            max(costs) > HEAVY_UNIT
            or is_large(self.simulation.scene)
            or any(command.is_heavy for command in self.waiting)
        )

    @property
    def is_idle(self) -> bool:
        """Whether only the clock runs, at next to no cost: no hand, key or log, no other body, no command."""
        acts = self.simulation.keys or self.hands.masses or self.driving.drive is not None or self.follow
        others = (
            self.development is not None
            or self.replay is not None
            or self.modes is not None
            or len(self.companions) > 0
        )
        busy = self.notices or self.stability_watch.is_looking or self.has_commands
        cheap = self.pacer.rates(self.clock()).solver_ms < CHEAP or not self.playing
        return cheap and not (acts or others or busy)

    @property
    def has_commands(self) -> bool:
        """Whether commands wait."""
        return bool(self._queue)

    @property
    def will_play(self) -> bool:
        """Whether the clock runs once the commands that wait are applied."""
        playing = self.playing
        for command in self.waiting:
            playing = command.playing_after(playing)
        return playing

    def notice_still_applies(self, about: About) -> bool:
        """Whether the condition that a notice reports still holds."""
        return self.simulation.divergence is not None if about == "runaway" else self.refusal is not None

    @property
    def waiting(self) -> list[Command]:
        """The commands that wait; handlers may be adding more."""
        with self._lock:
            return [command for _, command in self._queue]

    # --------------------------------------------------------------------- any thread
    def post(self, command: Command) -> None:
        """Hand a command to the ticker."""
        with self._lock:
            if command.brings_body:
                waiting = (entry for entry in self._queue if not entry[1].brings_body)
                self._queue = deque(waiting, maxlen=MAX_QUEUE)
            self._queue.append((self.clock(), command))

    def snapshot(self, name: str, with_pose: bool) -> sim.Scene:
        """The scene as it is now, to be saved: with the present pose, or the one that it started from.

        Raises:
            InputError: the ticker did not answer.
        """

        def find() -> sim.Scene:
            scene = msgspec.structs.replace(self.simulation.scene, name=name)
            return msgspec.structs.replace(scene, pose=self.simulation.pose()) if with_pose else scene

        return self._ask(find)

    def log_file(self) -> bytes:
        """The log up to now, as a file; see `app.session.log`.

        Raises:
            InputError: a log is being played, or the ticker did not answer.
            SceneError: the scene cannot be written.
        """

        def find() -> bytes:
            if self.replay is not None:
                raise InputError(say("session-log-plays"))
            return self.recorder.file()

        return self._ask(find)

    def recent(self, seconds: float) -> list[tuple[sim.Moment, sim.Moment | None]]:
        """The moments of the last simulated seconds before the one that is shown, with the ghost's, or None.

        Raises:
            InputError: the ticker did not answer.
        """
        past = self._ask(lambda: self.history.recent(seconds))
        return [(moment, getattr(companions.get(Ghost.name), "moment", None)) for moment, companions in past]

    def _ask(self, find: Callable[[], T]) -> T:
        """The ticker's answer, between two frames, to any thread.

        Raises:
            InputError: it did not answer, or there is no answer.
        """
        result: Future[T] = Future()
        self.post(_Question(find, result))
        try:
            return result.result(timeout=5.0)
        except TimeoutError:
            raise InputError(say("session-busy")) from None

    # --------------------------------------------------------------------- the ticker's thread
    def drain(self) -> None:
        """Apply the commands that wait, whether or not the clock runs."""
        for _ in range(len(self._queue)):
            with self._lock:
                if not self._queue or self.is_seeking:
                    break
                at, command = self._queue.popleft()
                if self._queue and command.is_overtaken_by(self._queue[0][1]):
                    continue
            try:
                self._apply(command, at)
            except (InputError, SettingError, SceneError) as error:
                if isinstance(error, sim.DesignError):
                    self.refusal, self.refused_shape = error, self.simulation.positions
                    self.notices.append(shape_notice(error))
                else:
                    self.notices.append(Notice("error", say("session-cannot"), str(error)))
        if self.replay is None and (not self.playing or self.simulation.divergence is not None):
            self.hands.steer(self.following, glide=False)

    def _apply(self, command: Command, at: float) -> None:
        if self.replay is not None and command.takes_over(self):
            self._end_replay(say("session-replay-ended.taken"))
        if command.takes_over(self) or command.brings_body:
            self.refusal = None
        command.apply(self, at)
        self.refresh(command.refresh)

    def tick(self, budget: float, longest: float = LONGEST_FRAME) -> None:
        """Advance by one frame, as far as the clock and the budget allow; call `drain` before.

        Args:
            budget: seconds of computing.
            longest: seconds of wall time that the frame may make up for.
        """
        now = self.clock()
        if self.development is not None:
            self._develop(self.development, budget)
        if now - self._keys_at > KEYS_FORGOTTEN_AFTER:
            self.hold_keys(frozenset(), self._keys_at)
        if now - self.driving.said_at > KEYS_FORGOTTEN_AFTER:
            self.driving.fade()
        running = self.playing and (self.replay is not None or self.simulation.divergence is None)
        if running and self.replay is not None:
            self._play_log(self.replay, now, budget)
        elif running:
            self._step(now, budget, longest)
        running = running and self.playing  # the body may just have run away
        self.stability_watch.tick(self.simulation, self.revision, running, now, budget)
        if self.modes is not None:
            self.modes.tick(self.simulation, self.driving.drive is not None or bool(self.hands.masses))

    def keepsake(self) -> bytes:
        """What `resume` needs to continue from here later."""
        ghost = self.ghost
        choices = keepsakes.Choices(
            playing=self.playing,
            speed=self.pacer.speed,
            follow=self.follow,
            joint=self.joint,
            ghost=keepsakes.Second(ghost.method, ghost.law, ghost.finer) if ghost else None,
            foretell=self.predictability is not None,
            touched=self.recorder.acts > 0,
        )
        return keepsakes.encode(self.simulation.capture(), choices, self.opened, self.lesson_base)

    # --------------------------------------------------------------------- what commands do
    def refresh(self, what: Refresh) -> None:
        """Have the page show again what has changed."""
        self.revision += what is not Refresh.NOTHING
        self.generation += what in (Refresh.CONTROLS, Refresh.BODY)
        self.openings += what is Refresh.BODY

    def play(self, on: bool) -> None:
        """Run the clock, from the moment that is shown, or stop it."""
        if on:
            self.branch()
            self.offer_back = self.awaits_answer = False
        if on != self.playing:
            self.playing = on
            self.pacer.restart()
            self.refresh(Refresh.SETTINGS)

    def do_steps(self, steps: int) -> None:
        """Stop the clock, and do some steps."""
        self.play(False)
        self.branch()
        self.hands.steer(self.following, glide=True)
        led = list(self.simulation.behind)
        done = self.costs.move(self.simulation, steps, MAX_SECONDS, self.recorder.step)
        self.companions.keep_pace(self.simulation, done, MAX_SECONDS)
        self.companions.follow(self.simulation, done, led, MAX_SECONDS)
        self._after_steps()

    def do(self, act: log.Act) -> None:
        """Act by hand on the body, and on those of its companions that hands reach.

        Raises:
            InputError: it cannot be done.
        """
        self.recorder.do(act)
        self.companions.touch()
        for body in self.companions.bodies:
            # Bodies that follow at any speed are led to where this one has come to.
            if body.rate_limited or not isinstance(act, log.Follow):
                act.do(body)

    def hold_keys(self, keys: frozenset[str], at: float) -> None:
        """Hold these arrow keys, as reported at a wall time, s."""
        self._keys_at = at
        if keys != self.simulation.keys and self.replay is None:
            self.do(log.Keys.of(keys))

    def let_go(self) -> None:
        """Have all hands let go."""
        self.driving.end()
        self.hands.let_all_go(self.following)

    def _drop_hands(self) -> None:
        """Forget what hands held: another body replaces it, or it has let go by itself."""
        self.hands.drop()
        self.driving.drop()

    def jump_to(self, make: Callable[[sim.Moment], sim.Moment], label: str, key: str) -> None:
        """Continue with other positions and velocities of the same body.

        Args:
            make: makes the moment to continue from, given the present one.
            label: of the step of undo.
            key: jumps with the same key in a row are one step of undo.
        """
        self.let_go()
        before = self.simulation.capture()
        moment = make(before)
        self.branch()
        self.recorder.restore(moment)
        self.versions.add_leap(label, before, moment, key)
        self._replace_moment(Refresh.SETTINGS)

    def change(self, change: Callable[[], None], label: str, key: str = "") -> None:
        """Continue with changed settings.

        Args:
            change: changes them.
            label: of the step of undo.
            key: of a number, whose changes are one step of undo until another control is used.
        """
        before = self.simulation.capture()
        change()
        after = self.simulation.capture()
        rebuilt = not same_topology(before.scene, self.simulation.scene)
        if rebuilt:
            self.versions.add_leap(label, before, after, key)
            # Another body, whose time begins at zero: the past belongs to the one before.
            self._drop_hands()
            self._begin_history()
            self._choose_joint()
            self.selection = Selection()
            self.companions.begin(self.simulation, self.history)
        else:
            if after.scene is not before.scene:
                self.versions.add_change(label, before, after, key)
            self.companions.adapt(self.simulation)
        self.refresh(Refresh.BODY if rebuilt else Refresh.SETTINGS)
        self.stability_watch.look_soon()

    def restore_scene_values(self, of: Literal["body", "solver"]) -> None:
        """Continue with the settings of body or solver that the scene was opened with."""
        present = self.simulation.capture().scene
        with_body, with_solver = (self.opened, present) if of == "body" else (present, self.opened)
        scene = msgspec.structs.replace(
            with_body, force_law=with_solver.force_law, integrator=with_solver.integrator
        )
        self.let_go()
        own: Key = "session-own-body" if of == "body" else "session-own-solver"
        self.change(lambda: self.recorder.set_scene(scene, keys_too=of == "body"), say(own))

    def continue_at(self, moment: sim.Moment, edit: Edit | None) -> None:
        """Continue at a moment of an edited scene, at the same time.

        Args:
            moment: of the scene as it is now.
            edit: what made it of the one before; None if it is another body's.
        """
        self._drop_hands()
        self.lesson_begun = True  # it continues where it was
        self.recorder.restore(moment)
        self.selection = Selection() if edit is None else still_selected(edit, self.selection)
        if edit is None or edit.moves_parts:
            self.abandoned_future = None
            self._choose_joint()
            self.follow = self.follow and self.driven is not None
        self._replace_moment(Refresh.BODY if edit is None else Refresh.CONTROLS)
        self.stability_watch.look_soon()

    def open(self, scene: sim.Scene) -> None:
        """Show another body from the beginning of its scene, without companions."""
        self._drop_hands()
        self._load(scene)
        self.lesson_begun = True
        if self.follows_energy:
            self.recorder.do(log.FollowEnergy(on=True))
        self.stability_watch.forget()
        self.refresh(Refresh.BODY)

    def reset(self) -> None:
        """Return to the scene's start; the clock goes on if it was stopped by an explosion."""
        exploded = self.offer_back
        self.let_go()
        self.recorder.reset()
        self.fallbacks = 0
        self._begin_history()
        self.companions.begin(self.simulation, self.history)
        self.pacer.restart()
        self.stability_watch.look_soon()
        if exploded:
            self.play(True)

    def resume(self, keepsake: bytes, versions: Versions | None) -> None:
        """Continue from a keepsake.

        Args:
            keepsake: see `keepsake`.
            versions: the steps of undo at that time, if known; the session's own from then on.

        Raises:
            SceneError: it makes no sense.
        """
        try:
            saved = keepsakes.decode(keepsake)
        except SceneError as error:
            raise SceneError(say("session-not-resumed", why=str(error))) from None
        moment, choices = saved.moment, saved.choices
        known = versions.return_to(moment.scene) if versions is not None else None
        if known is not None:
            moment = replace(moment, scene=known)  # versions compare scenes by identity
        self.open(moment.scene)
        self.versions = versions if versions is not None and known is not None else Versions()
        self.opened, self.lesson_base = saved.opened, saved.lesson_base
        self.recorder.acts = int(choices.touched)
        self.recorder.restore(moment)
        self._begin_history()
        self.follow = choices.follow and self.driven is not None
        self.joint = choices.joint
        self._choose_joint()
        self.pacer.speed = choices.speed
        if (second := choices.ghost) is not None:
            ghost = Ghost(self.simulation, second.method, second.law, second.finer, self.can_wait)
            self.companions.add(ghost, self.history)
        if choices.foretell:
            self.companions.add(PredictabilityMeter(self.simulation, self.can_wait), self.history)
        self.play(choices.playing)

    # --------------------------------------------------------------------- time
    @property
    def is_seeking(self) -> bool:
        """Whether a frame that is to be shown is still being computed; all commands wait for it."""
        return self.development is not None and not self.development.is_found

    def go_to(self, frame: int | Wanted) -> None:
        """Stop the clock, and show a past frame: at once, or as soon as it is computed again."""
        if isinstance(frame, int):
            self.show(frame)
            return
        self.play(False)
        self.development = self.history.development(
            frame, lambda scene: sim.Simulation(scene, wait=self.can_wait)
        )
        if self.development is None:
            self.show(self.history.index_of(*frame))

    def _develop(self, development: Development, budget: float) -> None:
        """Go on with computing past frames again; show the wanted one once it is there."""
        sought = not development.is_found
        try:
            development.advance(max(budget, MIN_SLICE))
        except (InputError, SettingError, SceneError):  # as where kernels that it needs have gone
            self.development = None
            if sought:
                self.show(self.history.index_of(development.number, development.time))
            return
        if not development.is_found:
            return
        frames, development.frames = development.frames, development.frames[-1:]
        scenes = {id(moment.scene): moment.scene for _, moment in frames}
        known = {key: self.versions.known(scene) for key, scene in scenes.items()}
        moments = [(number, replace(moment, scene=known[id(moment.scene)])) for number, moment in frames]
        self.history.take(moments, first=sought)
        if sought:
            self.show(self.history.index_of(development.number, development.time))
        if development.has_ended:
            self.development = None

    def branch(self) -> None:
        """Abandon the moments after the one that is shown; those to come take their place."""
        self.development = None
        if self.replay is not None:
            if self.history.scrubbed:
                self.show(self.history.last)
            self.history.forget_again()
        elif newer := self.history.cut():
            self.abandoned_future = AbandonedFuture.of(newer)
            self.refresh(Refresh.SETTINGS)

    def show(self, index: int, settings: sim.Scene | None = None) -> None:
        """Stop the clock, and show a past moment.

        Args:
            index: of the moment.
            settings: a scene whose settings it gets if it is of the same body; its own otherwise.
        """
        self.play(False)
        history, before = self.history, self.simulation.capture().scene
        if self.replay is None:
            self.let_go()
            if not history.scrubbed:
                # Keep what was changed since the last frame.
                history.amend(self.simulation.capture(), self.companions.capture())
            self.recorder.restore(history[index])
            if settings is not None and same_topology(history[index].scene, settings):
                self.recorder.set_scene(settings, keys_too=False)
        elif index == history.last:
            self.simulation = self.replay.simulation  # it must continue as if nobody had looked back
        else:
            self._viewer = self._viewer or sim.Simulation(history[index].scene, wait=self.can_wait)
            self._viewer.restore(history[index])
            self.simulation = self._viewer
        self.hands.forget_pointer()
        history.shown = index
        self.offer_back = False
        self._refresh_since(before)
        self.companions.go_back(history, index, self.simulation)
        self.refresh(Refresh.SETTINGS)
        self.stability_watch.look_soon()

    def begin_replay(self, record: Log) -> None:
        """Show the body of a log, and play the log."""
        self.open(record.scene)
        self.replay = Player(record, self.simulation, history=self.history)
        self.play(True)

    # --------------------------------------------------------------------- inside
    def _choose_joint(self) -> None:
        """Read out a joint that the scene has."""
        self.joint = min(self.joint, max(0, len(self.simulation.scene.angular_springs) - 1))

    def _begin_history(self) -> None:
        self.development = None
        self.history.clear()
        self.history.add(self.simulation.capture())
        self.abandoned_future: AbandonedFuture | None = None
        self.offer_back = False

    def _add_moment(self) -> None:
        """Add this frame's moment to the history, if time has passed."""
        if self.simulation.time != self.history.end:
            self.history.add(self.simulation.capture(), self.companions.capture())

    def _replace_moment(self, refresh: Refresh) -> None:
        """Replace the newest moment after the body has jumped; its companions start from there."""
        self.companions.begin(self.simulation, self.history)
        self.history.amend(self.simulation.capture(), self.companions.capture())
        self.refresh(refresh)

    def _step(self, now: float, budget: float, longest: float) -> None:
        """Advance by a frame."""
        steps = self.pacer.grant(now, self.simulation.dt, longest)
        self.hands.steer(self.following, glide=True)
        led = list(self.simulation.behind)
        began = time.perf_counter()
        step = partial(self.driving.step, self.recorder, self.modes)
        own = 0.5 * budget if self.companions.are_in_step else budget
        done = 0 if self.companions.are_late else self.costs.move(self.simulation, steps, own, step)
        self.companions.keep_pace(self.simulation, done, budget - (time.perf_counter() - began))
        seconds = self._count(now, done, steps - done, began)
        self.companions.follow(self.simulation, done, led, budget - seconds)
        self._after_steps()

    def _count(self, now: float, done: int, missed: int, began: float) -> float:
        """Enter the steps done since `began` into the pacer; the seconds that they took."""
        seconds, stats = time.perf_counter() - began, self.simulation.stats()
        self.history.reel.spend(seconds)
        self.fallbacks += stats.fallbacks
        self.pacer.record(now, self.simulation.dt, done, seconds, stats, missed=missed)
        return seconds

    def _after_steps(self) -> None:
        self._add_moment()
        if (divergence := self.simulation.divergence) is not None:
            self.play(False)
            self.offer_back = True
            # The limit shown is that of the body as it ran away, not as it was restored.
            self.stability_watch.set(divergence.stability, self.revision)
            self.notices.append(runaway_notice(divergence, self.simulation.scene))

    def _refresh_since(self, before: sim.Scene) -> None:
        """Have the page show the settings again if they are no longer those of a scene."""
        scene = self.simulation.capture().scene
        if scene is before:
            return
        self.versions.find(scene)
        other = not same_topology(before, scene)
        if other:
            self._choose_joint()
            self.selection = Selection()  # other parts may have its numbers
            self.abandoned_future = None
        controls = (scene.force_law, scene.integrator.method)
        other = other or controls != (before.force_law, before.integrator.method)
        self.refresh(Refresh.CONTROLS if other else Refresh.SETTINGS)

    def _play_log(self, player: Player, now: float, budget: float) -> None:
        """Advance a replay by a frame."""
        simulation = player.simulation
        if not simulation.complete:
            simulation.take_compiled()  # until then, steps would differ in their last bits
            return
        steps = self.pacer.grant(now, simulation.dt)
        scene, began = simulation.capture().scene, time.perf_counter()
        try:
            most, attempts = self.costs.affordable(MAX_SECONDS), self.costs.attempts(MAX_SECONDS)
            done = player.advance(steps * simulation.dt, budget, most, attempts)
        except InputError as error:
            self._end_replay(say("session-replay-ended.stuck", why=str(error)))
            return
        self.costs.learn(done, time.perf_counter() - began, simulation.work)
        self._count(now, done, 0, began)
        self._add_moment()
        self._refresh_since(scene)
        if player.ended:
            self.play(False)
            ends: Key = "session-replay-ended.agrees" if player.agrees else "session-replay-ended.differs"
            self._end_replay(say(ends, verdict=player.verdict), "info" if player.agrees else "warning")

    def _end_replay(self, text: str, kind: Literal["info", "warning"] = "info") -> None:
        self.replay = self._viewer = None
        self.recorder = Recorder(self.simulation, _AFTER_REPLAY, self.history)
        self.hold_keys(frozenset(), self._keys_at)
        self.refresh(Refresh.SETTINGS)
        self.notices.append(Notice(kind, say("session-replay-ended"), text))
