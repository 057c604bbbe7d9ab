"""Adams' methods choose their degree by what moves."""

from __future__ import annotations

import numpy as np
import pytest
from msgspec.structs import replace
from numpy.polynomial import Polynomial

import sim
from sim import Scene, Simulation
from sim.engine.tables import PAST
from sim.solve.adams_table import adams
from tests.sim.builders import folded_rope
from tests.sim.changes import by
from tests.sim.inside import STEADY, adams_degree, spaced

PARTS = 100


def moved(scene: Scene, tolerance: float) -> tuple[Simulation, list[int]]:
    """A scene after a second of `adams`, and the degrees on the way."""
    simulation = Simulation(by(scene, "adams", tolerance=tolerance, dt=1.0 / PARTS))
    degrees = []
    for _ in range(PARTS):
        assert simulation.step() == 1
        degrees.append(adams_degree(simulation))
    return simulation, degrees


@pytest.mark.parametrize("degree", range(1, PAST))
@pytest.mark.parametrize("ratio", [0.2, 0.5, 1.0, 1.25, 2.0, 4.0])
def test_the_past_is_interpolated_for_another_step(degree: int, ratio: float) -> None:
    """Enough past values to determine a polynomial of the degree; earlier ones are not used."""
    head, at, size = 5, 9, 2 * 16
    wave = Polynomial(np.random.default_rng(degree).normal(size=degree + 1))
    past, rows = np.zeros((PAST, size)), np.zeros((PAST + 4, size))
    for i in range(PAST):
        past[(head + i) % PAST, at] = wave(-i) if i <= degree else 1e9
    spaced(past, head, adams(PAST - 1), degree, ratio, rows)
    found = [past[(head + i) % PAST, at] for i in range(degree + 1)]
    expected = [wave(-ratio * i) for i in range(degree + 1)]
    np.testing.assert_allclose(found, expected, rtol=1e-9, atol=1e-9 * np.abs(expected).max())
    assert not np.delete(past, at, axis=1).any()


def mean_degree(scene: Scene, tolerance: float) -> float:
    """Over a second, and over tolerances beside each other: rounding alone changes a run's by a tenth."""
    degrees = []
    for nearby in np.geomspace(0.8, 1.25, 8) * tolerance:
        _, found = moved(scene, float(nearby))
        assert min(found) >= 3
        degrees += found
    return float(np.mean(degrees))


@pytest.mark.parametrize("air_friction", [0.0, 0.002])
def test_what_is_smooth_is_followed_by_high_degrees(air_friction: float) -> None:
    """Air friction has a kink wherever a velocity changes its sign, which is kept out of the past."""
    scene = replace(sim.load_scene("study-w2"), air_friction=air_friction)
    assert mean_degree(scene, 1e-6) > 5.7  # 5.0 if kinks were seen


def test_what_is_rough_is_followed_by_low_degrees() -> None:
    # A rope that unfolds: joints turn over. And no kink counts under this tolerance.
    assert mean_degree(folded_rope(), 1e-2) < 5.0


def growth(degree: int, part: float) -> float:
    """By what a step multiplies a vibration, or its traces in the past; `part`: that of Verlet's limit."""
    table, square = adams(PAST - 1), (2.0 * part) ** 2  # (omega h)²
    q, v, *past = np.eye(degree + 3)  # as sums of what there was before: positions, h v, h² a
    weights = (table.position, table.velocity, table.ahead)
    by_q, by_v, ahead = (w[degree, : degree + 1] @ np.array(past) for w in weights)
    to_q, to_v = q + v + by_q, v + by_v
    off = -square * to_q - ahead
    to_q, to_v = to_q + table.to_position[degree] * off, to_v + table.to_velocity[degree] * off
    step = np.array([to_q, to_v, -square * to_q, *past[:-1]])
    return np.abs(np.linalg.eigvals(step)).max()


def test_vibrations_fade_under_the_degree_that_long_steps_are_left() -> None:
    parts = np.linspace(0.34, 0.62, 30)
    assert max(growth(STEADY, part) for part in parts) < 1.0
    assert max(growth(PAST - 1, part) for part in parts) > 1.0004
    assert growth(STEADY, 0.65) > 1.0


def test_vibrations_that_nothing_damps_do_not_hold_steps() -> None:
    """They grow under the highest degree: then it takes 92000 evaluations, and ends 7 times as far off.

    Without that it takes 59000 to 66000, whichever way numbers are rounded.
    """
    simulation, _ = moved(sim.load_scene("study-w4"), 1e-5)
    assert simulation.stats().forces < 75_000
    exact, _ = moved(sim.load_scene("study-w4"), 1e-8)
    assert np.hypot(*(simulation.positions - exact.positions).T).max() < 3e-7
