"""What a page's view shows: where the body moves in its first seconds."""

from __future__ import annotations

import msgspec
import numpy as np
import pytest

import sim
from app.session import framing
from app.session.framing import MAX_GROWTH, SECONDS, Framing, motion_bounds
from tests.app.hostile import eventually

REPLACE = msgspec.structs.replace


@pytest.mark.parametrize("name", ["pendulum", "tutorial-3.3", "jelly"])
def test_the_body_stays_in_the_bounds_of_its_motion_and_reaches_all_of_them(name: str) -> None:
    scene = sim.load_scene(name)
    low, high = motion_bounds(scene)
    simulation = sim.Simulation(scene)
    radii = np.array([mass.radius for mass in scene.masses])[:, None]
    least, most = np.full(2, np.inf), np.full(2, -np.inf)
    for _ in range(round(SECONDS * 30)):
        least = np.minimum(least, (simulation.positions - radii).min(0))
        most = np.maximum(most, (simulation.positions + radii).max(0))
        simulation.advance(1.0 / 30.0)
    # A step before or after the last look.
    size = np.ptp(np.array((low, high)), axis=0).max()
    assert np.abs(low - least).max() < 0.1 * size
    assert np.abs(high - most).max() < 0.1 * size


def test_a_body_that_explodes_is_shown_as_it_begins() -> None:
    rod = sim.rod(masses=8, gravity=(0.0, 1000.0))
    wild = REPLACE(rod, integrator=sim.Integrator(method="symplectic_euler", dt=0.1))
    places = sim.Simulation(wild).positions
    low, high = motion_bounds(wild)
    assert (low <= places.min(0)).all() and (places.max(0) <= high).all()
    assert (high - low).max() < 2.5 * np.ptp(places, axis=0).max()


def test_a_body_that_travels_is_shown_in_bounds_that_leave_it_large() -> None:
    falling = REPLACE(sim.load_scene("ring"), anchors=(), gravity=(0.0, 2000.0), walls=())
    size = np.ptp(sim.Simulation(falling).positions, axis=0).max()
    low, high = motion_bounds(falling)
    assert size < (high - low).max() < MAX_GROWTH * size


def test_bounds_are_found_once_for_each_opening(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[str] = []

    def bounds(scene: sim.Scene) -> framing.Bounds:
        asked.append(scene.name)
        return np.zeros((2, 2))

    monkeypatch.setattr(framing, "motion_bounds", bounds)
    of, ring, rope = Framing(), sim.load_scene("ring"), sim.load_scene("rope")
    assert of.bounds(1, ring, False) is None
    assert asked == [], "before its kernels are there, it would have to compile them"
    eventually(lambda: of.bounds(1, ring, True) is not None)
    assert of.bounds(1, rope, True) is not None
    assert of.bounds(2, rope, False) is None, "these are the bounds of another body"
    eventually(lambda: of.bounds(2, rope, True) is not None)
    assert asked == ["ring", "rope"]
