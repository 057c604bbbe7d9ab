"""Adams' methods choose their degree by what moves."""

from __future__ import annotations

import msgspec
import numpy as np
import pytest

import sim
from sim import Integrator, Simulation
from tests.sim.inside import adams_degree

REPLACE = msgspec.structs.replace
PARTS = 100


def moved(name: str, tolerance: float, **changes: object) -> tuple[Simulation, list[int]]:
    """A scene after a second of `adams`, and the degrees on the way."""
    integrator = Integrator(method="adams", tolerance=tolerance, dt=1.0 / PARTS)
    simulation = Simulation(REPLACE(sim.load_scene(name), integrator=integrator, **changes))
    degrees = []
    for _ in range(PARTS):
        assert simulation.step() == 1
        degrees.append(adams_degree(simulation))
    return simulation, degrees


@pytest.mark.parametrize("air_friction", [0.0, 0.002])
def test_what_is_smooth_is_followed_by_high_degrees(air_friction: float) -> None:
    """Air friction has a kink wherever a velocity changes its sign, which is kept out of the past."""
    _, degrees = moved("study-w2", 1e-6, air_friction=air_friction)
    assert np.mean(degrees) > 6.0


def test_what_is_rough_is_followed_by_low_degrees() -> None:
    # Joints that fold, under the law that jumps where they do, and a tolerance for which no kink counts.
    _, degrees = moved("study-w5", 1e-2, force_law="angle")
    assert np.mean(degrees) < 6.0
    assert min(degrees) >= 3


@pytest.mark.parametrize("name", ["study-w1", "study-w2"])
def test_errors_keep_to_the_tolerance_whatever_the_degrees(name: str) -> None:
    exact = Simulation(
        REPLACE(sim.load_scene(name), integrator=Integrator(method="dop853", tolerance=1e-10, dt=1.0))
    )
    assert exact.step() == 1
    for tolerance in (1e-2, 1e-4, 1e-6):
        simulation, _ = moved(name, tolerance)
        assert np.hypot(*(simulation.positions - exact.positions).T).max() < tolerance
