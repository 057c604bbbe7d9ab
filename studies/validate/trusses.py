"""Girders at rest: their sag against the sum over their members."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal

import numpy as np

import sim
from sim.analysis.equilibrium import equilibrium

from .results import Case, Result, compared

_LOAD = 100.0
"""kg."""

_GRAVITY = 1000.0
"""px/s²."""


def girder(truss: Literal["warren", "pratt"], panels: int) -> sim.Scene:
    """Return a nearly massless and nearly rigid girder with a load at mid-span."""
    return sim.girder(
        truss=truss,
        panels=panels,
        depth=70.0,
        stiffness=1e10,
        mass=1e-6,
        load=_LOAD,
        gravity=(0.0, _GRAVITY),
    )


def sag_by_virtual_work(scene: sim.Scene, mass: int) -> float:
    """Return how far a loaded mass of a truss sinks, px: sum N n / k.

    N are the tensions under the load and n those under a force of 1. Of all tensions in balance, those of
    linear elasticity have the lowest energy.
    """
    points = np.array([m.position for m in scene.masses])
    held = {anchor.mass for anchor in scene.anchors}
    balance = np.zeros((len(points), 2, len(scene.linear_springs)))
    for s, spring in enumerate(scene.linear_springs):
        along = points[spring.b] - points[spring.a]
        balance[spring.a, :, s] = along / np.hypot(*along)
        balance[spring.b, :, s] = -balance[spring.a, :, s]
    force = np.zeros((len(points), 2))
    force[mass, 1] = -1.0
    free = [i for i in range(len(points)) if i not in held]
    soft = 1.0 / np.sqrt([spring.stiffness for spring in scene.linear_springs])
    # The minimum-norm solution, in roots of energies.
    roots, *_ = np.linalg.lstsq(
        balance[free].reshape(2 * len(free), -1) / soft, force[free].ravel(), rcond=None
    )
    return _LOAD * _GRAVITY * float(roots @ roots)


def _girders(fast: bool) -> Iterator[Result]:
    for truss in ("warren", "pratt"):
        for panels in (4, 10) if fast else (4, 10, 40):
            scene, middle = girder(truss, panels), panels // 2
            sag = equilibrium(scene).positions[middle][1] - scene.masses[middle].position[1]
            exact = sag_by_virtual_work(scene, middle)
            yield compared(f"sag, {truss.capitalize()}, {panels} panels", exact, float(sag), 1e-4)


CASES = (
    Case(
        "girder",
        "Girders under a load",
        "Trusses of springs between two pins, with a load at mid-span: by virtual work, the sag is "
        "Σ N n / k, with the tensions N under the load and n under a force of one there, and the stiffness "
        "k = EA / L of each member.",
        _girders,
    ),
)
