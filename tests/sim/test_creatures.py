"""Bodies with muscles: each does what its name says."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import sim
from sim import Medium, Simulation
from tests.sim.arrays import Floats


def center(simulation: Simulation) -> Floats:
    mass = np.array([mass.mass for mass in simulation.scene.masses])
    return mass @ simulation.positions / mass.sum()


def way(scene: sim.Scene, seconds: float) -> float:
    """How far to the right it gets, px."""
    simulation = Simulation(scene)
    start = center(simulation)
    simulation.advance(seconds)
    assert simulation.divergence is None
    return float(center(simulation)[0] - start[0])


def test_a_worm_creeps_where_its_waves_run_and_not_at_all_on_ice() -> None:
    assert way(sim.worm(), 4.0) > 80.0
    assert way(sim.worm(waves=-2.0), 4.0) < -80.0
    ice = tuple(sim.Wall(point=wall.point, normal=wall.normal, friction=0.0) for wall in sim.worm().walls)
    assert abs(way(sim.worm(walls=ice), 4.0)) < 15.0


def test_a_swimmer_swims_only_where_it_is_resisted_more_across_than_along() -> None:
    assert way(sim.swimmer(), 4.0) > 200.0
    assert way(sim.swimmer(waves=1.2), 4.0) < -200.0
    assert abs(way(sim.swimmer(medium=Medium(across=0.3, along=0.3)), 4.0)) < 10.0


@pytest.mark.parametrize("numbers", [{}, {"pairs": 2, "length": 200.0, "legs": 90.0, "start": (60.0, 402.0)}])
def test_a_walker_walks_upright(numbers: dict[str, Any]) -> None:
    simulation = Simulation(sim.walker(**numbers))
    hips = 2 * len(simulation.scene.masses) // 6
    start, tilts = center(simulation), []
    for _ in range(40):
        simulation.advance(0.25)
        x, y = simulation.positions[hips - 1] - simulation.positions[0]
        tilts.append(abs(math.degrees(math.atan2(y, x))))
    assert max(tilts) < 30.0
    assert center(simulation)[0] - start[0] > 300.0


def test_a_heart_beats() -> None:
    simulation, areas = Simulation(sim.heart()), []
    for _ in range(200):
        simulation.advance(0.025)
        x, y = simulation.positions.T
        areas.append(0.5 * float((x * np.roll(y, -1) - np.roll(x, -1) * y).sum()))
    late = np.array(areas[100:])
    assert late.min() < 0.8 * late.max()
    # At 1.2 Hz, 2.5 s are three beats, which are all alike.
    spectrum = np.abs(np.fft.rfft(late - late.mean()))
    assert spectrum[3] > 100.0 * spectrum[[1, 2, 4, 5]].max()


def test_the_notch_of_a_heart_never_closes() -> None:
    simulation = Simulation(sim.heart())
    for _ in range(240):
        simulation.advance(1.0 / 60.0)
        left, right = (simulation.positions[list(masses), 0] for masses in ((-1, -2, -3, -4), (1, 2, 3, 4)))
        assert (left < simulation.positions[0, 0]).all() and (right > simulation.positions[0, 0]).all()


def test_a_hand_lifts_its_ball_and_lets_it_go() -> None:
    simulation, height = Simulation(sim.hand()), []
    for _ in range(24):
        height.append(500.0 - float(simulation.positions[-16:, 1].mean()))
        simulation.advance(0.2)
    assert max(height) > height[0] + 30.0
    assert height[-1] < height[0] + 15.0
