"""The slow modes of a session's body, computed beside the frames while somebody looks at them."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

import sim
from sim.analysis.modes import Excitation, Modes
from sim.compiling.compiler import for_balance, is_ready
from sim.errors import InputError
from sim.model.system import same_topology

from .analysis import Analysis

COUNT = 10
"""Modes, at most."""
LARGE = 0.1
"""Amplitude of a full bar of the slowest mode, in sizes of the body."""
MOVED = 1e-3
"""Distance, in sizes of the body, that an anchor moves before the modes are computed again."""
STANDS = 10
"""Frames for which a moved anchor must have been left alone by then."""


class ModesWatch:
    """The slow modes of a session's body, for as long as somebody looks at them.

    They are computed again when the body, its numbers, its damage or the places of its anchors have changed.

    Attributes:
        found: the modes; None while there are none.
        number: counts results.
        trouble: why there are none, a sentence without a full stop; empty while they are being computed.
    """

    def __init__(self) -> None:
        self._analysis = Analysis("softrod-modes", _modes_of)
        self._about: tuple[Any, ...] = ()
        self._held = np.zeros((0, 2))
        self._stood = 0  # frames since an anchor was moved and let go
        self.found: Modes | None = None
        self.number = 0
        self.trouble = ""

    def tick(self, simulation: sim.Simulation, busy: bool) -> None:
        """Take a result, and start another analysis if the body is no longer the one analysed.

        Args:
            simulation: the body.
            busy: whether a mass is being led: the modes are then those from before.
        """
        result, is_running = self._analysis.take()
        if result is not None:
            self.found = result if isinstance(result, Modes) else None
            self.trouble = result if isinstance(result, str) else ""
            self.number += 1
        scene = simulation.scene
        if self.found is not None and not same_topology(self.found.scene, scene):
            self.found = None  # of another body
        held = simulation.positions[sorted({anchor.mass for anchor in scene.anchors})]
        about = (_Same(scene), simulation.damage)
        other = held.shape != self._held.shape
        away = not other and float(np.abs(held - self._held).max(initial=0.0)) > MOVED * _size(simulation)
        # An anchor that is still being led has no place yet.
        self._stood = self._stood + 1 if away and not busy else 0
        moved = other or self._stood > STANDS
        if is_running or simulation.divergence is not None or not (about != self._about or moved):
            return
        if is_ready(for_balance(simulation.tables[0].body)):
            self._about, self._held = about, held
            self._analysis.start(simulation)

    @property
    def full(self) -> NDArray[np.float64]:
        """(k,) amplitudes of full bars, px.

        All have the same action, energy over frequency: a faster mode swings less far, and the body is not
        torn.
        """
        modes = self.found
        if modes is None or not modes.omega.size:
            return np.zeros(0)
        action = modes.omega * modes.masses
        return LARGE * modes.size * np.sqrt(action[0] / action)

    @property
    def unit(self) -> float:
        """Energy of a full bar for all that is in no mode, kg px²/s²: the mean over the modes' own bars."""
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


class _Same:
    """A scene compared by identity, since it is compared in every frame."""

    def __init__(self, scene: sim.Scene) -> None:
        self._scene = scene

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Same) and other._scene is self._scene

    __hash__ = None  # type: ignore[assignment]


def _modes_of(scene: sim.Scene) -> Modes | str:
    """The modes of a scene in its pose, or why there are none."""
    try:
        modes = Modes(scene, COUNT)
        _ = modes.damping_ratios  # computed here, not in a frame
        return modes
    except InputError as error:
        return str(error)


def _size(simulation: sim.Simulation) -> float:
    return float(np.hypot(*np.ptp(simulation.positions, axis=0)))
