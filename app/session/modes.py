"""The slow vibrations of a session's body while somebody looks at them: found beside the frames."""

from __future__ import annotations

import threading
from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray

import sim
from sim.analysis.modes import Excitation, Modes
from sim.body.system import same_topology
from sim.compiling.compiler import FOR_FALLBACK, is_ready
from sim.errors import InputError

COUNT = 10
"""Modes that are looked at, at most."""
LARGE = 0.1
"""Amplitude of a full bar of the slowest mode, in sizes of the body."""
MOVED = 1e-3
"""By how much of its size an anchor may have moved before the body's modes are found anew."""
STANDS = 10
"""Looks for which it has to have been let go."""


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
        self._stood = 0  # looks since an anchor was moved and let go
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
        other = held.shape != self._held.shape
        away = not other and float(np.abs(held - self._held).max(initial=0.0)) > MOVED * _size(simulation)
        # One that is just being led has no place yet.
        self._stood = self._stood + 1 if away and not busy else 0
        moved = other or self._stood > STANDS
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
        if modes is None or not modes.omega.size:
            return np.zeros(0)
        action = modes.omega * modes.masses
        return LARGE * modes.size * np.sqrt(action[0] / action)

    @property
    def unit(self) -> float:
        """Energy that fills the bar of what is in no mode, kg px²/s²: the mean of what fills the others."""
        modes = self.found
        if modes is None or not modes.omega.size:
            return 1.0
        return float((0.5 * modes.masses * (modes.omega * self.full) ** 2).mean())

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
