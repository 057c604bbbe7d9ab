"""Notices when a body touches something after it was free."""

from __future__ import annotations

import math
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from sim.analysis.description import touches
from sim.motion.quantities import Moving

from .messages import Touched

FREE = 0.3
"""Seconds of simulated time without a touch after which the next one counts as new."""

MOST_AT_ONCE = 300
"""Masses up to which a body is looked at in each frame."""

_FEWER = 0.2
"""Seconds between two looks at a larger body."""

_UPRIGHT = 0.7
"""Part of a wall's force that points upwards from which on it is a floor."""


class TouchWatch:
    """Follows one body; forget it when another one takes its place."""

    def __init__(self) -> None:
        self._time = math.inf
        self._free_since: float | None = None  # simulated time; None while it touches something
        self._due = -math.inf

    def look(self, simulation: Moving, count: int, up: float, now: float) -> Touched | None:
        """What the body touches now that it did not before.

        Args:
            simulation: what moves it.
            count: of its masses.
            up: the sign of y upwards, as the scene draws it.
            now: wall time, s.
        """
        time, before = simulation.time, self._time
        if time == before or (count > MOST_AT_ONCE and now < self._due):
            return None
        self._time, self._due = time, now + _FEWER
        forces = {name: force for name, force in touches(simulation).items() if force.any()}
        free_since, self._free_since = self._free_since, None
        if not forces:
            # Of what was before the first look, or before time was turned back, nothing is known.
            known = time if before < time else -math.inf
            self._free_since = known if free_since is None else free_since
            return None
        is_new = before < time and free_since is not None and time - free_since > FREE
        return Touched(by=_what(forces, up)) if is_new else None


def _what(forces: dict[str, NDArray[np.complex128]], up: float) -> Literal["floor", "wall", "body"]:
    """What pushes most."""
    name = max(forces, key=lambda each: float(np.abs(forces[each]).sum()))
    if name != "walls":
        return "body"
    total = complex(forces[name].sum())
    return "floor" if up * total.imag > _UPRIGHT * abs(total) else "wall"
