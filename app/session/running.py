"""A page's body in motion, and everything that is with it in the present."""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from typing import Literal

import msgspec

import sim
from sim.body.system import same_topology
from sim.edit.edit import Selection
from sim.motion.stability import Look, StabilityEstimate
from sim.settings import settings_of

from .ghost import Ghost, GhostMoment
from .hand import Body, PointerHands
from .history import History, OldFuture
from .notices import Notice
from .pacing import Pacer
from .record import Recorder
from .replay import Player
from .shadow import WINDOW, Foresight, ShadowMoment
from .versions import Versions


class Running:
    """The body of one page in the present: its settings, its hands, its second body; see `Session`.

    Attributes:
        simulation: the body in motion; the ticker's alone.
        playing: whether the clock runs.
        follow: whether the driven mass follows the pointer.
        joint: the angular spring that is read out.
        generation: a new number means that nodes and controls are to be those of another body.
        openings: counts bodies that took the place of another; a new one is fitted to the window.
        revision: counts changes of settings, other than by the arrow keys.
        notices: what the page has still to be told.
        pacer: the clock.
        stability: the last look at the stability limit.
        ghost: the second body, if one is wanted.
        foresight: tells how fast errors grow, if that is wanted.
        versions: what undo and redo lead to.
        selection: the parts of the body that are selected.
        books: whether the energy is followed.
        fallbacks: fallback steps since the scene was opened or reset.
        recorder: what acts on the body, and keeps its log; not while a log is played.
        history: the moments that are past, and which of them is shown.
        old_future: what would have come, where the user has gone back and on; or None.
        offer_back: whether the body ran away and can be taken back to just before that.
        replay: the log that is played, if one is.
        opened: the scene as it was opened.
        lesson_begun: whether a step of the scene's lesson has begun; if not, the page says which.
        waits: whether the clock stands only until a question of the scene's lesson is answered.
        hands: what the pointers do.
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
        self.simulation = sim.Simulation(scene, wait=wait)
        self.opened = self.simulation.capture().scene
        self.recorder = Recorder(self.simulation)
        self.history = History()
        self.history.add(self.simulation.capture())
        self.old_future: OldFuture | None = None
        self.offer_back = False
        self.replay: Player | None = None
        self._viewer: sim.Simulation | None = None  # shows what is past in a replay
        self.pacer = Pacer()
        self.playing = True
        self.follow = False
        self.joint = 0
        self.lesson_begun = False
        self.waits = False
        self.generation = self.openings = 0
        self.versions = Versions()
        self.selection = Selection()
        self.revision = 0
        self.notices: list[Notice] = []
        self.stability = StabilityEstimate(math.inf, None)
        self._stability_due = 0.0
        self._look: Look | None = None  # at the stability limit, if one is under way
        self.hands = PointerHands(self._bodies, clock)
        self.ghost: Ghost | None = None
        self.foresight: Foresight | None = None
        self.books = False
        self.fallbacks = 0
        self.preparing = ""

    def now(self) -> float:
        """Wall time, s, by the clock that everything here goes by."""
        return self._clock()

    @property
    def scene(self) -> sim.Scene:
        """The scene as it is now, with what the arrow keys did."""
        return self.simulation.scene

    @property
    def driven(self) -> int | None:
        """The mass that the pointer drives, if the scene has one."""
        return next((a.mass for a in self.simulation.anchors if a.driven), None)

    @property
    def dragged(self) -> tuple[int, ...]:
        """The masses in hand, in the order in which they were taken."""
        return self.hands.masses

    @property
    def _following(self) -> int | None:
        """The mass that follows the pointer without a button."""
        return self.driven if self.follow else None

    def _let_go(self) -> None:
        self.hands.let_all_go(self._following)

    def _set(self, key: str, value: float) -> None:
        setting = next((s for s in settings_of(self.simulation.scene) if s.key == key), None)
        if setting is None or not math.isfinite(value):
            return
        self._change(
            lambda: self.recorder.set_value(key, min(max(value, setting.low), setting.high)),
            setting.label,
            key,
        )

    def _change(self, change: Callable[[], None], label: str, key: str = "") -> None:
        """Go on with changed settings.

        Args:
            change: changes them.
            label: what they are called.
            key: of a number, whose changes are one for undo until another control is used.
        """
        before = self.simulation.capture()
        change()
        scene, after = self.simulation.scene, self.simulation.capture()
        rebuilt = not same_topology(before.scene, scene)
        if rebuilt:
            self.versions.add_leap(label, before, after, key)
        elif after.scene is not before.scene:
            self.versions.add_change(label, before, after, key)
        if rebuilt:
            # Another body, whose time begins anew: what is past belongs to the other one.
            self.hands.drop()
            self._begin_history()
            self.generation += 1
            self.openings += 1
            self.selection = Selection()
            self.joint = min(self.joint, max(0, len(scene.angular_springs) - 1))
        if self.ghost is not None:
            if rebuilt:
                self.ghost.start_from(self.simulation)
            else:
                self.ghost.change(scene)
        if self.foresight is not None:
            if rebuilt:
                self.foresight.begin(self.simulation)
            else:
                self.foresight.place(self.simulation)
        self.revision += 1
        self._stability_due = 0.0

    def _own_values(self, of: Literal["body", "solver"]) -> None:
        """Go on with the settings that the scene was opened with."""
        present = self.simulation.capture().scene
        with_body, with_solver = (self.opened, present) if of == "body" else (present, self.opened)
        scene = msgspec.structs.replace(
            with_body, force_law=with_solver.force_law, integrator=with_solver.integrator
        )
        self._let_go()
        self._change(lambda: self.recorder.set_scene(scene, keys_too=of == "body"), f"own values of the {of}")

    def _open(self, scene: sim.Scene) -> None:
        simulation = sim.Simulation(scene, wait=self._wait)
        self.opened = simulation.capture().scene
        self.lesson_begun = True
        self.hands.drop()
        self.simulation, self.recorder = simulation, Recorder(simulation)
        if self.books:
            self.recorder.keep_books(True)
        self._begin_history()
        self.replay = self._viewer = None
        self.ghost = self.foresight = None
        self.fallbacks = 0
        self.follow = False
        self.joint = 0
        self.selection = Selection()
        self.generation += 1
        self.openings += 1
        self.revision += 1
        self.pacer = Pacer(self.pacer.speed)  # what the last body cost says nothing
        self._stability_due = 0.0
        self._look = None
        self.stability = StabilityEstimate(math.inf, None)

    def _begin_history(self) -> None:
        self.history.clear()
        self.history.add(self.simulation.capture())
        self.old_future = None
        self.offer_back = False

    def _remember(self) -> None:
        """Keep this frame's moment, if time has passed."""
        if self.simulation.time != self.history.end:
            self.history.add(self.simulation.capture(), *self._moments_beside())

    def _moments_beside(self) -> tuple[GhostMoment | None, ShadowMoment | None]:
        return (
            self.ghost.capture() if self.ghost is not None else None,
            self.foresight.capture() if self.foresight is not None else None,
        )

    def _go_back_beside(self, index: int) -> None:
        """Take what is beside the body to a moment of the history."""
        if self.ghost is not None:
            self.ghost.go_back(self.history.ghost(index), self.simulation)
        if self.foresight is not None:
            self.foresight.go_back(self.history.shadows(index, WINDOW), self.simulation)

    def _bodies(self) -> list[Body]:
        """The body, its ghost, and those that tell how errors grow."""
        bodies: list[Body] = [self.recorder]
        if self.ghost is not None:
            bodies.append(self.ghost.simulation)
        if self.foresight is not None:
            bodies += self.foresight.shadow.pair
        return bodies

    def _hold(self, keys: frozenset[str]) -> None:
        for body in self._bodies():
            body.keys = keys

    def _follow(self, steps: int, led: list[int], budget: float) -> None:
        """Let what is beside the body do as many steps, with the same masses led to where they are now.

        Args:
            steps: time steps that the body has done.
            led: the masses that were led at a limited speed.
            budget: seconds of computing that this may take.
        """
        ghost, foresight, began = self.ghost, self.foresight, time.perf_counter()
        if ghost is not None and ghost.is_ready(self.simulation):
            self._lead_too(ghost.simulation, led)
            ghost.follow(self.simulation, steps, budget)
        if foresight is not None:
            for one in foresight.shadow.pair:
                self._lead_too(one, led)
            foresight.follow(self.simulation, steps, budget - (time.perf_counter() - began))

    def _lead_too(self, other: sim.Simulation, led: list[int]) -> None:
        """Lead masses of another body to where they are in the first one, at once where it can follow."""
        if not other.rate_limited:
            for mass in led:
                other.lead(mass, tuple(self.simulation.positions[mass]))
