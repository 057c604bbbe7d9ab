"""One page's simulation, without the page: commands go in, a state to draw comes out.

Callbacks only call `post`, from any thread. Everything else is called by the ticker alone.
"""

from __future__ import annotations

import math
import time
from collections import deque
from collections.abc import Callable
from concurrent.futures import Future
from dataclasses import dataclass
from typing import Literal

import msgspec

import sim
from sim.errors import InputError, SceneError, SettingError
from sim.methods.registry import METHODS
from sim.motion.divergence import FARTHEST
from sim.motion.simulation import KEYS
from sim.motion.stability import StabilityEstimate
from sim.settings import SETTINGS, set_choice

from . import commands
from .commands import Command
from .ghost import Ghost
from .pacing import Pacer

KEYS_FORGOTTEN_AFTER = 0.5
"""Seconds of silence after which held keys count as released: the connection may be gone."""

SPEEDS = (0.125, 0.25, 0.5, 1.0, 2.0, 4.0)
MAX_QUEUE = 4000
"""Commands that wait at most; beyond that the page is not a person, and the oldest are dropped."""

FRAME = 1.0 / 60.0
DRAG_EVENT = 0.05
"""Seconds between two of viser's own reports of a drag; a mass is led smoothly from one to the next."""

HEAVY_UNIT = 0.004
"""Seconds of one step, or one attempt at a step, from which on a body is heavy."""

LARGE = 2000
"""Masses and springs from which on a scene counts as heavy before anything is known of its steps."""

MOST_ATTEMPTS = 20_000
"""Steps that a method may try for single steps of the clock, which have no frame to keep to."""

STABILITY_EVERY, STABILITY_SHARE = 0.25, 0.02
"""Seconds between two looks at the stability limit, at least; and the share of the budget that they may
take."""


@dataclass(frozen=True)
class Notice:
    """Something to tell the user once."""

    kind: Literal["error", "warning", "info"]
    title: str
    text: str


class Session:
    """The simulation of one page, and what its user is doing with it.

    Attributes:
        simulation: the body in motion; the ticker's alone.
        playing: whether the clock runs.
        follow: whether the driven mass follows the pointer.
        joint: the angular spring that is read out.
        generation: counts scenes opened; a new number means that everything has to be drawn anew.
        revision: counts changes of settings, other than by the arrow keys.
        notices: what the page has still to be told.
        pacer: the clock.
        stability: the last look at the stability limit.
        ghost: the second body, if one is wanted.
        books: whether the energy is followed.
        fallbacks: fallback steps since the scene was opened or reset.
        preparing: what is being compiled, for the page to say; empty when nothing is.

    Args:
        scene: what it shows first.
        clock: wall time, s.
        wait: whether a step may wait for the compiler. A page cannot: it moves by NumPy until then.
    """

    def __init__(
        self, scene: sim.Scene, clock: Callable[[], float] = time.monotonic, wait: bool = True
    ) -> None:
        self._clock = clock
        self._wait = wait
        self._queue: deque[tuple[float, Command]] = deque(maxlen=MAX_QUEUE)
        self.simulation = sim.Simulation(scene, wait=wait)
        self.pacer = Pacer()
        self.playing = True
        self.follow = False
        self.joint = 0
        self.generation = 0
        self.revision = 0
        self.notices: list[Notice] = []
        self.stability = StabilityEstimate(math.inf, None)
        self._stability_due = 0.0
        self._estimated = -1  # revision at the last look
        self._keys_at = -math.inf
        self._hand: tuple[int, float, float] | None = None  # mass, and where it is held off the pointer
        self._pointer: tuple[float, float] | None = None
        self._arrival = 0.0  # when a led mass is to be at the pointer
        self._pointed_at = -math.inf  # when the page's script last told where the pointer is
        self._last_steer = clock()
        self._by_gizmo = False
        self.ghost: Ghost | None = None
        self.books = False
        self.fallbacks = 0
        self.preparing = ""

    @property
    def heavy(self) -> bool:
        """Whether the next frame may take longer than others can wait for."""
        opened = [command.scene for _, command in list(self._queue) if isinstance(command, commands.Open)]
        return self.pacer.unit_cost > HEAVY_UNIT or any(map(is_large, (self.simulation.scene, *opened)))

    @property
    def will_play(self) -> bool:
        """Whether the clock runs once the commands that wait are applied."""
        playing = self.playing
        for _, command in list(self._queue):
            match command:
                case commands.Play(on):
                    playing = not playing if on is None else on
                case commands.DoSteps():
                    playing = False
        return playing

    def now(self) -> float:
        """Wall time, s, by the clock that everything here goes by."""
        return self._clock()

    # --------------------------------------------------------------------- any thread
    def post(self, command: Command) -> None:
        """Hand a command to the ticker."""
        self._queue.append((self._clock(), command))

    def snapshot(self, name: str, with_pose: bool) -> sim.Scene:
        """The scene as it is now, to be saved; with the present pose, or with the one it started from.

        Any thread may ask; the ticker makes it between two frames.

        Raises:
            SceneError: the ticker did not answer.
        """
        request = commands.Snapshot(name, with_pose, Future())
        self.post(request)
        try:
            return request.result.result(timeout=5.0)
        except TimeoutError:
            raise SceneError("the scene is busy; try again") from None

    # --------------------------------------------------------------------- the ticker's
    @property
    def scene(self) -> sim.Scene:
        """The scene as it is now, with what the arrow keys did."""
        return self.simulation.scene

    @property
    def driven(self) -> int | None:
        """The mass that the pointer drives, if the scene has one."""
        return next((a.mass for a in self.simulation.anchors if a.driven), None)

    @property
    def dragged(self) -> int | None:
        """The mass in hand."""
        return self._hand[0] if self._hand else None

    def tick(self, budget: float) -> None:
        """Go on by one frame, as far as the clock and the budget allow; `drain` comes before.

        Args:
            budget: seconds of computing that the frame may take.
        """
        now = self._clock()
        if now - self._keys_at > KEYS_FORGOTTEN_AFTER:
            self._hold(frozenset())
        running = self.playing and self.simulation.divergence is None
        if running:
            # A method with steps of its own is held to the budget by what it may try.
            own = METHODS[self.simulation.method].adaptive
            steps = self.pacer.grant(now, self.simulation.dt, math.inf if own else budget)
            self._steer(glide=True)
            led = list(self.simulation.behind)
            began = time.perf_counter()
            done = self.simulation.step(steps, attempts=self.pacer.attempts(budget))
            seconds, stats = time.perf_counter() - began, self.simulation.stats()
            self.fallbacks += stats.fallbacks
            self.pacer.record(now, self.simulation.dt, done, seconds, stats, missed=steps - done)
            self._follow_ghost(done, led)
            self._after_steps()
        # While the clock stands, only what its user changes can move the limit.
        if now >= self._stability_due and (running or self._estimated != self.revision):
            self._estimated = self.revision
            began = time.perf_counter()
            self.stability = self.simulation.stability()
            took = time.perf_counter() - began
            self._stability_due = now + max(STABILITY_EVERY, took / (STABILITY_SHARE * budget / FRAME))

    def drain(self) -> None:
        """Apply the commands that wait; also while the clock stands."""
        for _ in range(len(self._queue)):
            at, command = self._queue.popleft()
            try:
                self._apply(command, at)
            except (InputError, SettingError, SceneError) as error:
                self.notices.append(Notice("error", "That cannot be done", str(error)))
        if not self.playing or self.simulation.divergence is not None:
            self._steer(glide=False)

    # --------------------------------------------------------------------- inside
    def _apply(self, command: Command, at: float) -> None:
        match command:
            case commands.HoldKeys(keys):
                self._hold(keys & KEYS)
                self._keys_at = at
            case commands.Point(x, y):
                self._pointed_at = at
                if self._hand is None or not self._by_gizmo:
                    self._pointer, self._arrival = _finite(x, y), at + FRAME
            case commands.DragTo(x, y):
                # The page's script is faster and tells the same, but a gizmo may keep to an axis.
                if self._hand is not None and (self._by_gizmo or at - self._pointed_at > 0.2):
                    self._pointer, self._arrival = _finite(x, y), at + DRAG_EVENT
            case commands.Follow(on):
                self.follow = on and self.driven is not None
                self._pointer = None
            case commands.DragStart(mass, x, y, by_gizmo):
                self._take(mass, *_finite(x, y))
                self._by_gizmo = by_gizmo
            case commands.DragEnd():
                self._let_go()
            case commands.SetValue(key, value):
                self._set(key, value)
            case commands.SetChoice(key, value):
                self._replace(set_choice(self.simulation.scene, key, value))
                self.generation += 1  # other controls
            case commands.Compare(method, law, finer):
                self.ghost = Ghost(self.simulation, method, law, finer, self._wait) if method else None
                self.revision += 1
            case commands.KeepBooks(on):
                self.books = on
                self.simulation.keep_books(on)
                self.revision += 1
            case commands.Open(scene):
                self._open(scene)
            case commands.Play(on):
                self.play(not self.playing if on is None else on)
            case commands.DoSteps(steps):
                self.play(False)
                self._steer(glide=True)
                led = list(self.simulation.behind)
                done = self.simulation.step(max(0, min(steps, 1000)), attempts=MOST_ATTEMPTS)
                self._follow_ghost(done, led)
                self._after_steps()
            case commands.Reset():
                self._let_go()
                self.simulation.reset()
                self.fallbacks = 0
                if self.ghost is not None:
                    self.ghost.simulation.reset()
                    self.ghost.start_from(self.simulation)
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
            case commands.SelectJoint(joint):
                if 0 <= joint < len(self.simulation.scene.angular_springs):
                    self.joint = joint

    def play(self, on: bool) -> None:
        """Let the clock run or stand."""
        if on != self.playing:
            self.playing = on
            self.pacer.restart()
            self.revision += 1

    def _take(self, mass: int, x: float, y: float) -> None:
        self._let_go()
        for simulation in self._bodies():
            simulation.grab(mass)
        px, py = self.simulation.positions[mass]
        self._hand = (mass, px - x, py - y)
        self._pointer = (x, y)

    def _let_go(self) -> None:
        if self._hand is not None:
            mass = self._hand[0]
            # Where the pointer left it: the last frame may not have led it all the way.
            self._steer(glide=False)
            self._hand = None
            for simulation in self._bodies():
                simulation.release(mass)
        if not self.follow:
            self._pointer = None

    def _steer(self, glide: bool) -> None:
        """Lead the mass in hand, or the driven one, to the pointer: over the steps of a frame, or at once."""
        if self._pointer is None:
            return
        x, y = self._pointer
        if self._hand is not None:
            mass, dx, dy = self._hand
            x, y = x + dx, y + dy
        elif self.follow and self.driven is not None:
            mass = self.driven
        else:
            return
        x, y = _clamp(x), _clamp(y)
        if self.simulation.rate_limited:
            # As fast as it can follow while time passes, also after it was let go; the ghost as it does.
            for simulation in self._bodies():
                if simulation.rate_limited:
                    simulation.follow(mass, (x, y))
            return
        if not glide:
            for simulation in self._bodies():
                simulation.move(mass, (x, y))
            return
        # This frame's share of the way to where the mass is to be when the next report comes.
        now = self._clock()
        frame = min(max(now - self._last_steer, 1e-3), 2.0 * FRAME)
        self._last_steer = now
        share = min(1.0, frame / max(frame, self._arrival - now + frame))
        px, py = self.simulation.positions[mass]
        for simulation in self._bodies():
            simulation.lead(mass, (px + (x - px) * share, py + (y - py) * share))

    def _set(self, key: str, value: float) -> None:
        setting = SETTINGS.get(key)
        if setting is None or not math.isfinite(value):
            return
        self._replace(sim.set_value(self.simulation.scene, key, min(max(value, setting.low), setting.high)))

    def _replace(self, scene: sim.Scene) -> None:
        """Go on with changed settings."""
        rebuilt = len(scene.masses) != len(self.simulation.scene.masses)
        if rebuilt:
            self._let_go()
        self.simulation.replace(scene)
        if self.ghost is not None:
            self.ghost.simulation.replace(self.ghost.variant(scene))
            if rebuilt:
                self.ghost.start_from(self.simulation)
        if rebuilt:
            self.generation += 1
            self.joint = min(self.joint, max(0, len(scene.angular_springs) - 1))
        self.revision += 1
        self._stability_due = 0.0

    def _open(self, scene: sim.Scene) -> None:
        simulation = sim.Simulation(scene, wait=self._wait)
        self._let_go()
        self.simulation = simulation
        self.simulation.keep_books(self.books)
        self.ghost = None
        self.fallbacks = 0
        self.follow = False
        self._pointer = None
        self.joint = 0
        self.generation += 1
        self.revision += 1
        self.pacer.restart()
        self._stability_due = 0.0
        self.stability = StabilityEstimate(math.inf, None)

    def _bodies(self) -> list[sim.Simulation]:
        """The body, and its ghost."""
        return [self.simulation, *([self.ghost.simulation] if self.ghost is not None else [])]

    def _hold(self, keys: frozenset[str]) -> None:
        for simulation in self._bodies():
            simulation.keys = keys

    def _follow_ghost(self, steps: int, led: list[int]) -> None:
        """Let the ghost do as many steps, in which the same masses are led to where they are now."""
        if self.ghost is not None and self.ghost.is_ready(self.simulation):
            if not self.ghost.simulation.rate_limited:
                for mass in led:
                    self.ghost.simulation.lead(mass, tuple(self.simulation.positions[mass]))
            self.ghost.step(steps, self.simulation.dt)
            self.ghost.compare(self.simulation)

    def _after_steps(self) -> None:
        divergence = self.simulation.divergence
        if divergence is None:
            return
        self.play(False)
        scene = self.simulation.scene
        limit, cause = divergence.stability.limit, divergence.stability.cause
        if cause is not None and divergence.dt > limit:
            key = cause.replace(" ", "_")
            value = SETTINGS[key].read(scene)
            text = (
                f"Time step {divergence.dt:.3g} s is above the stability limit {limit:.2g} s at {cause} "
                f"{value:g}. The last good state is shown. Lower either of them, then press Reset."
            )
        else:
            text = (
                f"{str(divergence)[:1].upper()}{str(divergence)[1:]}. The last good state is shown. "
                "Move it more gently, or lower the time step, then press Reset."
            )
        self.notices.append(Notice("error", "The simulation ran away", text))


def is_large(scene: sim.Scene) -> bool:
    """Whether a scene is heavy by its size alone."""
    return len(scene.masses) + len(scene.linear_springs) + len(scene.angular_springs) > LARGE


def _clamp(coordinate: float) -> float:
    return min(max(coordinate, -FARTHEST), FARTHEST)


def _finite(x: float, y: float) -> tuple[float, float]:
    if not (math.isfinite(x) and math.isfinite(y)):
        raise InputError("the pointer is nowhere: its position is not a finite number")
    return x, y
