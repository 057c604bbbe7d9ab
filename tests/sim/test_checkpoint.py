"""Checkpoints: from them a simulation goes on to the same bits, whatever its method remembers."""

from __future__ import annotations

import numpy as np
import pytest

import sim
from sim import Simulation
from sim.errors import InputError
from sim.motion.checkpoint import Words
from sim.scene.types import Method
from sim.solve.registry import METHODS
from studies.bench.frames import rod
from tests.amount import part_of
from tests.sim.surrounded import with_everything

SCENES = (
    "tutorial-3.3",
    "ring",
    "girder",
    "pile",
    "stick-slip",
    "kapitza",
    "walker",
    "water-balloon",
    "crane",
)


def same(one: Simulation, other: Simulation) -> bool:
    """Whether two simulations are in the same state, to the last bit."""
    a, b = one.capture(), other.capture()
    bits = [(m.rows.tobytes(), m.time, m.step_count, m.rest_length_scale, m.rest_angle_shift) for m in (a, b)]
    return bits[0] == bits[1] and (a.damage, a.grips) == (b.damage, b.grips)


def play(simulation: Simulation, frames: int, attempts: int = 300) -> None:
    """A hand takes a mass, leads it about and lets it go, keys are held and a slider is moved."""
    last = len(simulation.positions) - 1
    x, y = simulation.positions[last].tolist()
    for i in range(frames):
        if i == 2:
            simulation.grab(last)
        if 2 <= i < 9:
            simulation.follow(last, (x + 3.0 * i, y - i))
        if i == 9:
            simulation.release(last)
        if i in (5, 12):
            simulation.keys = {"up", "right"} if i == 5 else set()
        if i == 14:
            simulation.replace(sim.set_value(simulation.scene, "gravity", 500.0))
        simulation.step(max(1, round(1.0 / 60.0 / simulation.dt)), attempts)


@pytest.mark.parametrize(
    ("preset", "method"),
    part_of([(preset, method) for preset in SCENES for method in METHODS], 20),
)
def test_it_goes_on_to_the_same_bits(preset: str, method: Method) -> None:
    scene = sim.set_choice(sim.load_scene(preset), "method", method)
    live, other = Simulation(scene), Simulation(sim.load_scene("rope"))
    for part in (1, 7, 3, 20):
        play(live, part)
        if live.divergence is not None:  # not every method is stable at every scene's step
            break
        point = live.checkpoint()
        play(live, 16)
        for _ in range(2):  # twice from the same checkpoint
            other.resume(point)
            assert other.time == point.time
            play(other, 16)
            assert same(live, other)


def test_of_a_long_rod_led_at_a_limited_speed() -> None:
    live = Simulation(rod(220, sim.Integrator()))
    live.follow(0, (500.0, 100.0))
    live.step(2, 400)
    assert live.behind
    point = live.checkpoint()
    other = Simulation(rod(220, sim.Integrator()))
    other.resume(point)
    assert other.behind == live.behind
    for each in (live, other):
        play(each, 6)
    assert same(live, other)


def test_of_a_body_that_breaks_among_everything() -> None:
    live, other = Simulation(with_everything()), Simulation(with_everything())
    for _ in range(4):
        play(live, 10)
        point = live.checkpoint()
        play(live, 10)
        other.resume(point)
        play(other, 10)
        assert same(live, other)


def test_in_the_middle_of_a_frame_that_was_too_long() -> None:
    live, other = Simulation(sim.set_value(sim.load_scene("ring"), "tolerance", 1e-6)), Simulation(sim.rope())
    live.lead(0, (400.0, 100.0))
    live.step(8, 9)
    other.resume(live.checkpoint())
    for each in (live, other):
        for _ in range(10):
            each.step(8, 9)
    assert same(live, other)


def test_the_energy_that_is_followed_changes_no_bit() -> None:
    live, other = Simulation(sim.load_scene("girder")), Simulation(sim.load_scene("girder"))
    live.track_energy(True)
    play(live, 20)
    other.resume(live.checkpoint())
    for each in (live, other):
        play(each, 20)
    assert same(live, other)


def test_none_of_a_body_that_has_run_away() -> None:
    live = Simulation(sim.set_value(sim.load_scene("ring"), "angular_stiffness", 1e9), integrator="rk4")
    live.lead(0, (400.0, 100.0))
    live.advance(2.0)
    assert live.divergence is not None
    with pytest.raises(InputError, match="checkpoint"):
        live.checkpoint()


def test_zeros_are_not_stored_but_their_sign_is() -> None:
    arrays = [np.zeros(1000), np.array([0.0, -0.0, 1.0]), np.zeros((2, 50))]
    words = Words.of(arrays)
    assert words.nbytes < 600
    copies = [np.ones_like(array) for array in arrays]
    words.put_into(copies)
    assert all(np.array_equal(a, b) for a, b in zip(arrays, copies, strict=True))
    assert np.signbit(copies[1][1])
