"""Keeping books of the energy only reads: the motion is the same with them and without."""

from __future__ import annotations

import msgspec
import numpy as np
import pytest

from sim import Integrator, SceneError, Simulation
from sim.methods import METHODS
from sim.scene import ForceLaw, Method
from tests.sim.bodies import LAWS, body
from tests.sim.fuzzing import STEPS, wild_scene
from tests.sim.inside import same_state

REPLACE = msgspec.structs.replace


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("shape", ["chain", "ring"])
@pytest.mark.parametrize("method", METHODS)
def test_books_do_not_change_the_motion(method: Method, shape: str, law: ForceLaw) -> None:
    # With a first mass that is free, and with one that is held and led.
    for held in ((), (0,)):
        scene = body(shape, law, 1, twist=0.0, held=held)
        scene = REPLACE(scene, integrator=Integrator(method=method, dt=1e-4, tolerance=1e-4))
        with_books, without = Simulation(scene), Simulation(scene)
        with_books.keep_books(True)
        x, y = scene.masses[0].position
        for i in range(5):
            for simulation in (with_books, without):
                if held:
                    simulation.lead(0, (x + i, y - i))
                # One step each, since books of symplectic Euler are kept step by step.
                for _ in range(20):
                    assert simulation.step() == 1
        assert same_state(with_books, without)


def test_nor_do_they_change_whole_frames_of_wild_scenes() -> None:
    # A rough tolerance, so that springs turn and shrink within few steps.
    looked_at = 0
    for seed in range(150):
        scene = wild_scene(np.random.default_rng(seed))
        scene = REPLACE(scene, integrator=Integrator(method="auto", tolerance=1.0))
        try:
            with_books, without = Simulation(scene), Simulation(scene)
        except SceneError:
            continue
        looked_at += 1
        with_books.keep_books(True)
        for _ in range(6):
            for simulation in (with_books, without):
                simulation.step(STEPS, attempts=400)
        assert same_state(with_books, without), seed
    assert looked_at > 100


@pytest.mark.parametrize("method", METHODS)
def test_what_is_asked_in_between_does_not_change_the_motion(method: Method) -> None:
    scene = REPLACE(body("chain", "angle", 2), integrator=Integrator(method=method, dt=1e-3, tolerance=1e-3))
    asked, left = Simulation(scene), Simulation(scene)
    for _ in range(30):
        asked.stability()
        asked.effort()
        assert asked.angles.size == asked.rest_angles.size
        assert asked.pose().positions
        assert asked.step() == left.step()
    assert same_state(asked, left)
