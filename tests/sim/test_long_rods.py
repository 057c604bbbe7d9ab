"""Long rods under `auto`, which moves them by generalized-alpha: its Newton steps, and how exact they are."""

from __future__ import annotations

import numpy as np
import pytest

from sim import Simulation
from sim.scene.types import Method
from tests.sim.builders import led_rod
from tests.sim.changes import apart

MASSES = 250
REFERENCE: tuple[Method, float] = ("rodas5p", 1e-3)
"""What `auto` at a tolerance of 0.1 px is held against: method, and tolerance in px."""


def test_a_smooth_motion_takes_little_more_than_one_move_a_step() -> None:
    simulation = Simulation(led_rod(MASSES))
    simulation.step(6)
    simulation.stats()
    simulation.step(30)
    stats = simulation.stats()
    assert stats.steps > 100
    # A force is evaluated for every move. One step in eight is solved for with two, to know how large a
    # second one is.
    tries = stats.steps + stats.rejected
    assert 1.1 * tries < stats.forces < 1.5 * tries


def test_moves_that_are_left_out_do_not_show() -> None:
    # What one of them would change is nothing beside the tolerance, but hundreds of them add up.
    right, found = Simulation(led_rod(MASSES, *REFERENCE)), Simulation(led_rod(MASSES))
    led = []
    for _ in range(60):
        right.step()
        found.step()
        assert np.hypot(*(found.positions - right.positions).T).max() <= 0.12
        led.append(right.positions[0])
    assert np.ptp(led, axis=0) == pytest.approx((400.0, 400.0), rel=0.1)


def test_a_rod_whose_end_is_torn_away_is_solved_for_all_the_same() -> None:
    # What was learnt about Newton's method in smooth motion does not hold any more.
    right = Simulation(led_rod(MASSES, *REFERENCE))
    found = Simulation(led_rod(MASSES))
    for simulation in (right, found):
        simulation.step(10)
        simulation.grab(MASSES - 1)
        x, y = simulation.positions[MASSES - 1]
        simulation.lead(MASSES - 1, (x - 60.0, y - 60.0))
        simulation.step(6)
        simulation.release(MASSES - 1)
        simulation.step(12)
    assert apart(found, right) <= 0.2


def test_a_very_long_rod_is_not_upset_by_how_it_begins() -> None:
    # Short steps follow vibrations that long ones cannot: handed on, they would make those fail for long.
    simulation = Simulation(led_rod(3000))
    assert simulation.step(30) == 30
    stats = simulation.stats()
    assert stats.steps < 700
    assert stats.rejected < 50


@pytest.mark.parametrize("masses", [1000, 3000])
def test_a_long_rod_soon_makes_the_steps_that_it_goes_on_with(masses: int) -> None:
    # Explicit steps, which stability cuts short, would leave the others to begin with tiny ones.
    simulation = Simulation(led_rod(masses))
    simulation.step()
    stats = simulation.stats()
    assert stats.steps + stats.rejected <= 24


def test_a_wave_that_slows_one_implicit_method_is_not_thought_to_spare_the_other() -> None:
    # It was last asked when all was smooth. Changing over then costs frames several times as long.
    simulation = Simulation(led_rod(1000))
    most = 0
    for _ in range(14):
        simulation.step()
        stats = simulation.stats()
        most = max(most, stats.steps + stats.rejected)
    assert most <= 32
