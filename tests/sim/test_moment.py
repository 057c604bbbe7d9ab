"""Going back to a moment: everything that a user cares for comes back, and going on from it is repeatable."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import sim
from sim import Simulation
from tests.amount import examples
from tests.sim.builders import askew, tutorial_preset


def bits(simulation: Simulation) -> bytes:
    return simulation.positions.tobytes() + simulation.velocities.tobytes()


def test_a_step_without_a_memory_goes_on_as_if_nothing_had_been() -> None:
    """The tutorial's method remembers nothing, so going back and on changes no bit."""
    simulation, straight = Simulation(askew()), Simulation(askew())
    straight.step(100)
    simulation.step(40)
    moment = simulation.capture()
    simulation.step(99)
    simulation.restore(moment)
    simulation.step(60)
    assert bits(simulation) == bits(straight)
    assert simulation.time == pytest.approx(straight.time, abs=1e-12)


@given(
    preset=st.sampled_from(["tutorial-3.3", "ring", "hair-tuft"]),
    before=st.integers(0, 40),
    key=st.sampled_from(["gravity", "linear_stiffness", "rest_angle", "dt"]),
    share=st.floats(0.0, 1.0),
    after=st.integers(1, 40),
)
@settings(max_examples=examples(30))
def test_settings_come_back_with_the_moment(
    preset: str, before: int, key: str, share: float, after: int
) -> None:
    simulation = Simulation(tutorial_preset(preset))
    simulation.keys = {"left"}
    simulation.step(before)
    moment, scene, there = simulation.capture(), simulation.scene, bits(simulation)
    simulation.step(after)
    simulation.keys = set()
    if key == "rest_angle" and preset == "hair-tuft":
        key = "bend"  # which shifts all rest angles of a recipe
    low, high = sim.settings.setting_of(simulation.scene, key).slider
    simulation.replace(sim.set_value(simulation.scene, key, low + share * (high - low)))
    simulation.step(after)
    simulation.restore(moment)
    assert simulation.scene == scene
    assert bits(simulation) == there
    again = simulation.capture()
    assert again.scene is moment.scene
    assert np.array_equal(again.rows, moment.rows)


def test_another_body_comes_back_too() -> None:
    simulation = Simulation(askew())
    simulation.step(50)
    moment = simulation.capture()
    simulation.replace(sim.load_scene("ring"))
    simulation.step(10)
    simulation.restore(moment)
    assert simulation.scene.name == "tutorial-3.3"
    assert np.array_equal(simulation.positions, moment.positions)
    assert np.array_equal(simulation.velocities, moment.velocities)


def test_a_stopped_body_goes_on_from_a_good_moment() -> None:
    scene = sim.set_value(askew(), "angular_stiffness", 60_000.0)
    simulation = Simulation(scene)
    moment = simulation.capture()
    simulation.step(100_000)
    assert simulation.divergence is not None
    simulation.restore(moment)
    assert simulation.divergence is None
    assert simulation.step(10) == 10


def test_hands_let_go_and_what_they_held_is_at_rest() -> None:
    # Under the tutorial's law, a hand counts as standing still however fast it is.
    simulation = Simulation(sim.set_choice(askew(), "force_law", "conservative"))
    simulation.grab(6)
    simulation.lead(6, (500.0, 300.0))
    simulation.step(10)
    assert simulation.tables[1].v.any()
    moment = simulation.capture()
    assert not moment.velocities[6].any()
    simulation.lead(6, (0.0, 0.0))
    simulation.restore(moment)
    place = simulation.positions[6]
    simulation.step(1)
    # At the speed at which it was led, it would go on by 20 px in a step.
    assert np.hypot(*(simulation.positions[6] - place)) < 10.0
    with pytest.raises(sim.InputError, match="not held"):
        simulation.move(6, (0.0, 0.0))


def test_a_moment_keeps_what_it_had_and_shares_its_scene() -> None:
    simulation = Simulation(askew())
    simulation.step(10)
    moment = simulation.capture()
    kept = moment.rows.copy()
    simulation.step(10)
    assert np.array_equal(moment.rows, kept)
    assert moment.scene is simulation.capture().scene
    assert moment.rows.nbytes == 4 * 8 * 12


def test_the_energy_balance_begins_anew() -> None:
    simulation = Simulation(sim.load_scene("tutorial-3.3"))
    simulation.track_energy(True)
    simulation.step(50)
    moment = simulation.capture()
    simulation.step(200)
    simulation.restore(moment)
    assert simulation.energy().damping == 0.0
    simulation.step(20)
    assert abs(simulation.energy().residual) < 1e3


def test_the_balance_bears_a_method_that_is_still_being_compiled(monkeypatch: pytest.MonkeyPatch) -> None:
    ready = [True]
    for module in ("motion", "simulation"):
        monkeypatch.setattr(f"sim.motion.{module}.is_ready", lambda names: ready[0])
    simulation = Simulation(sim.load_scene("tutorial-3.3"), wait=False)
    assert simulation.track_energy(True)
    moment = simulation.capture()
    ready[0] = False
    simulation.replace(sim.set_choice(simulation.scene, "method", "rk4"))
    assert simulation.plain
    assert not simulation.track_energy(True)
    simulation.step(3)
    ready[0] = True
    simulation.restore(moment)
    assert not simulation.plain


def test_the_balance_bears_a_change_of_the_method() -> None:
    simulation = Simulation(sim.load_scene("tutorial-3.3"))
    simulation.track_energy(True)
    moment = simulation.capture()
    simulation.replace(sim.set_choice(simulation.scene, "method", "rk4"))
    simulation.restore(moment)
    simulation.step(10)
    assert simulation.energy().damping <= 0.0
