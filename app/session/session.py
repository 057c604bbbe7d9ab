"""One page's simulation, without the page: commands go in, a state to draw comes out.

Callbacks only call `post`, from any thread. Everything else is called by the ticker alone.
"""

from __future__ import annotations

import math
import threading
import time
from collections import deque
from collections.abc import Callable
from concurrent.futures import Future
from dataclasses import replace
from typing import TypeVar

import msgspec

import sim
from sim.errors import InputError, SceneError, SettingError
from sim.methods.registry import METHODS
from sim.motion.simulation import KEYS
from sim.motion.stability import Look
from sim.scene.types import shown_name
from sim.settings import CHOICES

from . import commands, keepsakes
from .commands import Command
from .editing import Editing
from .ghost import Ghost
from .hand import DRAG_EVENT, FRAME
from .notices import Notice, runaway
from .pacing import HEAVY_UNIT, is_large
from .shadow import Foresight
from .timeline import MOST_SECONDS
from .versions import Versions

__all__ = ["FRAME", "KEYS_FORGOTTEN_AFTER", "SPEEDS", "Notice", "Session"]

KEYS_FORGOTTEN_AFTER = 0.5
"""Seconds of silence after which held keys count as released: the connection may be gone."""

SPEEDS = (0.125, 0.25, 0.5, 1.0, 2.0, 4.0)
MAX_QUEUE = 4000
"""Commands that wait at most; beyond that the page is not a person, and the oldest are dropped."""

STABILITY_EVERY, STABILITY_SHARE = 0.25, 0.02
"""Seconds between two looks at the stability limit, at least; and the share of the budget that they may
take."""
LOOK_SHARE = 0.1
"""Share of a frame's budget that a look may take: that at a large body goes on over many frames."""

T = TypeVar("T")

_OTHER_BODY = (commands.Open, commands.Replay, commands.Resume)
"""Commands that bring another body."""


class Session(Editing):
    """The simulation of one page, and what its user is doing with it.

    Args and attributes: see `Running`.
    """

    def __init__(
        self, scene: sim.Scene, clock: Callable[[], float] = time.monotonic, wait: bool = True
    ) -> None:
        super().__init__(scene, clock, wait)
        self._lock = threading.Lock()
        self._queue: deque[tuple[float, Command]] = deque(maxlen=MAX_QUEUE)
        self._estimated = -1  # revision at the last look at the stability limit
        self._looked = 0.0  # seconds of computing that the present look has taken
        self._keys_at = -math.inf

    @property
    def heavy(self) -> bool:
        """Whether the next frame may take longer than others can wait for."""
        waiting = self._waiting()
        beside = self.ghost, self.foresight
        opened = [command.scene for command in waiting if isinstance(command, commands.Open)]
        return (
            max([self.pacer.unit_cost, *(other.unit_cost for other in beside if other)]) > HEAVY_UNIT
            or any(map(is_large, (self.simulation.scene, *opened)))
            or any(isinstance(command, commands.Resume | commands.Replay) for command in waiting)
        )

    @property
    def is_looking(self) -> bool:
        """Whether `stability` is still to be that of the present body."""
        return self._look is not None

    @property
    def will_play(self) -> bool:
        """Whether the clock runs once the commands that wait are applied."""
        playing = self.playing
        for command in self._waiting():
            match command:
                case commands.Play(on):
                    playing = not playing if on is None else on
                case commands.DoSteps():
                    playing = False
        return playing

    def _waiting(self) -> list[Command]:
        """The commands that wait; handlers may be adding to them."""
        with self._lock:
            return [command for _, command in self._queue]

    # --------------------------------------------------------------------- any thread
    def post(self, command: Command) -> None:
        """Hand a command to the ticker."""
        with self._lock:
            if isinstance(command, _OTHER_BODY):
                # It may be of many megabytes, and takes the place of any other that still waits.
                waiting = (entry for entry in self._queue if not isinstance(entry[1], _OTHER_BODY))
                self._queue = deque(waiting, maxlen=MAX_QUEUE)
            self._queue.append((self._clock(), command))

    def snapshot(self, name: str, with_pose: bool) -> sim.Scene:
        """The scene as it is now, to be saved; with the present pose, or with the one it started from.

        Any thread may ask; the ticker makes it between two frames.

        Raises:
            InputError: the ticker did not answer.
        """
        request = commands.Snapshot(name, with_pose, Future())
        self.post(request)
        return _answer(request.result)

    def log_file(self) -> bytes:
        """The log until now, as a file, see `app.session.log`. Any thread may ask.

        Raises:
            InputError: a log is being played, or the ticker did not answer.
            SceneError: the scene cannot be written.
        """
        request = commands.SaveLog(Future())
        self.post(request)
        return _answer(request.result)

    def recent(self, seconds: float) -> list[tuple[sim.Moment, sim.Moment | None]]:
        """What the page has shown in the last simulated seconds; see `commands.Recent`. Any thread may ask.

        Raises:
            InputError: the ticker did not answer.
        """
        request = commands.Recent(seconds, Future())
        self.post(request)
        return _answer(request.result)

    # --------------------------------------------------------------------- the ticker's
    def tick(self, budget: float) -> None:
        """Go on by one frame, as far as the clock and the budget allow; `drain` comes before.

        Args:
            budget: seconds of computing that the frame may take.
        """
        now = self._clock()
        if self.replay is None and now - self._keys_at > KEYS_FORGOTTEN_AFTER:
            self._hold(frozenset())
        running = self.playing and (self.replay is not None or self.simulation.divergence is None)
        if running and self.replay is not None:
            self._play_log(self.replay, now, budget)
        elif running:
            self._step(now, budget)
        # While the clock stands, only what its user changes can move the limit.
        running = running and self.playing  # it may have ended just now
        due = now >= self._stability_due and (running or self._estimated != self.revision)
        if self._look is None and due:
            self._estimated, self._looked = self.revision, 0.0
            self._look = self.simulation.stability_in_parts()
        if self._look is not None:
            self._go_on_looking(self._look, now, budget)

    def keepsake(self) -> bytes:
        """What is needed to go on later where this page is now, see `commands.Resume`; the ticker's, too."""
        ghost = self.ghost
        return keepsakes.encode(
            self.simulation.capture(),
            keepsakes.Wishes(
                playing=self.playing,
                speed=self.pacer.speed,
                follow=self.follow,
                joint=self.joint,
                ghost=keepsakes.Second(ghost.method, ghost.law, ghost.finer) if ghost else None,
                foretell=self.foresight is not None,
            ),
            self.opened,
        )

    def drain(self) -> None:
        """Apply the commands that wait; also while the clock stands."""
        for _ in range(len(self._queue)):
            with self._lock:
                if not self._queue:
                    break
                at, command = self._queue.popleft()
            try:
                if self.replay is not None and self._is_input(command):
                    self._end_replay("You have taken over from the replay.")
                if not (self._apply_to_time(command) or self._apply_to_scene(command)):
                    self._apply(command, at)
            except (InputError, SettingError, SceneError) as error:
                self.notices.append(Notice("error", "That cannot be done", str(error)))
        if self.replay is None and (not self.playing or self.simulation.divergence is not None):
            self.hands.steer(self._following, glide=False)

    # --------------------------------------------------------------------- inside
    def _go_on_looking(self, look: Look, now: float, budget: float) -> None:
        """Go on with a look at the stability limit, for a share of a frame, but by one part at least."""
        began = time.perf_counter()
        try:
            next(look)
            while time.perf_counter() - began < LOOK_SHARE * budget:
                next(look)
        except StopIteration as end:
            self._look, self.stability = None, end.value
        self._looked += time.perf_counter() - began
        if self._look is None and self._estimated == self.revision:
            share = STABILITY_SHARE * budget / FRAME
            self._stability_due = now + max(STABILITY_EVERY, self._looked / share)

    def _apply(self, command: Command, at: float) -> None:
        match command:
            case commands.HoldKeys(keys):
                self._hold(keys & KEYS)
                self._keys_at = at
            case commands.Point():
                self._point(command, at)
            case commands.Points(points):
                for point in points:
                    self._point(point, at)
            case commands.DragTo(x, y, hand):
                self.hands.point(hand, x, y, at + DRAG_EVENT)
            case commands.Follow(on):
                self.follow = on and self.driven is not None
                self.hands.forget_pointer()
            case commands.DragStart(mass, x, y, hand):
                self.hands.take(hand, mass, x, y)
            case commands.DragEnd(hand):
                self.hands.let_go(hand, self._following)
            case commands.SetValue(key, value):
                self._set(key, value)
            case commands.SetChoice(key, value):
                label = CHOICES[key].label if key in CHOICES else key
                self._change(lambda: self.recorder.set_choice(key, value), label)
                self.generation += 1  # other controls
                if key == "method" and self.books:
                    # What is left over is the error of one method, not of two.
                    self.recorder.keep_books(False)
                    self.recorder.keep_books(True)
            case commands.OwnValues(of):
                self._own_values(of)
                self.generation += 1
            case commands.Compare(method, law, finer):
                self.history.forget_ghosts()
                self.ghost = Ghost(self.simulation, method, law, finer, self._wait) if method else None
                self.revision += 1
            case commands.Foretell(on):
                self.history.forget_shadows()
                self.foresight = Foresight(self.simulation, self._wait) if on else None
                self.revision += 1
            case commands.KeepBooks(on):
                self.books = on
                self.recorder.keep_books(on)
                self.revision += 1
            case commands.Open(scene, begun, waits):
                # What stopped the clock was the other body's.
                stopped = self.simulation.divergence is not None or self.waits
                before = self.simulation.capture()
                self._open(scene)
                self.lesson_begun = begun
                opened = self.simulation.capture()
                self.versions.add_leap(f"opening {shown_name(scene)}", before, opened)
                if stopped or waits:
                    self.play(not waits)
                self.waits = waits
            case commands.Play(on):
                self.play(not self.playing if on is None else on)
            case commands.DoSteps(steps):
                self.play(False)
                self._branch()
                self.hands.steer(self._following, glide=True)
                led = list(self.simulation.behind)
                done = self.recorder.step(max(0, min(steps, 1000)), self.pacer.attempts(MOST_SECONDS))
                self._follow(done, led, MOST_SECONDS)
                self._after_steps()
            case commands.Reset():
                self._let_go()
                self.recorder.reset()
                self.fallbacks = 0
                self._begin_history()
                if self.ghost is not None:
                    self.ghost.start_from(self.simulation)
                if self.foresight is not None:
                    self.foresight.begin(self.simulation)
                self.pacer.restart()
                self.revision += 1
            case commands.Speed(factor):
                self.pacer.speed = min(max(factor, SPEEDS[0]), SPEEDS[-1]) if math.isfinite(factor) else 1.0
                self.revision += 1
            case commands.Snapshot(name, with_pose, result):
                scene = msgspec.structs.replace(self.simulation.scene, name=name)
                if with_pose:
                    scene = msgspec.structs.replace(scene, pose=self.simulation.pose())
                result.set_result(scene)
            case commands.Recent(seconds, result):
                result.set_result(self.history.recent(seconds))
            case commands.SaveLog(result):
                self._save_log(result)
            case commands.Replay(record):
                self._begin_replay(record)
            case commands.Resume(keepsake, versions):
                self._resume(keepsake, versions)
            case commands.SelectJoint(joint):
                if 0 <= joint < len(self.simulation.scene.angular_springs):
                    self.joint = joint

    def _point(self, point: commands.Point, at: float) -> None:
        # What follows the pointer must not disturb a moment that was gone back to.
        if self.hands.is_full(point.hand) or not self.history.scrubbed:
            self.hands.point(point.hand, point.x, point.y, at + FRAME)

    def _step(self, now: float, budget: float) -> None:
        """Go on by a frame."""
        # A method with steps of its own is held to the budget by what it may try.
        own = METHODS[self.simulation.method].adaptive
        steps = self.pacer.grant(now, self.simulation.dt, math.inf if own else budget)
        self.hands.steer(self._following, glide=True)
        led = list(self.simulation.behind)
        began = time.perf_counter()
        done = self.recorder.step(steps, attempts=self.pacer.attempts(budget))
        seconds, stats = time.perf_counter() - began, self.simulation.stats()
        self.fallbacks += stats.fallbacks
        self.pacer.record(now, self.simulation.dt, done, seconds, stats, missed=steps - done)
        self._follow(done, led, budget - seconds)
        self._after_steps()

    def _is_input(self, command: Command) -> bool:
        """Whether a command does something to the body."""
        match command:
            case commands.HoldKeys(keys):
                return bool(keys)
            case commands.Follow(on):
                return on
            case commands.DragStart() | commands.SetValue() | commands.SetChoice() | commands.DoSteps():
                return True
            case commands.Change():
                return True
            case commands.Undo():
                return self.versions.has_undo(self.simulation.capture().scene)
            case commands.Redo():
                return self.versions.has_redo(self.simulation.capture().scene)
            case commands.Reset() | commands.KeepBooks() | commands.Compare() | commands.Foretell():
                return True
            case commands.OwnValues():
                return True
            case _:
                return False

    # --------------------------------------------------------------------- logs and keepsakes
    def _save_log(self, result: Future[bytes]) -> None:
        try:
            if self.replay is not None:
                raise InputError("a log is being played; there is nothing else to save")
            result.set_result(self.recorder.file())
        except (InputError, SceneError) as error:
            result.set_exception(error)

    def _resume(self, data: bytes, versions: Versions | None) -> None:
        try:
            kept = keepsakes.decode(data)
        except SceneError as error:
            raise SceneError(f"could not be resumed: {error}") from None
        moment, wishes = kept.moment, kept.wishes
        known = versions.return_to(moment.scene) if versions is not None else None
        if known is not None:
            moment = replace(moment, scene=known)  # by which the versions know it
        self._open(moment.scene)
        self.versions = versions if versions is not None and known is not None else Versions()
        self.opened = kept.opened
        self.recorder.restore(moment)
        self._begin_history()
        self.follow = wishes.follow and self.driven is not None
        self.joint = min(wishes.joint, max(0, len(moment.scene.angular_springs) - 1))
        self.pacer.speed = wishes.speed
        if wishes.ghost is not None:
            second = wishes.ghost
            self.ghost = Ghost(self.simulation, second.method, second.law, second.finer, self._wait)
        if wishes.foretell:
            self.foresight = Foresight(self.simulation, self._wait)
        self.play(wishes.playing)

    def _after_steps(self) -> None:
        self._remember()
        if self.simulation.divergence is not None:
            self.play(False)
            self.offer_back = True
            # The limit that is told is that of the body when it ran away, not of what is left of it.
            self.stability = self.simulation.divergence.stability
            self._look, self._estimated = None, self.revision
            self.notices.append(runaway(self.simulation.divergence, self.simulation.scene))


def _answer(result: Future[T]) -> T:
    """What the ticker gives.

    Raises:
        InputError: it took too long.
    """
    try:
        return result.result(timeout=5.0)
    except TimeoutError:
        raise InputError("the scene is busy; try again") from None
