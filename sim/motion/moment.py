"""A moment of a simulation, to come back to."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..scene.types import Damage, Grips, Scene


@dataclass(frozen=True, eq=False, slots=True)
class Moment:
    """All that decides how a body goes on; see `Simulation.capture` and `Simulation.restore`.

    What a method remembers of its last steps is not in it, nor what is in somebody's hand.

    Attributes:
        scene: its body and settings, without what keys have changed; shared, not copied.
        rest_length_scale: the factor of all rest lengths.
        rest_angle_shift: degrees that keys have added to all rest angles.
        rows: (4, n) x, y (px) and vx, vy (px/s) of the scene's masses; not to be written to.
        time: simulated time, s.
        step_count: time steps done until then.
        damage: what has yielded and broken, or None.
        grips: the tangential springs by which friction holds, or None.
        steer: what keys do to motors, muscles and forces, see `State.steer`; empty where none was held.
    """

    scene: Scene
    rest_length_scale: float
    rest_angle_shift: float
    rows: NDArray[np.float64]
    time: float
    step_count: int
    damage: Damage | None = None
    grips: Grips | None = None
    steer: tuple[float, ...] = ()

    @property
    def positions(self) -> NDArray[np.float64]:
        """(n, 2) positions, px; a view."""
        return self.rows[:2].T

    @property
    def velocities(self) -> NDArray[np.float64]:
        """(n, 2) velocities, px/s; a view."""
        return self.rows[2:].T
