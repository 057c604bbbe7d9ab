"""Long rods under `auto`, which moves them by generalized-alpha: its Newton steps, and how exact they are."""

from __future__ import annotations

import numpy as np
import pytest

from sim import Integrator, Scene, Simulation
from sim.scene import Method
from tests.sim.builders import led_rod


def rod(method: Method, tolerance: float, masses: int = 250) -> Scene:
    """The led rod, a frame of 1/60 s a step."""
    return led_rod(masses, Integrator(method=method, dt=1.0 / 60.0, tolerance=tolerance))


def path(scene: Scene, frames: int) -> np.ndarray:
    """(frames, n, 2) where the masses are after each frame."""
    simulation = Simulation(scene)
    places = []
    for _ in range(frames):
        simulation.step(1)
        places.append(simulation.positions.copy())
    return np.array(places)


def test_a_smooth_motion_takes_little_more_than_one_move_a_step() -> None:
    simulation = Simulation(rod("auto", 0.1))
    simulation.step(6)
    simulation.effort()
    simulation.step(30)
    effort = simulation.effort()
    assert effort.steps > 100
    # A force is evaluated for every move. One step in eight is solved for with two, to know how large a
    # second one is.
    tries = effort.steps + effort.rejected
    assert 1.1 * tries < effort.forces < 1.5 * tries


def test_moves_that_are_left_out_do_not_show() -> None:
    # What one of them would change is nothing beside the tolerance, but hundreds of them add up.
    right = path(rod("rodas5p", 1e-3), 30)
    off = np.abs(path(rod("auto", 0.1), 30) - right).max(axis=(1, 2))
    assert off.max() <= 0.12
    assert np.ptp(right[:, 0], axis=0) == pytest.approx((400.0, 400.0), rel=0.1)


def test_a_rod_whose_end_is_torn_away_is_solved_for_all_the_same() -> None:
    # What was learnt about Newton's method in smooth motion does not hold any more.
    right, found = Simulation(rod("rodas5p", 1e-3)), Simulation(rod("auto", 0.1))
    for simulation in (right, found):
        simulation.step(10)
        simulation.grab(249)
        x, y = simulation.positions[249]
        simulation.lead(249, (x - 60.0, y - 60.0))
        simulation.step(6)
        simulation.release(249)
        simulation.step(12)
    assert np.abs(found.positions - right.positions).max() <= 0.2


def test_nothing_is_carried_over_a_reset() -> None:
    one, other = Simulation(rod("auto", 0.1)), Simulation(rod("auto", 0.1))
    one.step(12)
    one.reset()
    one.step(6)
    other.step(6)
    assert np.array_equal(one.positions, other.positions)


def test_a_very_long_rod_is_not_upset_by_how_it_begins() -> None:
    # Short steps follow vibrations that long ones cannot: handed on, they would make those fail for long.
    simulation = Simulation(rod("auto", 0.1, 3000))
    assert simulation.step(30) == 30
    effort = simulation.effort()
    assert effort.steps < 700
    assert effort.rejected < 50
