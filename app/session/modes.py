"""The slow vibrations of a session's body while somebody looks at them: found beside the frames."""

from __future__ import annotations

import math
import threading
from dataclasses import dataclass, replace
from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray

import sim
from sim.analysis.modes import Excitation, Modes
from sim.body.system import same_topology
from sim.compiling.compiler import FOR_FALLBACK, is_ready
from sim.errors import InputError

from . import log

COUNT = 10
"""Modes that are looked at, at most."""
LARGE = 0.1
"""Amplitude of a full bar of the slowest mode, in sizes of the body."""
MOVED = 1e-3
"""By how much of its size an anchor may have moved before the body's modes are found anew."""
PIECES = 20
"""Calls of `step` in which a mass that drives a mode is led through a period."""
SWELLING = 6.0
"""Periods in which a mode that nothing damps comes to a full bar when it is driven."""
FURTHEST = 0.01
"""How far supports are moved at most to drive a mode, in sizes of the body."""


class ModesWatch:
    """What a session knows of its body's slow modes; it is there only while somebody looks at them.

    They are found by a thread that is there only meanwhile, and anew when the body, its numbers, its damage
    or the places of its anchors have changed.

    Attributes:
        found: the modes; None while there are none.
        number: counts what was found.
        trouble: why there are none, in a sentence without a full stop; empty while they are looked for.
    """

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._about: tuple[Any, ...] = ()
        self._held = np.zeros((0, 2))
        self._result: tuple[tuple[Any, ...], Modes | str] | None = None
        self._works = False
        self.found: Modes | None = None
        self.number = 0
        self.trouble = ""

    def tick(self, simulation: sim.Simulation, busy: bool) -> None:
        """Look whether the modes are still those of the body.

        Args:
            simulation: of the body.
            busy: whether somebody leads a mass just now: then they are those from before.
        """
        with self._lock:
            result, self._result = self._result, None
            works = self._works
        if result is not None and result[0] == self._about:
            self.found = result[1] if isinstance(result[1], Modes) else None
            self.trouble = result[1] if isinstance(result[1], str) else ""
            self.number += 1
        scene = simulation.scene
        if self.found is not None and not same_topology(self.found.scene, scene):
            self.found = None  # of another body
        held = simulation.positions[sorted({anchor.mass for anchor in scene.anchors})]
        about = (_Same(scene), simulation.damage)
        moved = held.shape != self._held.shape or (
            not busy and float(np.abs(held - self._held).max(initial=0.0)) > MOVED * _size(simulation)
        )
        if works or simulation.divergence is not None or not (about != self._about or moved):
            return
        if not is_ready(FOR_FALLBACK):
            return
        self._about, self._held = about, held
        places = tuple((float(x), float(y)) for x, y in simulation.positions)
        pose = sim.Pose(positions=places, velocities=((0.0, 0.0),) * len(places), damage=simulation.damage)
        self._works = True
        wanted = msgspec.structs.replace(scene, pose=pose)
        thread = threading.Thread(target=self._run, args=(wanted, about), name="softrod-modes", daemon=True)
        thread.start()

    @property
    def full(self) -> NDArray[np.float64]:
        """(k,) amplitudes of full bars, px.

        They have the same action, which is energy over frequency: a faster mode swings less far, so that the
        body bears it.
        """
        modes = self.found
        if modes is None or not modes.frequencies.size:
            return np.zeros(0)
        action = modes.frequencies * modes.masses
        return LARGE * modes.size * np.sqrt(action[0] / action)

    @property
    def unit(self) -> float:
        """Energy that fills the bar of what is in no mode, kg px²/s²: the mean of what fills the others."""
        modes = self.found
        if modes is None or not modes.frequencies.size:
            return 1.0
        return float((0.5 * modes.masses * (modes.frequencies * self.full) ** 2).mean())

    def excitation(self, simulation: sim.Simulation) -> Excitation | None:
        """How much of each mode is in the body's motion now; None while there are none."""
        modes = self.found
        if modes is None or not same_topology(modes.scene, simulation.scene):
            return None
        return modes.excitation(simulation.positions, simulation.velocities)

    def _run(self, scene: sim.Scene, about: tuple[Any, ...]) -> None:
        result: Modes | str
        try:
            result = Modes(scene, COUNT)
            _ = result.damping_ratios
        except InputError as error:
            result = str(error)
        with self._lock:
            self._works, self._result = False, (about, result)


class _Same:
    """A scene that equals itself alone: two are compared at every frame."""

    def __init__(self, scene: sim.Scene) -> None:
        self._scene = scene

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Same) and other._scene is self._scene

    __hash__ = None  # type: ignore[assignment]


def _size(simulation: sim.Simulation) -> float:
    return float(np.hypot(*np.ptp(simulation.positions, axis=0)))


@dataclass(frozen=True)
class Drive:
    """Masses that are led to and fro by hand at the frequency of a mode.

    Attributes:
        mode: which.
        masses: that are led.
        grabbed: whether it is a free one, in a hand meanwhile.
        about: where they were, px.
        swings: their amplitudes, px.
        frequency: angular, rad/s.
        began: simulated time, s.
        part: of these amplitudes; less as the mode comes to a full bar, so that nothing breaks by it.
    """

    mode: int
    masses: tuple[int, ...]
    grabbed: bool
    about: NDArray[np.float64]
    swings: NDArray[np.float64]
    frequency: float
    began: float
    part: float = 1.0

    @staticmethod
    def of(watch: ModesWatch, mode: int, simulation: sim.Simulation) -> Drive:
        """How a mode is driven: by all supports together, or else by the mass that it moves most.

        Raises:
            InputError: there is no such mode, or it is too fast for the time step.
        """
        modes = watch.found
        if modes is None or not 0 <= mode < modes.frequencies.size:
            raise InputError(f"there is no mode {mode + 1} to drive")
        w = float(modes.frequencies[mode])
        if (period := 2.0 * math.pi / w) < 4.0 * simulation.dt:
            raise InputError(f"mode {mode + 1} has a period of {period:.3g} s, less than four time steps")
        full = float(watch.full[mode])
        if (supports := modes.supports(mode)) is not None:
            masses, ways, felt = supports
            # A force f B sin(wt) on a mode of mass M has it grow by f B / (2 M w) in a second.
            wanted = full * 2.0 * float(modes.masses[mode]) * w / (felt * SWELLING * period)
            swings = min(wanted, FURTHEST * modes.size) * ways
        else:
            masses = np.array([np.argmax(np.hypot(*modes.shapes[mode].T))])
            swings = full * modes.shapes[mode][masses]
        about = simulation.positions[masses]
        led = tuple(int(mass) for mass in masses)
        return Drive(mode, led, supports is None, about, swings, w, simulation.time)

    def gentler(self, watch: ModesWatch, simulation: sim.Simulation) -> Drive:
        """As it goes on: the nearer the mode is to a full bar, the less."""
        now = watch.excitation(simulation)
        if now is None:
            return self
        amplitude = math.hypot(now.amplitudes[self.mode], now.rates[self.mode] / self.frequency)
        return replace(self, part=1.0 - min(amplitude / float(watch.full[self.mode]), 1.0))

    def steps(self, dt: float) -> int:
        """Time steps in which they are led in straight lines."""
        return max(1, int(2.0 * math.pi / self.frequency / PIECES / dt))

    def lead(self, simulation: sim.Simulation, steps: int) -> list[log.Act]:
        """What leads them through the next time steps."""
        part = self.part * math.sin(self.frequency * (simulation.time + steps * simulation.dt - self.began))
        return self._to(simulation, self.about + part * self.swings, log.Lead)

    def end(self, simulation: sim.Simulation) -> list[log.Act]:
        """What puts them back, or lets go."""
        if self.grabbed:
            return [log.Release(mass=mass) for mass in self.masses]
        return self._to(simulation, self.about, log.Move)

    def _to(
        self, simulation: sim.Simulation, places: NDArray[np.float64], how: type[log.Lead | log.Move]
    ) -> list[log.Act]:
        kind = log.Follow if simulation.rate_limited else how
        pairs = zip(self.masses, places.tolist(), strict=True)
        return [kind(mass=mass, to=(x, y)) for mass, (x, y) in pairs]
